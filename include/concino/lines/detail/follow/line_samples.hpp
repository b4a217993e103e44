// Short segments of lines, by cells of a grid, to ask which of them are near a point.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/index_table.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/closest_point.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A straight segment of a line, whose middle is after `arc` of its length; of a part backwards, minus the length.
template<class M>
struct line_sample {
  vec3 from, to;
  poly_t<M> poly;
  std::size_t line = 0;
  double arc = 0;
};

template<class M>
class line_samples {
  double cell_;
  std::vector<line_sample<M>> all_;
  core::index_table numbers_;  // of samples, by the cells of their middles

  struct grid_cell { std::int64_t x, y, z; };
  grid_cell cell_of(const vec3& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x / cell_)), static_cast<std::int64_t>(std::floor(p.y / cell_)),
            static_cast<std::int64_t>(std::floor(p.z / cell_))};
  }
  static std::uint32_t hash(const grid_cell& c) {
    std::uint32_t h = 0;
    for (const std::int64_t x : {c.x, c.y, c.z}) h = core::index_table::hash(static_cast<std::uint64_t>(x), h);
    return h;
  }

 public:
  /// cell: at least the distances that are asked for, and half of the length of a segment.
  explicit line_samples(double cell) : cell_(cell) {}

  void add(const line_sample<M>& s) {
    numbers_.add(hash(cell_of(s.from + 0.5 * (s.to - s.from))), static_cast<std::uint32_t>(all_.size()));
    all_.push_back(s);
  }

  /// Whether is_hit(s) holds for a sample s that is nearer to x than `radius`.
  template<class F>
  bool any_near(const vec3& x, double radius, const F& is_hit) const {
    const auto is_near = [&](std::uint32_t i) {
      return distance(closest_point(x, all_[i].from, all_[i].to), x) < radius && is_hit(all_[i]);
    };
    const grid_cell c = cell_of(x);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz)
          if (numbers_.find(hash({c.x + dx, c.y + dy, c.z + dz}), is_near) != core::index_table::none) return true;
    return false;
  }
};

}  // namespace concino::detail
