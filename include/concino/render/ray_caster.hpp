// The concepts of ray casters and ray tracers that render() needs. Models: <concino/render/box_tree_tracer.hpp>, the
// default, and the adapter <concino/adapters/embree.hpp>.
#pragma once

#include <concino/core/vec3.hpp>

#include <array>
#include <concepts>
#include <cstdint>
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

/// A ray caster: intersects rays with triangles, from several threads at once. It reports hits with t within [t_near,
/// t_far].
template<class C>
concept RayCaster = requires(const C& c, const vec3& origin, const vec3& direction, double t_near, double t_far) {
  { c.intersect(origin, direction, t_near, t_far) } -> std::convertible_to<ray_hit>;
  { c.occluded(origin, direction, t_near, t_far) } -> std::convertible_to<bool>;
};

/// A ray tracer: builds a ray caster for triangles.
template<class T> concept RayTracer = requires(const T& t, const triangle_soup& soup) {
  { t.build(soup) } -> RayCaster;
};

}  // namespace concino
