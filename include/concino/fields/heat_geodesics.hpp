// Distances over surfaces and through volumes of any polys, by heat: the mesh is prepared once, and a question costs back-substitutions.
#pragma once

#include <concino/concepts/sparse_solver.hpp>
#include <concino/core/message.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/progress.hpp>
#include <concino/fields/detail/geodesic_sources.hpp>
#include <concino/fields/detail/heat_preparation.hpp>
#include <concino/fields/detail/straight_distance.hpp>
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

/// natural:  no heat crosses the boundary (Neumann): distances come out too round where they meet it.
/// cold:     the boundary takes up all heat (Dirichlet), which bends them the other way.
/// averaged: the sum of both kinds of heat: the best, at the price of one factorisation and one back-substitution more, if there is a boundary.
enum class heat_boundary { averaged, natural, cold };

struct heat_geodesics_options {
  double time = 0;                                        // how long heat flows, in units of length^2, finite; 0: see heat_geodesics
  concino::heat_boundary boundary = concino::heat_boundary::averaged;  // what happens to heat at the boundary
  bool clamp = true;                                      // to between straight lines and ways over the mesh, see heat_geodesics
  concino::progress progress = nullptr;                   // told "heat geodesics" and "factorising"
};

namespace detail {

/// That of the mesh at the size of `scaled`.
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

/// The lower triangle of the masses plus `flow` times the stiffness a; mass(c) is that of column c.
template<class Mass>
Eigen::SparseMatrix<double> lower_heat_matrix(Eigen::SparseMatrix<double> a, double flow, const Mass& mass) {
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
      a.valuePtr()[k] *= flow;
      if (a.innerIndexPtr()[k] == c) a.valuePtr()[k] += mass(c);
    }
  return a;
}

/// The heat matrix a where these verts take up heat. It is not quite 0 there, so that it has a logarithm, and sources there warm the rest.
inline Eigen::SparseMatrix<double> with_cold_verts(Eigen::SparseMatrix<double> a, std::span<const unsigned char> is_cold) {
  for (int c = 0; c < a.cols(); ++c)
    if (is_cold[static_cast<std::size_t>(c)]) a.coeffRef(c, c) *= 1e6;
  return a;
}

}  // namespace detail

/// What prepare_heat_geodesics prepares: it answers questions, from several threads too if the solver can. Copies share what was prepared.
template<class M, class Solver>
class prepared_heat_geodesics {
  using scaled_mesh = views::scaled<M>;
  struct preparation {  // all lengths as in the scaled mesh
    detail::heat_system<Solver> system;
    detail::distance_graph graph;
    std::vector<double> mass;
    double time;
    int exponent;
    bool clamp;
  };
  struct question {
    std::vector<detail::distance_source> sources;
    std::vector<detail::distance_graph::start> starts;
  };

  detail::mesh_ref<M> mesh_;
  std::shared_ptr<const preparation> prepared_;

