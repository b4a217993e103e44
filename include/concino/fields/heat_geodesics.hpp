// Distances over surfaces and through volumes of any polys, by heat: the mesh is prepared once, and a question costs back-substitutions.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/detail/message.hpp>
#include <concino/detail/number_text.hpp>
#include <concino/fields/detail/geodesic_sources.hpp>
#include <concino/fields/detail/heat_preparation.hpp>
#include <concino/progress.hpp>
#include <concino/solve/auto_solver.hpp>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// natural:  no heat crosses the boundary (Neumann): distances come out too round where they meet it.
/// cold:     the boundary takes up all heat (Dirichlet), which bends them the other way.
/// averaged: the sum of both kinds of heat: the best, at the price of one factorisation and one back-substitution more, if there is a boundary.
enum class heat_boundary { averaged, natural, cold };

struct heat_geodesics_options {
  concino::weights weights = concino::weights::standard;  // of the Laplacian; uniform: heat flows along edges, lengths stay those of the mesh
  double time = 0;                                        // how long heat flows, in units of length^2, finite; 0: (1.5 times the mean edge length)^2
  concino::heat_boundary boundary = concino::heat_boundary::averaged;
  concino::progress progress = nullptr;
};

/// What heat_geodesics prepares: it answers questions, from several threads too if the solver can. Copies share what was prepared.
template<AnyMesh M, class Solver>
  requires Embedded<M>
class prepared_heat_geodesics {
  struct preparation {
    detail::heat_system<Solver> system;
    double time, edge;
  };
  struct start {
    vert_t<M> vert;
    double distance;
    bool is_exact;  // of a point nearby, so no further than this vert is asked
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

  static preparation prepare(const M& m, const heat_geodesics_options& options, const Solver& solver) {
    if (!(options.time >= 0 && options.time <= std::numeric_limits<double>::max()))
      detail::throw_joined<invalid_argument>({"heat_geodesics: time is ", detail::number_text(options.time), "; it must be finite and 0 or more"});
    detail::tell(options.progress, 0, "heat geodesics");
    detail::corner_fluxes corners = detail::fluxes_of(m);
    const double edge = detail::mean_edge_length(m), time = options.time > 0 ? options.time : 2.25 * edge * edge;
    const bool uniform = options.weights == weights::uniform;
    Eigen::SparseMatrix<double> stiffness = detail::lower_stiffness(m, uniform ? weights::standard : options.weights);
    const auto mass = vert_masses(m);
    double sum = 0;
    for (const double x : mass.values()) sum += x;
    const double mean = num_verts(m) > 0 ? sum / static_cast<double>(num_verts(m)) : 0;
    // uniform: the mean mass at every vert, and as much conductance at every edge as a grid of mean edges has
    const double flow = uniform ? (edge > 0 ? mean / (edge * edge) : 0) * time : time;
    const auto heat_by = [&](Eigen::SparseMatrix<double> a) {
      for (int c = 0; c < a.cols(); ++c) {
        const double here = mass.values()[static_cast<std::size_t>(c)];
        for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
          a.valuePtr()[k] *= flow;
          if (a.innerIndexPtr()[k] == c) a.valuePtr()[k] += uniform && here > 0 ? mean : here;
        }
      }
      return a;
    };
    Eigen::SparseMatrix<double> heat = heat_by(uniform ? detail::lower_stiffness(m, weights::uniform) : stiffness);
    detail::tell(options.progress, 0.1, "factorising");
    preparation r{{std::move(stiffness), std::move(corners), mean, solver}, time, edge};
    detail::tell(options.progress, 0.4, "factorising");
    std::vector<unsigned char> is_cold;
    if (options.boundary != heat_boundary::natural) is_cold = detail::boundary_verts(m);
    const bool has_boundary = std::find(is_cold.begin(), is_cold.end(), 1) != is_cold.end();
    // Not quite 0 at the boundary, so that it has a logarithm, and sources there warm the rest.
    const auto chilled = [&](Eigen::SparseMatrix<double> a) {
      for (int c = 0; c < a.cols(); ++c)
        if (is_cold[static_cast<std::size_t>(c)]) a.coeffRef(c, c) *= 1e6;
      return a;
    };
    if (!has_boundary || options.boundary != heat_boundary::cold) {
      r.system.add_heat(Eigen::SparseMatrix<double>(heat), solver);
      if (!uniform && r.system.is_heat_negative()) {
        r.system.forget_heat();
        heat = heat_by(detail::lower_positive_stiffness(m));
        r.system.add_heat(Eigen::SparseMatrix<double>(heat), solver);
      }
    }
    detail::tell(options.progress, 0.7, "factorising");
    if (has_boundary) r.system.add_heat(chilled(std::move(heat)), solver);
    detail::tell(options.progress, 1, "heat geodesics");
    return r;
  }

