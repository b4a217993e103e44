// Checks and integers of the costs of labels; see label_costs.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/graph/detail/cuts/label_costs.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace concino::detail {

CONCINO_INLINE label_costs::label_costs(const label_problem& problem, const segment_options& options)
    : problem_(problem), options_(options), labels_(static_cast<std::size_t>(std::max(options.labels, 0))) {
  if (options.labels < 1)
    core::throw_joined<invalid_argument>({problem.caller, ": labels must be 1 or more"});
  if (!(options.smoothness >= 0 && options.smoothness < std::numeric_limits<double>::infinity()))
    core::throw_joined<invalid_argument>({problem.caller, ": smoothness must be finite and 0 or more"});
  check_element_costs();
  integer_scale::sum sum;
  for_each_largest_cost([&](double c) { sum.raise_largest(c); });
  for_each_largest_cost([&](double c) { sum.add(c); });
  scale_ = sum.scale();
}

CONCINO_INLINE bool label_costs::allows(std::size_t element, int label) const {
  return element_cost(element, static_cast<std::size_t>(label)) < std::numeric_limits<double>::infinity();
}

CONCINO_INLINE bool label_costs::allows_both(std::size_t edge, int a, int b) const {
  return allows(problem_.edges[edge][0], a) && allows(problem_.edges[edge][1], b);
}

CONCINO_INLINE double label_costs::pairwise_cost(std::size_t edge, int a, int b) const {
  if (problem_.pairwise) return problem_.pairwise(edge, a, b);
  return a == b ? 0 : options_.smoothness;
}

CONCINO_INLINE void label_costs::check_element_costs() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < num_elements(); ++i) {
    bool any = false;
    for (std::size_t l = 0; l < labels_; ++l) {
      const double c = element_cost(i, l);
      if (!(c > -infinity))
        core::throw_joined<invalid_argument>({problem_.caller, ": the cost of label ", l, " for ",
                                              problem_.element_name, " ", problem_.index[i], " is ",
                                              c < 0 ? "-inf" : "not a number",
                                              "; costs must be finite, or +inf for a label that is not allowed"});
      any = any || c < infinity;
    }
    if (!any)
      core::throw_joined<invalid_argument>({problem_.caller, ": all labels of ", problem_.element_name, " ",
                                            problem_.index[i], " cost +inf; at least one must be finite"});
  }
}

/// Fills the table of the costs of an edge, 0 for labels that are not allowed.
CONCINO_INLINE void label_costs::read_pairwise_costs(std::size_t edge, std::vector<double>& table) const {
  for (std::size_t k = 0; k < table.size(); ++k) {
    const int a = static_cast<int>(k / labels_), b = static_cast<int>(k % labels_);
    table[k] = allows_both(edge, a, b) ? pairwise_cost(edge, a, b) : 0;
    if (table[k] >= 0 && table[k] < std::numeric_limits<double>::infinity()) continue;
    const auto [i, j] = problem_.edges[edge];
    core::throw_joined<invalid_argument>(
        {problem_.caller, ": the pairwise cost of label ", a, " for ", problem_.element_name, " ", problem_.index[i],
         " and label ", b, " for ", problem_.element_name, " ", problem_.index[j], " is ",
         std::isnan(table[k]) ? std::string("not a number") : core::number_text(table[k]),
         "; it must be finite and 0 or more"});
  }
}

/// Whether a cut can find the best move of two neighbours with labels b and c: to label a, each of them or both. For
/// exchanges and for two labels c is b.
CONCINO_INLINE void label_costs::check_condition(std::size_t edge, const std::vector<double>& table) const {
  const bool expands = labels_ > 2 && options_.moves == label_moves::expansion;
  const auto cost = [&](int a, int b) {
    return table[static_cast<std::size_t>(a) * labels_ + static_cast<std::size_t>(b)];
  };
  for (int a = 0; a < num_labels(); ++a)
    for (int b = 0; b < num_labels(); ++b)
      for (int c = expands ? 0 : b; c < (expands ? num_labels() : b + 1); ++c) {
        const double before = cost(a, a) + cost(b, c), after = cost(a, c) + cost(b, a);
        if (before - after <= 4 * std::numeric_limits<double>::epsilon() * after) continue;
        if (!allows_both(edge, a, a) || !allows_both(edge, b, c)) continue;
        const auto [i, j] = problem_.edges[edge];
        core::throw_joined<invalid_argument>(
            {problem_.caller, ": the pairwise costs of ", problem_.element_name, " ", problem_.index[i], " and ",
             problem_.element_name, " ", problem_.index[j], " have cost(", a, ", ", a, ") + cost(", b, ", ", c,
             ") > cost(", a, ", ", c, ") + cost(", b, ", ", a, "); ",
             b == c ? "equal labels must not cost more than different ones"
                    : "expansions need the triangle inequality; label_moves::swap does not"});
      }
}

/// Calls f with an upper bound of the cost of each element and of each edge.
template<class F>
void label_costs::for_each_largest_cost(F&& f) const {
  for (std::size_t i = 0; i < num_elements(); ++i) {
    double largest = 0;
    for (std::size_t l = 0; l < labels_; ++l)
      if (allows(i, static_cast<int>(l))) largest = std::max(largest, std::abs(element_cost(i, l)));
    f(largest);
  }
  std::vector<double> table(problem_.pairwise ? labels_ * labels_ : 0);
  for (std::size_t e = 0; e < num_edges(); ++e) {
    if (problem_.pairwise) {
      read_pairwise_costs(e, table);
      check_condition(e, table);
      f(*std::max_element(table.begin(), table.end()));
    } else {
      f(options_.smoothness);
    }
  }
}

CONCINO_INLINE std::int64_t label_costs::of_all(const std::vector<int>& label) const {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < num_elements(); ++i) sum += of_element(i, label[i]);
  for (std::size_t e = 0; e < num_edges(); ++e)
    sum += of_edge(e, label[problem_.edges[e][0]], label[problem_.edges[e][1]]);
  return sum;
}

}  // namespace concino::detail
