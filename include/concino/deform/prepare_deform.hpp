// Deformation of surfaces and volumes by handles, as rigid as possible.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/iterable.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/deform/deform_options.hpp>
#include <concino/deform/detail/arap/arap_problem.hpp>
#include <concino/deform/detail/arap/handle_positions.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/solve/ldlt.hpp>

#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

namespace concino {

/// A deformation prepared by prepare_deform. Copies share the prepared data.
template<class M, class Solver>
class prepared_deform {
  struct preparation {
    detail::arap_problem problem;
    Eigen::SparseMatrix<double> lower;
    std::unique_ptr<Solver> solver;
  };
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

 public:
  template<class V, class D>
  prepared_deform(const M& m, const V& handles, const D& discretisation, const prepare_deform_options& options,
                  const Solver& solver)
      : mesh_(m) {
    const core::profiled_options profiled(options, "prepare_deform");
    detail::arap_problem problem = make_problem(m, handles, discretisation, options.rigidity);
    std::unique_ptr<Solver> own;
    if constexpr (requires { Solver(solver.options()); }) own = std::make_unique<Solver>(solver.options());
    else if constexpr (std::default_initializable<Solver>) own = std::make_unique<Solver>();
    else own = std::make_unique<Solver>(solver);
    const Eigen::SparseMatrix<double> lower = problem.lower_triangle();
    detail::report_progress(profiled->progress, 0.2, "factorising");
    if (problem.num_unknowns() > 0)
      core::factorize_over_verts(*own, lower, "prepare_deform", [&](Eigen::Index row) {
        return problem.vert_of_unknown(static_cast<std::size_t>(row));
      });
    prepared_ = std::make_shared<const preparation>(preparation{std::move(problem), lower, std::move(own)});
    detail::report_progress(profiled->progress, 1, "factorising");
  }

  const M& mesh() const { return mesh_.get(); }
  const Solver& solver() const { return *prepared_->solver; }
  /// The number of weights of the discretisation that were negative and are positive here.
  std::size_t num_made_positive() const { return prepared_->problem.num_made_positive(); }

  /// The shape with the handles at these positions: arap.with_positions({{a, p}, {b, q}}).points.
  /// Needs:  pairs of a vert and a point, in braces or any container, one for each handle and none elsewhere. The mesh
  ///         has not changed since it was prepared.
  /// Result: a minimum of the energy near the start. Each component starts from its place in the mesh, moved by the
  ///         best rigid motion of its handles: the smallest rotation, if they are on a line. Verts without edges move
  ///         likewise, by that of all handles. Handles are exactly where they were put.
  /// Cost:   three back-substitutions for each iteration, and a rotation for each vert, in parallel.
  /// Errors: invalid_mesh if a vert is no vert of the mesh; invalid_argument if a position is not finite, a vert gets
  ///         two different positions, is no handle, or a handle gets none, or an option is out of range; solver_error.
  template<class D = std::initializer_list<std::pair<vert_t<M>, vec3>>>
  deform_result<M> with_positions(const D& positions, const deform_options& options = {}) const {
    const auto all = detail::handle_positions(mesh_.get(), positions, prepared_->problem);
    return iterate(prepared_->problem.rigid_start(all), options);
  }

  /// The same, starting from points near the result: those of the last call, while handles are dragged.
  /// Needs:  start: a map of points, such as the member points of a result.
  /// Errors: also invalid_argument if a point of start is not finite.
  template<class Map, class D = std::initializer_list<std::pair<vert_t<M>, vec3>>>
    requires requirement::gives_points<Map, vert_t<M>>
  deform_result<M> with_positions_from(const Map& start, const D& positions, const deform_options& options = {}) const {
    auto all = detail::handle_positions(mesh_.get(), positions, prepared_->problem);
    for (const vert_t<M> v : verts(mesh_.get())) {
      const std::size_t i = index_of(mesh_.get(), v);
      if (prepared_->problem.is_handle(i)) continue;
      all[i] = to_vec3(start[v]);
      if (!is_finite(all[i])) detail::throw_point_not_finite("with_positions_from", "point of the start", i);
    }
    return iterate(std::move(all), options);
  }