  template<class D>
  static preparation prepare(const M& mesh_in, const D& discretisation, const heat_geodesics_options& options, const Solver& solver) {
    if (!(options.time >= 0 && options.time <= std::numeric_limits<double>::max()))
      core::throw_joined<invalid_argument>({"heat_geodesics: time is ", core::number_text(options.time), "; it must be finite and 0 or more"});
    detail::tell(options.progress, 0, "heat geodesics");
    const scaled_mesh m = detail::scaled_to_unit(mesh_in);
    detail::corner_fluxes corners = detail::fluxes_of(m);
    const double edge = detail::mean_edge_length(m);
    const double time = options.time > 0 ? std::ldexp(options.time, -2 * m.exponent()) : 2 * detail::mean_square_width(m) / dimension_v<M>;
    constexpr bool along_edges = requirement::has_masses<D, M>;  // lengths are those of the mesh all the same
    Eigen::SparseMatrix<double> stiffness;
    if constexpr (along_edges) stiffness = lower_stiffness(m, virtual_elements);
    else stiffness = detail::lower_stiffness_at(m, mesh_in, discretisation);
    const auto mass = vert_masses(m);
    double sum = 0;
    for (const double x : mass.values()) sum += x;
    const double mean = num_verts(m) > 0 ? sum / static_cast<double>(num_verts(m)) : 0;
    // Along edges: the mean mass at every vert, and as much conductance at every edge as a grid of mean edges has.
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
    detail::tell(options.progress, 0.1, "factorising");
    preparation r{{std::move(stiffness), std::move(corners), mean, solver},
                  detail::distance_graph_of(m),
                  {mass.values().begin(), mass.values().end()},
                  time,
                  m.exponent(),
                  options.clamp};
    detail::tell(options.progress, 0.4, "factorising");
    const auto cold = options.boundary == heat_boundary::natural ? make_vert_map<bool>(m, false) : boundary_verts(m);
    const std::span<const unsigned char> is_cold = cold.values();
    const bool has_boundary = std::find(is_cold.begin(), is_cold.end(), 1) != is_cold.end();
    if (!has_boundary || options.boundary != heat_boundary::cold) {
      r.system.add_heat(Eigen::SparseMatrix<double>(heat), solver);
      if (!along_edges && r.system.is_heat_negative()) {
        r.system.forget_heat();
        heat = heat_by(detail::lower_positive_stiffness(m));
        r.system.add_heat(Eigen::SparseMatrix<double>(heat), solver);
      }
    }
    detail::tell(options.progress, 0.7, "factorising");
    if (has_boundary) r.system.add_heat(detail::with_cold_verts(std::move(heat), is_cold), solver);
    detail::tell(options.progress, 1, "heat geodesics");
    return r;
  }

  int number(const vert_t<M>& v) const { return static_cast<int>(index_of(mesh_.get(), v)); }

  double down(double length) const { return std::ldexp(length, -prepared_->exponent); }

  void add_source(question& q, const vert_t<M>& v, double distance) const {
    if (!contains(mesh_.get(), v))
      throw invalid_mesh("heat_geodesics: a source is no vert of the mesh; take it from verts(m)");
    if (!std::isfinite(distance))
      core::throw_joined<invalid_argument>(
          {"heat_geodesics: the initial distance at vert ", index_of(mesh_.get(), v), " is not finite"});
    const int i = number(v);
    q.starts.push_back({i, static_cast<int>(q.sources.size()), 0, down(distance)});
    q.sources.push_back({prepared_->graph.place(static_cast<std::size_t>(i)), down(distance)});
  }

  static double given(const detail::distance_graph::start& s) { return s.before + s.distance; }
  static std::size_t index(const detail::distance_graph::start& s) { return static_cast<std::size_t>(s.vert); }
  std::size_t component(std::size_t i) const { return static_cast<std::size_t>(prepared_->system.component(static_cast<int>(i))); }

  std::vector<double> log_heat(const question& q, const std::vector<double>& least) const;
  vert_map<M, double> answer(const question& q) const;

 public:
  template<class D>
  prepared_heat_geodesics(const M& m, const D& discretisation, const heat_geodesics_options& options, const Solver& solver)
      : mesh_(m), prepared_(std::make_shared<const preparation>(prepare(m, discretisation, options, solver))) {}

  const M& mesh() const { return mesh_.get(); }
  /// How long heat flows, in units of length^2.
  double time() const { return std::ldexp(prepared_->time, 2 * prepared_->exponent); }