  int number(const vert_t<M>& v) const { return static_cast<int>(index_of(mesh_.get(), v)); }

  void add_start(std::vector<start>& starts, const vert_t<M>& v, double distance) const {
    if (!contains(mesh_.get(), v))
      throw invalid_mesh("heat_geodesics: a source is no vert of the mesh; take it from verts(m)");
    if (!std::isfinite(distance))
      detail::throw_joined<invalid_argument>(
          {"heat_geodesics: the initial distance at vert ", static_cast<std::size_t>(index_of(mesh_.get(), v)), " is not finite"});
    starts.push_back({v, distance, false});
  }

  vert_map<M, double> answer(const std::vector<start>& starts) const;

 public:
  prepared_heat_geodesics(const M& m, const heat_geodesics_options& options, const Solver& solver)
      : mesh_(m), prepared_(std::make_shared<const preparation>(prepare(m, options, solver))) {}

  const M& mesh() const { return mesh_.get(); }
  /// How long heat flows, in units of length^2.
  double time() const { return prepared_->time; }

  /// How far away everything is from one vert, from the nearest of several, or, where pairs of a vert and a number are given, from the source for
  /// which the number plus the way from there is least.
  /// Needs:  a vert, a container of verts or of pairs, or braces of either: {v, w}, {{v, 0.5}, {w, 0.0}}. The mesh is as it was prepared.
  /// Result: a map of double, in units of length; 0 (or the number given, where no other source is nearer) at sources, never less than at the
  ///         least of the sources of the component; +inf in components of polys without a source and at verts of no poly that are no source.
  /// Cost:   two back-substitutions, O(size of the polys); more than one of the first where heat has to be carried on, see heat_geodesics.
  /// Errors: invalid_argument if there is no source or a number is not finite; invalid_mesh if a source is no vert of the mesh; solver_error.
  template<class S>
    requires(detail::gives_verts<M, S> || detail::gives_distances<M, S>)
  vert_map<M, double> distance_from(const S& sources) const {
    std::vector<start> starts;
    detail::for_each_source<M>(sources, [&](const vert_t<M>& v, double d) { add_start(starts, v, d); });
    return answer(starts);
  }
  vert_map<M, double> distance_from(std::initializer_list<vert_t<M>> sources) const {
    return distance_from<std::initializer_list<vert_t<M>>>(sources);
  }
  vert_map<M, double> distance_from(std::initializer_list<std::pair<vert_t<M>, double>> sources) const {
    return distance_from<std::initializer_list<std::pair<vert_t<M>, double>>>(sources);
  }

  /// How far away everything is from a point of poly p.
  /// Needs:  x lies on or in p, which is best convex: its verts are as far away as straight lines say.
  /// Result, cost: as above.
  /// Errors: invalid_mesh if p is no poly of the mesh; invalid_argument if x is not finite.
  vert_map<M, double> distance_from(const poly_t<M>& p, const vec3& x) const {
    const M& m = mesh_.get();
    if (!contains(m, p)) throw invalid_mesh("heat_geodesics: the poly of a source is no poly of the mesh; take it from polys(m)");
    if (!is_finite(x)) throw invalid_argument("heat_geodesics: the point of a source is not finite");
    std::vector<start> starts;
    for (const vert_t<M> v : adj_p2v(m, p)) starts.push_back({v, distance(x, to_vec3(point(m, v))), true});
    return answer(starts);
  }
};

template<AnyMesh M, class Solver>
  requires Embedded<M>
