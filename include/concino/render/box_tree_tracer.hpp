// The ray tracer that pictures use unless another one is passed. It needs no package.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/ray_caster.hpp>

#include <cstdint>
#include <vector>

namespace concino {

/// Triangles in a binary tree of boxes, with up to four triangles in each leaf. Movable; several threads may use it at
/// the same time.
///
/// No ray passes between two triangles that share an edge or a corner. If several triangles are hit at the same
/// parameter, the result is the lowest number, whatever the order in which they are tested. A triangle without area is
/// never hit, nor one with a point that is not finite. Cost of a ray: O(log n) if triangles are well distributed.     
/// Errors of a ray: none.
/// Source: Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection"; the signs of its edge functions are
///         exact here, in double precision.
class box_tree_caster {
 public:
  /// Needs:  coordinates that are at most 1e15 in absolute value, else distances can overflow.
  /// Cost:   O(n log n), in parallel, some 70 bytes for each triangle. The tree is the same for any number of threads.
  /// Errors: invalid_argument if a triangle names a point that the soup does not have; unsupported for more than 2^31
  ///         triangles.
  explicit box_tree_caster(const triangle_soup& soup);

  /// The first hit with a parameter in [t_near, t_far], from either side of the triangle.
  ray_hit intersect(const vec3& origin, const vec3& direction, double t_near, double t_far) const;

  /// Whether there is a hit with a parameter in [t_near, t_far].
  bool occluded(const vec3& origin, const vec3& direction, double t_near, double t_far) const;

 private:
  /// A leaf has the triangles [first, first + count). An inner node has count 0 and the children first and first + 1.
  struct node {
    float bounds[2][3];  // min, max
    std::uint32_t first, count;
  };
  struct triangle {
    float corner[3][3];
    std::uint32_t number;
  };

  std::vector<node> nodes_;
  std::vector<triangle> triangles_;

  void add_boxes();
  ray_hit search(const vec3& origin, const vec3& direction, double t_near, double t_far, bool any) const;
};

/// The ray tracer: box_tree_tracer{} as the last argument of render, best_view and ambient_occlusion, which is its
/// default.
struct box_tree_tracer {
  box_tree_caster build(const triangle_soup& soup) const { return box_tree_caster(soup); }
};

static_assert(RayCaster<box_tree_caster> && RayTracer<box_tree_tracer>);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/trace/box_tree_builder.ipp>
#include <concino/render/detail/trace/box_tree_tracer.ipp>
#endif
