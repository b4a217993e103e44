// Harmonic coordinates of the verts of a volume in a cage around it.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/deform/cage_weights.hpp>
#include <concino/deform/detail/cages/mean_value.hpp>
#include <concino/fields/harmonic_map.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino {

struct harmonic_coordinates_options {
  bool non_negative = true;              // make negative weights 0 and the sums 1 again
  double tolerance = 1e-6;               // distance of boundary verts from the cage, as a part of its size; >= 0
  concino::progress progress = nullptr;  // called with the fraction of the verts of the cage that are done
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// Harmonic coordinates, and how many weights the discretisation made negative.
template<class M>
struct harmonic_coordinates_result : mesh_cage_weights<M> {
  std::size_t num_negative = 0;  // weights below 0 by more than rounding errors
  double min_weight = 0;         // the smallest of all, before they were made non-negative
};

/// Harmonic coordinates: weights of the verts of a cage for the verts of a volume that fills it. They are positive
/// inside of concave cages too, where those of cage_coordinates are not, and know the inside: a hand does not move a
/// leg beside it. auto moved = harmonic_coordinates(volume, cage).points_of(bent_cage);
/// Needs:  m: an Embedded VolumeMesh, no temporary, whose boundary verts are on the cage. cage: as for
///         cage_coordinates.
/// Result: weights that sum to 1: on the boundary those of cage_coordinates, linear on each triangle of the cage;
///         inside the harmonic maps of these, by virtual elements. They reproduce linear functions. Where dihedral
///         angles of the cells are obtuse, some may come out slightly negative: num_negative counts them. With
///         non_negative they become 0 and the sums 1 again, by which linear functions change as little.
/// Cost:   one factorisation for the verts inside, one solve for each vert of the cage, and O(boundary verts x
///         triangles of the cage).
/// Errors: as cage_coordinates about the cage; invalid_argument if a boundary vert is not on the cage, or tolerance is
///         negative or not a number; those of prepare_harmonic_map; cancelled.
/// Source: Joshi, Meyer, DeRose, Green and Sanocki 2007, "Harmonic coordinates for character articulation".
template<class M, class C>
  requires requirement::is_lvalue_or_view<M> && VolumeMesh<M> && Embedded<M> && SurfaceMesh<C> && Embedded<C>
harmonic_coordinates_result<std::remove_cvref_t<M>> harmonic_coordinates(
    M&& m, const C& cage, const harmonic_coordinates_options& input_options = {}) {
  const core::profiled_options profiled(input_options, "harmonic_coordinates");
  const harmonic_coordinates_options& options = *profiled;
  constexpr const char* caller = "harmonic_coordinates";
  if (!(options.tolerance >= 0)) core::throw_joined<invalid_argument>({caller, ": tolerance must be 0 or more"});
  const auto flat = detail::make_flat_cage(detail::cage_polys_of(cage, caller), caller);
  const auto points = detail::points_by_index(m, caller);
  const std::size_t n = flat.num_verts;
  std::vector<vert_t<M>> on_cage;
  for (const vert_t<M> v : verts(m))
    if (is_boundary(m, v)) on_cage.push_back(v);
  std::vector<double> all(points.size() * n), row(flat.num_points());
  for (const vert_t<M>& v : on_cage) {
    const std::size_t i = index_of(m, v);
    if (detail::weights_on_cage(flat, points[i] / flat.unit, row) > options.tolerance * flat.size)
      core::throw_joined<invalid_argument>(
          {caller, ": vert ", i, " is on the boundary of the volume, but not on the cage"});
    std::copy_n(row.begin(), n, all.begin() + static_cast<std::ptrdiff_t>(i * n));
  }
  const auto prepared = prepare_harmonic_map(m, on_cage);
  std::vector<std::pair<vert_t<M>, double>> values(on_cage.size());
  std::size_t num_negative = 0;
  double min_weight = 0;
  for (std::size_t c = 0; c < n; ++c) {
    detail::report_progress(options.progress, static_cast<double>(c) / static_cast<double>(n), "harmonic coordinates");
    bool any = false;
    for (std::size_t k = 0; k < on_cage.size(); ++k) {
      values[k] = {on_cage[k], all[index_of(m, on_cage[k]) * n + c]};
      any = any || values[k].second != 0;
    }
    if (!any) continue;
    const auto u = prepared.with_values(values);
    for (const vert_t<M> v : verts(m)) {
      const double w = u[v];
      min_weight = std::min(min_weight, w);
      num_negative += w < -1e-9;
      all[index_of(m, v) * n + c] = options.non_negative ? std::max(0.0, w) : w;
    }
  }
  for (const vert_t<M> v : verts(m)) {
    double* const w = all.data() + index_of(m, v) * n;
    double sum = 0;
    for (std::size_t c = 0; c < n; ++c) sum += w[c];
    if (sum > 0)
      for (std::size_t c = 0; c < n; ++c) w[c] /= sum;
  }
  return {{m, cage_weights(n, std::move(all))}, num_negative, min_weight};
}

// What to write instead of calls that cannot compile.
template<class... T> void harmonic_coordinates(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void harmonic_coordinates(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void harmonic_coordinates(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
