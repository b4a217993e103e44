// The logarithmic map of a surface: the distance and the direction of each vert, as seen from one vert.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/progress.hpp>
#include <concino/core/tangent_vector.hpp>
#include <concino/fields/detail/heat_preparation.hpp>
#include <concino/fields/detail/scaled_mesh.hpp>
#include <concino/fields/detail/vector_heat.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

struct log_map_options {
  double time = 0;                       // how long heat flows, in units of length^2, finite; 0: the square of the length of edges, averaged by area
  concino::progress progress = nullptr;  // called with "log map" and "factorising"
};

/// distance: along the surface, in units of length; 0 at the source, +inf where no path leads there.
/// direction: the direction in which a straight path leaves the source, of length 1, in the source's frame (see tangent_vector); 0 at the source and where
///            the distance is infinite. Where only paths lead that bend around corners of the boundary, it is the direction of the straight line across the
///            gap, in the plane into which the surface unfolds.
template<class M>
struct log_map_result {
  vert_map<M, double> distance;
  vert_map<M, tangent_vector> direction;
};

namespace detail {

/// Vectors of the affine heat method end where the vert is if the surface is unfolded. Their lengths are too short where paths bend around corners of the
/// boundary, so they are compared with the lengths of paths.
class path_lengths {
  distance_graph graph_;
  double width_;  // of polys, in units of the graph
  int exponent_;  // coordinates of the graph are those of the mesh times 2^-exponent

  path_lengths(distance_graph&& graph, double width, int exponent) : graph_(std::move(graph)), width_(width), exponent_(exponent) {}

 public:
  template<SurfaceMesh M>
  static path_lengths of(const M& m) {
    const views::scaled<M> at = scaled_to_unit(m);
    return {distance_graph_of(at), std::sqrt(mean_square_width(at)), at.exponent()};
  }

  /// By the index of each vert: the length of a short path from this one, along edges and straight across triangles, in units of the graph.
  std::vector<double> from(int vert) const { return graph_.path_lengths_from({{vert, 0, 0, 0}}, std::numeric_limits<double>::infinity()); }

  /// The distance where a vector has this length, and a path this one: that of the vector if both differ by less than 1.5 times the width of polys,
  /// that of the path if they differ by more than 2.5 times the width.
  double distance(double of_vector, double of_path) const {
    const double straight = std::ldexp(of_vector, -exponent_), off = of_path - straight;
    return std::ldexp(straight + std::clamp(std::abs(off) / width_ - 1.5, 0.0, 1.0) * off, exponent_);
  }
};

}  // namespace detail

/// A surface prepared by prepare_log_map. Several threads may query it if the solver allows it. Copies share the prepared data.
template<class M, class Solver>
class prepared_log_map {
  static constexpr const char* caller = "log_map";
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const detail::vector_heat<Solver>> heat_;
  std::shared_ptr<const detail::path_lengths> paths_;

 public:
  prepared_log_map(const M& m, const log_map_options& options, const Solver& solver) : mesh_(m) {
    detail::report_progress(options.progress, 0, "log map");
    heat_ = detail::vector_heat<Solver>::make(m, options.time, solver, caller);
    paths_ = std::make_shared<const detail::path_lengths>(detail::path_lengths::of(m));
    detail::report_progress(options.progress, 1, "log map");
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
    const std::vector<double> path_length = paths_->from(from);
    log_map_result<M> r{make_vert_map<double>(m, std::numeric_limits<double>::infinity()), make_vert_map<tangent_vector>(m)};
    for (std::size_t v = 0; v < equations.size(); ++v) {
      if (!d.is_reached(v)) continue;
      const auto i = static_cast<Eigen::Index>(v);
      const tangent_vector axis = d.at(d.first, v), away = -1.0 * d.at(d.offset, v);
      const double size = norm(axis) * norm(away);
      r.distance.data()[v] = paths_->distance(heat_->unit * std::sqrt(std::max(d.square[i] / d.heat[i], 0.0)), path_length[v]);
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
/// Needs:  as log_map; the mesh must not change afterwards. solver: two of its type are constructed, from its options() if it has them.
/// Result: an object with log_map_from(v).      Cost: as log_map without the query.      Errors: as log_map, except that about the source.
template<class M, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_log_map<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_log_map(M&& m, const log_map_options& options = {}, Solver&& solver = {}) {
  return {m, options, solver};
}

/// The logarithmic map of a surface about one vert, by the affine heat method: auto l = log_map(m, v). Then l.distance[w] is the length of a path from v to w
/// that is as straight as the surface allows, and l.direction[w] the direction in which it leaves v.
/// Needs:  Embedded SurfaceMesh, not a temporary, with or without boundary. The polys at each vert are one fan. solver: a SparseSolver that factorises.
/// Result: see log_map_result. Where the surface is flat, polar coordinates to rounding, whatever the polygons are; directions across holes
///         too, if heat reaches them along a way without turns about curved parts. Elsewhere approximate: on spheres the errors halve if edges do. On scanned
///         and designed surfaces distances are wrong by 1 to 3 % of the largest in the mean, and by up to 12 % where several paths are nearly the shortest, at
///         the cut locus. There directions are between theirs. Distances are root mean squares over paths along which heat flows. Where they are off
///         from the shortest path along edges and straight across triangles by more than 2.5 times the mean width of polys, they are its length; from 1.5 to
///         2.5 times they are between both. So they are lengths of paths round notches and holes too, and distance times direction is no position there.
///         For distances alone, heat_geodesics is more accurate. Polygons other than triangles are triangulated. Frames where the surface is not orientable
///         are those carried along the path.
/// Cost:   two sparse factorisations, of as many unknowns as there are verts and of twice as many. Then two back-substitutions with each, one more with the second if polys at an edge have opposite orientations; as many again for each 550 root(time) of distance.
///         And a search for shortest paths, O(n log n) for n elements.
/// Errors: invalid_mesh if source is not a vert of the mesh, or if a poly has no area or points that are not finite. unsupported if the polys at a vert are not
///         one fan, or the solver is iterative. invalid_argument if time is out of its range, or so short that heat vanishes. solver_error. cancelled.
/// Source: Soliman, Sharp 2025, "The affine heat method", with squared distances carried along, which do not cancel at the cut locus as vectors do; the transport of vectors: Sharp, Soliman, Crane 2019, "The vector heat method".
template<class M, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
log_map_result<std::remove_cvref_t<M>> log_map(M&& m, const vert_t<M>& source, const log_map_options& options = {}, Solver&& solver = {}) {
  return prepare_log_map(m, options, solver).log_map_from(source);
}

// What to write instead of calls that cannot compile.
template<class... T> void prepare_log_map(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void prepare_log_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_log_map(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void log_map(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void log_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void log_map(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void log_map(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, not 0

}  // namespace concino
