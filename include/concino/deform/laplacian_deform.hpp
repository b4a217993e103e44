// Laplacian editing: deformation by handles that keeps the details of a surface, or the shape of a volume, by one
// linear solve.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/deform/detail/arap/handle_positions.hpp>
#include <concino/deform/detail/editing/laplacian_editing.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/solve/ldlt.hpp>

#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct laplacian_deform_options {
  concino::progress progress = nullptr;  // called with "factorising", "solving"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The verts of a mesh with some at prescribed positions: the others keep their Laplacian vectors, rotated and scaled
/// with their neighbours. auto x = laplacian_deform(m, {{a, p}, {b, q}, {c, r}});
/// Needs:  EmbeddedMesh M, no temporary, a surface or a volume of any polys. positions: pairs of a vert and a point, in
///         braces or any container: at least three in each component, not on a line. solver: a SparseSolver for
///         symmetric positive definite matrices.
/// Result: a map of points, exact at the handles: the minimum of the sum, over the verts, of the squared change of the
///         Laplacian vector divided by the mass, by virtual elements. Vectors at rest are mapped by the similarity
///         that is best for the edges of the vert, which is linear in the result. Each component is moved by the best
///         rigid motion of its handles first. So similarities of the handles move the mesh likewise, and details turn
///         with the surface. Turns of handles against each other are linearised: where they are large,
///         prepare_deform keeps shapes better. Verts without edges move with all handles.
/// Cost:   one factorisation with three unknowns for each vert that is no handle, coupled over two edges.
/// Errors: invalid_argument if there are no handles, a position is not finite, or a vert gets two different ones.
///         invalid_mesh if a handle is no vert of m, a point is not finite, or a vert with edges has no mass.
///         solver_error if a component has no handle, only such on a line, or too few otherwise, as flat parts may
///         with few handles; it names one of its verts and their number. Those of laplacian; cancelled.
/// Source: Sorkine, Cohen-Or, Lipman, Alexa, Roessl and Seidel 2004, "Laplacian surface editing".
template<class M, class D = std::initializer_list<std::pair<vert_t<M>, vec3>>, class Solver = ldlt>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, vec3> laplacian_deform(M&& m, const D& positions, const laplacian_deform_options& options = {},
                                             Solver&& solver = {}) {
    constexpr const char* caller = "laplacian_deform";
    const core::profiled_options profiled(options, caller);
    const std::remove_cvref_t<M>& mesh_in = m;
    const auto rest = detail::points_by_index(mesh_in, caller);
    const auto handles = detail::place_handles(mesh_in, positions, caller);
    const auto masses = mass_matrix(mesh_in);
    std::vector<double> mass(rest.size());
    for (std::size_t i = 0; i < mass.size(); ++i) mass[i] = masses.coeff(static_cast<int>(i), static_cast<int>(i));
    const detail::laplacian_editing problem(rest, detail::indices_of_points(mesh_in), laplacian(mesh_in), mass,
                                            handles.index, handles.position);
    detail::report_progress(profiled->progress, 0.2, "factorising");
    Eigen::VectorXd u(problem.load().size());
    if (u.size() > 0) {
      try {
        core::factorize_symmetric(solver, problem.lower());
      } catch (const core::singular_row& e) {
        problem.throw_singular(static_cast<Eigen::Index>(e.row));
      }
      detail::report_progress(profiled->progress, 0.9, "solving");
      u = core::solve_and_check(solver, problem.lower(), problem.load(), caller);
    }
    const auto points = problem.points(u);
    auto x = make_vert_map<vec3>(mesh_in);
    for (const auto v : verts(mesh_in)) x[v] = points[index_of(mesh_in, v)];
    for (std::size_t i = 0; i < handles.vert.size(); ++i) x[handles.vert[i]] = handles.position[i];
    return x;
  }

// What to write instead of calls that cannot compile.
template<class... T> void laplacian_deform(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void laplacian_deform(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void laplacian_deform(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
