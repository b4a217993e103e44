// What labels are chosen for: elements, the pairs of neighbours, and what labels cost.
#pragma once

#include <concino/core/function_ref.hpp>
#include <concino/core/progress.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

enum class label_moves {
  expansion,  // one label takes any elements at once
  swap        // two labels exchange any elements at once: for more pairwise costs, with more cuts in each round
};

struct segment_options {
  int labels = 2;         // how many, 1 or more: the labels are 0, 1 ... labels - 1
  double smoothness = 1;  // 0 or more, in units of cost: what two adjacent elements with different labels cost. It is
                          // not used if the call has pairwise costs
  label_moves moves = label_moves::expansion;  // how the energy is reduced if there are three labels or more
  concino::progress progress = nullptr;        // called before each cut, with the fraction of the round's cuts
  concino::profiler* profiler = nullptr;       // measures the call and its steps
};

namespace detail {

/// Elements are numbered from 0, without gaps.
struct label_problem {
  const char* caller;                                // begins messages
  const char* element_name;                          // vert or poly
  std::vector<std::size_t> index;                    // by element: its index, for messages
  std::vector<double> costs;                         // by element: those of all labels; +inf: not allowed
  std::vector<std::array<std::uint32_t, 2>> edges;   // the pairs of adjacent elements
  function_ref<double(std::size_t edge, int label_of_first, int label_of_second)> pairwise;  // none: as smoothness says
};

}  // namespace detail

}  // namespace concino
