// Geodesic distances by the heat method, on surfaces and volumes of any polys. After a preparation, a query costs back-substitutions.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/geodesic_sources.hpp>
#include <concino/fields/detail/heat_preparation.hpp>
#include <concino/fields/detail/euclidean_distance.hpp>
#include <concino/fields/detail/laplace_system.hpp>
#include <concino/fields/detail/scaled_mesh.hpp>
#include <concino/operators/virtual_elements.hpp>
#include <concino/solve/auto_solver.hpp>

#include <algorithm>
#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

/// averaged:  the sum of both kinds of heat. It is the most accurate, and costs one more factorisation and back-substitution if there is a boundary.
/// neumann:   no heat flows through the boundary. Distances are too round near it.
/// dirichlet: the boundary absorbs all heat, which bends distances the other way.
enum class heat_boundary { averaged, neumann, dirichlet };

struct heat_geodesics_options {
  double time = 0;                                        // how long heat flows, in units of length^2, finite; 0: the default, see heat_geodesics
  concino::heat_boundary boundary = concino::heat_boundary::averaged;  // boundary conditions of the heat
  bool clamp = true;                                      // to the range between straight lines and paths over the mesh, see heat_geodesics
  concino::progress progress = nullptr;                   // called with "heat geodesics" and "factorising"
};

namespace detail {

/// The lower triangle of the stiffness matrix of the mesh at the size of `scaled`.
template<class M, class D>
Eigen::SparseMatrix<double> lower_stiffness_at(const views::scaled<M>& scaled, const M& m, const D& discretisation) {
  if constexpr (scales_with<D, M>) {
    return lower_stiffness(scaled, discretisation);
  } else {
    Eigen::SparseMatrix<double> a = lower_stiffness(m, discretisation);
    for (Eigen::Index k = 0; k < a.nonZeros(); ++k) a.valuePtr()[k] = std::ldexp(a.valuePtr()[k], (2 - dimension_v<M>) * scaled.exponent());
    return a;
  }
}

/// The lower triangle of the masses plus `flow` times the stiffness a; mass(c) is the mass of column c.
template<class Mass>
Eigen::SparseMatrix<double> lower_heat_matrix(Eigen::SparseMatrix<double> a, double flow, const Mass& mass) {
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
      a.valuePtr()[k] *= flow;
      if (a.innerIndexPtr()[k] == c) a.valuePtr()[k] += mass(c);
    }
  return a;
}

/// The heat matrix a with Dirichlet conditions at these verts. Heat there is not quite 0, so that it has a logarithm and sources there heat the rest.
inline Eigen::SparseMatrix<double> with_dirichlet_verts(Eigen::SparseMatrix<double> a, std::span<const unsigned char> is_dirichlet) {
  for (int c = 0; c < a.cols(); ++c)
    if (is_dirichlet[static_cast<std::size_t>(c)]) a.coeffRef(c, c) *= 1e6;
  return a;
}

}  // namespace detail

/// A mesh prepared by prepare_heat_geodesics for distance queries. Several threads may query it if the solver allows it. Copies share the prepared data.
template<class M, class Solver>
class prepared_heat_geodesics {
  using scaled_mesh = views::scaled<M>;
  struct preparation {  // all lengths are those of the scaled mesh
    detail::heat_system<Solver> system;
    detail::distance_graph graph;
    std::vector<double> mass;
    double time;
    int exponent;
    bool clamp;

    bool is_heat_negative() const {
      const auto sources = system.one_source_per_component();
      std::vector<double> guess;
      if (system.is_iterative()) {
        std::vector<detail::distance_graph::start> starts;
        for (const detail::heat_source& s : sources) starts.push_back({s.vert, 0, 0, 0});
        guess = graph.path_lengths_from(starts, std::numeric_limits<double>::infinity());
        for (double& x : guess) x /= -std::sqrt(time);
      }
      return system.is_heat_negative(sources, guess);
    }
  };
  struct query {
    std::vector<detail::distance_source> sources;
    std::vector<detail::distance_graph::start> starts;
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

