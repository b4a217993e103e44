// Colours of OFF files, whose components are integers from 0 to 255, or numbers from 0 to 1.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/io/file_contents.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The numbers of a colour: integers from 0 to 255, or reals from 0 to 1.
struct off_color {
  double x[4] = {0, 0, 0, 0};
  std::uint32_t size = 0;
  bool whole = true;

  double largest() const { return std::max({x[0], x[1], x[2], x[3]}); }
  double smallest() const { return std::min({x[0], x[1], x[2], x[3]}); }
  rgba color() const {
    rgba c;
    float* const components[] = {&c.r, &c.g, &c.b, &c.a};
    for (std::uint32_t i = 0; i < size; ++i) *components[i] = static_cast<float>(whole ? x[i] / 255 : x[i]);
    return c;
  }
};

/// The colours of the verts, in the order of the file.
class off_vert_colors {
  element_values<rgba>& colors_;
  std::vector<std::uint32_t> whole_;  // verts whose colours are integers, all 0 or 1
  std::uint64_t largest_ = 0;         // integer of all colours

 public:
  explicit off_vert_colors(element_values<rgba>& colors) : colors_(colors) {}

  void add(const off_color& c) {
    if (c.whole) {
      largest_ = std::max(largest_, static_cast<std::uint64_t>(c.largest()));
      if (largest_ < 2) whole_.push_back(static_cast<std::uint32_t>(colors_.size()));
    }
    colors_.push_back(c.color());
  }

  /// Call it after the last vert. Scales integers so that 1 is full intensity, if none is larger.
  /// Result: whether there were any.
  bool rescale() {
    if (largest_ >= 2 || whole_.empty()) return false;
    for (const std::uint32_t v : whole_) {
      rgba& c = colors_[v];
      for (float* const component : {&c.r, &c.g, &c.b, &c.a}) *component = *component > 0 ? 1.0f : 0.0f;
    }
    return true;
  }
};

}  // namespace concino::detail
