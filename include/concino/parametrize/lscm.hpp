// lscm(m): least squares conformal maps of disks to the plane.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/parametrize/detail/plane_maps.hpp>
#include <concino/parametrize/detail/read_polys.hpp>

#include <initializer_list>
#include <type_traits>
#include <utility>

namespace concino {

struct lscm_options {
  concino::progress progress = nullptr;   // called with "lscm"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The map of a disk to the plane that preserves angles best: it minimises the integral of its squared gradient minus
/// twice its area, with two or more verts fixed. Each poly is cut into triangles by diagonals.
/// Needs:  SurfaceMesh M, Embedded, no temporary, with polys of any number of verts. fixed: pairs of a vert and a point
///         of the plane, in braces or a container, two or more.
/// Result: the map, exact at fixed verts. Without `fixed`, two boundary verts that are far from each other are fixed at
///         their distance, and the map is scaled to the area of the surface; the first is at the origin, the second on
///         the positive x axis. Of a developable surface it is then an isometry. Others may be flipped in places, see
///         map_distortion and injective_map. Verts of no poly are at the origin.
/// Cost:   one factorisation of a matrix with two rows for each vert.
/// Errors: invalid_mesh if the surface is no disk, which says why and what to do, a point is not finite, or a poly has
///         a part without area. invalid_argument if a position is not finite, a vert has two, or only one is fixed.
///         solver_error; cancelled.
/// Source: Levy, Petitjean, Ray, Maillot 2002, "Least squares conformal maps for automatic texture atlas generation";
///         the energy as in Desbrun, Meyer, Alliez 2002, "Intrinsic parameterizations of surface meshes".
template<class M, class D = std::initializer_list<std::pair<vert_t<M>, uv_point>>>
  requires detail::can_be_mapped<M> && detail::gives_positions<D, M>
uv_map<M> lscm(M&& m, const D& fixed, const lscm_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "lscm");
  detail::report_progress(profiled->progress, 0, "lscm");
  const std::remove_cvref_t<M>& mesh = m;
  const auto disk = detail::read_disk(mesh, "lscm");
  auto at = disk.positions(mesh, fixed, "lscm");
  for (auto& [v, x] : at) x = detail::scaled_point(x, -disk.flat.exponent);
  const detail::poly_triangles cut(disk.flat);
  cut.check_areas(disk.flat, "lscm");
  auto uv = detail::conformal_map(disk.flat, cut, at, "lscm");
  detail::scale_by(uv, disk.flat.exponent);
  detail::report_progress(profiled->progress, 1, "lscm");
  return disk.map_of(mesh, uv);
}
template<class M>
  requires detail::can_be_mapped<M>
uv_map<M> lscm(M&& m, const lscm_options& options = {}) {
  const std::initializer_list<std::pair<vert_t<M>, uv_point>> none = {};
  return lscm(m, none, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void lscm(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void lscm(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void lscm(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
