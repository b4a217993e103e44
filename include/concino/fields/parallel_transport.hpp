// Parallel transport of tangent vectors over a surface, from some verts to all others.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/core/tangent_vector.hpp>
#include <concino/fields/detail/heat/vector_heat.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct parallel_transport_options {
  double time = 0;                       // how long heat flows, in units of length^2, finite; 0: the square of the
                                         // length of edges, averaged by area
  concino::progress progress = nullptr;  // called with "parallel transport"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail {

/// A container of pairs of a vert and its vector.
template<class M, class S>
concept gives_tangent_vectors = requires(const S& sources) {
  { (*sources.begin()).first } -> std::convertible_to<vert_t<M>>;
  { (*sources.begin()).second } -> std::convertible_to<tangent_vector>;
};

}  // namespace detail

/// A surface prepared by prepare_parallel_transport. Several threads may query it if the solver allows it. Copies share
/// the prepared data.
template<class M, class Solver>
class prepared_parallel_transport {
  static constexpr const char* caller = "parallel_transport";
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const detail::vector_heat<Solver>> heat_;

 public:
  prepared_parallel_transport(const M& m, const parallel_transport_options& options, const Solver& solver) : mesh_(m) {
    const core::profiled_options profiled(options, "prepare_parallel_transport");
    detail::report_progress(profiled->progress, 0, "parallel transport");
    heat_ = detail::vector_heat<Solver>::make(m, options.time, solver, caller);
    detail::report_progress(profiled->progress, 1, "parallel transport");
  }

  const M& mesh() const { return mesh_.get(); }

  /// The vectors of some verts, transported to all others.
  /// Needs:  a container of pairs of a vert and its vector, or braces: {{v, {1, 0}}, {w, {0, 2}}}. The mesh has not
  ///         changed since it was prepared.
  /// Result: that of parallel_transport.
  /// Cost:   see parallel_transport.      Errors: as parallel_transport, about sources.
  template<class S>
    requires detail::gives_tangent_vectors<M, S>
  vert_map<M, tangent_vector> transport_from(const S& sources) const {
    const M& m = mesh_.get();
    std::vector<detail::vector_source> starts;
    double largest = 0;
    for (const auto& [v, x] : sources) {
      const int i = heat_->index_of_source(m, v, caller);
      if (!(std::isfinite(x.x) && std::isfinite(x.y)))
        core::throw_joined<invalid_argument>(
            {caller, ": the vector at vert ", static_cast<std::size_t>(i), " is not finite"});
      starts.push_back({i, x});
      largest = std::max(largest, norm(x));
    }
    if (starts.empty())
      core::throw_joined<invalid_argument>({caller, ": there is no source; give at least one vert and its vector"});
    const double unit = largest > 0 ? largest : 1;
    bool same_length = true;
    for (detail::vector_source& s : starts) {
      s.vector = {s.vector.x / unit, s.vector.y / unit};
      same_length = same_length && norm(s.vector) == norm(starts[0].vector);
    }
    const detail::diffused d = heat_->run(starts, {.second_heat = !same_length}, caller);
    auto r = make_vert_map<tangent_vector>(m);
    for (std::size_t v = 0; v < d.round.size(); ++v) {
      if (!d.is_reached(v)) continue;
      const tangent_vector x = d.at(d.first, v);
      const double size = norm(x);
      if (!(size > 0)) continue;
      const auto i = static_cast<Eigen::Index>(v);
      const double length = same_length ? norm(starts[0].vector) : d.second_heat[i] / d.heat[i];
      r.data()[v] = (unit * length / size) * x;
    }
    return r;
  }
  vert_map<M, tangent_vector> transport_from(
      std::initializer_list<std::pair<vert_t<M>, tangent_vector>> sources) const {
    return transport_from<std::initializer_list<std::pair<vert_t<M>, tangent_vector>>>(sources);
  }
  void transport_from(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0
};

/// Prepares the transport of vectors from many sets of verts: auto transport = prepare_parallel_transport(m); auto x =
/// transport.transport_from({{v, {1, 0}}}).
/// Needs:  as parallel_transport; the mesh must not change afterwards. solver: two of its type are constructed, from
///         its options() if it has them.
/// Result: an object with transport_from(sources).      Cost: as parallel_transport without the query.      Errors: as
///         parallel_transport, except about sources.
template<class M, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_parallel_transport<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_parallel_transport(
              M&& m, const parallel_transport_options& options = {}, Solver&& solver = {}) {
    return {m, options, solver};
  }

/// Tangent vectors at all verts: each is that of the nearest source, carried there along a shortest path without
/// turning. By the vector heat method: auto x = parallel_transport(m, {{v, {1, 0}}, {w, {0, 2}}}). Vectors are in the
/// frames of their verts, see tangent_vector.
/// Needs:  Embedded SurfaceMesh, not a temporary, with or without boundary. The polys at each vert are one fan.
///         sources: a container of pairs of a vert and a vector, or braces. solver: a SparseSolver that factorises.
/// Result: a map of vectors; 0 where no path leads. From one source the lengths are those of its vector, and on flat
///         parts the directions are exact, whatever the polygons are. Elsewhere they are approximate, and smooth where
///         the nearest source changes: directions and lengths are mixed within a few edges. Polygons other than
///         triangles are triangulated.
/// Cost:   two sparse factorisations, of as many unknowns as there are verts and of twice as many; then one
///         back-substitution with each, and one more if vectors have different lengths; as many again for each 550
///         root(time) of distance.
/// Errors: invalid_argument if there is no source, a vector is not finite, or time is out of its range or so short that
///         heat vanishes. invalid_mesh if a source is not a vert of the mesh, or if a poly has no area or points that
///         are not finite. unsupported if the polys at a vert are not one fan, or the solver is iterative.
///         solver_error. cancelled.
/// Source: Sharp, Soliman, Crane 2019, "The vector heat method".
template<class M, class S, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> && detail::gives_tangent_vectors<M, S> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, tangent_vector> parallel_transport(M&& m, const S& sources,
                                                         const parallel_transport_options& options = {},
                                                         Solver&& solver = {}) {
    const core::profiled_options profiled(options, "parallel_transport");
    return prepare_parallel_transport(m, *profiled, solver).transport_from(sources);
  }
template<class M, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          vert_map<M, tangent_vector> parallel_transport(
              M&& m, std::initializer_list<std::pair<vert_t<M>, tangent_vector>> sources,
              const parallel_transport_options& options = {}, Solver&& solver = {}) {
    const core::profiled_options profiled(options, "parallel_transport");
    return prepare_parallel_transport(m, *profiled, solver).transport_from(sources);
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_parallel_transport(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_parallel_transport(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_parallel_transport(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void parallel_transport(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void parallel_transport(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void parallel_transport(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void parallel_transport(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, not 0

}  // namespace concino
