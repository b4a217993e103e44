// Colours of the verts of OBJ files, whose components are numbers from 0 to 1, or integers from 0 to 255.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/io/file_contents.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The colours of the verts that have one, in the order of the file. The others are white.
class obj_vert_colors {
  element_values<rgba>& colors_;
  double largest_ = 0;                    // component
  bool are_bytes_ = true;                 // all components are whole numbers up to 255
  std::vector<std::uint32_t> uncolored_;  // verts without a colour before the last one that has one

 public:
  explicit obj_vert_colors(element_values<rgba>& colors) : colors_(colors) {}

  /// is_whole: whether all three components are whole numbers.
  void add(std::size_t vert, const double (&x)[3], bool is_whole) {
    const double largest = std::max({x[0], x[1], x[2]});
    are_bytes_ = are_bytes_ && is_whole && largest <= 255;
    largest_ = std::max(largest_, largest);
    for (std::size_t v = colors_.size(); v < vert; ++v) uncolored_.push_back(static_cast<std::uint32_t>(v));
    colors_.resize(vert);
    colors_.push_back(rgba{static_cast<float>(x[0]), static_cast<float>(x[1]), static_cast<float>(x[2])});
  }

  /// Call it after the last vert. Divides integers by 255.
  /// Result: whether it did.
  bool finish(std::size_t num_verts) {
    if (colors_.empty()) return false;
    const bool is_scaled = are_bytes_ && largest_ > 1;
    std::size_t next = 0;
    for (std::size_t v = 0; is_scaled && v < colors_.size(); ++v) {
      rgba& c = colors_[v];
      if (next < uncolored_.size() && uncolored_[next] == v) ++next;
      else c = {c.r / 255, c.g / 255, c.b / 255};
    }
    colors_.resize(num_verts);
    return is_scaled;
  }
};

}  // namespace concino::detail
