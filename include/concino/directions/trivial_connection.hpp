// trivial_connection(m, indices): directions at polys with given singularities, by a connection that turns least.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/directions/detail/connection/connection_input.hpp>
#include <concino/directions/detail/connection/trivial_turns.hpp>
#include <concino/directions/detail/surface/oriented_surface.hpp>
#include <concino/directions/detail/surface/poly_planes.hpp>
#include <concino/directions/singularities.hpp>
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
  std::vector<std::pair<edge_t<M>, int>> boundary = {};  // loops of the boundary, each by one of its edges, and their
                                                         // indices, see the result; others turn least
  std::optional<std::pair<poly_t<M>, vec3>> start = {};  // a poly, and one of its directions; empty: any
  concino::progress progress = nullptr;   // called with "trivial_connection"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// A connection with given singularities, and directions at polys that it carries from one to the next.
///
/// Each generator is a closed strip of polys, which crosses an edge, and returns through a breadth-first tree of polys;
/// there are 2 g on a component of genus g. Its index counts how often directions turn along it against the strip
/// itself, in n-ths of a full turn. The index of a loop of the boundary is how often its tangent turns against the
/// directions, with the surface on the left, as in boundary_turns: n in a flat disk if they do not turn.
template<class M>
class trivial_connection_result {
  detail::mesh_ref<M> mesh_;
  int symmetry_;
  std::vector<double> turn_;                          // by edge
  std::vector<double> holonomy_, strip_turns_;        // in n-ths of a full turn; those of verts 0 at the boundary
  std::vector<edge_t<M>> strip_edges_;
  std::vector<boundary_turn<M>> loops_;
  std::vector<std::array<vec3, 2>> directions_;       // by poly: the first one, and that to its left

 public:
  /// From the parts in the order above.
  trivial_connection_result(const M& m, int symmetry, std::vector<double> turn, std::vector<double> holonomy,
                            std::vector<double> strip_turns, std::vector<edge_t<M>> strip_edges,
                            std::vector<boundary_turn<M>> loops, std::vector<std::array<vec3, 2>> directions)
      : mesh_(m), symmetry_(symmetry), turn_(std::move(turn)), holonomy_(std::move(holonomy)),
        strip_turns_(std::move(strip_turns)), strip_edges_(std::move(strip_edges)), loops_(std::move(loops)),
        directions_(std::move(directions)) {}

  const M& mesh() const { return mesh_.get(); }
  int symmetry() const { return symmetry_; }

  /// The angle by which directions turn across edge e more than parallel transport turns them, from the first poly of
  /// adj_e2p to the second, counter-clockwise.
  double turn(const edge_t<M>& e) const { return turn_[index_of(mesh_.get(), e)]; }
  /// How often directions turn around v, in n-ths of a full turn: an integer up to rounding; 0 at the boundary.
  double index(const vert_t<M>& v) const { return holonomy_[index_of(mesh_.get(), v)]; }
  /// The same for each generator.
  const std::vector<double>& generator_indices() const { return strip_turns_; }
  /// The edge that each generator crosses beside those of the tree.
  const std::vector<edge_t<M>>& generator_edges() const { return strip_edges_; }
  /// The loops of the boundary, see boundary_turns.
  const std::vector<boundary_turn<M>>& loops() const { return loops_; }

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

/// The directions at the angles in the planes of polys, by index of the poly.
inline std::vector<std::array<vec3, 2>> directions_at(const oriented_surface& s, const poly_planes& planes,
                                                      const std::vector<double>& angles, std::size_t bound) {
  std::vector<std::array<vec3, 2>> directions(bound);
  for (std::uint32_t p = 0; p < s.num_polys(); ++p) {
    const auto& [x, y] = planes.axes[p];
    const double c = std::cos(angles[p]), d = std::sin(angles[p]);
    directions[s.poly_index[p]] = {c * x + d * y, c * y - d * x};
  }
  return directions;
}

/// By edge, from its first poly to the second.
template<class M>
std::vector<double> turns_by_edge(const M& m, const oriented_surface& s, const trivial_turns& turns) {
  std::vector<double> by_edge(s.num_edges, 0.0);
  std::vector<std::uint32_t> side(s.num_edges, 0);
  for (std::uint32_t c = 0; c < s.vert.size(); ++c) side[s.edge[c]] = c;
  for (const edge_t<M> e : edges(m)) {
    const std::uint32_t c = side[index_of(m, e)];
    for (const poly_t<M> p : adj_e2p(m, e)) {
      by_edge[index_of(m, e)] = s.poly_index[s.poly[c]] == index_of(m, p) ? turns.turn[c] : turns.turn[s.twin[c]];
      break;
    }
  }
  return by_edge;
}

template<class M>
trivial_connection_result<M> connection_result(const M& m, const oriented_surface& s, const wanted_turns& wanted,
                                               const std::vector<poly_strip>& strips, trivial_turns&& turns, int n,
                                               std::vector<std::array<vec3, 2>>&& directions) {
  for (double& turn : turns.holonomy) turn *= n / (2 * std::numbers::pi);
  for (double& turn : turns.of_strip) turn *= n / (2 * std::numbers::pi);
  std::vector<edge_t<M>> edge(s.num_edges), strip_edges;
  for (const edge_t<M> e : edges(m)) edge[index_of(m, e)] = e;
  for (const poly_strip& strip : strips) strip_edges.push_back(edge[s.edge[strip[0]]]);
  std::vector<boundary_turn<M>> loops;
  std::vector<unsigned char> is_known(s.num_verts());
  for (std::uint32_t c = 0; c < s.vert.size(); ++c) {
    const std::uint32_t loop = wanted.place[s.vert[c]];
    if (s.twin[c] != oriented_surface::none || is_known[loop]) continue;
    is_known[loop] = 1;
    loops.push_back({edge[s.edge[c]], static_cast<int>(std::lround(std::exchange(turns.holonomy[loop], 0.0)))});
  }
  auto by_edge = turns_by_edge(m, s, turns);
  return {m, n, std::move(by_edge), std::move(turns.holonomy), std::move(turns.of_strip), std::move(strip_edges),
          std::move(loops), std::move(directions)};
}

}  // namespace detail

