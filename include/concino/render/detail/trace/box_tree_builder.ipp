// The tree of box_tree_tracer.hpp is built.
#pragma once

#include <concino/core/box_tree_builder.hpp>
#include <concino/core/error.hpp>
#include <concino/render/box_tree_tracer.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino {

namespace detail {

/// The boxes of the triangles whose points are finite.
CONCINO_INLINE std::vector<core::box_item> boxes_of(const triangle_soup& soup) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  std::vector<core::box_item> items;
  items.reserve(soup.triangles.size());
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    core::box_item item{{inf, inf, inf}, {-inf, -inf, -inf}, static_cast<std::uint32_t>(i)};
    bool finite = true;
    for (const std::uint32_t p : soup.triangles[i]) {
      if (p >= soup.points.size())
        core::throw_joined<invalid_argument>(
            {"box_tree_tracer: triangle ", i, " names point ", p, " of ", soup.points.size()});
      for (std::size_t k = 0; k < 3; ++k) {
        const float x = soup.points[p][k];
        finite = finite && std::isfinite(x);
        item.min[k] = std::min(item.min[k], x);
        item.max[k] = std::max(item.max[k], x);
      }
    }
    if (finite) items.push_back(item);
  }
  return items;
}

}  // namespace detail

/// The boxes of children lie in those of their parents, which precede them.
CONCINO_INLINE void box_tree_caster::add_boxes() {
  constexpr float inf = std::numeric_limits<float>::infinity();
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    node& n = nodes_[i];
    for (std::size_t k = 0; k < 3; ++k) {
      n.bounds[0][k] = inf;
      n.bounds[1][k] = -inf;
      const auto add = [&](float low, float high) {
        n.bounds[0][k] = std::min(n.bounds[0][k], low);
        n.bounds[1][k] = std::max(n.bounds[1][k], high);
      };
      for (std::uint32_t t = n.first; t < n.first + n.count; ++t)
        for (const auto& corner : triangles_[t].corner) add(corner[k], corner[k]);
      if (n.count == 0)
        for (const std::uint32_t child : {n.first, n.first + 1})
          add(nodes_[child].bounds[0][k], nodes_[child].bounds[1][k]);
    }
  }
}

CONCINO_INLINE box_tree_caster::box_tree_caster(const triangle_soup& soup) {
  if (soup.triangles.size() > std::size_t{1} << 31) throw unsupported("box_tree_tracer: more than 2^31 triangles");
  std::vector<core::box_item> items = detail::boxes_of(soup);
  nodes_ = core::box_tree_builder<node>(items, 4)();
  triangles_.reserve(items.size());
  for (const core::box_item& item : items) {
    triangle& t = triangles_.emplace_back();
    t.number = item.id;
    for (std::size_t c = 0; c < 3; ++c) std::copy_n(soup.points[soup.triangles[item.id][c]].begin(), 3, t.corner[c]);
  }
  add_boxes();
}

}  // namespace concino
