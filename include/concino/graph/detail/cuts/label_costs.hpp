// The costs of a label_problem as integers, after checks that cuts can reduce them.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/graph/detail/cuts/flow.hpp>
#include <concino/graph/detail/cuts/label_problem.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Needs:  the problem and the options stay alive.
/// Errors: invalid_argument that names the element or the pair of elements whose cost is wrong.
class label_costs {
  const label_problem& problem_;
  const segment_options& options_;
  std::size_t labels_;
  integer_scale scale_;

  double element_cost(std::size_t element, std::size_t label) const {
    return problem_.costs[element * labels_ + label];
  }
  double pairwise_cost(std::size_t edge, int a, int b) const;
  bool allows_both(std::size_t edge, int a, int b) const;
  void check_element_costs() const;
  void read_pairwise_costs(std::size_t edge, std::vector<double>& table) const;
  void check_condition(std::size_t edge, const std::vector<double>& table) const;
  template<class F> void for_each_largest_cost(F&& f) const;

 public:
  label_costs(const label_problem& problem, const segment_options& options);

  std::size_t num_elements() const { return problem_.index.size(); }
  std::size_t num_edges() const { return problem_.edges.size(); }
  int num_labels() const { return options_.labels; }
  const integer_scale& scale() const { return scale_; }
  bool allows(std::size_t element, int label) const;
  std::int64_t of_element(std::size_t element, int label) const {
    return scale_(element_cost(element, static_cast<std::size_t>(label)));
  }
  std::int64_t of_edge(std::size_t edge, int a, int b) const { return scale_(pairwise_cost(edge, a, b)); }
  std::int64_t of_all(const std::vector<int>& label) const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/graph/detail/cuts/label_costs.ipp>
#endif