  /// How far away everything is from these sources.
  /// Needs:  sources as for heat_geodesics. The mesh is as it was prepared.
  /// Result: that of heat_geodesics.
  /// Cost:   two back-substitutions, three where there is a boundary, and a search for shortest ways; more where heat has to be carried on.
  /// Errors: invalid_argument if there is no source or a number is not finite; invalid_mesh if a source is no vert of the mesh; solver_error.
  template<class S>
    requires(detail::gives_verts<M, S> || detail::gives_distances<M, S>)
  vert_map<M, double> distance_from(const S& sources) const {
    question q;
    detail::for_each_source<M>(sources, [&](const vert_t<M>& v, double d) { add_source(q, v, d); });
    return answer(q);
  }
  vert_map<M, double> distance_from(std::initializer_list<vert_t<M>> sources) const {
    return distance_from<std::initializer_list<vert_t<M>>>(sources);
  }
  vert_map<M, double> distance_from(std::initializer_list<std::pair<vert_t<M>, double>> sources) const {
    return distance_from<std::initializer_list<std::pair<vert_t<M>, double>>>(sources);
  }
  void distance_from(mistake::number<mistake::name_the_element>, ...) const = delete;  // elements have types: vert_id{0}, not 0

  /// How far away everything is from a point of poly p.
  /// Needs:  x lies on or in p, which is best convex: its verts are as far away as straight lines say.
  /// Result, cost: as above.
  /// Errors: invalid_mesh if p is no poly of the mesh; invalid_argument if x is not finite.
  vert_map<M, double> distance_from(const poly_t<M>& p, const vec3& x) const {
    const M& m = mesh_.get();
    if (!contains(m, p)) throw invalid_mesh("heat_geodesics: the poly of a source is no poly of the mesh; take it from polys(m)");
    if (!is_finite(x)) throw invalid_argument("heat_geodesics: the point of a source is not finite");
    question q;
    q.sources.push_back({vec3{down(x.x), down(x.y), down(x.z)}, 0});
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const int i = number(v);
      q.starts.push_back({i, 0, distance(q.sources[0].place, prepared_->graph.place(static_cast<std::size_t>(i))), 0});
    }
    return answer(q);
  }
};

/// The logarithm of heat. It starts as much later as a source lies further back, relative to the first of its component, which lies at `least`.
template<class M, class Solver>
std::vector<double> prepared_heat_geodesics<M, Solver>::log_heat(const question& q, const std::vector<double>& least) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double decay = std::sqrt(prepared_->time);
  std::vector<detail::heat_source> sources;
  for (const auto& s : q.starts)
    if (const double strength = std::exp((least[component(index(s))] - given(s)) / decay); strength > 0) sources.push_back({s.vert, strength});
  std::vector<double> heat = prepared_->system.log_heat(sources);
  bool complete = true;
  for (std::size_t i = 0; i < least.size(); ++i) complete = complete && (heat[i] > -infinity || least[component(i)] == infinity);
  if (!complete) detail::fill_along_edges(scaled_mesh(mesh_.get(), prepared_->exponent), decay, heat);
  return heat;
}

