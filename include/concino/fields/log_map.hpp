// The logarithmic map of a surface: the distance and the direction of each vert, as seen from one vert.
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
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>

namespace concino {

struct log_map_options {
  double time = 0;                       // how long heat flows, in units of length^2, finite; 0: the square of the
                                         // length of edges, averaged by area
  concino::progress progress = nullptr;  // called with "log map" and "factorising"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// distance: of the vert from the source, in units of length, in the plane into which the surface unfolds; 0 at the
/// source, +inf where no path leads there. Where
///           a straight path over the surface joins both, it is the length of this path. Across a notch or a hole it is
///           shorter than every path; heat_geodesics and exact_geodesics measure round it.
/// direction: the direction in which the straight path leaves the source, of length 1, in the source's frame (see
/// tangent_vector); 0 at the source and where the
///            distance is infinite.
template<class M>
struct log_map_result {
  vert_map<M, double> distance;
  vert_map<M, tangent_vector> direction;
};

/// A surface prepared by prepare_log_map. Several threads may query it if the solver allows it. Copies share the
/// prepared data.
template<class M, class Solver>
class prepared_log_map {
  static constexpr const char* caller = "log_map";
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const detail::vector_heat<Solver>> heat_;

 public:
  prepared_log_map(const M& m, const log_map_options& options, const Solver& solver) : mesh_(m) {
    const core::profiled_options profiled(options, "prepare_log_map");
    detail::report_progress(profiled->progress, 0, "log map");
    heat_ = detail::vector_heat<Solver>::make(m, options.time, solver, caller);
    detail::report_progress(profiled->progress, 1, "log map");
  }

  const M& mesh() const { return mesh_.get(); }

  /// The logarithmic map about one vert.
  /// Needs:  the mesh has not changed since it was prepared.
  /// Result: that of log_map.
  /// Cost:   see log_map.      Errors: invalid_mesh if source is not a vert of the mesh.
  log_map_result<M> log_map_from(const vert_t<M>& source) const {
    const M& m = mesh_.get();
    const int from = heat_->index_of_source(m, source, caller);
    const detail::affine_heat& equations = heat_->equations;
    const detail::diffused d = heat_->run({{from, {1, 0}}}, {.second = equations.reflects, .offset = true}, caller);
    log_map_result<M> r{make_vert_map<double>(m, std::numeric_limits<double>::infinity()),
                        make_vert_map<tangent_vector>(m)};
    for (std::size_t v = 0; v < equations.size(); ++v) {
      if (!d.is_reached(v)) continue;
      const auto i = static_cast<Eigen::Index>(v);
      const tangent_vector axis = d.at(d.first, v), away = -1.0 * d.at(d.offset, v);
      const double size = norm(axis) * norm(away);
      r.distance.data()[v] = heat_->unit * (std::sqrt(std::max(d.square[i] / d.heat[i], 0.0)));
      if (!(size > 0)) continue;
      bool is_mirrored = false;
      if (equations.reflects) {
        const tangent_vector other = d.at(d.second, v);
        is_mirrored = axis.x * other.y - axis.y * other.x < 0;
      }
      const double along = dot(axis, away) / size, left = (axis.x * away.y - axis.y * away.x) / size;
      r.direction.data()[v] = {along, is_mirrored ? -left : left};
    }
    r.distance[source] = 0;
    r.direction[source] = {};
    return r;
  }
  void log_map_from(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0
};

/// Prepares logarithmic maps about many verts: auto log = prepare_log_map(m); auto l = log.log_map_from(v).
/// Needs:  as log_map; the mesh must not change afterwards. solver: two of its type are constructed, from its options()
///         if it has them.
/// Result: an object with log_map_from(v).      Cost: as log_map without the query.      Errors: as log_map, except
///         that about the source.
template<class M, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          prepared_log_map<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_log_map(
              M&& m, const log_map_options& options = {}, Solver&& solver = {}) {
    return {m, options, solver};
  }

/// The logarithmic map of a surface about one vert, by the affine heat method: auto l = log_map(m, v). Then
/// l.distance[w] and l.direction[w] are the polar coordinates of w in the plane into which the surface unfolds about v:
/// length and direction of the straight path from v to w, where there is one.
/// Needs:  Embedded SurfaceMesh, not a temporary, with or without boundary. The polys at each vert are one fan. solver:
///         a SparseSolver that factorises.
/// Result: see log_map_result. Where the surface is flat, polar coordinates to rounding, whatever the polygons are;
///         across holes too, if heat reaches them along a way without turns about curved parts. Elsewhere approximate:
///         on spheres the errors halve if edges do. On scanned and designed surfaces distances are wrong by 1 to 3 % of
///         the largest in the mean, and by up to 12 % where several paths are nearly the shortest, at the cut locus.
///         There directions are between theirs. Distances are root mean squares over paths along which heat flows.
///         Unlike heat_geodesics, they are not clamped. Polygons other than triangles are triangulated. Frames where
///         the surface is not orientable are those carried along the path.
/// Cost:   two sparse factorisations, of as many unknowns as there are verts and of twice as many. Then two
///         back-substitutions with each, one more with the second if polys at an edge have opposite orientations; as
///         many again for each 550 root(time) of distance.
/// Errors: invalid_mesh if source is not a vert of the mesh, or if a poly has no area or points that are not finite.
///         unsupported if the polys at a vert are not one fan, or the solver is iterative. invalid_argument if time is
///         out of its range, or so short that heat vanishes. solver_error. cancelled.
/// Source: Soliman, Sharp 2025, "The affine heat method", with squared distances carried along, which do not cancel at
///         the cut locus as vectors do; the transport of vectors: Sharp, Soliman, Crane 2019, "The vector heat method".
template<class M, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          log_map_result<std::remove_cvref_t<M>> log_map(M&& m, const vert_t<M>& source,
                                                         const log_map_options& options = {}, Solver&& solver = {}) {
    const core::profiled_options profiled(options, "log_map");
    return prepare_log_map(m, *profiled, solver).log_map_from(source);
  }

// What to write instead of calls that cannot compile.
template<class... T> void prepare_log_map(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void prepare_log_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_log_map(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void log_map(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void log_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void log_map(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void log_map(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, not 0

}  // namespace concino
