// Cylinders: make_cylinder<M>() returns the closed surface, or the solid cylinder if M is a volume.
#pragma once

#include <concino/core/message.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/detail/shapes/quad_disk.hpp>

#include <array>

namespace concino {

struct cylinder_options {
  std::array<std::size_t, 2> cells = {32, 8};  // around the axis, rounded up to a multiple of 4, and along it; 1 or
                                               // more
  double radius = 1;                           // finite, above 0
  double height = 1;                           // finite, above 0
  vec3 centre = {0, 0, 0};                     // of the base, finite; the axis runs along z from there
};

namespace detail {

/// The point of a cylinder over point x of the disk, at level `level` of options.cells[1].
inline vec3 in_cylinder(const cylinder_options& o, const vec3& x, std::size_t level) {
  return o.centre + vec3{o.radius * x.x, o.radius * x.y,
                         o.height * (static_cast<double>(level) / static_cast<double>(o.cells[1]))};
}

/// The disks at both ends, and rings of quads between them. Verts are numbered from the base to the top.
inline surface_arrays quad_cylinder(const cylinder_options& o) {
  const std::size_t n = (o.cells[0] + 3) / 4, around = 4 * n, levels = o.cells[1];
  const surface_arrays disk = quad_disk(n);
  const std::size_t lid = disk.points.size(), first_on_circle = lid - around, top = lid + (levels - 1) * around;
  surface_arrays a{{}, {}, {}, 4};
  a.points.reserve(top + lid), a.verts.reserve(2 * disk.verts.size() + 4 * levels * around);
  for (const vec3& x : disk.points) a.points.push_back(in_cylinder(o, x, 0));
  for (std::size_t level = 1; level < levels; ++level)
    for (std::size_t k = 0; k < around; ++k)
      a.points.push_back(in_cylinder(o, disk.points[first_on_circle + k], level));
  for (const vec3& x : disk.points) a.points.push_back(in_cylinder(o, x, levels));
  for (std::size_t q = 0; q < disk.verts.size(); q += 4)
    for (const std::size_t k : {0u, 3u, 2u, 1u}) a.verts.push_back(disk.verts[q + k]);
  const auto number = [&](std::size_t level, std::size_t k) {
    return level == 0        ? first_on_circle + k
           : level == levels ? top + first_on_circle + k
                             : lid + (level - 1) * around + k;
  };
  for (std::size_t level = 0; level < levels; ++level)
    for (std::size_t k = 0; k < around; ++k) {
      const std::size_t next = (k + 1) % around;
      for (const std::size_t v : {number(level, k), number(level, next), number(level + 1, next), number(level + 1, k)})
        a.verts.push_back(vert_id{v});
    }
  for (const vert_id v : disk.verts) a.verts.push_back(vert_id{top + v.raw()});
  return a;
}

inline cell_arrays hex_cylinder(const cylinder_options& o) {
  const surface_arrays disk = quad_disk((o.cells[0] + 3) / 4);
  const std::size_t layer = disk.points.size(), levels = o.cells[1];
  cell_arrays a{{}, {}, 8};
  a.points.reserve((levels + 1) * layer), a.verts.reserve(2 * levels * disk.verts.size());
  for (std::size_t level = 0; level <= levels; ++level)
    for (const vec3& x : disk.points) a.points.push_back(in_cylinder(o, x, level));
  for (std::size_t level = 0; level < levels; ++level)
    for (std::size_t q = 0; q < disk.verts.size(); q += 4)
      for (const std::size_t at : {level, level + 1})
        for (std::size_t k = 0; k < 4; ++k) a.verts.push_back(vert_id{at * layer + disk.verts[q + k].raw()});
  return a;
}

}  // namespace detail

/// A cylinder along z, closed by disks and oriented outward. If M is a volume: a solid cylinder.
/// Needs:  M is one of the six native meshes, or a mesh that can add verts and polys.
/// Result: cells[1] rings of quads between two disks. A disk has a core of n x n quads, n = cells[0] / 4 rounded up,
///         and (n + 1) / 2 rings of 4 n quads around it. Triangles: two per quad; polygons of any size: the quads.
///         Volumes: cells[1] layers of a hex over each quad of the disk; tets, six per hex; or the hexes as polyhedra.
/// Cost:   O(verts) time and memory.
/// Errors: invalid_argument that names the field: no cells or more than 32-bit descriptors, a radius or height that is
///         not finite and above 0, a centre that is not finite. unsupported if a mesh of another library refuses a
///         poly.
/// Source: tets by Dompierre et al. 1999.
template<requirement::can_be_generated M>
M make_cylinder(const cylinder_options& options = {}) {
  for (const std::size_t k : {0u, 1u})
    detail::check_at_least("make_cylinder", core::joined({"cells[", k, "]"}), options.cells[k], 1);
  detail::check_positive("make_cylinder", "radius", options.radius);
  detail::check_positive("make_cylinder", "height", options.height);
  detail::check_finite("make_cylinder", "centre", options.centre);
  const double n = static_cast<double>(options.cells[0]) / 4 + 1, levels = static_cast<double>(options.cells[1]),
               disk = n * n + 2 * n * (n + 1);
  if constexpr (dimension_v<M> == 3) {  // a volume is a solid cylinder, a surface its boundary
    detail::check_element_counts<M>("make_cylinder", "cells", (levels + 1) * (disk + 2 * n), levels * disk);
    return detail::construct_from_hexes<M>(detail::hex_cylinder(options));
  } else {
    detail::check_element_counts<M>("make_cylinder", "cells", 2 * disk + (levels + 1) * 4 * n,
                                    2 * disk + levels * 4 * n);
    return detail::construct_from_quads<M>(detail::quad_cylinder(options));
  }
}

// What to write instead of calls that cannot compile.
template<class M, class R = mistake::remedy<mistake::include_adapter>>
  requires(!requirement::is_adapted<M>)
M make_cylinder(...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter

}  // namespace concino
