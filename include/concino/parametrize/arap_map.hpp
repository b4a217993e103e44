// arap_map(m): maps of disks to the plane that are as rigid as possible.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/parametrize/detail/rigid_map.hpp>
#include <concino/parametrize/detail/read_polys.hpp>

#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct arap_map_options {
  int max_iterations = 200;   // 0 or more; with 0 the result is the map from which it starts
  double tolerance = 1e-6;    // from 0 to 1: it ends when an iteration reduces the energy by less than this part of it
  concino::progress progress = nullptr;   // called with "arap_map"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

template<class M>
struct arap_map_result {
  uv_map<M> uv;
  std::vector<double> energies;  // at the start and after each iteration, never increasing: the mean over the surface
                                 // of the squared distance from the derivative to the nearest rotation; 0: an isometry
  bool has_converged = false;    // whether it ended before the last iteration
};

/// The map of a disk to the plane that is as rigid as possible: it keeps angles and areas together. It starts from
/// lscm, and repeats two steps: rotate each triangle to fit best, and fit the verts to the triangles. Each poly is cut
/// into triangles by diagonals.
/// Needs:  SurfaceMesh M, Embedded, no temporary, with polys of any number of verts. fixed: pairs of a vert and a point
///         of the plane, in braces or a container; two or more, at lengths like those of the mesh, or none.
/// Result: the map, exact at fixed verts, and the energies; a local minimum. Without `fixed` it is placed and turned as
///         that of lscm. Of a developable surface it is an isometry. Others may be flipped in places, see
///         map_distortion and injective_map. Verts of no poly are at the origin.
/// Cost:   that of lscm, one factorisation of a matrix with a row for each vert, and two solves in each iteration.
/// Errors: as lscm; invalid_argument if an option is out of its range.
/// Source: Liu, Zhang, Xu, Gotsman, Gortler 2008, "A local/global approach to mesh parameterization".
template<class M, class D = std::initializer_list<std::pair<vert_t<M>, uv_point>>>
  requires detail::can_be_mapped<M> && detail::gives_positions<D, M>
arap_map_result<std::remove_cvref_t<M>> arap_map(M&& m, const D& fixed, const arap_map_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "arap_map");
  detail::report_progress(profiled->progress, 0, "arap_map");
  const std::remove_cvref_t<M>& mesh = m;
  const auto disk = detail::read_disk(mesh, "arap_map");
  auto at = disk.positions(mesh, fixed, "arap_map");
  for (auto& [v, x] : at) x = detail::scaled_point(x, -disk.flat.exponent);
  auto found = detail::local_global_map(
      disk.flat, at, {profiled->max_iterations, profiled->tolerance, profiled->progress});
  detail::scale_by(found.uv, disk.flat.exponent);
  return {disk.map_of(mesh, found.uv), std::move(found.energies), found.has_converged};
}
template<class M>
  requires detail::can_be_mapped<M>
arap_map_result<std::remove_cvref_t<M>> arap_map(M&& m, const arap_map_options& options = {}) {
  const std::initializer_list<std::pair<vert_t<M>, uv_point>> none = {};
  return arap_map(m, none, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void arap_map(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void arap_map(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void arap_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
