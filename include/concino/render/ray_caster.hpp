// The concepts of ray casters and ray tracers that render() needs. Models: <concino/render/box_tree_tracer.hpp>, the default, and the adapter
// <concino/adapters/embree.hpp>.
#pragma once

#include <concino/core/vec3.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino {

/// Triangles in single precision, within about one unit of the origin.
struct triangle_soup {
  std::vector<std::array<float, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// The intersection of a ray with a triangle (a, b, c): the point (1-u-v) a + u b + v c = origin + t direction.
struct ray_hit {
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  std::uint32_t triangle = none;
  double u = 0, v = 0, t = 0;

  explicit operator bool() const { return triangle != none; }
};

/// A ray caster: intersects rays with triangles, from several threads at once. It reports hits with t within [t_near, t_far].
template<class C> concept RayCaster = requires(const C& c, const vec3& origin, const vec3& direction, double t_near, double t_far) {
  { c.intersect(origin, direction, t_near, t_far) } -> std::convertible_to<ray_hit>;
  { c.occluded(origin, direction, t_near, t_far) } -> std::convertible_to<bool>;
};

/// A ray caster that can also cast up to 64 rays of one origin together, which may take less time: bit k says what occluded() says of ray k.
template<class C> concept RayPacketCaster =
    RayCaster<C> && requires(const C& c, const vec3& origin, std::span<const vec3> directions, double t_near, double t_far) {
      { c.occluded_rays(origin, directions, t_near, t_far) } -> std::same_as<std::uint64_t>;
    };

/// A ray tracer: builds a ray caster for triangles.
template<class T> concept RayTracer = requires(const T& t, const triangle_soup& soup) {
  { t.build(soup) } -> RayCaster;
};

namespace detail {

constexpr std::size_t max_rays_together = 64;

/// Bit k: whether ray k is occluded. Needs: at most 64 directions.
template<RayCaster C>
std::uint64_t occluded_rays(const C& c, const vec3& origin, std::span<const vec3> directions, double t_near, double t_far) {
  if constexpr (RayPacketCaster<C>) {
    return c.occluded_rays(origin, directions, t_near, t_far);
  } else {
    std::uint64_t result = 0;
    for (std::size_t k = 0; k < directions.size(); ++k)
      result |= std::uint64_t{static_cast<bool>(c.occluded(origin, directions[k], t_near, t_far))} << k;
    return result;
  }
}

}  // namespace detail

}  // namespace concino
