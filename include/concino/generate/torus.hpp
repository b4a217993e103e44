// Tori: make_torus<M>() returns the surface, or the solid torus if M is a volume.
#pragma once

#include <concino/core/message.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/detail/shapes/quad_disk.hpp>

namespace concino {

struct torus_options {
  std::array<std::size_t, 2> cells = {32, 16};  // around the axis, and around the tube; 3 or more
  double radius = 1;                            // of the circle in the middle of the tube; finite, above 0
  double tube_radius = 0.4;                     // above 0, below radius
  vec3 centre = {0, 0, 0};                      // the axis passes through it along z
};

namespace detail {

/// A point of the solid torus: at the fraction `turn` of a whole turn around the axis, with coordinates `out` and `up`
/// in the disk of the tube.
inline vec3 in_torus(const torus_options& o, double turn, double out, double up) {
  const double angle = 6.28318530717958647692 * turn, far = o.radius + o.tube_radius * out;
  return o.centre + vec3{far * std::cos(angle), far * std::sin(angle), o.tube_radius * up};
}

/// A point of the torus. Its coordinates around the axis and around the tube are in cells.
inline vec3 on_torus(const torus_options& o, double around, double tube) {
  const double angle = 6.28318530717958647692 * (tube / static_cast<double>(o.cells[1]));
  return in_torus(o, around / static_cast<double>(o.cells[0]), std::cos(angle), std::sin(angle));
}

inline surface_arrays quad_torus(const torus_options& o) {
  const auto [n, k] = o.cells;
  surface_arrays a{{}, {}, {}, 4};
  for (std::size_t j = 0; j < k; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      a.points.push_back(on_torus(o, static_cast<double>(i), static_cast<double>(j)));
      const std::size_t right = (i + 1) % n, up = (j + 1) % k;
      for (const std::size_t v : {j * n + i, j * n + right, up * n + right, up * n + i}) a.verts.push_back(vert_id{v});
    }
  return a;
}

inline cell_arrays hex_torus(const torus_options& o) {
  const surface_arrays disk = quad_disk((o.cells[1] + 3) / 4);
  const std::size_t n = o.cells[0], layer = disk.points.size();
  cell_arrays a{{}, {}, 8};
  a.points.reserve(n * layer);
  a.verts.reserve(n * 2 * disk.verts.size());
  for (std::size_t i = 0; i < n; ++i) {
    const double turn = static_cast<double>(i) / static_cast<double>(n);
    // swapped, so that the disk is oriented towards the next slice
    for (const vec3& x : disk.points) a.points.push_back(in_torus(o, turn, x.y, x.x));
    for (std::size_t q = 0; q < disk.verts.size(); q += 4)
      for (const std::size_t at : {i, (i + 1) % n})
        for (std::size_t k = 0; k < 4; ++k) a.verts.push_back(vert_id{at * layer + disk.verts[q + k].raw()});
  }
  return a;
}

}  // namespace detail

/// A torus about an axis parallel to z, oriented outward. If M is a volume: a solid torus.
/// Needs:  M is one of the six native meshes, or a mesh that can add verts and polys.
/// Result: cells[0] x cells[1] quads; triangles: two per quad; polygons of any size: the dual of these triangles,
///         hexagons that are not quite planar. Volumes: cells[0] slices, each of a disk with a core of n x n hexes, n =
///         cells[1] / 4 rounded up, and (n + 1) / 2 layers of 4 n hexes around it; tets, six per hex; or the hexes as
///         polyhedra. All verts of the boundary lie on the torus.
/// Cost:   O(verts) time and memory.
/// Errors: invalid_argument, which names the field, if there are fewer than 3 cells or more cells than 32-bit
///         descriptors. The same if a radius is not finite and above 0, if tube_radius is not below radius, or if the
///         centre is not finite. unsupported if a mesh of another library refuses a poly.
/// Source: tets by Dompierre et al. 1999.
template<requirement::can_be_generated M>
M make_torus(const torus_options& options = {}) {
  for (const std::size_t k : {0u, 1u})
    detail::check_at_least("make_torus", core::joined({"cells[", k, "]"}), options.cells[k], 3);
  detail::check_positive("make_torus", "radius", options.radius);
  detail::check_positive("make_torus", "tube_radius", options.tube_radius);
  if (options.tube_radius >= options.radius)
    core::throw_joined<invalid_argument>({"make_torus: tube_radius is ", core::number_text(options.tube_radius),
                                            "; it must be below radius, which is ", core::number_text(options.radius)});
  detail::check_finite("make_torus", "centre", options.centre);
  const double n = static_cast<double>(options.cells[0]), k = static_cast<double>(options.cells[1]);
  if constexpr (dimension_v<M> == 3) {  // a volume is a solid torus, a surface its boundary
    const double core = (k + 3) / 4 + 1, around = 4 * core * (core / 2 + 1);
    detail::check_element_counts<M>("make_torus", "cells", n * (core * core + around), n * (core * core + around));
    return detail::construct_from_hexes<M>(detail::hex_torus(options));
  } else {
    detail::check_element_counts<M>("make_torus", "cells", 2 * n * k, n * k);
    surface_arrays quads = detail::quad_torus(options);
    if constexpr (arity_v<M> == 0) {  // general polygons are the dual of triangles
      const auto point_of = [&](std::size_t t) {  // the middle of the triangle, by angles: first the lower right
                                                  // triangle of the quad, then the upper left one
        const double right = t % 2 ? 1 / 3.0 : 2 / 3.0, up = 1 - right;
        return detail::on_torus(options, static_cast<double>(t / 2 % options.cells[0]) + right,
                                static_cast<double>(t / 2 / options.cells[0]) + up);
      };
      return detail::construct_from_arrays<M>(detail::dual_of_triangles(detail::cut_quads(std::move(quads)), point_of));
    } else {
      return detail::construct_from_quads<M>(std::move(quads));
    }
  }
}

// What to write instead of calls that cannot compile.
template<class M, class R = mistake::remedy<mistake::include_adapter>>
  requires(!requirement::is_adapted<M>)
M make_torus(...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter

}  // namespace concino
