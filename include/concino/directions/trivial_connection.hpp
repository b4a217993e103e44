// trivial_connection(m, indices): directions at polys with given singularities, by a connection that turns least.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/directions/detail/connection/trivial_turns.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>
#include <concino/directions/detail/surface/poly_planes.hpp>
#include <concino/directions/singularities.hpp>
#include <concino/graph/tree_cotree.hpp>
#include <concino/mesh/element_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

template<class M>
struct trivial_connection_options {
  int symmetry = 1;                   // n, 1 to 16: the number of directions of a poly; indices are in n-ths of a turn
  std::vector<int> generators = {};   // the index of each generator, see the result; empty: those that turn least
  std::optional<std::pair<poly_t<M>, vec3>> start = {};  // a poly, and one of its directions; empty: any
  concino::progress progress = nullptr;   // called with "trivial_connection"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// A connection with given singularities, and directions at polys that it carries from one to the next.
///
/// Generator i is the strip of polys that crosses edge i of `rest` of tree_cotree(m), and returns through its tree of
/// polys. Its index counts how often directions turn along it against the strip itself, in n-ths of a full turn.
template<class M>
class trivial_connection_result {
  detail::mesh_ref<M> mesh_;
  int symmetry_;
  std::vector<double> turn_;                          // by edge
  std::vector<double> holonomy_, strip_turns_;        // in n-ths of a full turn
  std::vector<std::array<vec3, 2>> directions_;       // by poly: the first one, and that to its left

 public:
  trivial_connection_result(const M& m, int symmetry, std::vector<double> turn, std::vector<double> holonomy,
                            std::vector<double> strip_turns, std::vector<std::array<vec3, 2>> directions)
      : mesh_(m), symmetry_(symmetry), turn_(std::move(turn)), holonomy_(std::move(holonomy)),
        strip_turns_(std::move(strip_turns)), directions_(std::move(directions)) {}

  const M& mesh() const { return mesh_.get(); }
  int symmetry() const { return symmetry_; }

  /// The angle by which directions turn across edge e more than parallel transport turns them, from the first poly of
  /// adj_e2p to the second, counter-clockwise.
  double turn(const edge_t<M>& e) const { return turn_[index_of(mesh_.get(), e)]; }
  /// How often directions turn around v, in n-ths of a full turn: an integer up to rounding.
  double index(const vert_t<M>& v) const { return holonomy_[index_of(mesh_.get(), v)]; }
  /// The same for each generator.
  const std::vector<double>& generator_indices() const { return strip_turns_; }

