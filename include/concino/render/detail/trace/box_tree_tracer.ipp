// The first triangle of box_tree_tracer.hpp that a ray hits.
#pragma once

#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/trace/box_tree_ray.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace concino {

/// The first hit, or `any`. The nearer child is searched first.
CONCINO_INLINE ray_hit box_tree_caster::search(const vec3& origin, const vec3& direction, double t_near, double t_far,
                                               bool any) const {
  struct entry {
    std::uint32_t node;
    float t;
  };
  ray_hit best;
  if (nodes_.empty()) return best;
  const detail::box_tree_ray r(origin, direction, nodes_[0].bounds[0], nodes_[0].bounds[1]);
  best.t = t_far;
  const float near = static_cast<float>(t_near);
  entry later[128];  // one for each level of a tree of 2^31 triangles
  std::size_t waiting = 0;
  later[waiting++] = {0, near};
  while (waiting > 0 && !(any && best)) {
    const entry e = later[--waiting];
    const float far = static_cast<float>(best.t);
    if (!(e.t <= far)) continue;
    const node& n = nodes_[e.node];
    for (std::uint32_t i = n.first; i < n.first + n.count; ++i)
      r.test(triangles_[i].corner, triangles_[i].number, t_near, best);
    if (n.count > 0) continue;
    entry left{n.first, r.entry(nodes_[n.first].bounds, near, far)},
        right{n.first + 1, r.entry(nodes_[n.first + 1].bounds, near, far)};
    if (left.t < right.t) std::swap(left, right);
    for (const entry& child : {left, right})
      if (child.t < std::numeric_limits<float>::infinity()) later[waiting++] = child;
  }
  return best ? best : ray_hit{};
}

CONCINO_INLINE ray_hit box_tree_caster::intersect(const vec3& origin, const vec3& direction, double t_near,
                                                  double t_far) const {
  return search(origin, direction, t_near, t_far, false);
}

CONCINO_INLINE bool box_tree_caster::occluded(const vec3& origin, const vec3& direction, double t_near,
                                              double t_far) const {
  return static_cast<bool>(search(origin, direction, t_near, t_far, true));
}

}  // namespace concino