  template<class D>
  static preparation prepare(const M& mesh_in, const D& discretisation, const heat_geodesics_options& options, const Solver& solver) {
    if (!(options.time >= 0 && options.time <= std::numeric_limits<double>::max()))
      core::throw_joined<invalid_argument>({"heat_geodesics: time is ", core::number_text(options.time), "; it must be finite and 0 or more"});
    detail::report_progress(options.progress, 0, "heat geodesics");
    const scaled_mesh m = detail::scaled_to_unit(mesh_in);
    detail::corner_fluxes corners = detail::fluxes_of(m);
    const double edge = detail::mean_edge_length(m);
    const double time = options.time > 0 ? std::ldexp(options.time, -2 * m.exponent()) : 2 * detail::mean_square_width(m) / dimension_v<M>;
    constexpr bool along_edges = requirement::has_masses<D, M>;  // lengths are still those of the mesh
    Eigen::SparseMatrix<double> stiffness;
    if constexpr (along_edges) stiffness = lower_stiffness(m, virtual_elements);
    else stiffness = detail::lower_stiffness_at(m, mesh_in, discretisation);
    const auto mass = vert_masses(m);
    double sum = 0;
    for (const double x : mass.values()) sum += x;
    const double mean = num_verts(m) > 0 ? sum / static_cast<double>(num_verts(m)) : 0;
    // Along edges: the mean mass at every vert, and at every edge the conductance of a grid with edges of mean length.
    const double flow = along_edges ? (edge > 0 ? mean / (edge * edge) : 0) * time : time;
    std::vector<double> own;
    if constexpr (along_edges) own = detail::lumped_masses(mesh_in, discretisation, "heat_geodesics");
    const auto heat_by = [&](Eigen::SparseMatrix<double> a) {
      return detail::lower_heat_matrix(std::move(a), flow, [&](int c) {
        const double here = mass.values()[static_cast<std::size_t>(c)];
        return along_edges && here > 0 ? mean * own[static_cast<std::size_t>(c)] : here;
      });
    };
    Eigen::SparseMatrix<double> heat = along_edges ? heat_by(lower_stiffness(mesh_in, discretisation)) : heat_by(stiffness);
    detail::report_progress(options.progress, 0.1, "factorising");
    preparation r{{std::move(stiffness), std::move(corners), mean, solver},
                  detail::distance_graph_of(m),
                  {mass.values().begin(), mass.values().end()},
                  time,
                  m.exponent(),
                  options.clamp};
    detail::report_progress(options.progress, 0.4, "factorising");
    const auto is_dirichlet_vert = options.boundary == heat_boundary::neumann ? make_vert_map<bool>(m, false) : boundary_verts(m);
    const std::span<const unsigned char> is_dirichlet = is_dirichlet_vert.values();
    const bool has_boundary = std::find(is_dirichlet.begin(), is_dirichlet.end(), 1) != is_dirichlet.end();
    if (!has_boundary || options.boundary != heat_boundary::dirichlet) {
      r.system.add_heat(Eigen::SparseMatrix<double>(heat), solver);
      if (!along_edges && r.is_heat_negative()) {
        r.system.forget_heat();
        heat = heat_by(detail::lower_positive_stiffness(m));
        r.system.add_heat(Eigen::SparseMatrix<double>(heat), solver);
      }
    }
    detail::report_progress(options.progress, 0.7, "factorising");
    if (has_boundary) r.system.add_heat(detail::with_dirichlet_verts(std::move(heat), is_dirichlet), solver);
    detail::report_progress(options.progress, 1, "heat geodesics");
    return r;
  }

  int number(const vert_t<M>& v) const { return static_cast<int>(index_of(mesh_.get(), v)); }

  double scale_down(double length) const { return std::ldexp(length, -prepared_->exponent); }

  void add_source(query& q, const vert_t<M>& v, double distance) const {
    if (!contains(mesh_.get(), v))
      throw invalid_mesh("heat_geodesics: a source is not a vert of the mesh; take it from verts(m)");
    if (!std::isfinite(distance))
      core::throw_joined<invalid_argument>(
          {"heat_geodesics: the initial distance at vert ", index_of(mesh_.get(), v), " is not finite"});
    const int i = number(v);
    q.starts.push_back({i, static_cast<int>(q.sources.size()), 0, scale_down(distance)});
    q.sources.push_back({prepared_->graph.position(static_cast<std::size_t>(i)), scale_down(distance)});
  }

  static double path_length_at_source(const detail::distance_graph::start& s) { return s.before + s.distance; }
  static std::size_t index(const detail::distance_graph::start& s) { return static_cast<std::size_t>(s.vert); }
  std::size_t component(std::size_t i) const { return static_cast<std::size_t>(prepared_->system.component(static_cast<int>(i))); }

  std::vector<double> log_heat(const query& q, const std::vector<double>& least, const std::vector<double>& longest) const;
  vert_map<M, double> answer(const query& q) const;

