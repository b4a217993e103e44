// spectral_conformal(m): conformal maps of disks to the plane without fixed verts.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/parametrize/detail/plane_maps.hpp>
#include <concino/parametrize/detail/read_polys.hpp>

#include <type_traits>

namespace concino {

struct spectral_conformal_options {
  concino::progress progress = nullptr;   // called with "spectral_conformal"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The map of a disk to the plane that preserves angles best, measured by the size of its boundary: it minimises the
/// energy of lscm, divided by the integral along the boundary of the squared distance from its mean. No vert is fixed,
/// so the distortion is not larger around two of them.
/// Needs:  SurfaceMesh M, Embedded, no temporary, with polys of any number of verts.
/// Result: the map, scaled to the area of the surface, placed and turned as that of lscm. Of a developable surface it
///         is an isometry. Others may be flipped in places, see map_distortion and injective_map. Verts of no poly are
///         at the origin.
/// Cost:   two factorisations of matrices with two rows for each vert, and some solves.
/// Errors: invalid_mesh as lscm. solver_error if the smallest eigenvalue is not far enough from the next; cancelled.
/// Source: Mullen, Tong, Alliez, Desbrun 2008, "Spectral conformal parameterization".
template<class M>
  requires detail::can_be_mapped<M>
uv_map<M> spectral_conformal(M&& m, const spectral_conformal_options& options = {}) {
  const core::profiled_options profiled(options, "spectral_conformal");
  detail::report_progress(profiled->progress, 0, "spectral_conformal");
  const std::remove_cvref_t<M>& mesh = m;
  const auto disk = detail::read_disk(mesh, "spectral_conformal");
  const detail::poly_triangles cut(disk.flat);
  cut.check_areas(disk.flat, "spectral_conformal");
  auto uv = detail::smallest_conformal_mode(disk.flat, cut, profiled->progress);
  detail::scale_by(uv, disk.flat.exponent);
  detail::report_progress(profiled->progress, 1, "spectral_conformal");
  return disk.map_of(mesh, uv);
}

// What to write instead of calls that cannot compile.
template<class... T> void spectral_conformal(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void spectral_conformal(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void spectral_conformal(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