template<class M, class Solver>
vert_map<M, double> prepared_heat_geodesics<M, Solver>::answer(const question& q) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (q.starts.empty()) throw invalid_argument("heat_geodesics: there is no source; give at least one vert");
  const double decay = std::sqrt(prepared_->time);
  auto distance_at = make_vert_map<double>(mesh_.get(), infinity);
  const auto size = distance_at.values().size();
  std::vector<double> least(size, infinity);  // of the distances given in each component
  for (const auto& s : q.starts) least[component(index(s))] = std::min(least[component(index(s))], given(s));
  const Eigen::VectorXd rise = prepared_->system.rise_along(log_heat(q, least));

  // The rise is known up to a constant in each component, and at a source it is too round. It is fitted to what is known of distances not far from
  // sources, and the more so the better it is known there.
  constexpr double near = 2;          // verts are used up to this times `decay` from a source,
  constexpr double most_doubt = 0.2;  // where the way over the mesh is longer than the straight line by at most this part of it
  // Without clamp, longer ways than those are not needed.
  double first = -infinity;
  for (const double x : least)
    if (x < infinity) first = std::max(first, x);
  const std::vector<double> longest = prepared_->graph.ways_from(q.starts, prepared_->clamp ? infinity : first + (1 + most_doubt) * near * decay);
  const detail::straight_distance straight(q.sources);
  std::vector<double> shortest(size), sum(size), weight(size);
  for (std::size_t i = 0; i < size; ++i) {
    if (!(longest[i] < infinity)) continue;
    shortest[i] = straight(prepared_->graph.place(i));
    const std::size_t c = component(i);
    const double off = shortest[i] - least[c], doubt = longest[i] - shortest[i];
    if (!(off > 0 && off <= near * decay && doubt <= most_doubt * off)) continue;
    const double trust = off / (doubt + 0.01 * off), w = prepared_->mass[i] * trust * trust;
    sum[c] += w * (shortest[i] + doubt / 2 - rise[static_cast<Eigen::Index>(i)]);
    weight[c] += w;
  }
  for (const auto& s : q.starts)
    if (const std::size_t c = component(index(s)); !(weight[c] > 0)) {
      sum[c] += given(s) - rise[s.vert];
      weight[c] -= 1;
    }
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t c = component(i);
    if (least[c] == infinity || (prepared_->clamp && !(longest[i] < infinity))) continue;
    double d = rise[static_cast<Eigen::Index>(i)] + sum[c] / std::abs(weight[c]);
    if (prepared_->clamp) d = std::max(std::min(d, longest[i]), shortest[i]);
    distance_at.values()[i] = std::ldexp(std::max(least[c], d), prepared_->exponent);
  }
  for (const auto& s : q.starts) {
    double& d = distance_at.values()[index(s)];
    d = std::min(d, std::ldexp(given(s), prepared_->exponent));
  }
  return distance_at;
}

/// Prepares distances over a surface or through a volume, for many questions: auto heat = prepare_heat_geodesics(m);
/// auto d = heat.distance_from(v); d[w] is a length.
/// Needs:  as heat_geodesics; the mesh stays as it is. solver: two or three of its type are kept, made of its options() where it has them.
/// Result: an object that answers distance_from(...).
/// Cost:   as heat_geodesics, but for the question.
/// Errors: as heat_geodesics, but for what is about sources.
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_heat_geodesics<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_heat_geodesics(M&& m, const heat_geodesics_options& options = {},
                                                                                                    Solver&& solver = {}) {
  return {m, virtual_elements, options, solver};
}
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
prepared_heat_geodesics<std::remove_cvref_t<M>, std::remove_cvref_t<Solver>> prepare_heat_geodesics(M&& m, const D& discretisation,
                                                                                                    const heat_geodesics_options& options = {},
                                                                                                    Solver&& solver = {}) {
  return {m, discretisation, options, solver};
}

