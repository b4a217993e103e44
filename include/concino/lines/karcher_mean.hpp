// The mean of verts on a surface, by geodesic distances.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/iterable.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/fields/log_map.hpp>
#include <concino/lines/trace_geodesic.hpp>

#include <cmath>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace concino {

namespace detail {

template<class M, class S>
concept gives_weighted_verts = core::iterable<S> && requires(const S& s) {
  { (*s.begin()).first } -> std::convertible_to<vert_t<M>>;
  { (*s.begin()).second } -> std::convertible_to<double>;
};
template<class M, class S> concept gives_several_verts = core::iterable<S> && requires(const S& s) {
  { *s.begin() } -> std::convertible_to<vert_t<M>>;
};

template<class M>
using weighted_verts = std::vector<std::pair<vert_t<M>, double>>;

/// Errors: as karcher_mean, about verts and weights.
template<class M, class S>
weighted_verts<M> read_weighted_verts(const M& m, const S& sites, const char* caller) {
  weighted_verts<M> r;
  double sum = 0;
  for (const auto& site : sites) {
    if constexpr (gives_weighted_verts<M, S>) r.emplace_back(site.first, static_cast<double>(site.second));
    else r.emplace_back(site, 1.0);
    const auto& [v, weight] = r.back();
    if (!contains(m, v))
      core::throw_joined<invalid_mesh>({caller, ": a vert is not one of the mesh; take it from verts(m)"});
    if (!(weight >= 0 && std::isfinite(weight)))
      core::throw_joined<invalid_argument>({caller, ": the weight of vert ", index_of(m, v), " is ",
                                            core::number_text(weight), "; it has to be finite and not negative"});
    sum += weight;
  }
  if (!(sum > 0 && std::isfinite(sum)))
    core::throw_joined<invalid_argument>(
        {caller, ": there is no vert with a weight above 0, or the weights are too large; give at least one"});
  for (auto& site : r) site.second /= sum;
  return r;
}

/// Descends from vert to vert, and ends at the vert where a step does not lead to a better one.
template<class M, class Solver>
class mean_search {
  static constexpr const char* caller = "karcher_mean";
  const prepared_log_map<M, Solver>& log_;
  const weighted_verts<M>& sites_;
  const prepared_trace_geodesic<M> trace_;

  struct candidate {
    vert_t<M> vert;
    tangent_vector step;  // to the mean, as seen from the vert
    double energy;        // the mean of squared distances
  };

  candidate at(const vert_t<M>& v) const {
    const auto seen = log_.log_map_from(v);
    candidate c{v, {}, 0};
    for (const auto& [w, weight] : sites_) {
      if (!(weight > 0)) continue;
      const double d = seen.distance[w];
      if (d == std::numeric_limits<double>::infinity())
        core::throw_joined<invalid_argument>({caller, ": no path leads from vert ", index_of(log_.mesh(), v),
                                              " to vert ", index_of(log_.mesh(), w), "; take verts of one component"});
      c.step = c.step + (weight * d) * seen.direction[w];
      c.energy += weight * d * d;
    }
    return c;
  }

  mesh_point<M> after_step(const candidate& c) const {
    const double length = norm(c.step);
    if (!(length > 0)) return {c.vert, to_vec3(point(log_.mesh(), c.vert))};
    return trace_.trace_from(c.vert, c.step, length).points.back();
  }

  vert_t<M> nearest_vert(const mesh_point<M>& x) const {
    const M& m = log_.mesh();
    if (const auto* v = std::get_if<vert_t<M>>(&x.element)) return *v;
    vert_t<M> best{};
    double least = std::numeric_limits<double>::infinity();
    const auto take_nearest = [&](const auto& all) {
      for (const vert_t<M> v : all)
        if (const double d = distance(to_vec3(point(m, v)), x.position); d < least) {
          least = d;
          best = v;
        }
    };
    if (const auto* e = std::get_if<edge_point<M>>(&x.element)) take_nearest(adj_e2v(m, e->edge));
    else take_nearest(adj_p2v(m, std::get<poly_t<M>>(x.element)));
    return best;
  }

