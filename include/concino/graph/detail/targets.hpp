// target_set: the targets of a search, and whether enough of them were reached.
#pragma once

#include <concino/graph/detail/graph_of.hpp>

#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// A set of nodes, the targets. meet(slot) returns whether the search has now reached all of them, or the first if one
/// is enough.
class target_set {
  std::vector<unsigned char> is_target_;
  std::size_t left_ = 0;
  bool one_is_enough_ = false;

 public:
  template<class G>
  target_set(const G& g, const std::vector<typename G::node>& targets, bool one_is_enough, const char* caller)
      : one_is_enough_(one_is_enough) {
    if (targets.empty()) return;
    is_target_.resize(g.bound());
    for (const auto& t : targets) {
      expect_node(g, t, caller, "target");
      left_ += !std::exchange(is_target_[g.index(t)], static_cast<unsigned char>(1));
    }
  }

  bool meet(std::size_t slot) {
    if (left_ == 0 || !is_target_[slot]) return false;
    left_ = one_is_enough_ ? 0 : left_ - 1;
    return left_ == 0;
  }
};

}  // namespace concino::detail
