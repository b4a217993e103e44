// trivial_connection: given singularities and generators come out, directions follow the connection, bad input.
#include <concino/directions/trivial_connection.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus_meshes.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class W>
double error_of_indices(const W& w, const std::vector<std::pair<vert_id, int>>& wanted) {
  double worst = 0;
  for (const auto v : verts(w.mesh())) {
    double index = 0;
    for (const auto& [x, k] : wanted)
      if (x == v) index = k;
    worst = std::max(worst, std::abs(w.index(v) - index));
  }
  return worst;
}

/// The indices of verts and of loops of the boundary.
template<class W>
int sum_of_indices(const W& w) {
  int sum = 0;
  for (const auto& s : singularities(w)) sum += s.index;
  for (const auto& b : boundary_turns(w)) sum += b.index;
  return sum;
}

template<class M>
int euler_characteristic(const M& m) {
  return static_cast<int>(num_verts(m)) - static_cast<int>(num_edges(m)) + static_cast<int>(num_polys(m));
}

/// A flat square of 5 x 5 cells without the one in the middle.
template<class M>
auto ring_in_plane(const M& square) {
  return submesh(square, [&](const auto& p) { return norm(centroid(square, p) - vec3{0.5, 0.5, 0}) > 0.19; });
}

/// The largest difference of the directions of two polys at an edge from those that the connection carries there, as parts of the angle between
/// directions. The polys are laid flat along the edge.
template<class W>
double error_of_directions(const W& w) {
  double worst = 0;
  const auto& m = w.mesh();
  for (const auto e : edges(m)) {
    if (num_elements(adj_e2p(m, e)) < 2) continue;
    const auto [a, b] = end_verts(m, e);
    const vec3 along = to_vec3(point(m, b)) - to_vec3(point(m, a));
    double angle[2] = {0, 0};
    std::size_t k = 0;
    for (const auto p : adj_e2p(m, e)) {
      const vec3 n = normal(m, p), flat = along - dot(along, n) * n, d = w.direction(p);
      if (k < 2) angle[k++] = std::atan2(dot(d, cross(n, flat)), dot(d, flat));
    }
    const double turns = (angle[1] - angle[0] - w.turn(e)) * w.symmetry() / (2 * std::numbers::pi);
    worst = std::max(worst, std::abs(turns - std::round(turns)));
  }
  return worst;
}

}  // namespace

TEST_CASE("trivial_connection: two singularities of a sphere") {
  const auto m = icosphere(2);
  const vert_id v{0}, u{11};
  const auto w = trivial_connection(m, {{v, 1}, {u, 1}});
  CHECK(error_of_indices(w, {{v, 1}, {u, 1}}) < 1e-10);
  CHECK(error_of_directions(w) < 1e-10);
  const auto found = singularities(w);
  REQUIRE(found.size() == 2);
  CHECK(found[0].element == v);
  CHECK(found[0].index == 1);
  CHECK(found[1].element == u);
  for (const auto p : polys(m)) {
    CHECK(norm(w.direction(p)) == doctest::Approx(1));
    CHECK(std::abs(dot(w.direction(p), normal(m, p))) < 1e-12);
    CHECK(w.directions(p).size() == 1);
  }
  const poly_id first{7};
  const auto [a, b, c] = [&] {
    std::array<vec3, 3> x;
    std::size_t k = 0;
    for (const auto t : adj_p2v(m, first)) x[k++] = point(m, t);
    return x;
  }();
  const auto given = trivial_connection(m, {{v, 2}}, {.start = std::pair(first, b - a + 0.2 * (c - a))});
  const vec3 d = b - a + 0.2 * (c - a);
  CHECK(norm(given.direction(first) - d / norm(d)) < 1e-12);
  CHECK(error_of_indices(given, {{v, 2}}) < 1e-10);
}

TEST_CASE_TEMPLATE("trivial_connection: indices and generators of surfaces of any genus", M, CONCINO_ALL_SURFACE_KINDS) {
  for (const int genus : {0, 1, 2, 5, 8}) {
    CAPTURE(genus);
    const M m = from_quads<M>(holed_board(genus));
    const int n = 4, chi = 2 - 2 * genus;
    const std::vector<std::pair<vert_id, int>> wanted{{vert_id{0}, n * chi - 3}, {vert_id{5}, 5}, {vert_id{7}, -2}};
    const auto w = trivial_connection(m, wanted, {.symmetry = n});
    CHECK(error_of_indices(w, wanted) < 1e-10);
    CHECK(error_of_directions(w) < 1e-10);
    const auto& turns = w.generator_indices();
    CHECK(turns.size() == static_cast<std::size_t>(2 * genus));
    for (const double x : turns) CHECK(std::abs(x - std::round(x)) < 1e-10);
    std::vector<int> generators;
    for (std::size_t k = 0; k < turns.size(); ++k) generators.push_back(static_cast<int>(std::lround(turns[k])) + static_cast<int>(k % 3) - 1);
    const auto other = trivial_connection(m, wanted, {.symmetry = n, .generators = generators});
    CHECK(error_of_indices(other, wanted) < 1e-10);
    CHECK(error_of_directions(other) < 1e-10);
    for (std::size_t k = 0; k < turns.size(); ++k) CHECK(std::abs(other.generator_indices()[k] - generators[k]) < 1e-10);
  }
}

