// The ray tracer that pictures use unless another one is passed. It needs no package.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/ray_caster.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

namespace detail {
struct box_tree_ray;
}

/// Triangles in a tree of boxes, in which each node has up to eight children, and each leaf four triangles. Movable; several threads may use it at the same time.
///
/// No ray passes between two triangles that share an edge or a corner. If several triangles are hit at the same parameter, the result is the lowest number,
/// whatever the order in which they are tested. A triangle without area is never hit, nor one with a point that is not finite.
/// Cost of a ray: O(log n) if triangles are well distributed.      Errors of a ray: none.
/// Source: Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection"; the signs of its edge functions are exact here, in double precision.
class box_tree_caster {
 public:
  /// Needs:  coordinates that are at most 1e15 in absolute value, else distances can overflow.
  /// Cost:   O(n log n), in parallel, some 70 bytes for each triangle. The tree is the same for any number of threads.
  /// Errors: invalid_argument if a triangle names a point that the soup does not have; unsupported for more than 2^31 triangles.
  explicit box_tree_caster(const triangle_soup& soup);

  /// The first hit with a parameter in [t_near, t_far], from either side of the triangle.
  ray_hit intersect(const vec3& origin, const vec3& direction, double t_near, double t_far) const;

  /// Whether there is a hit with a parameter in [t_near, t_far].
  bool occluded(const vec3& origin, const vec3& direction, double t_near, double t_far) const;

  /// The same for up to 64 rays of one origin, in about half of the time: bit k of the result is occluded() of ray k.
  std::uint64_t occluded_rays(const vec3& origin, std::span<const vec3> directions, double t_near, double t_far) const;

 private:
  struct packet;
  struct builder;

  /// Eight boxes: bounds[2 * axis + (0: min, 1: max)]. A child is a node, or a block of triangles if its highest bit is set.
  struct alignas(64) node {
    float bounds[6][8];
    std::uint32_t child[8];
  };
  /// Up to four triangles, by corner and axis. A place without triangle has points that are not a number.
  struct alignas(32) block {
    float corner[3][3][4];
    std::uint32_t triangle[4];
  };
  static constexpr std::uint32_t is_block = std::uint32_t{1} << 31;

  std::vector<node> nodes_;
  std::vector<block> blocks_;
  std::array<float, 3> low_{}, high_{};  // of all triangles

  void test(const block& b, const detail::box_tree_ray& r, double t_near, ray_hit& best) const;
  void prefetch(std::uint32_t child) const {
    const bool leaf = child & is_block;
    const char* const at = leaf ? reinterpret_cast<const char*>(blocks_.data() + (child & ~is_block)) : reinterpret_cast<const char*>(nodes_.data() + child);
    for (std::size_t i = 0; i < (leaf ? sizeof(block) : sizeof(node)); i += 64) __builtin_prefetch(at + i);
  }
};

/// The ray tracer: box_tree_tracer{} as the last argument of render, best_view and ambient_occlusion, which is its default.
struct box_tree_tracer {
  box_tree_caster build(const triangle_soup& soup) const { return box_tree_caster(soup); }
};

static_assert(RayPacketCaster<box_tree_caster> && RayTracer<box_tree_tracer>);

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/box_tree_builder.ipp>
#include <concino/render/detail/box_tree_tracer.ipp>
#include <concino/render/detail/ray_packet.ipp>
#endif
