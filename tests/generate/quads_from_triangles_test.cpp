#include <concino/generate/quads_from_triangles.hpp>

#include <concino/generate/grid.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/geometry/corner_angles.hpp>
#include <concino/io/load_any.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/random_meshes.hpp>
#include <support/subdivisions.hpp>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/max_cardinality_matching.hpp>

#include <algorithm>
#include <bit>
#include <limits>
#include <numbers>
#include <set>
#include <variant>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double degrees = std::numbers::pi / 180;

std::vector<vert_id> ring_of(const trimesh& m, poly_id p) {
  std::vector<vert_id> ring;
  for (const vert_id v : adj_p2v(m, p)) ring.push_back(v);
  return ring;
}

bool has_step(const trimesh& m, poly_id p, vert_id a, vert_id b) {
  const auto ring = ring_of(m, p);
  for (std::size_t k = 0; k < 3; ++k)
    if (ring[k] == a && ring[(k + 1) % 3] == b) return true;
  return false;
}

/// The pairs of triangles that may be joined, by their definition.
std::vector<std::pair<poly_id, poly_id>> allowed_pairs(const trimesh& m, double max_angle_deg = 180) {
  std::vector<std::pair<poly_id, poly_id>> pairs;
  for (const edge_id e : edges(m)) {
    std::vector<poly_id> p;
    for (const poly_id x : adj_e2p(m, e)) p.push_back(x);
    if (p.size() != 2) continue;
    const auto [a, b] = end_verts(m, e);
    if (has_step(m, p[0], a, b) == has_step(m, p[1], a, b)) continue;
    int common = 0;
    for (const edge_id x : adj_p2e(m, p[0]))
      for (const edge_id y : adj_p2e(m, p[1])) common += x == y;
    if (common != 1) continue;
    double smallest = 10;
    std::vector<double> corners;
    for (const vert_id v : {a, b}) corners.push_back(corner_angle(m, p[0], v) + corner_angle(m, p[1], v));
    for (const poly_id x : p)
      for (const vert_id v : adj_p2v(m, x)) {
        smallest = std::min(smallest, corner_angle(m, x, v));
        if (v != a && v != b) corners.push_back(corner_angle(m, x, v));
      }
    if (smallest > 0 && *std::max_element(corners.begin(), corners.end()) < max_angle_deg * degrees - 1e-9) pairs.push_back({p[0], p[1]});
  }
  return pairs;
}

/// The size of a maximum matching, by trying all sets of pairs.
std::size_t tried_size(std::size_t n, const std::vector<std::pair<poly_id, poly_id>>& pairs, std::size_t from = 0, std::uint32_t used = 0) {
  std::size_t best = 0;
  for (std::size_t i = from; i < pairs.size(); ++i) {
    const std::uint32_t both = 1u << pairs[i].first.raw() | 1u << pairs[i].second.raw();
    if ((used & both) == 0) best = std::max(best, 1 + tried_size(n, pairs, i + 1, used | both));
    if (2 * best + static_cast<std::size_t>(std::popcount(used)) + 1 >= n) break;
  }
  return best;
}

/// The same by Boost.Graph.
std::size_t size_by_boost(std::size_t n, const std::vector<std::pair<poly_id, poly_id>>& pairs) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> g(n);
  for (const auto& [p, q] : pairs) add_edge(p.raw(), q.raw(), g);
  std::vector<boost::graph_traits<decltype(g)>::vertex_descriptor> mate(n);
  boost::edmonds_maximum_cardinality_matching(g, mate.data());
  return boost::matching_size(g, mate.data());
}

/// Checks that each poly of the result is a triangle of m or two that may be joined; returns the number of quads.
std::size_t check_joined(const trimesh& m, const quads_from_triangles_options& options = {}) {
  correspondence c;
  std::vector<poly_id> triangles{poly_id{99}};
  quads_from_triangles_options o = options;
  o.correspondence = &c, o.triangles = &triangles;
  const polygonmesh q = quads_from_triangles(m, o);
  CHECK(check_laws(q).empty());
  REQUIRE(num_verts(q) == num_verts(m));
  std::set<std::pair<std::uint32_t, std::uint32_t>> allowed;
  for (const auto& [a, b] : allowed_pairs(m, o.max_angle_deg)) allowed.insert(std::minmax(a.raw(), b.raw()));
  std::vector<int> met(poly_index_bound(m));
  std::vector<poly_id> left;
  std::uint32_t before = 0;
  for (const poly_id p : polys(q)) {
    std::vector<vert_id> ring;
    for (const vert_id v : adj_p2v(q, p)) ring.push_back(v);
    const auto from = c.polys[p.raw()];
    REQUIRE(ring.size() == from.size() + 2);
    CHECK((p.raw() == 0 || from[0].index > before));  // in the order of the first triangles
    before = from[0].index;
    for (const origin x : from) ++met[x.index];
    if (from.size() == 1) {
      left.push_back(p);
      continue;
    }
    CHECK(allowed.count({from[0].index, from[1].index}) == 1);
    const poly_id a{from[0].index}, b{from[1].index};
    for (std::size_t k = 0; k < 4; ++k) {
      const vert_id v{c.verts.only(ring[k].raw())}, w{c.verts.only(ring[(k + 1) % 4].raw())};
      CHECK(int(has_step(m, a, v, w)) + int(has_step(m, b, v, w)) == 1);
    }
    CHECK(from[0].weight * measure(m, b) == doctest::Approx(from[1].weight * measure(m, a)).epsilon(1e-9));
  }
  for (const poly_id p : polys(m)) CHECK(met[p.raw()] == 1);
  CHECK(triangles == left);
  for (const vert_id v : verts(q)) CHECK(point(q, v) == point(m, vert_id{c.verts.only(v.raw())}));
  return num_polys(m) - num_polys(q);
}

}  // namespace

