// Labels of nodes with the smallest energy: costs of labels, and of pairs of labels at the ends of edges.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/graph/detail/cuts/label_problem.hpp>

#include <vector>

namespace concino::detail {

struct element_labels {
  std::vector<int> label;
  std::vector<double> rounds;  // the energy at the start and after each round
  int scale_exponent = 0;
};

/// Labels as segment_polys describes them.
element_labels find_labels(const label_problem& problem, const segment_options& options);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/graph/detail/cuts/labels.ipp>
#endif
