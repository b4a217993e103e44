// injective_map(m): maps of disks to the plane with little distortion and without flips.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/parametrize/detail/flip_free_map.hpp>
#include <concino/parametrize/detail/read_polys.hpp>

#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct injective_map_options {
  int max_iterations = 300;     // 0 or more; with 0 the result is the map from which it starts
  double tolerance = 1e-6;      // from 0 to 1: it ends when an iteration reduces the energy by less than this part
  bool fixed_boundary = false;  // whether boundary verts stay where they are at the start
  concino::progress progress = nullptr;   // called with "injective_map"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

template<class M>
struct injective_map_result {
  uv_map<M> uv;
  std::vector<double> energies;  // at the start and after each iteration, falling: the mean over the surface of the
                                 // squared factors by which lengths grow and shrink, summed; 4: an isometry
  bool has_converged = false;    // whether it ended before the last iteration
};

/// The map of a disk to the plane with the smallest symmetric Dirichlet energy near a start without flips. The energy
/// is infinite where a triangle has no area, so none is flipped on the way. Each poly is cut into triangles by
/// diagonals.
/// Needs:  SurfaceMesh M, Embedded, no temporary, with polys of any number of verts. start: a map from verts to points
///         of the plane without flips, by map_distortion; else that of tutte, scaled to the area of the surface.
/// Result: the map, without flips, and the energies; a local minimum. Parts that are far from each other on the surface
///         may overlap in the plane. Without a start and a fixed boundary, it is placed and turned as that of lscm;
///         with a start, the first vert that lscm fixes stays in place. Of a developable surface it is an isometry.
///         Verts of no poly are at the origin.
/// Cost:   in each iteration a factorisation of a matrix with two rows for each vert; most maps take 10 to 100.
/// Errors: invalid_mesh as lscm. invalid_argument if an option is out of its range, or a point of the start is not
///         finite, or the start has flips. solver_error that says why, if tutte has flips, because pieces are attached
///         at two verts, or by rounding errors. cancelled.
/// Source: Smith, Schaefer 2015, "Bijective parameterization with free boundaries", for the energy and steps without
///         flips; Smith, de Goes, Kim 2019, "Analytic eigensystems for isotropic distortion energies", for the
///         projected Newton steps.
template<class M, class U>
  requires detail::can_be_mapped<M> && detail::gives_uv<U, vert_t<M>>
injective_map_result<std::remove_cvref_t<M>> injective_map(M&& m, const U& start,
                                                           const injective_map_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "injective_map");
  detail::report_progress(profiled->progress, 0, "injective_map");
  const std::remove_cvref_t<M>& mesh = m;
  const auto disk = detail::read_disk(mesh, "injective_map");
  detail::plane_points from;
  for (const auto& v : disk.verts) {
    const auto& x = start[v];
    from.push_back(detail::scaled_point({static_cast<double>(x[0]), static_cast<double>(x[1])}, -disk.flat.exponent));
  }
  auto found = detail::flip_free_map(disk.flat, std::move(from), profiled->fixed_boundary,
                                     {profiled->max_iterations, profiled->tolerance, profiled->progress});
  detail::scale_by(found.uv, disk.flat.exponent);
  return {disk.map_of(mesh, found.uv), std::move(found.energies), found.has_converged};
}
template<class M>
  requires detail::can_be_mapped<M>
injective_map_result<std::remove_cvref_t<M>> injective_map(M&& m, const injective_map_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "injective_map");
  detail::report_progress(profiled->progress, 0, "injective_map");
  const std::remove_cvref_t<M>& mesh = m;
  const auto disk = detail::read_disk(mesh, "injective_map");
  auto found = detail::flip_free_map(disk.flat, {}, profiled->fixed_boundary,
                                     {profiled->max_iterations, profiled->tolerance, profiled->progress});
  detail::scale_by(found.uv, disk.flat.exponent);
  return {disk.map_of(mesh, found.uv), std::move(found.energies), found.has_converged};
}

// What to write instead of calls that cannot compile.
template<class... T> void injective_map(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void injective_map(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void injective_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