 public:
  template<class D>
  prepared_heat_geodesics(const M& m, const D& discretisation, const heat_geodesics_options& options, const Solver& solver)
      : mesh_(m), prepared_(std::make_shared<const preparation>(prepare(m, discretisation, options, solver))) {}

  const M& mesh() const { return mesh_.get(); }
  /// How long heat flows, in units of length^2.
  double time() const { return std::ldexp(prepared_->time, 2 * prepared_->exponent); }

  /// The distances of all verts from these sources.
  /// Needs:  sources as for heat_geodesics. The mesh has not changed since it was prepared.
  /// Result: that of heat_geodesics.
  /// Cost:   two back-substitutions, three where there is a boundary, and a search for shortest paths; more if heat underflows and is continued. With
  ///         iterative solvers one solve and iterations in bands, see heat_geodesics.
  /// Errors: invalid_argument if there is no source or a number is not finite; invalid_mesh if a source is not a vert of the mesh; solver_error.
  template<class S>
    requires(detail::gives_verts<M, S> || detail::gives_distances<M, S>)
  vert_map<M, double> distance_from(const S& sources) const {
    query q;
    detail::for_each_distance_source<M>(sources, [&](const vert_t<M>& v, double d) { add_source(q, v, d); });
    return answer(q);
  }
  vert_map<M, double> distance_from(std::initializer_list<vert_t<M>> sources) const {
    return distance_from<std::initializer_list<vert_t<M>>>(sources);
  }
  vert_map<M, double> distance_from(std::initializer_list<std::pair<vert_t<M>, double>> sources) const {
    return distance_from<std::initializer_list<std::pair<vert_t<M>, double>>>(sources);
  }
  void distance_from(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0

  /// The distances of all verts from a point of poly p.
  /// Needs:  x lies on or in p. p should be convex: the distances of its verts are those of straight lines.
  /// Result, cost: as above.
  /// Errors: invalid_mesh if p is not a poly of the mesh; invalid_argument if x is not finite.
  vert_map<M, double> distance_from(const poly_t<M>& p, const vec3& x) const {
    const M& m = mesh_.get();
    if (!contains(m, p)) throw invalid_mesh("heat_geodesics: the poly of a source is not a poly of the mesh; take it from polys(m)");
    if (!is_finite(x)) throw invalid_argument("heat_geodesics: the point of a source is not finite");
    query q;
    q.sources.push_back({vec3{scale_down(x.x), scale_down(x.y), scale_down(x.z)}, 0});
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const int i = number(v);
      q.starts.push_back({i, 0, distance(q.sources[0].position, prepared_->graph.position(static_cast<std::size_t>(i))), 0});
    }
    return answer(q);
  }
};

/// The logarithm of heat. A source is the weaker the more its initial distance exceeds `least`, the smallest one in its component.
/// longest: lengths of paths to each vert.
template<class M, class Solver>
std::vector<double> prepared_heat_geodesics<M, Solver>::log_heat(const query& q, const std::vector<double>& least, const std::vector<double>& longest) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double decay = std::sqrt(prepared_->time);
  std::vector<detail::heat_source> sources;
  for (const auto& s : q.starts)
    if (const double strength = std::exp((least[component(index(s))] - path_length_at_source(s)) / decay); strength > 0) sources.push_back({s.vert, strength});
  std::vector<double> guess(least.size(), -infinity);
  for (std::size_t i = 0; i < guess.size(); ++i)
    if (longest[i] < infinity) guess[i] = (least[component(i)] - longest[i]) / decay;
  std::vector<double> heat = prepared_->system.log_heat(sources, guess);
  bool complete = true;
  for (std::size_t i = 0; i < least.size(); ++i) complete = complete && (heat[i] > -infinity || least[component(i)] == infinity);
  if (!complete) detail::fill_along_edges(scaled_mesh(mesh_.get(), prepared_->exponent), decay, heat);
  return heat;
}

