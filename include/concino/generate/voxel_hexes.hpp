// Hexes from the voxels inside a closed surface.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/shapes/voxel_lattice.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/mesh/hexmesh.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino {

struct voxel_options {
  concino::inside_rule rule = concino::inside_rule::winding;  // which points are inside
};

namespace detail {

/// The box of the polys of m, which has some.
template<class M>
std::pair<vec3, vec3> box_of_polys(const M& m) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};
  for (const poly_t<M> p : polys(m))
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const vec3 x = to_vec3(point(m, v));
      for (const std::size_t k : {0u, 1u, 2u}) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
    }
  return {low, high};
}

/// Sets the flags of the cubes of column (i, j) whose centres are inside. Between two hits of the column with the
/// surface, one centre is tested for all.
template<class M>
void flag_column(const poly_tree<M>& tree, const voxel_lattice& lattice, std::size_t i, std::size_t j,
                 const inside_options& rule, std::vector<std::uint8_t>& flags) {
  const std::size_t nx = lattice.num_cells(0), ny = lattice.num_cells(1), nz = lattice.num_cells(2);
  const vec3 bottom = lattice.centre(i, j, 0), up{0, 0, lattice.cell_size()};
  const auto hits = tree.ray_all(bottom - up, up);
  std::size_t next = 0;
  bool is_known = false, is_inside = false;
  for (std::size_t k = 0; k < nz; ++k) {
    const double height = static_cast<double>(k) + 1;
    // Hits near the centre may be above or below it by rounding.
    bool is_near = false;
    while (next < hits.size() && hits[next].parameter < height - 1e-6) ++next, is_known = false;
    for (std::size_t h = next; h < hits.size() && hits[h].parameter <= height + 1e-6; ++h) is_near = true;
    if (!is_known || is_near) is_inside = tree.is_inside(lattice.centre(i, j, k), rule);
    is_known = !is_near;
    flags[(k * ny + j) * nx + i] = is_inside;
  }
}

}  // namespace detail

/// Hexes that fill a closed surface roughly: the cubes of a lattice around its box whose centres are inside or on it.
/// voxel_hexes(surface, 64).
/// Needs:  Embedded SurfaceMesh, closed. For the winding rule, consistently oriented; self-intersections are allowed.
/// Result: a hexmesh of cubes, of which n fit along the longest side of the box of the polys; the box is in the middle
///         of the lattice along the other two. Verts and polys are in the order of the lattice, x fastest. The surface
///         of the hexes has steps, and may not be manifold where cubes meet in an edge or a vert only. Parts thinner
///         than a cube may be missing. Exact, and the same for any number of threads.
/// Cost:   O(t log t) for t triangles, then for each of the columns along z the time of a ray and of a test for each of
///         its hits, in parallel; a byte for each cube of the lattice.
/// Errors: invalid_argument if n is 0 or asks for 2^30 cubes or more. invalid_mesh that names an edge at which the
///         surface is open, or a poly with a vert that is not finite; the same if all verts are at one point.
template<SurfaceMesh M>
  requires Embedded<M>
hexmesh voxel_hexes(const M& m, std::size_t n, const voxel_options& options = {}) {
  for (const edge_t<M> e : edges(m))
    if (num_elements(adj_e2p(m, e)) % 2 != 0)
      core::throw_joined<invalid_mesh>(
          {"voxel_hexes: the surface is open at edge ", index_of(m, e), "; only closed surfaces have an inside"});
  if (n > 0 && num_polys(m) == 0) return {};
  const auto tree = bounding_tree(m);
  const auto [low, high] = detail::box_of_polys(m);
  const detail::voxel_lattice lattice("voxel_hexes", low, high, n);
  std::vector<std::uint8_t> flags(lattice.size());
  const std::size_t nx = lattice.num_cells(0);
  parallel_for(
      nx * lattice.num_cells(1),
      [&](std::size_t column) { detail::flag_column(tree, lattice, column % nx, column / nx, {options.rule}, flags); },
      16);
  return hexmesh(detail::voxels_as_hexes(lattice, flags));
}

// What to write instead of calls that cannot compile.
template<class... T> void voxel_hexes(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void voxel_hexes(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