TEST_CASE_TEMPLATE("trivial_connection: a flat ring", M, CONCINO_ALL_SURFACE_KINDS) {
  const M square = make_grid<M>({.cells = {5, 5, 1}});
  const auto ring = ring_in_plane(square);
  using ring_type = std::remove_const_t<decltype(ring)>;
  const std::vector<std::pair<vert_id, int>> none;
  const auto parallel = trivial_connection(ring, none, {.symmetry = 4});
  const auto loops = boundary_turns(parallel);
  REQUIRE(loops.size() == 2);
  for (const auto& b : loops) {
    const auto [from, to] = end_verts(ring, b.edge);
    const vec3 p = (point(ring, from) + point(ring, to)) / 2;
    CHECK(b.index == (std::min({p.x, p.y, 1 - p.x, 1 - p.y}) < 1e-9 ? 4 : -4));
  }
  CHECK(parallel.generator_edges().empty());
  for (const auto e : edges(ring)) CHECK(std::abs(parallel.turn(e)) < 1e-12);
  CHECK(error_of_directions(parallel) < 1e-10);

  // A direction that follows the ring turns once with it, and not against the boundary.
  const edge_id outer = loops[0].index > 0 ? loops[0].edge : loops[1].edge, inner = loops[0].index > 0 ? loops[1].edge : loops[0].edge;
  trivial_connection_options<ring_type> options;
  options.boundary = {{outer, 0}};
  const auto around = trivial_connection(ring, none, options);
  for (const auto& b : boundary_turns(around)) CHECK(b.index == 0);
  std::vector<std::pair<double, vec3>> sorted;  // by angle about the middle
  for (const auto p : polys(ring)) {
    const vec3 at = centroid(ring, p) - vec3{0.5, 0.5, 0};
    if (std::max(std::abs(at.x), std::abs(at.y)) > 0.3) sorted.emplace_back(std::atan2(at.y, at.x), around.direction(p));
  }
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  double turned = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const vec3 &a = sorted[i].second, &b = sorted[(i + 1) % sorted.size()].second;
    turned += std::atan2(a.x * b.y - a.y * b.x, dot(a, b));
  }
  CHECK(turned == doctest::Approx(2 * std::numbers::pi));
  options.boundary = {{outer, 2}, {inner, -2}};
  CHECK(sum_of_indices(trivial_connection(ring, none, options)) == 0);
  options.boundary = {{outer, 2}, {inner, -1}};
  CHECK_THROWS_WITH_AS((void)trivial_connection(ring, none, options), "trivial_connection: the indices of component 0 sum to 1; they must sum to the symmetry times its Euler characteristic, 0",
                       invalid_argument);
  options.boundary = {{outer, 2}, {outer, 1}};
  CHECK_THROWS_AS((void)trivial_connection(ring, none, options), invalid_argument);
  for (const auto e : edges(ring))
    if (num_elements(adj_e2p(ring, e)) == 2) options.boundary = {{e, 1}};
  CHECK_THROWS_AS((void)trivial_connection(ring, none, options), invalid_argument);
  options.boundary = {{edge_id{9999}, 1}};
  CHECK_THROWS_AS((void)trivial_connection(ring, none, options), invalid_mesh);
}

TEST_CASE_TEMPLATE("trivial_connection: surfaces with handles and boundary", M, CONCINO_ALL_SURFACE_KINDS) {
  for (const int genus : {0, 1, 3}) {
    CAPTURE(genus);
    const M closed = from_quads<M>(holed_board(genus));
    const std::size_t last = num_polys(closed) - 1;
    const auto m = submesh(closed, [&](const auto& p) { return p.raw() != last && p.raw() != 0; });
    const int n = 4, chi = euler_characteristic(m);
    std::vector<unsigned char> on_boundary(vert_index_bound(m));
    for (const auto e : edges(m))
      if (num_elements(adj_e2p(m, e)) == 1)
        for (const auto v : adj_e2v(m, e)) on_boundary[v.raw()] = 1;
    std::vector<std::pair<vert_id, int>> wanted;
    for (const auto v : verts(m))
      if (!on_boundary[v.raw()] && wanted.size() < 2) wanted.emplace_back(v, wanted.empty() ? 3 : -5);
    const auto w = trivial_connection(m, wanted, {.symmetry = n});
    CHECK(error_of_indices(w, wanted) < 1e-10);
    CHECK(error_of_directions(w) < 1e-10);
    CHECK(sum_of_indices(w) == n * chi);
    CHECK(w.generator_edges().size() == static_cast<std::size_t>(2 * genus));
    const auto loops = boundary_turns(w);
    REQUIRE(loops.size() == 2);
    trivial_connection_options<std::remove_const_t<decltype(m)>> options;
    options.symmetry = n;
    for (const double x : w.generator_indices()) options.generators.push_back(static_cast<int>(std::lround(x)) + 1);
    options.boundary = {{loops[0].edge, loops[0].index + 2}};
    const auto other = trivial_connection(m, wanted, options);
    CHECK(error_of_indices(other, wanted) < 1e-10);
    CHECK(error_of_directions(other) < 1e-10);
    CHECK(sum_of_indices(other) == n * chi);
    CHECK(boundary_turns(other)[0].index == loops[0].index + 2);
    for (std::size_t k = 0; k < options.generators.size(); ++k) CHECK(std::abs(other.generator_indices()[k] - options.generators[k]) < 1e-10);
  }
}

