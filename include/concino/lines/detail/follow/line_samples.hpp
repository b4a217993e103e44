// Short segments of lines, by cells of a grid, to ask which of them are near a point.
#pragma once

#include <concino/concepts/mesh.hpp>
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
  struct listed {
    line_sample<M> sample;
    std::int64_t next;
  };

  double cell_;
  std::vector<std::int64_t> first_ = std::vector<std::int64_t>(1024, -1);  // by hash of the cell
  std::vector<listed> all_;

  struct grid_cell { std::int64_t x, y, z; };
  grid_cell cell_of(const vec3& p) const {
    return {static_cast<std::int64_t>(std::floor(p.x / cell_)), static_cast<std::int64_t>(std::floor(p.y / cell_)), static_cast<std::int64_t>(std::floor(p.z / cell_))};
  }
  std::size_t slot(const grid_cell& c) const {
    const std::uint64_t h = (static_cast<std::uint64_t>(c.x) * 0x9e3779b97f4a7c15u) ^ (static_cast<std::uint64_t>(c.y) * 0xc2b2ae3d27d4eb4fu) ^
                            (static_cast<std::uint64_t>(c.z) * 0x165667b19e3779f9u);
    return static_cast<std::size_t>((h ^ h >> 29) & (first_.size() - 1));
  }
  void list(std::size_t i) {
    const line_sample<M>& s = all_[i].sample;
    std::int64_t& head = first_[slot(cell_of(s.from + 0.5 * (s.to - s.from)))];
    all_[i].next = head;
    head = static_cast<std::int64_t>(i);
  }

 public:
  /// cell: at least the distances that are asked for, and half of the length of a segment.
  explicit line_samples(double cell) : cell_(cell) {}

  void add(const line_sample<M>& s) {
    all_.push_back({s, -1});
    if (all_.size() <= first_.size()) return list(all_.size() - 1);
    first_.assign(2 * first_.size(), -1);
    for (std::size_t i = 0; i < all_.size(); ++i) list(i);
  }

  /// Whether is_hit(s) holds for a sample s that is nearer to x than `radius`.
  template<class F>
  bool any_near(const vec3& x, double radius, const F& is_hit) const {
    const grid_cell c = cell_of(x);
    for (std::int64_t dx = -1; dx <= 1; ++dx)
      for (std::int64_t dy = -1; dy <= 1; ++dy)
        for (std::int64_t dz = -1; dz <= 1; ++dz)
          for (std::int64_t i = first_[slot({c.x + dx, c.y + dy, c.z + dz})]; i >= 0; i = all_[static_cast<std::size_t>(i)].next) {
            const line_sample<M>& s = all_[static_cast<std::size_t>(i)].sample;
            if (distance(closest_point(x, s.from, s.to), x) < radius && is_hit(s)) return true;
          }
    return false;
  }
};

}  // namespace concino::detail