template<class M, class Solver>
vert_map<M, double> prepared_heat_geodesics<M, Solver>::answer(const query& q) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (q.starts.empty()) throw invalid_argument("heat_geodesics: there is no source; give at least one vert");
  const double decay = std::sqrt(prepared_->time);
  auto distance_at = make_vert_map<double>(mesh_.get(), infinity);
  const auto size = distance_at.values().size();
  std::vector<double> least(size, infinity);  // of the initial distances in each component
  for (const auto& s : q.starts) least[component(index(s))] = std::min(least[component(index(s))], path_length_at_source(s));
  // The integral of the gradient is known up to a constant in each component, and it is too round at a source. The constant is fitted to bounds of the
  // distances near the sources; tighter bounds have more weight.
  constexpr double near = 2;          // verts are used up to this times `decay` from a source,
  constexpr double max_doubt = 0.2;  // if the path over the mesh is longer than the straight line by at most this fraction of it
  // Without clamp, longer paths are only needed as a guess.
  const bool needs_all = prepared_->clamp || prepared_->system.is_iterative();
  double first = -infinity;
  for (const double x : least)
    if (x < infinity) first = std::max(first, x);
  const std::vector<double> longest = prepared_->graph.path_lengths_from(q.starts, needs_all ? infinity : first + (1 + max_doubt) * near * decay);
  const Eigen::VectorXd potential = prepared_->system.integrate_gradient(log_heat(q, least, longest));
  const detail::euclidean_distance straight(q.sources);
  std::vector<double> shortest(size), sum(size), weight(size);
  for (std::size_t i = 0; i < size; ++i) {
    if (!(longest[i] < infinity)) continue;
    shortest[i] = straight(prepared_->graph.position(i));
    const std::size_t c = component(i);
    const double off = shortest[i] - least[c], doubt = longest[i] - shortest[i];
    if (!(off > 0 && off <= near * decay && doubt <= max_doubt * off)) continue;
    const double trust = off / (doubt + 0.01 * off), w = prepared_->mass[i] * trust * trust;
    sum[c] += w * (shortest[i] + doubt / 2 - potential[static_cast<Eigen::Index>(i)]);
    weight[c] += w;
  }
  for (const auto& s : q.starts)
    if (const std::size_t c = component(index(s)); !(weight[c] > 0)) {
      sum[c] += path_length_at_source(s) - potential[s.vert];
      weight[c] -= 1;
    }
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t c = component(i);
    if (least[c] == infinity || (prepared_->clamp && !(longest[i] < infinity))) continue;
    double d = potential[static_cast<Eigen::Index>(i)] + sum[c] / std::abs(weight[c]);
    if (prepared_->clamp) d = std::max(std::min(d, longest[i]), shortest[i]);
    distance_at.values()[i] = std::ldexp(std::max(least[c], d), prepared_->exponent);
  }
  for (const auto& s : q.starts) {
    double& d = distance_at.values()[index(s)];
    d = std::min(d, std::ldexp(path_length_at_source(s), prepared_->exponent));
  }
  return distance_at;
}

/// Prepares geodesic distances over a surface or through a volume, for many queries: auto heat = prepare_heat_geodesics(m);
/// auto d = heat.distance_from(v); d[w] is a length.
/// Needs:  as heat_geodesics; the mesh must not change afterwards. solver: the result keeps two or three of its type, constructed from its options() if
///         it has them. By default auto_solver expects 20 queries, so it factorises all but very large meshes; {.questions = n} says how many you expect.
/// Result: an object with distance_from(...).
/// Cost:   as heat_geodesics without the query.
/// Errors: as heat_geodesics, except those about sources.
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_heat_geodesics<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_heat_geodesics(M&& m, const heat_geodesics_options& options = {},
                                                                                                    Solver&& solver = auto_solver({.questions = 20})) {
  return {m, virtual_elements, options, solver};
}
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_heat_geodesics<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_heat_geodesics(M&& m, const D& discretisation,
                                                                                                    const heat_geodesics_options& options = {},
                                                                                                    Solver&& solver = auto_solver({.questions = 20})) {
  return {m, discretisation, options, solver};
}

