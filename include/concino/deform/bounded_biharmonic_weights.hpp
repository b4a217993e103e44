// Bounded biharmonic weights of handles inside a volume, and weights of one mesh on another.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/deform/detail/weights/bounded.hpp>
#include <concino/deform/skin_weights.hpp>
#include <concino/fields/resample.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace concino {

struct bounded_biharmonic_options {
  double tolerance = 1e-5;    // of the quadratic programs, see qp_options; 1e-12 to 1
  int max_iterations = 20000;  // of each of them, 1 or more
  double min_weight = 1e-4;   // smaller weights become 0; from 0 to 0.1
  concino::progress progress = nullptr;  // called with "weights of handles" before each of them
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// Weights of handles for skin: each is 1 at its verts, 0 at those of the others, and between them as smooth as numbers
/// from 0 to 1 can be. auto w = bounded_biharmonic_weights(volume, {{a}, {b, c}});
/// Needs:  EmbeddedMesh M, best a volume around the shape: tets, or voxel_hexes(surface, 32) where there is no tet
///         engine. handles: lists of verts, one list for each handle, in braces or containers.
/// Result: weights from 0 to 1, of sum 1, of each handle: for each the minimum of the energy of the biharmonic equation
///         with the bounds 0 and 1, by virtual elements; then divided by their sum. Verts without polys have none,
///         unless they are of a handle. transfer_weights brings them to the surface.
/// Cost:   one quadratic program for each handle; some seconds for 10^4 verts.
/// Errors: invalid_argument if there are no handles, one has no verts, two have a vert in common, or an option is out
///         of range. invalid_mesh if a vert of a handle is no vert of m, or a vert with neighbours has no mass.
///         solver_error if a component has no vert of a handle, or a program does not converge. Those of laplacian;
///         cancelled.
/// Source: Jacobson, Baran, Popovic and Sorkine 2011, "Bounded biharmonic weights for real-time deformation". The
///         weights are computed one handle after the other and made 1 in sum, as proposed there.
template<class M, class H = std::initializer_list<std::initializer_list<vert_t<M>>>>
  requires EmbeddedMesh<M>
skin_weights bounded_biharmonic_weights(const M& m, const H& handles, const bounded_biharmonic_options& options = {}) {
  constexpr const char* caller = "bounded_biharmonic_weights";
  const core::profiled_options profiled(options, caller);
  if (!(options.min_weight >= 0 && options.min_weight <= 0.1))
    core::throw_joined<invalid_argument>({caller, ": min_weight must be from 0 to 0.1"});
  if (!(options.tolerance >= 1e-12 && options.tolerance <= 1) || options.max_iterations < 1)
    core::throw_joined<invalid_argument>(
        {caller, ": tolerance must be from 1e-12 to 1, and max_iterations 1 or more"});
  std::vector<std::vector<std::size_t>> indices;
  for (const auto& list : handles) {
    indices.emplace_back();
    for (const vert_t<M> v : list) {
      if (!contains(m, v))
        core::throw_joined<invalid_mesh>(
            {caller, ": handle ", indices.size() - 1, " has a vert that is none of the mesh"});
      indices.back().push_back(index_of(m, v));
    }
  }
  const auto masses = mass_matrix(m);
  std::vector<double> mass(vert_index_bound(m));
  for (const vert_t<M> v : verts(m))
    mass[index_of(m, v)] = masses.coeff(static_cast<int>(index_of(m, v)), static_cast<int>(index_of(m, v)));
  return detail::make_bounded_weights(
      laplacian(m), mass, indices, {options.tolerance, options.min_weight, options.max_iterations}, profiled->progress);
}

/// The weights of the verts of one mesh at those of another: of a volume at the surface of the shape inside.
/// auto w = transfer_weights(volume, bounded_biharmonic_weights(volume, handles), surface);
/// Needs:  EmbeddedMesh both; weights for the index bound of `from`, at each vert that has polys.
/// Result: weights that are 0 or more, and 1 in sum; at the closest point of `from`, by resample.
/// Cost:   that of resample for each bone.
/// Errors: invalid_argument if the weights are for another number of verts; those of resample.
template<EmbeddedMesh From, EmbeddedMesh To>
skin_weights transfer_weights(const From& from, const skin_weights& weights, const To& to) {
  if (weights.num_verts() != vert_index_bound(from))
    core::throw_joined<invalid_argument>({"transfer_weights: the weights are for ", weights.num_verts(),
                                          " verts, and the mesh has an index bound of ", vert_index_bound(from)});
  std::vector<skin_weight> all;
  for (std::size_t j = 0; j < weights.num_bones(); ++j) {
    auto u = make_vert_map<double>(from, 0.0);
    for (const vert_t<From> v : verts(from)) u[v] = weights.weight(index_of(from, v), j);
    const auto there = resample(from, u, to);
    for (const vert_t<To> v : verts(to))
      if (there[v] > 0) all.push_back({index_of(to, v), j, there[v]});
  }
  return skin_weights(vert_index_bound(to), weights.num_bones(), all);
}

// What to write instead of calls that cannot compile.
template<class... T> void bounded_biharmonic_weights(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void bounded_biharmonic_weights(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void transfer_weights(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void transfer_weights(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
