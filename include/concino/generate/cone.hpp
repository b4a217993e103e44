// Cones and truncated cones: make_cone<M>() returns the closed surface, or the solid cone if M is a volume.
#pragma once

#include <concino/generate/cylinder.hpp>
#include <concino/generate/detail/shapes/quad_disk.hpp>
#include <concino/generate/sphere.hpp>

#include <cmath>
#include <cstdint>

namespace concino {

struct cone_options {
  std::size_t cells = 8;    // along a quarter of the circle of the base, 1 or more, rounded up to an even number
  double radius = 1;        // of the base, finite, above 0
  double top_radius = 0;    // finite, 0 or more; 0: the cone ends at its apex, else at a disk
  double height = 1;        // finite, above 0
  vec3 centre = {0, 0, 0};  // of the base, finite; the axis runs along z from there
};

namespace detail {

/// The polys of which no vert is below z = 0, and their verts, in the same order.
template<class Arrays>
Arrays upper_half(const Arrays& whole) {
  Arrays half = whole;
  half.points.clear(), half.verts.clear();
  std::vector<std::uint32_t> number(whole.points.size(), ~0u);
  for (std::size_t v = 0; v < whole.points.size(); ++v) {
    if (!(whole.points[v].z >= 0)) continue;
    number[v] = static_cast<std::uint32_t>(half.points.size());
    half.points.push_back(whole.points[v]);
  }
  for (std::size_t i = 0; i < whole.verts.size(); i += whole.arity) {
    bool is_above = true;
    for (std::size_t k = 0; k < whole.arity; ++k) is_above = is_above && number[whole.verts[i + k].raw()] != ~0u;
    if (!is_above) continue;
    for (std::size_t k = 0; k < whole.arity; ++k) half.verts.push_back(vert_id{number[whole.verts[i + k].raw()]});
  }
  return half;
}

/// The upper half of a sphere, closed by a disk. The verts on the circle are those of the half sphere.
inline surface_arrays closed_half_sphere(std::size_t n) {
  surface_arrays a = upper_half(cube_sphere(n));
  const surface_arrays disk = quad_disk(n);
  const std::size_t inside = disk.points.size() - 4 * n, first = a.points.size();
  std::vector<std::uint32_t> number(disk.points.size());
  for (std::size_t v = 0; v < inside; ++v) number[v] = static_cast<std::uint32_t>(first + v);
  // The first verts of the half sphere are those at z = 0, around the square from its first corner like those of the
  // disk.
  for (std::size_t k = 0; k < 4 * n; ++k) number[inside + k] = static_cast<std::uint32_t>(k);
  a.points.insert(a.points.end(), disk.points.begin(), disk.points.begin() + static_cast<std::ptrdiff_t>(inside));
  for (std::size_t q = 0; q < disk.verts.size(); q += 4)
    for (const std::size_t k : {0u, 3u, 2u, 1u}) a.verts.push_back(vert_id{number[disk.verts[q + k].raw()]});
  return a;
}

/// Maps the upper half of the unit ball to a cone along the rays from the centre of the base.
template<class Arrays>
Arrays as_cone(Arrays a, const cone_options& o) {
  for (vec3& x : a.points) {
    const double across = std::hypot(x.x, x.y) + x.z, factor = across > 0 ? norm(x) / across : 0;
    x = o.centre + vec3{o.radius * factor * x.x, o.radius * factor * x.y, o.height * factor * x.z};
  }
  return a;
}

/// Maps a cylinder of radius 1 and height 1 to a truncated cone.
template<class Arrays>
Arrays as_truncated_cone(Arrays a, const cone_options& o) {
  for (vec3& x : a.points) {
    const double radius = x.z == 1 ? o.top_radius : o.radius + x.z * (o.top_radius - o.radius);
    x = o.centre + vec3{radius * x.x, radius * x.y, o.height * x.z};
  }
  return a;
}

/// Errors: those of make_cone, for its arguments.
inline void check_cone(const cone_options& o) {
  check_at_least("make_cone", "cells", o.cells, 1);
  check_positive("make_cone", "radius", o.radius);
  check_positive("make_cone", "height", o.height);
  check_finite("make_cone", "centre", o.centre);
  if (!(o.top_radius >= 0 && std::isfinite(o.top_radius)))
    core::throw_joined<invalid_argument>(
        {"make_cone: top_radius is ", core::number_text(o.top_radius), "; it must be finite and not below 0"});
}

}  // namespace detail

/// A cone along z, closed by a disk, or by two if options.top_radius is above 0, and oriented outward. If M is a
/// volume: a solid cone.
/// Needs:  M is one of the six native meshes, or a mesh that can add verts and polys.
/// Result: the upper half of make_sphere, with the base, moved along rays from the centre of the base. So the apex is a
///         vert of four quads, or of one hex at each quad. Quads: 3 cells^2 and those of the base; triangles: two per
///         quad; polygons of any size: the quads. Volumes: hexes; tets, six per hex; or the hexes as polyhedra. All
///         verts of the boundary lie on the cone. A truncated cone is as make_cylinder with `cells` cells along a
///         quarter of the circle, and as many along the axis.
/// Cost:   O(verts) time and memory.
/// Errors: invalid_argument that names the field: no cells or more than 32-bit descriptors, a radius or height that is
///         not finite and above 0, a centre that is not finite, a top radius that is not finite or below 0. unsupported
///         if a mesh of another library refuses a poly.
/// Source: as make_sphere.
template<requirement::can_be_generated M>
M make_cone(const cone_options& options = {}) {
  detail::check_cone(options);
  const double n = static_cast<double>(options.cells) + 1, boundary_quads = (options.top_radius > 0 ? 11 : 6) * n * n;
  const std::size_t even = options.cells + options.cells % 2;
  if constexpr (dimension_v<M> == 3) {  // a volume is a solid cone, a surface its boundary
    detail::check_element_counts<M>("make_cone", "cells",
                                    (n + 1) * (n + 1) * (n + 1) + (n + 1) / 2 * (boundary_quads + 2),
                                    n * n * n + (n + 1) / 2 * boundary_quads);
    if (options.top_radius > 0)
      return detail::construct_from_hexes<M>(
          detail::as_truncated_cone(detail::hex_cylinder({.cells = {4 * even, even}}), options));
    return detail::construct_from_hexes<M>(detail::as_cone(detail::upper_half(detail::hex_ball(even)), options));
  } else {
    detail::check_element_counts<M>("make_cone", "cells", 2 * boundary_quads, boundary_quads);
    if (options.top_radius > 0)
      return detail::construct_from_quads<M>(
          detail::as_truncated_cone(detail::quad_cylinder({.cells = {4 * even, even}}), options));
    return detail::construct_from_quads<M>(detail::as_cone(detail::closed_half_sphere(even), options));
  }
}

// What to write instead of calls that cannot compile.
template<class M, class R = mistake::remedy<mistake::include_adapter>>
  requires(!requirement::is_adapted<M>)
M make_cone(...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter

}  // namespace concino