  /// Direction k of poly p in space, of length 1, counter-clockwise from the first.
  vec3 direction(const poly_t<M>& p, int k = 0) const {
    const auto& [x, y] = directions_[index_of(mesh_.get(), p)];
    const double at = 2 * std::numbers::pi * k / symmetry_;
    return std::cos(at) * x + std::sin(at) * y;
  }
  /// All n directions of p.
  std::vector<vec3> directions(const poly_t<M>& p) const {
    std::vector<vec3> all;
    for (int k = 0; k < symmetry_; ++k) all.push_back(direction(p, k));
    return all;
  }
};

namespace detail {

/// By vert, in radians.
/// Errors: those of trivial_connection about indices.
template<class M, class I>
std::vector<double> wanted_holonomy(const M& m, const oriented_surface& s, const I& indices,
                                    const std::vector<double>& defects, int n, const char* caller) {
  std::vector<double> holonomy(s.num_verts(), 0.0), sum(s.num_components, 0.0), chi(s.num_components, 0.0);
  std::vector<unsigned char> is_given(s.num_verts());
  for (const auto& [v, index] : indices) {
    if (!contains(m, v) || s.component[index_of(m, v)] == oriented_surface::none)
      core::throw_joined<invalid_mesh>({caller, ": an index is given at what is no vert of a poly of the mesh"});
    const std::size_t i = index_of(m, v);
    if (is_given[i]) core::throw_joined<invalid_argument>({caller, ": vert ", i, " is given two indices"});
    is_given[i] = 1;
    holonomy[i] = 2 * std::numbers::pi * index / n;
    sum[s.component[i]] += index;
  }
  for (std::size_t v = 0; v < defects.size(); ++v)
    if (s.component[v] != oriented_surface::none) chi[s.component[v]] += defects[v] / (2 * std::numbers::pi);
  for (std::size_t k = 0; k < sum.size(); ++k)
    if (const auto all = std::lround(n * chi[k]), given = std::lround(sum[k]); all != given)
      core::throw_joined<invalid_argument>({caller, ": the indices of component ", k, " sum to ", given,
                                            "; they must sum to the symmetry times its Euler characteristic, ", all});
  return holonomy;
}

/// The number of the poly whose direction is given, and its angle there.      Errors: those about `start`.
template<class M>
std::pair<std::uint32_t, double> start_of(const M& m, const oriented_surface& s, const poly_planes& planes,
                                          const trivial_connection_options<M>& options, const char* caller) {
  if (!options.start) return {0, 0.0};
  const auto& [poly, d] = *options.start;
  std::uint32_t p = 0;
  if (contains(m, poly))
    while (p < s.num_polys() && s.poly_index[p] != index_of(m, poly)) ++p;
  if (!contains(m, poly) || p == s.num_polys())
    core::throw_joined<invalid_mesh>({caller, ": start is at what is no poly of the mesh"});
  const double x = dot(d, planes.axes[p][0]), y = dot(d, planes.axes[p][1]);
  if (!is_finite(d) || !(std::hypot(x, y) > 1e-9 * norm(d)))
    core::throw_joined<invalid_argument>({caller, ": the direction of start is not finite, or 0 in the plane of poly ",
                                          s.poly_index[p]});
  return {p, std::atan2(y, x)};
}

template<class M>
trivial_connection_result<M> connection_result(const M& m, const oriented_surface& s, const poly_planes& planes,
                                               const trivial_turns& turns, int n, const std::vector<double>& angles) {
  const auto in_parts = [&](std::vector<double> x) {
    for (double& turn : x) turn *= n / (2 * std::numbers::pi);
    return x;
  };
  std::vector<std::uint32_t> number(poly_index_bound(m));
  std::vector<std::array<vec3, 2>> directions(poly_index_bound(m));
  for (std::uint32_t p = 0; p < s.num_polys(); ++p) {
    const auto& [x, y] = planes.axes[p];
    const double c = std::cos(angles[p]), d = std::sin(angles[p]);
    directions[s.poly_index[p]] = {c * x + d * y, c * y - d * x};
    number[s.poly_index[p]] = p;
  }
  std::vector<double> by_edge(s.num_edges, 0.0);
  std::vector<std::uint32_t> side(s.num_edges, 0);
  for (std::uint32_t c = 0; c < s.vert.size(); ++c) side[s.edge[c]] = c;
  for (const edge_t<M> e : edges(m)) {
    const std::uint32_t c = side[index_of(m, e)];
    for (const poly_t<M> p : adj_e2p(m, e)) {
      by_edge[index_of(m, e)] = s.poly[c] == number[index_of(m, p)] ? turns.turn[c] : turns.turn[s.twin[c]];
      break;
    }
  }
  return {m, n, std::move(by_edge), in_parts(turns.holonomy), in_parts(turns.of_strip), std::move(directions)};
}

}  // namespace detail

/// Directions at polys with given singularities at verts and no others: auto w = trivial_connection(m, {{v, 1}, {u,
/// 1}}); then w.directions(p) are the directions of a poly.
/// Needs:  Embedded SurfaceMesh, no temporary, closed, orientable, of polys of any shape. indices: pairs of a vert and
///         an integer, in braces or a container, in n-ths of a full turn; 0 at all other verts. On each component they
///         sum to n times the Euler characteristic.
/// Result: see trivial_connection_result. The sum of the squares of the turns at edges is the smallest with these
///         indices. The first direction of one poly of each component is any, or that of `start`.
/// Cost:   one or two sparse factorisations with a row for each vert, and O(edges of the generators).
/// Errors: invalid_mesh if the surface is not closed and manifold, has no polys, a poly has no area or points that are
///         not finite, or an index or `start` is at what is none of its elements. unsupported if it is not orientable,
///         or a poly crosses itself. invalid_argument if the sums do not match, a vert has two indices, generators are
///         not as many as there are, `start` is not finite or 0 in the plane of its poly, or symmetry is out of range.
///         solver_error; cancelled.
/// Source: Crane, Desbrun, Schroder 2010, "Trivial connections on discrete surfaces".
template<class M, class I = std::initializer_list<std::pair<vert_t<M>, int>>>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && Embedded<M>
trivial_connection_result<std::remove_cvref_t<M>> trivial_connection(
    M&& m, const I& indices, const trivial_connection_options<std::remove_cvref_t<M>>& options = {}) {
  constexpr const char* caller = "trivial_connection";
  using mesh_type = std::remove_cvref_t<M>;
  const core::profiled_options profiled(options, caller);
  const int n = options.symmetry;
  if (n < 1 || n > 16) core::throw_joined<invalid_argument>({caller, ": symmetry must be from 1 to 16"});
  detail::report_progress(profiled->progress, 0, caller);
  const mesh_type& mesh = m;
  const auto trees = tree_cotree(mesh);
  const auto s = detail::read_oriented_surface(mesh, caller);
  const detail::poly_planes planes(s);
  const auto defects = detail::defects_of(s, planes, caller);
  const auto holonomy = detail::wanted_holonomy(mesh, s, indices, defects, n, caller);
  if (!options.generators.empty() && options.generators.size() != trees.rest.size())
    core::throw_joined<invalid_argument>({caller, ": ", options.generators.size(), " generators are given; there are ",
                                          trees.rest.size(), ", the edges `rest` of tree_cotree(m)"});
  const auto numbers = [&](const std::vector<edge_t<mesh_type>>& list) {
    std::vector<std::uint32_t> all;
    for (const auto& e : list) all.push_back(static_cast<std::uint32_t>(index_of(mesh, e)));
    return all;
  };
  const auto [start, angle] = detail::start_of(mesh, s, planes, options, caller);
  const double step = 2 * std::numbers::pi / n;
  std::vector<double> strip_turns;
  for (const int index : options.generators) strip_turns.push_back(step * index);
  const auto strips = detail::strips_of(s, numbers(trees.cotree), numbers(trees.rest));
  auto turns = detail::find_trivial_turns(s, planes, holonomy, defects, strips, std::move(strip_turns), step);
  auto result = detail::connection_result(mesh, s, planes, turns, n,
                                          detail::carried_angles(s, planes, turns, start, angle));
  detail::report_progress(profiled->progress, 1, caller);
  return result;
}

/// The verts round which a connection turns directions.
/// Needs:  a connection of trivial_connection, and its mesh unchanged.
/// Result: verts in the order of verts(m), with their indices in n-ths of a full turn: those that were given.
/// Cost:   O(V).      Errors: none.
template<class M>
std::vector<field_singularity<vert_t<M>>> singularities(const trivial_connection_result<M>& connection) {
  std::vector<field_singularity<vert_t<M>>> all;
  for (const vert_t<M> v : verts(connection.mesh()))
    if (const auto index = static_cast<int>(std::lround(connection.index(v))); index != 0) all.push_back({v, index});
  return all;
}

// What to write instead of calls that cannot compile.
template<class... T> void trivial_connection(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void trivial_connection(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void trivial_connection(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