TEST_CASE("trivial_connection: several components, polys oriented against each other, an archetype") {
  auto two = triangulated(beside(holed_board(0), holed_board(1)));
  for (std::size_t p = 3; p < two.verts.size(); p += 6) std::swap(two.verts[p], two.verts[p + 1]);
  const trimesh m(two);
  const vert_id last{two.points.size() - 1};
  const std::vector<std::pair<vert_id, int>> wanted{{vert_id{0}, 2}, {last, 1}, {vert_id{two.points.size() - 2}, -1}};
  const auto w = trivial_connection(m, wanted);
  CHECK(error_of_indices(w, wanted) < 1e-10);
  CHECK_THROWS_WITH_AS((void)trivial_connection(m, {{vert_id{0}, 3}, {last, -1}}),
                       "trivial_connection: the indices of component 0 sum to 3; they must sum to the symmetry times its Euler characteristic, 2", invalid_argument);
  const polygonmesh board(from_quads<polygonmesh>(holed_board(1)));
  const auto only = only_embedded_mesh(board);
  const std::vector<std::pair<vert_t<decltype(only)>, int>> none;
  const auto smooth = trivial_connection(only, none);
  CHECK(singularities(smooth).empty());
}

TEST_CASE("trivial_connection: surfaces of the corpus, closed and open") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const corpus_row& row : rows) {
    const auto is = [&](const char* name, const char* value) { return row.column.count(name) && row.column.at(name) == value; };
    if (!is("manifold", "yes") || !is("orientable", "True") || !is("components", "1")) continue;
    if (!long_run() && std::filesystem::file_size(row.file) > 300'000) continue;
    CAPTURE(row.name);
    const auto any = load_any(row.file.string());
    std::visit(
        [&](const auto& m) {
          if constexpr (dimension_v<decltype(m)> == 2) {
            const int chi = std::stoi(row.column.at("euler_chi"));
            std::vector<unsigned char> on_boundary(vert_index_bound(m));
            for (const auto e : edges(m))
              if (num_elements(adj_e2p(m, e)) == 1)
                for (const auto v : adj_e2v(m, e)) on_boundary[v.raw()] = 1;
            std::vector<vert_id> inside;
            for (const auto v : verts(m))
              if (num_elements(adj_v2e(m, v)) > 0 && !on_boundary[v.raw()]) inside.push_back(v);
            if (inside.size() < 2) return;
            const std::vector<std::pair<vert_id, int>> wanted{{inside.front(), 2 * chi + 1}, {inside.back(), -1}};
            const auto w = trivial_connection(m, wanted, {.symmetry = 2});
            CHECK(error_of_indices(w, wanted) < 1e-10);
            CHECK(sum_of_indices(w) == 2 * chi);
            CHECK(std::to_string(boundary_turns(w).size()) == row.column.at("boundary_loops"));
          }
        },
        any);
  }
}

TEST_CASE("trivial_connection: bad input") {
  const auto m = icosphere(1);
  const vert_id v{0}, u{1};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {v, 1}}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {vert_id{999}, 1}}), invalid_mesh);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.symmetry = 0}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.generators = {1}}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.start = std::pair(poly_id{0}, vec3{0, 0, 0})}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.start = std::pair(poly_id{0}, vec3{nan, 0, 0})}), invalid_argument);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.start = std::pair(poly_id{999}, vec3{1, 0, 0})}), invalid_mesh);
  CHECK_THROWS_AS((void)trivial_connection(m, {{v, 1}, {u, 1}}, {.progress = [](double, const char*) { return false; }}), cancelled);
  const auto open = grid_on<trimesh>(3, on_hill);
  CHECK_THROWS_WITH_AS((void)trivial_connection(open, {{v, 1}}), "trivial_connection: vert 0 is at the boundary; give the index of its loop, as an option", invalid_argument);
  const trimesh projective(projective_plane());
  CHECK_THROWS_AS((void)trivial_connection(projective, {{v, 1}}), unsupported);
  const polygonmesh none;
  CHECK_THROWS_AS((void)trivial_connection(none, {{v, 1}}), invalid_mesh);
}