TEST_CASE("quads_from_triangles: as many quads as possible on small random surfaces") {
  std::mt19937 random(5);
  std::size_t joined = 0;
  for (unsigned i = 0; i < num_random_meshes(); ++i) {
    const trimesh m = random_mesh<trimesh>(random);
    const double max_angle_deg = i % 3 == 0 ? 130 : 180;
    const std::size_t quads = check_joined(m, {.max_angle_deg = max_angle_deg});
    const auto pairs = allowed_pairs(m, max_angle_deg);
    CHECK(quads == size_by_boost(poly_index_bound(m), pairs));
    if (poly_index_bound(m) <= 18) CHECK(quads == tried_size(poly_index_bound(m), pairs));
    joined += quads;
  }
  CHECK(joined > num_random_meshes() / 2);
}

TEST_CASE("quads_from_triangles: as many quads as possible where few pairs are allowed") {
  for (const unsigned seed : {1u, 2u, 3u})
    for (const double max_angle_deg : {180.0, 150.0, 120.0, 110.0}) {
      const trimesh m(jittered(triangle_grid(12), 0.04, seed % 2 == 0, seed));
      CHECK(check_joined(m, {.max_angle_deg = max_angle_deg}) == size_by_boost(num_polys(m), allowed_pairs(m, max_angle_deg)));
    }
}

TEST_CASE("quads_from_triangles: no triangle is left on closed surfaces") {
  for (const unsigned n : {0u, 1u, 2u, 3u}) {
    trimesh m = icosphere(n);
    CHECK(2 * check_joined(m) == num_polys(m));
  }
  const trimesh torus = make_torus<trimesh>({.cells = {13, 7}});
  CHECK(2 * check_joined(torus) == num_polys(torus));
}

TEST_CASE("quads_from_triangles: triangles of a grid become its squares, with the same area") {
  const trimesh m = grid<trimesh>(5);
  const polygonmesh q = quads_from_triangles(m);
  REQUIRE(num_polys(q) == 25);
  for (const poly_id p : polys(q)) CHECK(measure(q, p) == doctest::Approx(1.0 / 25).epsilon(1e-14));
  for (const int exponent : {-600, 600}) {  // independent of scale
    const trimesh scaled(scaled_by_power_of_two(triangle_grid(5), exponent));
    const polygonmesh again = quads_from_triangles(scaled);
    REQUIRE(num_polys(again) == 25);
    for (const poly_id p : polys(q)) CHECK(index_of(again, *adj_p2v(again, p).begin()) == index_of(q, *adj_p2v(q, p).begin()));
  }
  trimesh j(jittered(triangle_grid(9), 0.02, false));
  const polygonmesh quads = quads_from_triangles(j);
  CHECK(total_measure(quads) == doctest::Approx(total_measure(j)).epsilon(1e-13));
  for (const poly_id p : polys(quads))
    for (const vert_id v : adj_p2v(quads, p)) CHECK(corner_angle(quads, p, v) < std::numbers::pi);
}

