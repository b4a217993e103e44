// Smooth deformation by handles: a biharmonic displacement.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/deform/affine_map.hpp>
#include <concino/deform/detail/arap/handle_positions.hpp>
#include <concino/deform/detail/cages/weighted_sums.hpp>
#include <concino/fields/harmonic_map.hpp>

#include <initializer_list>
#include <utility>
#include <vector>

namespace concino {

struct biharmonic_deform_options {
  int exponent = 2;  // n >= 1: the displacement is n-harmonic; 1 has kinks at handles, 3 is smoother
  concino::progress progress = nullptr;  // called with "harmonic map", "factorising", "solving"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The verts of a mesh with some at prescribed positions: the others follow smoothly, by one linear solve.
/// auto x = biharmonic_deform(m, {{a, p}, {b, q}});
/// Needs:  EmbeddedMesh M, no temporary. positions: pairs of a vert and a point, in braces or any container. solver as
///         for harmonic_map.
/// Result: a map of points: the mesh moved by the best rigid motion of the handles, plus a displacement that is
///         biharmonic, by virtual elements. Rigid motions of the handles move the mesh likewise. Details are not
///         rotated where handles turn against each other; prepare_deform does that.
/// Cost:   that of harmonic_map<vec3>.
/// Errors: invalid_argument if there are no handles, or a position is not finite; invalid_mesh if a handle is no vert
///         of m or a point is not finite; those of harmonic_map.
/// Source: Botsch and Kobbelt 2004, "An intuitive framework for real-time freeform modeling".
template<class M, class D = std::initializer_list<std::pair<vert_t<M>, vec3>>, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, vec3> biharmonic_deform(M&& m, const D& positions, const biharmonic_deform_options& options = {},
                                              Solver&& solver = {}) {
    constexpr const char* caller = "biharmonic_deform";
    const core::profiled_options profiled(options, caller);
    const std::remove_cvref_t<M>& mesh_in = m;
    const std::vector<vec3> rest = detail::points_by_index(mesh_in, caller);
    const detail::placed_handles<std::remove_cvref_t<M>> handles = detail::place_handles(mesh_in, positions, caller);
    std::vector<vec3> from;
    for (const std::size_t i : handles.index) from.push_back(rest[i]);
    const affine_map rigid = best_rigid_motion(from, handles.position);
    std::vector<std::pair<vert_t<M>, vec3>> values;
    for (std::size_t i = 0; i < from.size(); ++i)
      values.push_back({handles.vert[i], handles.position[i] - rigid(from[i])});
    auto x = harmonic_map<vec3>(m, values, {.exponent = profiled->exponent, .progress = profiled->progress}, solver);
    for (const vert_t<M> v : verts(m)) x[v] += rigid(rest[index_of(m, v)]);
    for (std::size_t i = 0; i < from.size(); ++i) x[handles.vert[i]] = handles.position[i];  // to the last digit
    return x;
  }

// What to write instead of calls that cannot compile.
template<class... T> void biharmonic_deform(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void biharmonic_deform(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void biharmonic_deform(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