 private:
  template<class V, class D>
  static detail::arap_problem make_problem(const M& m, const V& handles, const D& discretisation, rigid_cells cells) {
    auto rest = detail::points_by_index(m, "prepare_deform");
    const auto used = detail::indices_of_points(m);
    const auto indices = detail::handle_indices(m, handles, "prepare_deform");
    if (cells == rigid_cells::spokes) return {std::move(rest), used, laplacian(m, discretisation), indices};
    if constexpr (requirement::has_poly_matrices<D, M>) {
      auto all = detail::arap_polys_of(m, discretisation);
      const auto of_polys = all.laplacian(rest.size());
      return {std::move(rest), used, of_polys, indices, std::move(all)};
    } else {
      core::throw_joined<unsupported>({"prepare_deform: spokes and rims need a discretisation with matrices of polys, ",
                                       "such as virtual_elements"});
    }
  }
  deform_result<M> iterate(std::vector<vec3> x, const deform_options& options) const {
    detail::check_limits(options.max_iterations, options.tolerance);
    deform_result<M> result{make_vert_map<vec3>(mesh_.get()), {}, false};
    result.energies = prepared_->problem.iterate(*prepared_->solver, prepared_->lower,
                                                 {options.max_iterations, options.tolerance}, x, result.has_converged);
    for (const vert_t<M> v : verts(mesh_.get())) result.points[v] = x[index_of(mesh_.get(), v)];
    return result;
  }
};

/// Prepares a deformation that is as rigid as possible, for many positions of the same handles:
/// auto arap = prepare_deform(m, {a, b, c}); auto x = arap.with_positions({{a, p}, {b, q}, {c, r}});
/// Needs:  EmbeddedMesh M, no temporary, a surface or a volume of any polys; it must not change afterwards. handles:
///         verts, in braces or any container. discretisation: see Discretisation; virtual_elements by default, the
///         cotangents on triangles and tets. solver: a SparseSolver for symmetric positive definite matrices; a similar
///         one is kept.
/// Result: an object with with_positions(...). Its energy is the sum, over the verts and their edges, of the weight
///         times the squared difference between the edge and its rest, rotated by the best rotation of the vert: a
///         rigid motion costs nothing. Edges are pairs of verts with a weight in the Laplacian, diagonals of polys too.
///         Negative weights are made positive; num_made_positive() counts them. With options.rigidity =
///         rigid_cells::spokes_and_rims the edges of a vert are those of all its polys, with the weights in the matrix
///         of the poly. Their sum in a poly is never negative, so that no sign is changed. A surface resists bending
///         then, also where triangles are obtuse.
/// Cost:   one factorisation for the verts that are no handles.
/// Errors: solver_error if a component has no handle; it names one of its verts and their number. invalid_mesh if a
///         point is not finite, or a handle is no vert of m. unsupported for spokes and rims if the discretisation has
///         no matrices of polys. Those of laplacian with this discretisation. cancelled.
/// Source: Sorkine and Alexa 2007, "As-rigid-as-possible surface modeling"; of volumes, and spokes and rims, Chao,
///         Pinkall, Sanan and Schroeder 2010, "A simple geometric model for elastic deformation". The rotations are
///         those of Horn 1987, by quaternions.
template<class M, class V = std::initializer_list<vert_t<M>>, class Solver = ldlt>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && core::iterable<V> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_deform<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_deform(
              M&& m, const V& handles, const prepare_deform_options& options = {}, Solver&& solver = {}) {
    return {m, handles, virtual_elements, options, solver};
  }
template<class M, class V = std::initializer_list<vert_t<M>>, class D, class Solver = ldlt>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && core::iterable<V> && Discretisation<D, M> &&
      SparseSolver<std::remove_cvref_t<Solver>, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_deform<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_deform(
              M&& m, const V& handles, const D& discretisation, const prepare_deform_options& options = {},
              Solver&& solver = {}) {
    return {m, handles, discretisation, options, solver};
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_deform(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_deform(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_deform(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void prepare_deform(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
