// hodge_decomposition of 1-forms: values at the directed edges of a surface of any polygons as a sum of differences, of
// a part that turns, and a harmonic part.
#pragma once

#include <concino/fields/detail/problems/form_problem.hpp>
#include <concino/fields/hodge_decomposition.hpp>

#include <cstddef>

namespace concino {

/// The parts of a 1-form, and the function whose differences along edges the first one is.
template<class M>
struct hodge_form_parts {
  edge_map<M, double> exact, coexact, harmonic;  // in the direction of end_verts(m, e)
  vert_map<M, double> potential;                 // exact[e] is its difference, second end minus first; 0 at the first
                                                 // vert of each component
  std::size_t harmonic_dimension = 0;            // how many linearly independent harmonic forms there are
};

/// The Hodge decomposition of a 1-form on a surface of any polygons: a number for each edge, such as the integral of a
/// field along it, from the first to the second of end_verts(m, e). exact is the differences of a function at verts.
/// harmonic sums to 0 around each poly, and is orthogonal to exact forms. coexact is orthogonal to both.
/// Needs:  Embedded SurfaceMesh, not a temporary; form[e] is a number for each edge. solver: a SparseSolver, symmetric
///         matrices.
/// Result: three forms that sum to the given one. They are orthogonal in the inner product of virtual elements: for
///         each poly its area times the scalar product of the vectors nearest to the forms (form_vectors), plus the
///         products of what these leave over at its edges. So the vectors alone are orthogonal only on triangles with
///         closed forms. A closed surface of genus g has exact forms of dimension V - 1, coexact ones of F - 1, and
///         harmonic ones of 2g; with b boundary loops 2g + b - 1 harmonic ones. Accuracy is that of the solver.
/// Cost:   one factorisation of a matrix with a row for each vert, one solve and one more for each dimension of
///         harmonic forms.
/// Errors: invalid_mesh that names a poly without area or with points that are not finite. invalid_argument that names
///         an edge whose value is not finite. solver_error where edges have no polys. cancelled if progress returns
///         false.
/// Source: de Goes, Butts, Desbrun 2020, "Discrete differential operators on polygonal meshes"; Beirao da Veiga,
///         Brezzi, Marini, Russo 2016, "H(div) and H(curl)-conforming virtual element methods".
template<class M, class Form, class Solver = auto_solver>
  requires(
      requirement::is_lvalue_or_view<M>&& SurfaceMesh<M>&& Embedded<M>&& requirement::gives_numbers<Form, edge_t<M>> &&
      !requirement::gives_points<Form, poly_t<M>> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>)
hodge_form_parts<std::remove_cvref_t<M>> hodge_decomposition(M&& m, const Form& form, const hodge_options& options = {},
                                                             Solver&& solver = {}) {
  using mesh = std::remove_cvref_t<M>;
  const mesh& mesh_in = m;
  detail::report_progress(options.progress, 0, "Hodge decomposition");
  const detail::form_problem<mesh> problem(mesh_in);
  const auto whole = problem.read(form);
  problem.factorize(solver, options.progress);
  detail::report_progress(options.progress, 0.7, "solving");
  hodge_form_parts<mesh> parts{make_edge_map<double>(mesh_in), make_edge_map<double>(mesh_in),
                               make_edge_map<double>(mesh_in), make_vert_map<double>(mesh_in), 0};
  const auto exact = problem.project_to_differences(solver, whole, &parts.potential);
  const auto basis = problem.harmonic_forms(solver);
  parts.harmonic_dimension = basis.size();
  const auto products = problem.apply(whole);
  std::vector<double> harmonic(whole.size());
  for (const auto& h : basis) problem.add(harmonic, problem.dot_product(products, h), h);
  for (const edge_t<mesh> e : edges(mesh_in)) {
    const std::size_t i = index_of(mesh_in, e);
    parts.exact[e] = exact[i];
    parts.harmonic[e] = harmonic[i];
    parts.coexact[e] = whole[i] - exact[i] - harmonic[i];
  }
  detail::report_progress(options.progress, 1, "Hodge decomposition");
  return parts;
}

/// The vectors nearest to a 1-form, one for each polygon: of the integrals of a constant field along the edges it is
/// that field.
/// Needs:  Embedded SurfaceMesh, not a temporary; form[e] is a number for each edge, from the first to the second of
///         end_verts(m, e).
/// Result: a map of vec3, in units of the form over length. The vectors lie in the planes of vector areas. Values that
///         are not finite make those of their polys not finite.
/// Cost:   O(corners) time, O(P) memory.
/// Errors: invalid_mesh that names a poly without area or with points that are not finite.
/// Source: as hodge_decomposition.
template<class M, class Form>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M> &&
      requirement::gives_numbers<Form, edge_t<M>>
          poly_map<M, vec3> form_vectors(M&& m, const Form& form) {
    using mesh = std::remove_cvref_t<M>;
    auto result = make_poly_map<vec3>(m);
    std::vector<double> values(edge_index_bound(m));
    for (const edge_t<mesh> e : edges(m)) values[index_of(m, e)] = static_cast<double>(form[e]);
    detail::form_on_polygon<mesh> local;
    for (const poly_t<mesh> p : polys(m)) {
      local.visit(m, m, p, "form_vectors");
      result[p] = local.vector_of(values);
    }
    return result;
  }

// What to write instead of calls that cannot compile.
template<class... T> void form_vectors(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void form_vectors(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void form_vectors(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
