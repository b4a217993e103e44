// Shells: the volume between a surface and its offset along the normals of its verts.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/generate/detail/common/construct_from_arrays.hpp>
#include <concino/generate/detail/sweep/folded_cells.hpp>
#include <concino/generate/detail/sweep/plane_offsets.hpp>
#include <concino/generate/detail/sweep/swept_surface.hpp>
#include <concino/geometry/normals.hpp>

#include <cmath>
#include <utility>
#include <vector>

namespace concino {

/// What keeps the distance of the thickness.
enum class offset_distance {
  of_verts,   // verts, along their unit normals; where the surface turns, the polys are nearer
  of_planes,  // the planes of polys, by least squares at each vert: exact where they have up to three directions, as at
              // the corners of a box
};

struct offset_shell_options {
  offset_distance distance = offset_distance::of_verts;  // what keeps the distance
  bool properties = true;                             // whether named properties of verts, of polys and of the mesh are
                                                      // transferred, if m has any
  concino::correspondence* correspondence = nullptr;  // unless null, filled with the vert or poly of m of which each
                                                      // vert and poly was made
  std::vector<poly_id>* inverted = nullptr;           // unless null, filled with the polys of the result that are
                                                      // inverted at a corner or an edge; if null, they are an error
};

namespace detail {

/// The vectors along which the verts of m move, by number.
/// Errors: invalid_mesh that names a vert of a poly without normal.
template<class M>
std::vector<vec3> offset_vectors(const M& m, const swept_surface& s, offset_distance distance) {
  const auto normal_of = vert_normals(m);
  std::vector<vec3> n;
  n.reserve(s.points.size());
  for (const vert_t<M> v : verts(m)) n.push_back(normal_of[v]);
  for (const std::uint32_t v : s.verts)
    if (n[v] == vec3())
      core::throw_joined<invalid_mesh>(
          {"offset_shell: vert ", s.vert_index[v],
           " has no normal, as the areas around it cancel or are 0; remove polys without area first"});
  if (distance == offset_distance::of_verts) return n;
  std::vector<vec3> of_polys;
  of_polys.reserve(s.num_polys());
  for (const poly_t<M> p : polys(m)) of_polys.push_back(normal(m, p));
  return plane_offsets(s, of_polys);
}

}  // namespace detail

/// The volume between a surface and its offset along the unit normals of its verts: offset_shell(m, 0.1, 3). With
/// offset_distance::of_planes, the walls of the shell have this thickness too.
/// Needs:  Embedded SurfaceMesh, consistently oriented, with at most two polys at each edge.
/// Result: as extrude, with vert_normal(m, v) * thickness as the direction of each vert, or the vector by which the
///         planes of its polys move by the thickness; a negative thickness offsets against the normals. Verts without
///         polys are not repeated. Whether far parts of the shell overlap is not checked;
///         self_intersections(boundary_surface(shell)) finds out.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: invalid_argument if layers is 0, if thickness is 0 or not finite, or if the result would have too many
///         elements. Unless options.inverted lists them, it names a poly whose offset is inverted at a corner or an
///         edge, as where the surface is more curved than the thickness allows. invalid_mesh that names a vert of a
///         poly without normal, a vert whose point is not finite, an edge of more than two polys, or one along which
///         two polys run in the same direction.
/// Source: the normals as vert_normal; the planes by the quadrics of Garland, Heckbert 1997, "Surface simplification
///         using quadric error metrics".
template<SurfaceMesh M>
  requires Embedded<M> detail::swept_mesh<M> offset_shell(const M& m, double thickness, std::size_t layers = 1,
                                                          const offset_shell_options& options = {}) {
    detail::check_at_least("offset_shell", "layers", layers, 1);
    if (!std::isfinite(thickness) || thickness == 0)
      core::throw_joined<invalid_argument>(
          {"offset_shell: thickness is ", core::number_text(thickness), "; it must be finite and not 0"});
    detail::check_sweep_counts("offset_shell", "layers", layers, num_verts(m), num_polys(m),
                               detail::num_poly_corners(m));
    const auto s = detail::read_swept_surface("offset_shell", m, [&](const poly_t<M>&) { return thickness < 0; });
    const std::vector<vec3> vectors = detail::offset_vectors(m, s, options.distance);
    detail::sweep_layers all{s.points.size(), layers, false, std::vector<std::uint32_t>(s.points.size(), ~0u), 0};
    for (const std::uint32_t v : s.verts) all.moving[v] = 0;
    for (std::uint32_t& v : all.moving)
      if (v == 0) v = static_cast<std::uint32_t>(all.num_moving++);
    const auto at = [&](std::size_t level, std::uint32_t v) {
      return s.points[v] + (thickness * (static_cast<double>(level) / static_cast<double>(layers))) * vectors[v];
    };
    std::vector<poly_id> inverted = detail::folded_cells(s, vectors, thickness, layers);
    if (!inverted.empty() && !options.inverted)
      core::throw_joined<invalid_argument>({"offset_shell: thickness ", core::number_text(thickness),
                                            " inverts a corner or an edge of the offset of poly ",
                                            s.poly_index[inverted.front().raw() % s.num_polys()],
                                            "; choose a smaller one, or let options.inverted list such polys"});
    auto result = detail::construct_swept(m, s, all, at, options.properties, options.correspondence);
    if (options.inverted) *options.inverted = std::move(inverted);
    return result;
  }

// What to write instead of calls that cannot compile.
template<class... T> void offset_shell(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void offset_shell(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