vert_map<M, double> prepared_heat_geodesics<M, Solver>::answer(const std::vector<start>& starts) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (starts.empty()) throw invalid_argument("heat_geodesics: there is no source; give at least one vert");
  const M& m = mesh_.get();
  const auto& system = prepared_->system;
  const double decay = std::sqrt(prepared_->time), edge = prepared_->edge;
  auto distance_at = make_vert_map<double>(m, infinity);
  const auto size = distance_at.values().size();

  // Heat starts as much later as a source lies further back, relative to the first of its component.
  std::vector<double> least(size, infinity);  // of the distances given in each component
  const auto component = [&](const start& s) { return static_cast<std::size_t>(system.component(number(s.vert))); };
  for (const start& s : starts) least[component(s)] = std::min(least[component(s)], s.distance);
  std::vector<detail::heat_source> sources;
  for (const start& s : starts)
    if (const double strength = std::exp((least[component(s)] - s.distance) / decay); strength > 0) sources.push_back({number(s.vert), strength});
  std::vector<double> heat = system.log_heat(sources);
  bool complete = true;
  for (std::size_t i = 0; i < size; ++i) {
    const auto c = static_cast<std::size_t>(system.component(static_cast<int>(i)));
    complete = complete && (heat[i] > -infinity || least[c] == infinity);
  }
  if (!complete) detail::fill_along_edges(m, decay, heat);
  const Eigen::VectorXd rise = system.rise_along(heat);

  // The rise is known up to a constant in each component. At a source it is too round, so it is fitted to the verts around: these are as far
  // away as their edges are long. Of sources that others overtake that is not true: they ask for more than others do, and are passed over.
  std::vector<double> least_shift(size, infinity), sum(size), count(size);
  std::vector<double> shift_at;
  for (const start& s : starts) {
    double shift = 0, n = 0;
    const vec3 x = to_vec3(point(m, s.vert));
    if (!s.is_exact)
      for (const vert_t<M> w : adj_v2v(m, s.vert)) {
        if (system.component(number(w)) != system.component(number(s.vert))) continue;
        shift += s.distance + distance(x, to_vec3(point(m, w))) - rise[number(w)];
        n += 1;
      }
    shift_at.push_back(n > 0 ? shift / n : s.distance - rise[number(s.vert)]);
    least_shift[component(s)] = std::min(least_shift[component(s)], shift_at.back());
  }
  for (std::size_t k = 0; k < starts.size(); ++k) {
    const std::size_t c = component(starts[k]);
    if (shift_at[k] > least_shift[c] + edge) continue;
    sum[c] += shift_at[k];
    count[c] += 1;
  }
  for (std::size_t i = 0; i < size; ++i) {
    const auto c = static_cast<std::size_t>(system.component(static_cast<int>(i)));
    if (count[c] > 0) distance_at.values()[i] = std::max(least[c], rise[static_cast<Eigen::Index>(i)] + sum[c] / count[c]);
  }
  for (const start& s : starts) distance_at[s.vert] = std::min(distance_at[s.vert], s.distance);
  return distance_at;
}

/// Prepares distances over a surface or through a volume, for many questions: auto heat = heat_geodesics(m); auto d = heat.distance_from(v);
/// d[w] is a length.
/// Needs:  Embedded AnyMesh, no temporary, that stays as it is; for cotangent weights all polys triangles or tets. solver: a SparseSolver for
///         symmetric positive definite matrices; two or three of its type are kept, made of its options() where it has them.
/// Result: an object that answers distance_from(...). Distances are approximate: with the default time the mean error falls with the edge length, and
///         is far less than an edge. Heat is kept as its logarithm, whose gradient is as steep far away as near by, and is carried on where
///         it is too little for double precision, so that distances are right over any number of edges; each 1250 sqrt(time) of distance
///         cost another back-substitution. Laplacians with negative weights may make it negative, where polys are very long and thin: then
///         it flows by positive weights along edges instead, and where it still is, shortest ways along edges take its place. A longer time makes
///         distances smoother, and rounder near the boundary.
/// Cost:   two sparse factorisations of as many unknowns as there are verts, three where there is a boundary, see heat_boundary; one
///         more where heat has to flow along edges.
/// Errors: invalid_argument if time is out of its range; invalid_mesh if a poly has no area or volume or points that are not finite;
///         unsupported as laplacian; solver_error; cancelled.
/// Source: Crane, Weischedel, Wardetzky 2013, "Geodesics in heat"; the logarithm: Varadhan 1967; paper section 2.2, "Distances and paths".
template<class M, class Solver = auto_solver>
  requires AnyMesh<M> && Embedded<M> && requirement::is_no_temporary<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_heat_geodesics<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> heat_geodesics(M&& m, const heat_geodesics_options& options = {},
                                                                                             Solver&& solver = {}) {
  return {m, options, solver};
}

}  // namespace concino
