// Rounds of moves, each the best by one minimum cut; see labels.hpp.
#pragma once

#include <concino/graph/detail/cuts/flow.hpp>
#include <concino/graph/detail/cuts/label_costs.hpp>
#include <concino/graph/detail/cuts/labels.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace concino::detail {

/// The labels of all elements, and moves that give each of them one of two labels.
class label_search {
  const label_problem& problem_;
  label_costs costs_;
  std::vector<int> label_;
  std::int64_t energy_ = 0;

  static constexpr std::uint32_t no_node = std::numeric_limits<std::uint32_t>::max();

  /// The two labels between which a move chooses for an element: that on the source's side of the cut, and the other.
  struct choice { int first, second; };

  /// The network whose cuts are the choices.
  /// node: by element, its node, or no_node if its labels are equal.
  /// Source: Kolmogorov, Zabih 2004, "What energy functions can be minimized via graph cuts?".
  flow_network network_of(const std::vector<choice>& choices, const std::vector<std::uint32_t>& node,
                          std::size_t nodes) const {
    flow_network network{std::vector<std::int64_t>(nodes), {}};
    for (std::size_t i = 0; i < choices.size(); ++i)
      if (node[i] != no_node)
        network.terminals[node[i]] +=
            costs_.of_element(i, choices[i].second) - costs_.of_element(i, choices[i].first);
    for (std::size_t e = 0; e < problem_.edges.size(); ++e) {
      const auto [i, j] = problem_.edges[e];
      const std::uint32_t x = node[i], y = node[j];
      if (x == no_node && y == no_node) continue;
      const choice p = choices[i], q = choices[j];
      const std::int64_t both_first = costs_.of_edge(e, p.first, q.first);
      const std::int64_t i_second = costs_.of_edge(e, p.second, q.first);
      const std::int64_t j_second = costs_.of_edge(e, p.first, q.second);
      if (y == no_node) {
        network.terminals[x] += i_second - both_first;
      } else if (x == no_node) {
        network.terminals[y] += j_second - both_first;
      } else {
        const std::int64_t both_second = costs_.of_edge(e, p.second, q.second);
        // Rounding can make the capacity negative; it is 0 then.
        const std::int64_t capacity = std::max<std::int64_t>(i_second + j_second - both_first - both_second, 0);
        const std::int64_t back = capacity / 2;
        network.terminals[x] += i_second - both_first - back;
        network.terminals[y] += both_second - i_second + back;
        if (capacity > 0) network.edges.push_back({x, y, capacity - back, back});
      }
    }
    return network;
  }

 public:
  label_search(const label_problem& problem, const segment_options& options)
      : problem_(problem), costs_(problem, options), label_(problem.index.size()) {
    for (std::size_t i = 0; i < label_.size(); ++i) {
      while (!costs_.allows(i, label_[i])) ++label_[i];
      for (int l = label_[i] + 1; l < options.labels; ++l)
        if (costs_.allows(i, l) && costs_.of_element(i, l) < costs_.of_element(i, label_[i])) label_[i] = l;
    }
    energy_ = costs_.of_all(label_);
  }

  double energy() const { return costs_.scale().back(energy_); }
  int scale_exponent() const { return costs_.scale().exponent; }
  const std::vector<int>& labels() const { return label_; }

  /// Gives elements the best of the labels between which choose(label) chooses, all at once.
  /// Result: false if that does not reduce the energy; then all labels stay.
  template<class F>
  bool move(const F& choose) {
    std::vector<choice> choices(label_.size());
    std::vector<std::uint32_t> node(label_.size(), no_node);
    std::uint32_t nodes = 0;
    for (std::size_t i = 0; i < label_.size(); ++i) {
      choices[i] = choose(label_[i]);
      const auto [first, second] = choices[i];
      if (first == second || !costs_.allows(i, first) || !costs_.allows(i, second)) choices[i] = {label_[i], label_[i]};
      else node[i] = nodes++;
    }
    if (nodes == 0) return false;
    const std::vector<unsigned char> is_first = source_side(network_of(choices, node, nodes), problem_.caller);
    std::vector<int> moved(label_.size());
    for (std::size_t i = 0; i < label_.size(); ++i)
      moved[i] = node[i] != no_node && is_first[node[i]] ? choices[i].first : choices[i].second;
    const std::int64_t energy = costs_.of_all(moved);
    if (energy >= energy_) return false;
    label_ = std::move(moved);
    energy_ = energy;
    return true;
  }

  /// Any elements take label a.
  bool expand(int a) {
    return move([&](int l) { return choice{a, l}; });
  }

  /// Any elements with label a or b take the other of them.
  bool exchange(int a, int b) {
    return move([&](int l) { return l == a || l == b ? choice{a, b} : choice{l, l}; });
  }
};

CONCINO_INLINE element_labels find_labels(const label_problem& problem, const segment_options& options) {
  label_search search(problem, options);
  element_labels result{{}, {search.energy()}, search.scale_exponent()};
  const int n = options.labels;
  const bool expands = n > 2 && options.moves == label_moves::expansion;
  const int moves = expands ? n : n * (n - 1) / 2;
  bool is_better = moves > 0;
  while (is_better) {
    is_better = false;
    int done = 0;
    const auto report = [&] {
      report_progress(options.progress, static_cast<double>(done++) / static_cast<double>(moves), problem.caller);
    };
    for (int a = 0; a < n; ++a) {
      if (expands) {
        report();
        is_better |= search.expand(a);
        continue;
      }
      for (int b = a + 1; b < n; ++b) {
        report();
        is_better |= search.exchange(a, b);
      }
    }
    if (is_better) result.rounds.push_back(search.energy());
    if (n == 2) break;  // the first cut is the best
  }
  result.label = search.labels();
  return result;
}

}  // namespace concino::detail
