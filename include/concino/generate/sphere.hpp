// Spheres (surfaces) and balls (volumes): make_sphere<M>().
#pragma once

#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/detail/shapes/box_surface.hpp>
#include <concino/generate/detail/shapes/round.hpp>

namespace concino {

struct sphere_options {
  std::size_t cells = 8;  // 1 or more, along each edge of the cube that is projected to the sphere
  double radius = 1;      // finite, above 0
  vec3 centre = {0, 0, 0};  // finite
};

namespace detail {

inline vec3 in_even_cube(const grid_corner& at, std::size_t n) {
  return {even_angle(at[0], n), even_angle(at[1], n), even_angle(at[2], n)};
}

/// The surface of a cube, projected from its centre to the unit sphere.
inline surface_arrays cube_sphere(std::size_t n) {
  const box_surface quad_surface({n, n, n});
  surface_arrays a{{}, {}, {}, 4};
  a.points.reserve(quad_surface.num_verts());
  a.verts.reserve(4 * quad_surface.num_quads());
  quad_surface.for_each_vert(
      [&](const grid_corner& at) { a.points.push_back(on_round_boundary(in_even_cube(at, n))); });
  quad_surface.for_each_quad([&](const std::array<grid_corner, 4>& quad) {
    for (const grid_corner& at : quad) a.verts.push_back(vert_id{quad_surface.number(at)});
  });
  return a;
}

/// A core of n^3 hexes, surrounded by layers of hexes.
inline cell_arrays hex_ball(std::size_t n) {
  const box_surface quad_surface({n, n, n});
  const std::size_t layers = layers_around(n), row = n + 1, core = row * row * row;
  cell_arrays a{{}, {}, 8};
  a.points.reserve(core + layers * quad_surface.num_verts());
  a.verts.reserve(8 * (n * n * n + layers * quad_surface.num_quads()));
  const auto core_number = [&](const grid_corner& at) { return (at[2] * row + at[1]) * row + at[0]; };
  for (std::size_t k = 0; k < row; ++k)
    for (std::size_t j = 0; j < row; ++j)
      for (std::size_t i = 0; i < row; ++i) a.points.push_back(in_round_core(in_even_cube({i, j, k}, n)));
  for (std::size_t l = 1; l <= layers; ++l)
    quad_surface.for_each_vert([&](const grid_corner& at) {
      const vec3 u = in_even_cube(at, n), inner = in_round_core(u), outer = on_round_boundary(u);
      a.points.push_back(
          l == layers ? outer : inner + (static_cast<double>(l) / static_cast<double>(layers)) * (outer - inner));
    });
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        for (const std::size_t up : {k, k + 1})
          for (const grid_corner& at : {grid_corner{i, j, up}, {i + 1, j, up}, {i + 1, j + 1, up}, {i, j + 1, up}})
            a.verts.push_back(vert_id{core_number(at)});
  for (std::size_t l = 0; l < layers; ++l)
    quad_surface.for_each_quad([&](const std::array<grid_corner, 4>& quad) {
      for (const std::size_t level : {l, l + 1})
        for (const grid_corner& at : quad)
          a.verts.push_back(vert_id{
              level == 0 ? core_number(at) : core + (level - 1) * quad_surface.num_verts() + quad_surface.number(at)});
    });
  return a;
}

template<class Arrays>
Arrays placed(Arrays a, double radius, const vec3& centre) {
  for (vec3& x : a.points) x = centre + radius * x;
  return a;
}

}  // namespace detail

/// A sphere, oriented outward. If M is a volume: a solid ball.
/// Needs:  M is one of the six native meshes, or a mesh that can add verts and polys.
/// Result: a cube with `cells` quads along each edge, whose surface is projected to the sphere, evenly by angle. Quads:
///         6 cells^2; triangles: two per quad; polygons of any size: the dual of these triangles, mostly hexagons that
///         are not quite planar. Volumes: a core of cells^3 hexes and (cells + 1) / 2 layers of 6 cells^2 hexes around
///         it; tets, six per hex; or the hexes as polyhedra. All verts of the boundary lie on the sphere. The triangles
///         of icosphere() are more uniform.
/// Cost:   O(verts) time and memory.
/// Errors: invalid_argument that names the field: no cells or more than 32-bit descriptors, a radius that is not finite
///         and above 0, a centre that is not finite. unsupported if a mesh of another library refuses a poly.
/// Source: the equiangular cubed sphere of Ronchi, Iacono, Paolucci 1996; tets by Dompierre et al. 1999.
template<requirement::can_be_generated M>
M make_sphere(const sphere_options& options = {}) {
  detail::check_at_least("make_sphere", "cells", options.cells, 1);
  detail::check_positive("make_sphere", "radius", options.radius);
  detail::check_finite("make_sphere", "centre", options.centre);
  const double n = static_cast<double>(options.cells), boundary_quads = 6 * n * n;
  if constexpr (dimension_v<M> == 3) {  // a volume is a ball, a surface its boundary
    detail::check_element_counts<M>("make_sphere", "cells",
                                    (n + 1) * (n + 1) * (n + 1) + (n + 1) / 2 * (boundary_quads + 2),
                                    n * n * n + (n + 1) / 2 * boundary_quads);
    return detail::construct_from_hexes<M>(
        detail::placed(detail::hex_ball(options.cells), options.radius, options.centre));
  } else {
    detail::check_element_counts<M>("make_sphere", "cells", 2 * boundary_quads, boundary_quads);
    surface_arrays quads = detail::cube_sphere(options.cells);
    if constexpr (arity_v<M> == 0) {  // general polygons are the dual of triangles
      const surface_arrays triangles = detail::cut_quads(std::move(quads));
      quads = detail::dual_of_triangles(triangles, [&](std::size_t t) {
        vec3 sum;
        for (const std::size_t k : {0u, 1u, 2u}) sum += triangles.points[triangles.verts[3 * t + k].raw()];
        return detail::on_round_boundary(sum);
      });
      return detail::construct_from_arrays<M>(detail::placed(std::move(quads), options.radius, options.centre));
    } else {
      return detail::construct_from_quads<M>(detail::placed(std::move(quads), options.radius, options.centre));
    }
  }
}

// What to write instead of calls that cannot compile.
template<class M, class R = mistake::remedy<mistake::include_adapter>>
  requires(!requirement::is_adapted<M>)
M make_sphere(...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter

}  // namespace concino
