// Splits a polygon along diagonals.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// Splits one polygon after another and reuses its memory. Corners are numbers, each once in a polygon.
class polygon_splitter {
  std::vector<std::vector<std::uint32_t>> parts_;
  std::size_t n_ = 0;  // the parts of the current polygon; those behind are memory

  std::vector<std::uint32_t>& add() {
    if (n_ == parts_.size()) parts_.emplace_back();
    parts_[n_].clear();
    return parts_[n_++];
  }

 public:
  /// Starts with a whole polygon.
  void start(std::span<const std::uint32_t> corners) {
    n_ = 0;
    add().assign(corners.begin(), corners.end());
  }
  /// Splits the part that has both corners. Returns false if there is none: the diagonal crosses an earlier one.
  bool split(std::uint32_t a, std::uint32_t b) {
    for (std::size_t i = 0; i < n_; ++i) {
      const auto at_a = std::find(parts_[i].begin(), parts_[i].end(), a),
                 at_b = std::find(parts_[i].begin(), parts_[i].end(), b);
      if (at_a == parts_[i].end() || at_b == parts_[i].end()) continue;
      const auto first = std::min(at_a, at_b) - parts_[i].begin(), last = std::max(at_a, at_b) - parts_[i].begin();
      if (last - first == 1 || last - first + 1 == std::ssize(parts_[i])) return true;  // an edge of the part
      std::vector<std::uint32_t>& other = add();
      std::vector<std::uint32_t>& part = parts_[i];
      other.assign(part.begin() + first, part.begin() + last + 1);
      part.erase(part.begin() + first + 1, part.begin() + last);
      return true;
    }
    return false;
  }
  std::size_t num_parts() const { return n_; }
  std::span<const std::uint32_t> part(std::size_t i) const { return parts_[i]; }
};

}  // namespace concino::detail