TEST_CASE("quads_from_triangles: pairs that cannot be joined") {
  const std::vector<vec3> points{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  // Three triangles at an edge; two with the same orientation of their edge; two that share two edges; one triangle.
  for (const std::vector<std::vector<unsigned>>& lists : std::vector<std::vector<std::vector<unsigned>>>{
           {{0, 2, 1}, {0, 1, 3}, {0, 4, 1}}, {{0, 1, 2}, {0, 1, 3}}, {{0, 1, 2}, {2, 1, 0}}, {{0, 1, 2}}}) {
    const trimesh m(points, lists);
    CHECK(check_joined(m) == 0);
  }
  // A straight corner, a reflex corner, and triangles without area.
  for (const vec3& x : {vec3{0, 1, 0}, vec3{-0.2, 1, 0}, vec3{-1, 0, 0}, vec3{0, 0, 0}}) {
    const trimesh m(std::vector<vec3>{{0, 0, 0}, {0, -1, 0}, {1, 0, 0}, x}, std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 2, 3}});
    CHECK(check_joined(m) == 0);
  }
  CHECK(check_joined(trimesh(std::vector<vec3>{{0, 0, 0}, {0.1, -1, 0}, {1, 0, 0}, {0.1, 1, 0}}, std::vector<std::vector<unsigned>>{{0, 1, 2}, {0, 2, 3}})) == 1);
}

TEST_CASE("quads_from_triangles: empty meshes, and verts of no triangle") {
  const trimesh empty;
  const polygonmesh q = quads_from_triangles(empty);
  CHECK(num_polys(q) == 0);
  CHECK(num_verts(q) == 0);
  CHECK(check_joined(two_grids<trimesh>(3)) == 18);
}

TEST_CASE("quads_from_triangles: properties, correspondence, archetype") {
  trimesh m = icosphere(1);
  add_properties(m);
  correspondence c;
  const polygonmesh q = quads_from_triangles(m, {.correspondence = &c});
  const auto place = find_vert_property<vec3>(q, "place");
  const auto mass = find_poly_property<double>(q, "mass");
  const auto crease = find_edge_property<int>(q, "crease");
  REQUIRE(place);
  for (const vert_id v : verts(q)) CHECK(place[v] == point(q, v));
  for (const poly_id p : polys(q)) CHECK(mass[p] == doctest::Approx(measure(m, poly_id{c.polys[p.raw()][0].index}) + measure(m, poly_id{c.polys[p.raw()][1].index})).epsilon(1e-14));
  for (const edge_id e : edges(q)) CHECK(crease[e] == 1 + static_cast<int>(c.edges.only(e.raw())));
  const polygonmesh plain = quads_from_triangles(m, {.properties = false});
  CHECK(!find_vert_property<vec3>(plain, "place"));
  CHECK(record_of(quads_from_triangles(only_embedded_mesh(m))) == record_of(plain));
}

TEST_CASE("quads_from_triangles: polys that are no triangles, points that are not finite, wrong angles") {
  CHECK_THROWS_WITH_AS(quads_from_triangles(grid<polygonmesh>(1)), doctest::Contains("quads_from_triangles: poly 0 has 8 verts, but must have 3"), unsupported);
  trimesh m = grid<trimesh>(2);
  for (const double wrong : {90.0, 0.0, 180.1, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_WITH_AS(quads_from_triangles(m, {.max_angle_deg = wrong}), doctest::Contains("it must be above 90 and at most 180"), invalid_argument);
  set_point(m, vert_id{4}, vec3{0, std::numeric_limits<double>::infinity(), 0});
  CHECK_THROWS_WITH_AS(quads_from_triangles(m), "quads_from_triangles: the point of vert 4 is not finite; validate() lists all such verts", invalid_mesh);
}

TEST_CASE("quads_from_triangles: a path through a long strip, and many odd cycles, need no recursion") {
  // A strip of triangles whose best pairs leave one at each end; at one end it has an odd cycle.
  const unsigned n = 20000;
  trimesh m(jittered(triangle_grid(long_run() ? 300 : 40), 0.0003));
  CHECK(2 * (num_polys(m) - num_polys(quads_from_triangles(m))) == num_polys(m));
  surface_arrays strip{{}, {}, {}, 3};
  for (unsigned i = 0; i <= n; ++i) strip.points.insert(strip.points.end(), {{i, 0, 0}, {i + 0.5 + 0.001, 1, 0}});
  for (unsigned i = 0; i < n; ++i)
    for (const unsigned v : {2 * i, 2 * i + 2, 2 * i + 1, 2 * i + 1, 2 * i + 2, 2 * i + 3}) strip.verts.push_back(vert_id{v});
  const trimesh s(strip);
  CHECK(num_polys(quads_from_triangles(s)) == n);
}

TEST_CASE("quads_from_triangles: surfaces of files") {
  for (const corpus_row& row : corpus_meshes()) {
    if (std::filesystem::file_size(row.file) > (long_run() ? 20000000u : 150000u)) continue;
    std::visit(
        [&](const auto& m) {
          if constexpr (std::is_same_v<std::remove_cvref_t<decltype(m)>, trimesh>) {
            CAPTURE(row.name);
            const std::size_t joined = check_joined(m);
            CHECK(joined == size_by_boost(num_polys(m), allowed_pairs(m)));
          }
        },
        load_any(row.file));
  }
}
