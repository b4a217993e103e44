// hodge_decomposition: a field as the sum of a gradient, of a part that turns, and of a part that does neither. 1-forms
// on polygons have a header of their own.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/problems/hodge_problem.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/solve/auto_solver.hpp>

#include <cstddef>
#include <utility>

namespace concino {

struct hodge_options {
  concino::progress progress = nullptr;  // called with "Hodge decomposition", "factorising", "solving"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The parts of a field, and the function whose gradient the first one is.
template<class M>
struct hodge_parts {
  poly_map<M, vec3> exact, coexact, harmonic;
  vert_map<M, double> potential;        // exact is its gradient; 0 at the first vert of each component, in units of the
                                        // field times length
  std::size_t harmonic_dimension = 0;  // how many linearly independent harmonic fields there are
};

/// The Hodge decomposition of a field that is constant on each triangle or tet. exact is the gradient of a function at
/// verts. harmonic is locally such a gradient, but not around holes or handles, and orthogonal to all gradients.
/// coexact is orthogonal to both: on surfaces a gradient of a function at edges that is linear on triangles and 0 on
/// the boundary, turned by 90 degrees; in volumes a curl.
/// Needs:  EmbeddedMesh of triangles or tets, by type or in fact, not a temporary; field[p], a vec3 or anything with
///         [0], [1], [2], for each poly, readable from several threads. solver: a SparseSolver, symmetric matrices.
/// Result: three fields, orthogonal in the sum over polys of measure times scalar product, up to the accuracy of the
///         solver. They sum to the field; on surfaces, to its projection into the triangles. The dimension of harmonic
///         fields is the first Betti number: 2g on a closed surface of genus g, 2g + b - 1 on one with b boundary
///         loops, for each component; 0 in a ball, 1 in a solid torus.
/// Cost:   one factorisation of a matrix with a row for each vert, one solve and one more for each dimension of
///         harmonic fields.
/// Errors: unsupported that names a poly that is no triangle or tet. invalid_mesh that names a poly without area or
///         volume or with points that are not finite. invalid_argument that names a poly whose vector is not finite.
///         solver_error where edges have no polys. cancelled if progress returns false.
/// Source: Polthier, Preuss 2003, "Identifying vector field singularities using a discrete Hodge decomposition";
///         Poelke, Polthier 2016, "Boundary-aware Hodge decompositions for piecewise constant vector fields".
template<class M, class Field, class Solver = auto_solver>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && Discretisation<cotangent_t, M> &&
      requirement::gives_points<Field, poly_t<M>> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          hodge_parts<std::remove_cvref_t<M>> hodge_decomposition(M&& m, const Field& field,
                                                                  const hodge_options& input_options = {},
                                                                  Solver&& solver = {}) {
    const core::profiled_options profiled(input_options, "hodge_decomposition");
    const hodge_options& options = *profiled;
    using mesh = std::remove_cvref_t<M>;
    const mesh& mesh_in = m;
    detail::report_progress(options.progress, 0, "Hodge decomposition");
    const detail::hodge_problem<mesh> problem(mesh_in);
    const auto whole = problem.tangential(field);
    problem.factorize(solver, options.progress);
    detail::report_progress(options.progress, 0.7, "solving");
    hodge_parts<mesh> parts{make_poly_map<vec3>(mesh_in), make_poly_map<vec3>(mesh_in), make_poly_map<vec3>(mesh_in),
                            make_vert_map<double>(mesh_in), 0};
    const auto exact = problem.project_to_gradients(solver, whole, &parts.potential);
    const auto basis = problem.harmonic_fields(solver);
    parts.harmonic_dimension = basis.size();
    auto harmonic = problem.zero();
    for (const auto& h : basis) problem.add(harmonic, problem.product(whole, h), h);
    for (const poly_t<mesh> p : polys(mesh_in)) {
      const std::size_t i = index_of(mesh_in, p);
      parts.exact[p] = exact[i];
      parts.harmonic[p] = harmonic[i];
      parts.coexact[p] = whole[i] - exact[i] - harmonic[i];
    }
    detail::report_progress(options.progress, 1, "Hodge decomposition");
    return parts;
  }

// What to write instead of calls that cannot compile.
template<class... T> void hodge_decomposition(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void hodge_decomposition(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void hodge_decomposition(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_vectors_at_polys>>
  requires(EmbeddedMesh<M> && !requirement::gives_points<U, poly_t<M>> &&
           !(SurfaceMesh<M> && requirement::gives_numbers<U, edge_t<M>>))
void hodge_decomposition(M&&, const U&, ...) = delete;  // a vector at each poly: make_poly_map<vec3>(m)
template<class M, class U, class R = mistake::remedy<mistake::use_simplices>>
  requires(EmbeddedMesh<M> && requirement::gives_points<U, poly_t<M>> && !Discretisation<cotangent_t, M>)
void hodge_decomposition(M&&, const U&, ...) = delete;  // for triangles and tets: to_triangles(m), to_tets(m)

}  // namespace concino