/// Geodesic distances of all verts by the heat method, over a surface or through a volume: auto d = heat_geodesics(m, v); d[w] is a length.
/// They are distances from one vert or from the nearest of several. Sources may be pairs of a vert and an initial distance: then d[w] is the
/// minimum over all sources of the initial distance plus the distance from there.
/// Needs:  EmbeddedMesh M, no temporary. sources: a vert, a container of verts or of pairs, or braces of either: {v, w}, {{v, 0.5}, {w, 0.0}}.
///         A discretisation of the Laplacian may follow the sources. If it has masses of its own, as `uniform` has, heat only flows along
///         edges, and gradients and lengths remain those of the mesh. solver: a SparseSolver for symmetric positive definite matrices; two or three of
///         its type are constructed, from its options() if it has them.
/// Result: a map of double, in units of length. A source has distance 0, or its initial distance where no other source is nearer. No vert has
///         less than the smallest initial distance in its component. +inf in components of polys without a source, and at verts of no poly that
///         are no source.
///         Distances are approximate. On the meshes of docs/convergence.md the mean error is at most 0.3 edges, mostly below 0.1. The largest error is
///         below two edges, except for agglomerates round a corner and squeezed polygons.
///         Distances are clamped. They are at most the shortest path along edges and straight across triangles or tets inside the polys, and at least
///         the straight line through space. With .clamp = false they are as smooth as heat, and wrong by some edges on curved surfaces; a
///         query then takes as little as a third of the time. Distances scale exactly with the mesh by powers of two.
///         The default time is twice the squared width of polys, averaged by their measure, over their dimension: two squared edges in grids of
///         squares and of cubes. Heat resolves directions over a distance of about one poly, and rounds off finer details. The average by measure
///         sets that distance by the polys that cover most of the mesh. The many small polys in a corner of a graded mesh do not set it, nor do the
///         short edges of an interlocking polygon. A longer time makes distances smoother, and rounder near the boundary.
///         Heat is stored as its logarithm, whose gradient does not decay with distance. Where heat underflows double precision, it is continued
///         from there, so that distances are right over any number of edges; each 1250 sqrt(time) of distance costs another back-substitution.
///         Where polys are very long and thin, a Laplacian with negative weights may make heat negative. Then heat flows along edges by positive
///         weights instead, and where it still is negative, shortest paths along edges replace it.
/// Cost:   two sparse factorisations with as many unknowns as there are verts, three if there is a boundary (see heat_boundary), one
///         more if heat flows along edges because it was negative. Then two or three back-substitutions and a search for shortest paths, O(n log n)
///         for n elements. For several queries prepare_heat_geodesics factorises once.
///         Iterative solvers, such as multigrid, are only used for the potential of the gradient: one set-up to prepare, and one solve per query. Heat is
///         found by conjugate gradients in bands of verts, from the sources outwards, in 10 to 100 short iterations. At 10^6 triangles a query takes the time of
///         20 to 30 cycles of multigrid, and up to 60 where triangles are long or obtuse. Distances differ by about 1e-4 of the largest from those
///         by factorisation. A tolerance of 1e-6 of the solver is enough. Only bands with many edges far shorter than the square root of the time need a set-up
///         and a solve of their own.
/// Errors: invalid_argument if time is out of its range, there is no source, or an initial distance is not finite. invalid_mesh if a source is no
///         vert of the mesh, or if a poly has no area or volume or points that are not finite. unsupported as laplacian. solver_error. cancelled.
/// Source: Crane, Weischedel, Wardetzky 2013, "Geodesics in heat"; the logarithm: Varadhan 1967; paths across triangles: Novotni, Klein 2002, "Computing
///         geodesic distances on triangular meshes"; paper section 2.2, "Distances and paths".
template<class M, class S, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && (detail::gives_verts<M, S> || detail::gives_distances<M, S>) && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, const S& sources, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, options, solver).distance_from(sources);
}
template<class M, class S, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && (detail::gives_verts<M, S> || detail::gives_distances<M, S>) && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, const S& sources, const D& discretisation, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, discretisation, options, solver).distance_from(sources);
}
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<vert_t<M>> sources, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, options, solver).distance_from(sources);
}
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<vert_t<M>> sources, const D& discretisation, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, discretisation, options, solver).distance_from(sources);
}
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<std::pair<vert_t<M>, double>> sources, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, options, solver).distance_from(sources);
}
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<std::pair<vert_t<M>, double>> sources, const D& discretisation, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, discretisation, options, solver).distance_from(sources);
}

/// Geodesic distances of all verts from a point of poly p, by the heat method.
/// Needs:  x lies on or in p. p should be convex: the distances of its verts are those of straight lines.
/// Result: as above.
/// Cost:   as above.
/// Errors: as above, and invalid_mesh if p is not a poly of the mesh; invalid_argument if x is not finite.
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, const poly_t<M>& p, const vec3& x, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, options, solver).distance_from(p, x);
}
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_lvalue_or_view<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, const poly_t<M>& p, const vec3& x, const D& discretisation, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, discretisation, options, solver).distance_from(p, x);
}

// What to write instead of calls that cannot compile.
template<class... T> void prepare_heat_geodesics(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void prepare_heat_geodesics(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_heat_geodesics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void prepare_heat_geodesics(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void heat_geodesics(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void heat_geodesics(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void heat_geodesics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void heat_geodesics(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