/// How far away every vert is, over the surface or through the volume, from one vert, from the nearest of several, or, where pairs of a vert and a
/// number are given, from the source for which the number plus the way from there is least: auto d = heat_geodesics(m, v); d[w] is a length.
/// Needs:  EmbeddedMesh M, no temporary. sources: a vert, a container of verts or of pairs, or braces of either: {v, w}, {{v, 0.5}, {w, 0.0}}.
///         A discretisation of the Laplacian may stand after them; with one that has masses of its own, as `uniform`, heat only flows along
///         edges, and gradients and lengths stay those of the mesh. solver: a SparseSolver for symmetric positive definite matrices; two or three of
///         its type are made, of its options() where it has them.
/// Result: a map of double, in units of length; 0 (or the number given, where no other source is nearer) at sources, never less than at the
///         least of the sources of the component; +inf in components of polys without a source and at verts of no poly that are no source.
///         Distances are approximate. On the meshes of docs/convergence.md the mean error is 0.3 edges at most, mostly below 0.1; largest errors are below
///         two edges, but where agglomerates stand round a corner or polygons are squeezed. They are no longer than ways along edges and straight across
///         triangles or tets inside the polys, nor shorter than straight lines through space; .clamp = false leaves that out, so that they
///         are as smooth as heat is, and off by some edges where surfaces bend; a question then takes down to a third of the time. Distances
///         scale exactly with the mesh by powers of two.
///         The default time is twice the squared width of polys, averaged by their measure, over their dimension: two squared edges in grids of
///         squares and of cubes. Heat shows directions where it has crossed about a poly, and rounds off what is finer; the polys that most
///         places lie in say how far that is, not the many in a corner of a graded mesh, nor the short edges of an interlocking polygon. A
///         longer time makes distances smoother, and rounder near the boundary.
///         Heat is kept as its logarithm, whose gradient is as steep far away as near by, and is carried on where
///         it is too little for double precision, so that distances are right over any number of edges; each 1250 sqrt(time) of distance
///         cost another back-substitution. Laplacians with negative weights may make it negative, where polys are very long and thin: then
///         it flows by positive weights along edges instead, and where it still is, shortest ways along edges take its place.
/// Cost:   two sparse factorisations of as many unknowns as there are verts, three where there is a boundary, see heat_boundary; one
///         more where heat has to flow along edges; then two or three back-substitutions and a search for shortest ways, O(n log n) for n
///         elements. For several questions prepare_heat_geodesics factorises once.
/// Errors: invalid_argument if time is out of its range, there is no source or its number is not finite; invalid_mesh if a source is no vert
///         of the mesh, or if a poly has no area or volume or points that are not finite; unsupported as laplacian; solver_error; cancelled.
/// Source: Crane, Weischedel, Wardetzky 2013, "Geodesics in heat"; the logarithm: Varadhan 1967; ways across triangles: Novotni, Klein 2002, "Computing
///         geodesic distances on triangular meshes"; paper section 2.2, "Distances and paths".
template<class M, class S, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && (detail::gives_verts<M, S> || detail::gives_distances<M, S>) && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, const S& sources, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, options, solver).distance_from(sources);
}
template<class M, class S, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && (detail::gives_verts<M, S> || detail::gives_distances<M, S>) && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, const S& sources, const D& discretisation, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, discretisation, options, solver).distance_from(sources);
}
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<vert_t<M>> sources, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, options, solver).distance_from(sources);
}
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<vert_t<M>> sources, const D& discretisation, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, discretisation, options, solver).distance_from(sources);
}
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<std::pair<vert_t<M>, double>> sources, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, options, solver).distance_from(sources);
}
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, std::initializer_list<std::pair<vert_t<M>, double>> sources, const D& discretisation, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, discretisation, options, solver).distance_from(sources);
}

/// The same from a point of poly p.
/// Needs:  x lies on or in p, which is best convex: its verts are as far away as straight lines say.
/// Result: as above.
/// Cost:   as above.
/// Errors: as above, and invalid_mesh if p is no poly of the mesh; invalid_argument if x is not finite.
template<class M, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, const poly_t<M>& p, const vec3& x, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, options, solver).distance_from(p, x);
}
template<class M, class D, class Solver = auto_solver>
  requires EmbeddedMesh<M> && requirement::is_no_temporary<M> && Discretisation<D, M> && SparseSolver<Solver, Eigen::SparseMatrix<double>, Eigen::VectorXd>
vert_map<M, double> heat_geodesics(M&& m, const poly_t<M>& p, const vec3& x, const D& discretisation, const heat_geodesics_options& options = {},
                                   Solver&& solver = {}) {
  return prepare_heat_geodesics(m, discretisation, options, solver).distance_from(p, x);
}

// What to write instead of calls that cannot compile.
template<class... T> void prepare_heat_geodesics(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void prepare_heat_geodesics(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void prepare_heat_geodesics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void prepare_heat_geodesics(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0
template<class... T> void heat_geodesics(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or a sibling
template<class... T> void heat_geodesics(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void heat_geodesics(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void heat_geodesics(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: vert_id{0}, poly_id{0} ..., not 0

}  // namespace concino
