// Geodesic distances by the heat method, on surfaces and volumes of any polys. After a preparation, a query costs
// back-substitutions.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/fields/detail/heat/geodesic_sources.hpp>
#include <concino/fields/heat_geodesics_options.hpp>
#include <concino/fields/prepared_heat_geodesics.hpp>
#include <concino/operators/virtual_elements.hpp>
#include <concino/solve/auto_solver.hpp>

#include <initializer_list>
#include <type_traits>
#include <utility>

namespace concino {

/// Prepares geodesic distances over a surface or through a volume, for many queries: auto heat =
/// prepare_heat_geodesics(m); auto d = heat.distance_from(v); d[w] is a length.
/// Needs:  as heat_geodesics; the mesh must not change afterwards. solver: the result keeps two or three of its type,
///         constructed from its options() if it has them. By default auto_solver expects 20 queries, so it factorises
///         all but very large meshes; {.questions = n} says how many you expect.
/// Result: an object with distance_from(...).
/// Cost:   as heat_geodesics without the query.
/// Errors: as heat_geodesics, except those about sources.
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_heat_geodesics<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_heat_geodesics(
              M&& m, const heat_geodesics_options& options = {}, Solver&& solver = auto_solver({.questions = 20})) {
    return {m, virtual_elements, options, solver};
  }
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_heat_geodesics<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_heat_geodesics(
              M&& m, const D& discretisation, const heat_geodesics_options& options = {},
              Solver&& solver = auto_solver({.questions = 20})) {
    return {m, discretisation, options, solver};
  }

/// Geodesic distances of all verts by the heat method, over a surface or through a volume: auto d = heat_geodesics(m,
/// v); d[w] is a length. They are distances from one vert or from the nearest of several. Sources may be pairs of a
/// vert and an initial distance: then d[w] is the minimum over all sources of the initial distance plus the distance
/// from there.
/// Needs:  EmbeddedMesh M, no temporary. sources: a vert, a container of verts or of pairs, or braces of either: {v,
///         w}, {{v, 0.5}, {w, 0.0}}. A discretisation of the Laplacian may follow the sources. If it has masses of its
///         own, as `uniform` has, heat only flows along edges, and gradients and lengths remain those of the mesh.
///         solver: a SparseSolver for symmetric positive definite matrices; two or three of its type are constructed,
///         from its options() if it has them.
/// Result: a map of double, in units of length. A source has distance 0, or its initial distance where no other source
///         is nearer. No vert has less than the smallest initial distance in its component. +inf in components of polys
///         without a source, and at verts of no poly that are no source.
///         Distances are approximate, and as smooth as heat. On curved surfaces they may be wrong by some edges far
///         from the source, be longer than a path along edges, or shorter than the straight line through space.
///         With .clamp = true they are none of these: at most the shortest path along edges and straight across
///         triangles or tets inside the polys, and at least the straight line. Then on the meshes of
///         docs/convergence.md the mean error is at most 0.3 edges, mostly below 0.1, and the largest error is below
///         two edges, except for agglomerates round a corner and squeezed polygons. Tets of hexes and polyhedra
///         overlap: they are cones from each of up to 16 verts to the triangles of the faces. A query takes three to
///         five times as long. Distances scale exactly with the mesh by powers of two. By a factorisation they do not
///         depend on the order of storage, but for rounding. The default time is twice the squared width of polys,
///         averaged by their measure, over their dimension: two squared edges in grids of squares and of cubes. Heat
///         resolves directions over a distance of about one poly, and rounds off finer details. The average by measure
///         sets that distance by the polys that cover most of the mesh. The many small polys in a corner of a graded
///         mesh do not set it, nor do the short edges of an interlocking polygon. A longer time makes distances
///         smoother, and rounder near the boundary. Heat is stored as its logarithm, whose gradient does not decay with
///         distance. Where heat underflows double precision, it is continued from there, so that distances are right
///         over any number of edges; each 1250 sqrt(time) of distance costs another back-substitution. Where polys are
///         very long and thin, a Laplacian with negative weights may make heat negative. Then heat flows along edges by
///         positive weights instead, and where it still is negative, shortest paths along edges replace it.
/// Cost:   two sparse factorisations with as many unknowns as there are verts, three if there is a boundary (see
///         heat_boundary), one more if heat flows along edges because it was negative. Then two or three
///         back-substitutions, and half of their time for all else. With .clamp also a search for shortest paths, O(n
///         log n) for n elements, triangles and tets inside the polys included; a box has 36 tets, with 32 bytes each.
///         For several queries prepare_heat_geodesics factorises once. Iterative solvers, such as multigrid, are only
///         used for the potential of the gradient: one set-up to prepare, and one solve per query. Heat is found by
///         conjugate gradients in bands of verts, from the sources outwards, in 10 to 100 short iterations. At 10^6
///         triangles a query takes the time of 20 to 30 cycles of multigrid, and about 60 where triangles are long or
///         obtuse. Distances differ by about 1e-4 of the largest from those by factorisation. A tolerance of 1e-6 of
///         the solver is enough. Only bands with many edges far shorter than the square root of the time need a set-up
///         and a solve of their own.
/// Errors: invalid_argument if time is out of its range, there is no source, or an initial distance is not finite.
///         invalid_mesh if a source is no vert of the mesh, or if a poly has no area or volume or points that are not
///         finite. unsupported as laplacian. solver_error. cancelled.
/// Source: Crane, Weischedel, Wardetzky 2013, "Geodesics in heat"; the logarithm: Varadhan 1967; paths across
///         triangles: Novotni, Klein 2002, "Computing geodesic distances on triangular meshes"; paper section 2.2,
///         "Distances and paths".
template<class M, class S, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> &&
      (detail::gives_verts<M, S> || detail::gives_distances<M, S>)&&SparseSolver<
          Solver, Eigen::SparseMatrix<double>,
          Eigen::VectorXd> vert_map<M, double> heat_geodesics(M&& m, const S& sources,
                                                              const heat_geodesics_options& options = {},
                                                              Solver&& solver = {}) {
    const core::profiled_options profiled(options, "heat_geodesics");
    return prepare_heat_geodesics(m, *profiled, solver).distance_from(sources);
  }
template<class M, class S, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> &&
      (detail::gives_verts<M, S> || detail::gives_distances<M, S>)&&Discretisation<D, M>&& SparseSolver<
          Solver, Eigen::SparseMatrix<double>,
          Eigen::VectorXd> vert_map<M, double> heat_geodesics(M&& m, const S& sources, const D& discretisation,
                                                              const heat_geodesics_options& options = {},
                                                              Solver&& solver = {}) {
    const core::profiled_options profiled(options, "heat_geodesics");
    return prepare_heat_geodesics(m, discretisation, *profiled, solver).distance_from(sources);
  }
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<vert_t<M>> sources,
                                             const heat_geodesics_options& options = {}, Solver&& solver = {}) {
    const core::profiled_options profiled(options, "heat_geodesics");
    return prepare_heat_geodesics(m, *profiled, solver).distance_from(sources);
  }
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<vert_t<M>> sources, const D& discretisation,
                                             const heat_geodesics_options& options = {}, Solver&& solver = {}) {
    const core::profiled_options profiled(options, "heat_geodesics");
    return prepare_heat_geodesics(m, discretisation, *profiled, solver).distance_from(sources);
  }
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<std::pair<vert_t<M>, double>> sources,
                                             const heat_geodesics_options& options = {}, Solver&& solver = {}) {
    const core::profiled_options profiled(options, "heat_geodesics");
    return prepare_heat_geodesics(m, *profiled, solver).distance_from(sources);
  }
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<std::pair<vert_t<M>, double>> sources,
                                             const D& discretisation, const heat_geodesics_options& options = {},
                                             Solver&& solver = {}) {
    const core::profiled_options profiled(options, "heat_geodesics");
    return prepare_heat_geodesics(m, discretisation, *profiled, solver).distance_from(sources);
  }

/// Geodesic distances of all verts from a point of poly p, by the heat method.
/// Needs:  x lies on or in p. The polys that contain it should be convex: the distances of their verts are those of
///         straight lines.
/// Result: as above; a place of the lowest element that contains x.
/// Cost:   as above.
/// Errors: as above, and those of lowest_element.
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, double> heat_geodesics(M&& m, const poly_t<M>& p, const vec3& x,
                                             const heat_geodesics_options& options = {}, Solver&& solver = {}) {
    const core::profiled_options profiled(options, "heat_geodesics");
    return prepare_heat_geodesics(m, *profiled, solver).distance_from(p, x);
  }
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, double> heat_geodesics(M&& m, const poly_t<M>& p, const vec3& x, const D& discretisation,
                                             const heat_geodesics_options& options = {}, Solver&& solver = {}) {
    const core::profiled_options profiled(options, "heat_geodesics");
    return prepare_heat_geodesics(m, discretisation, *profiled, solver).distance_from(p, x);
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_heat_geodesics(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_heat_geodesics(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_heat_geodesics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void prepare_heat_geodesics(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void heat_geodesics(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void heat_geodesics(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void heat_geodesics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void heat_geodesics(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