/// Directions at polys with given singularities at verts and no others: auto w = trivial_connection(m, {{v, 1}, {u,
/// 1}}); then w.directions(p) are the directions of a poly.
/// Needs:  Embedded SurfaceMesh, no temporary, orientable, with or without boundary, of polys of any shape. indices:
///         pairs of a vert inside the surface and an integer, in braces or a container, in n-ths of a full turn; 0 at
///         all other verts. On each component the indices of verts and of loops of the boundary sum to n times the
///         Euler characteristic.
/// Result: see trivial_connection_result. The sum of the squares of the turns at edges is the smallest with these
///         indices. Generators and loops that are not given have the integers nearest to what they would be without
///         this condition; the last such loop of a component has what is left of the sum. The first direction of one
///         poly of each component is any, or that of `start`.
/// Cost:   one or two sparse factorisations with a row for each vert, and O(edges of the generators).
/// Errors: invalid_mesh if the surface has no polys, a poly has no area or points that are not finite, or an index or
///         `start` is at what is none of its elements. unsupported if it is not orientable, an edge has more than two
///         polys, the polys at a vert are not one fan, or a poly crosses itself. invalid_argument if the sums do not
///         match, a vert or a loop has two indices, a vert with an index is at the boundary, or an edge of a loop is
///         not. invalid_argument if generators are not as many as there are, `start` is not finite or 0 in the plane of
///         its poly, or symmetry is out of range. solver_error; cancelled.
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
  const auto s = detail::read_oriented_surface(mesh, caller);
  const detail::poly_planes planes(s);
  detail::wanted_turns wanted{detail::points_and_loops(s), {}, {}, 2 * std::numbers::pi / n};
  const auto defects = detail::defects_of(s, planes, wanted.place, caller);
  wanted.holonomy = detail::wanted_holonomy(mesh, s, wanted.place, indices, options.boundary, n, caller);
  detail::check_sums_of_indices(s, wanted, defects, n, caller);
  const auto strips = detail::generating_strips(s, wanted.place);
  if (!options.generators.empty() && options.generators.size() != strips.size())
    core::throw_joined<invalid_argument>({caller, ": ", options.generators.size(), " generators are given; there are ",
                                          strips.size(), ", see generator_edges()"});
  for (const int index : options.generators) wanted.of_strip.push_back(wanted.step * index);
  const auto [start, angle] = detail::start_of(mesh, s, planes, options.start, caller);
  auto turns = detail::find_trivial_turns(s, planes, defects, strips, wanted);
  auto directions = detail::directions_at(s, planes, detail::carried_angles(s, planes, turns, start, angle),
                                          poly_index_bound(mesh));
  auto result = detail::connection_result(mesh, s, wanted, strips, std::move(turns), n, std::move(directions));
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

/// How a connection turns directions along each loop of the boundary.
/// Needs:  a connection of trivial_connection, and its mesh unchanged.
/// Result: one for each loop, by its first edge in the order of polys: the turns of the tangent of the boundary against
///         the directions, as boundary_turns of a field. With the indices of singularities they sum to n chi on each
///         component.
/// Cost:   O(loops).      Errors: none.
template<class M>
std::vector<boundary_turn<M>> boundary_turns(const trivial_connection_result<M>& connection) {
  return connection.loops();
}

// What to write instead of calls that cannot compile.
template<class... T> void trivial_connection(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void trivial_connection(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void trivial_connection(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
