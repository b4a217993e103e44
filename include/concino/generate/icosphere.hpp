// Spheres of triangles of nearly equal size, by subdividing an icosahedron.
#pragma once

#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/subdivide_1_to_4.hpp>
#include <concino/mesh/trimesh.hpp>

namespace concino {

namespace detail {

/// The twelve verts and twenty triangles of the regular icosahedron on the unit sphere.
inline surface_arrays icosahedron() {
  surface_arrays a{{}, {}, {}, 3};
  const double golden = (1 + std::sqrt(5.0)) / 2, length = std::sqrt(1 + golden * golden);
  for (const double s : {-1.0, 1.0})
    for (const double t : {-golden, golden})
      for (std::size_t axis = 0; axis < 3; ++axis) {
        vec3 x;
        x[axis] = s / length;
        x[(axis + 1) % 3] = t / length;
        a.points.push_back(x);
      }
  // 1 / sqrt(5) if joined, else below 0
  const auto joined_by_edge = [&](std::size_t i, std::size_t j) { return dot(a.points[i], a.points[j]) > 0.4; };
  for (std::size_t i = 0; i < 12; ++i)
    for (std::size_t j = i + 1; j < 12; ++j)
      for (std::size_t k = j + 1; k < 12; ++k) {
        if (!joined_by_edge(i, j) || !joined_by_edge(j, k) || !joined_by_edge(k, i)) continue;
        const bool outward = dot(cross(a.points[i], a.points[j]), a.points[k]) > 0;
        for (const std::size_t v : {i, outward ? j : k, outward ? k : j}) a.verts.push_back(vert_id{v});
      }
  return a;
}

}  // namespace detail

/// A sphere of triangles of nearly the same size: an icosahedron whose triangles are split into four repeatedly on the
/// sphere.
/// Needs:  nothing.
/// Result: 20 * 4^subdivisions triangles, 10 * 4^subdivisions + 2 verts, all on the sphere, oriented outward.
/// Cost:   linear in these numbers.
/// Errors: invalid_argument if subdivisions is above 12 (there would be more polys than 32-bit descriptors), if radius
///         is not finite and above 0, or if centre is not finite.
/// Source: Baumgardner, Frederickson 1985, "Icosahedral discretization of the two-sphere".
inline trimesh icosphere(unsigned subdivisions, double radius = 1, const vec3& centre = {}) {
  if (subdivisions > 12)
    core::throw_joined<invalid_argument>({"icosphere: subdivisions is ", subdivisions, "; it must be at most 12"});
  detail::check_positive("icosphere", "radius", radius);
  detail::check_finite("icosphere", "centre", centre);
  trimesh m(detail::icosahedron());
  for (unsigned k = 0; k < subdivisions; ++k) {
    const std::size_t before = num_verts(m);
    m = subdivide_1_to_4(m);
    for (const vert_id v : verts(m))
      if (v.raw() >= before) set_point(m, v, point(m, v) / norm(point(m, v)));
  }
  for (const vert_id v : verts(m)) set_point(m, v, centre + radius * point(m, v));
  return m;
}

}  // namespace concino