 public:
  mean_search(const prepared_log_map<M, Solver>& log, const weighted_verts<M>& sites)
      : log_(log), sites_(sites), trace_(log.mesh()) {}

  mesh_point<M> run() const {
    std::size_t first = 0;
    for (std::size_t i = 1; i < sites_.size(); ++i)
      if (sites_[i].second > sites_[first].second) first = i;
    candidate best = at(sites_[first].first);
    while (true) {
      const mesh_point<M> x = after_step(best);
      const vert_t<M> v = nearest_vert(x);
      if (v == best.vert) return x;
      const candidate next = at(v);
      if (!(next.energy < best.energy)) return x;
      best = next;
    }
  }
};

}  // namespace detail

/// The point of a surface with the smallest mean of squared distances to some verts, near the one with the largest
/// weight: auto x = karcher_mean(m, {v, w}), or with weights karcher_mean(m, {{v, 0.5}, {w, 2.0}}). It is where
/// logarithmic maps have the mean 0; on the plane it is the mean of the points.
/// Needs:  as log_map. sites: a container of verts or of pairs of a vert and a weight, or braces of either. With a
///         prepared_log_map in place of the mesh, its factorisation is used again.
/// Result: a point of the mesh. On flat parts exact to rounding. Elsewhere it is one step, of less than about an edge,
///         from the best vert, with the errors of log_map. On large parts of round surfaces there may be several such
///         points; this is one of them.
/// Cost:   as log_map; each step is a query, and commonly there are two to five.
/// Errors: as log_map and trace_geodesic. invalid_argument if no weight is above 0, one is negative or not finite, or
///         no path leads between two verts. invalid_mesh if a vert is not one of the mesh.
/// Source: Karcher 1977, "Riemannian center of mass and mollifier smoothing"; Sharp, Soliman, Crane 2019, "The vector
///         heat method", section 8.3.
template<class M, class S, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      (detail::gives_weighted_verts<M, S> || detail::gives_several_verts<M, S>)&&SparseSolver<
          Solver, Eigen::SparseMatrix<double>,
          Eigen::VectorXd> mesh_point<std::remove_cvref_t<M>> karcher_mean(M&& m, const S& sites,
                                                                           const log_map_options& options = {},
                                                                           Solver&& solver = {}) {
    const auto weighted = detail::read_weighted_verts<std::remove_cvref_t<M>>(m, sites, "karcher_mean");
    const auto log = prepare_log_map(m, options, solver);
    return detail::mean_search(log, weighted).run();
  }
template<class M, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          mesh_point<std::remove_cvref_t<M>> karcher_mean(M&& m, std::initializer_list<vert_t<M>> sites,
                                                          const log_map_options& options = {}, Solver&& solver = {}) {
    return karcher_mean<M, std::initializer_list<vert_t<M>>, Solver>(m, sites, options, std::forward<Solver>(solver));
  }
template<class M, class Solver = ldlt>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
          mesh_point<std::remove_cvref_t<M>> karcher_mean(M&& m,
                                                          std::initializer_list<std::pair<vert_t<M>, double>> sites,
                                                          const log_map_options& options = {}, Solver&& solver = {}) {
    return karcher_mean<M, std::initializer_list<std::pair<vert_t<M>, double>>, Solver>(m, sites, options,
                                                                                        std::forward<Solver>(solver));
  }
template<class M, class Solver, class S>
  requires(detail::gives_weighted_verts<M, S> || detail::gives_several_verts<M, S>)
mesh_point<M> karcher_mean(const prepared_log_map<M, Solver>& log, const S& sites) {
  const auto weighted = detail::read_weighted_verts<M>(log.mesh(), sites, "karcher_mean");
  return detail::mean_search(log, weighted).run();
}

// What to write instead of calls that cannot compile.
template<class... T> void karcher_mean(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void karcher_mean(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void karcher_mean(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void karcher_mean(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, not 0

}  // namespace concino
