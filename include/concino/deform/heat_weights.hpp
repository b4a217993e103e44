// Weights of the bones of a skeleton at the verts of a surface, by heat that flows from the bones.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/deform/detail/cages/weighted_sums.hpp>
#include <concino/deform/detail/weights/heat.hpp>
#include <concino/deform/skin_weights.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/io/skeleton_graph.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace concino {

struct heat_weights_options {
  double amount = 1;         // of heat against its flow along the surface, > 0; larger: the weights are sharper
  double min_weight = 1e-6;  // smaller weights become 0; from 0 to 0.1
  bool visible = true;       // bones warm only verts that they see
  concino::progress progress = nullptr;  // called with "nearest bones", "factorising"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

struct heat_weights_result {
  skin_weights weights;
  std::size_t num_negative = 0;  // weights that came out negative, by obtuse angles, and were made 0
};

/// Weights of bones for skin: skin(m, heat_weights(m, k).weights, transforms, dual_quaternions).
/// Needs:  Embedded SurfaceMesh M; a skeleton with edges, its bones: their numbers are those of edges(k). The mesh is
///         closed, or options.visible is false.
/// Result: weights that are 0 or more, and 1 in sum, of each bone. Heat flows to each vert from the nearest bone, or
///         evenly from those that are as near, in proportion to amount / distance^2, if no poly is between them; and
///         along the surface. Verts without polys have the weights of the nearest bones.
/// Cost:   O(verts x bones), a ray for each vert, one factorisation, and one solve for each bone.
/// Errors: invalid_argument if the skeleton has no edges, a point of it is not finite, or an option is out of range.
///         invalid_mesh if a point is not finite; solver_error if no vert of a component sees its nearest bone. Those
///         of laplacian and mass_matrix; cancelled.
/// Source: Baran and Popovic 2007, "Automatic rigging and animation of 3D characters".
template<SurfaceMesh M>
  requires Embedded<M>
heat_weights_result heat_weights(const M& m, const skeleton& k, const heat_weights_options& options = {}) {
  constexpr const char* caller = "heat_weights";
  const core::profiled_options profiled(options, caller);
  if (k.num_edges() == 0) core::throw_joined<invalid_argument>({caller, ": the skeleton has no edges"});
  if (!(options.amount > 0) || !std::isfinite(options.amount))
    core::throw_joined<invalid_argument>({caller, ": amount must be finite and more than 0"});
  if (!(options.min_weight >= 0 && options.min_weight <= 0.1))
    core::throw_joined<invalid_argument>({caller, ": min_weight must be from 0 to 0.1"});
  std::vector<std::array<vec3, 2>> bones;
  for (const auto& [a, b] : k.edges()) bones.push_back({k.point(a), k.point(b)});
  for (std::size_t i = 0; i < k.num_verts(); ++i)
    if (!is_finite(k.points()[i])) detail::throw_point_not_finite(caller, "node", i);
  detail::report_progress(profiled->progress, 0, "nearest bones");
  const auto points = detail::points_by_index(m, caller);
  detail::bone_heat_rows rows{detail::indices_of_points(m), {}, {}, 0};
  for (const std::size_t v : rows.used) rows.size = std::max(rows.size, distance(points[v], points[rows.used.front()]));
  rows.nearest.resize(rows.used.size());
  const auto tree = bounding_tree(m);
  parallel_for(
      rows.used.size(),
      [&](std::size_t i) {
        rows.nearest[i] = detail::bones_nearest_to(bones, points[rows.used[i]]);
      },
      64);
  rows.fallback = rows.nearest;
  if (options.visible)
    parallel_for(
        rows.used.size(),
        [&](std::size_t i) {
          auto& nearest = rows.nearest[i];
          const vec3 way = points[rows.used[i]] - nearest.point;
          if (norm(way) > 1e-9 * rows.size && tree.ray(nearest.point, way, {.max_parameter = 1 - 1e-6}))
            nearest.bones.clear();
        },
        64);
  const auto masses = mass_matrix(m);
  std::vector<double> mass(points.size());
  for (const std::size_t v : rows.used) mass[v] = masses.coeff(static_cast<int>(v), static_cast<int>(v));
  detail::report_progress(profiled->progress, 0.5, "factorising");
  auto found = detail::diffuse_heat(laplacian(m), mass, rows, bones.size(), options.amount, options.min_weight);
  detail::report_progress(profiled->progress, 1, "factorising");
  return {std::move(found.weights), found.num_negative};
}

// What to write instead of calls that cannot compile.
template<class... T> void heat_weights(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void heat_weights(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
