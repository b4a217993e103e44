// Tutte's map of disks: no flips, the boundary where it is asked for, pieces at two verts, bad input.
#include <concino/parametrize/tutte.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/subdivide_catmull_clark.hpp>
#include <concino/generate/to_triangles.hpp>
#include <concino/generate/torus.hpp>
#include <concino/parametrize/map_distortion.hpp>

#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

polygonmesh polygons(std::vector<vec3> points, const std::vector<std::vector<unsigned>>& polys) {
  surface_arrays a{std::move(points), {0}, {}, 0};
  for (const auto& p : polys) {
    for (const unsigned v : p) a.verts.push_back(vert_id{v});
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  return polygonmesh(std::move(a));
}

std::vector<vec3> some_points(unsigned n) {
  std::vector<vec3> x;
  for (unsigned i = 0; i < n; ++i) x.push_back({std::cos(2.0 * i), std::sin(3.0 * i), 0.1 * i});
  return x;
}

std::string message_of(const polygonmesh& m) {
  try {
    (void)tutte(m);
  } catch (const invalid_mesh& e) {
    return e.what();
  }
  return "";
}

template<class M>
bool is_bound(const M& m, vert_t<M> v) {
  for (const auto e : adj_v2e(m, v))
    if (is_boundary(m, e)) return true;
  return false;
}

}  // namespace

TEST_CASE_TEMPLATE("tutte: verts are at the means of their neighbours, the boundary on the circle, by its lengths", M, CONCINO_ALL_SURFACE_KINDS) {
  const M m = grid_on<M>(6, on_hill);
  const auto [uv, attached] = tutte(m);
  if constexpr (!std::is_same_v<M, polygonmesh>) CHECK(attached.empty());
  for (const auto v : verts(m)) {
    if (is_bound(m, v)) {
      CHECK(std::hypot(uv[v][0], uv[v][1]) == doctest::Approx(1));
      continue;
    }
    double x = 0, y = 0, n = 0;
    for (const auto w : adj_v2v(m, v)) x += uv[w][0], y += uv[w][1], ++n;
    CHECK(uv[v][0] == doctest::Approx(x / n).epsilon(1e-12));
    CHECK(uv[v][1] == doctest::Approx(y / n).epsilon(1e-12));
  }
  double total = 0, ratio = 0;
  for (const auto e : edges(m))
    if (is_boundary(m, e)) {
      const auto [a, b] = end_verts(m, e);
      const double chord = std::hypot(uv[a][0] - uv[b][0], uv[a][1] - uv[b][1]), angle = 2 * std::asin(chord / 2);
      if (ratio == 0) ratio = angle / distance(point(m, a), point(m, b));
      CHECK(angle / distance(point(m, a), point(m, b)) == doctest::Approx(ratio).epsilon(1e-9));
      total += angle;
    }
  CHECK(total == doctest::Approx(2 * std::numbers::pi));
  if constexpr (!std::is_same_v<M, polygonmesh>) CHECK(map_distortion(m, uv).flipped == 0);
  const auto only = only_embedded_mesh(m);  // the archetype
  const auto same = tutte(only).uv;
  auto at = verts(only).begin();
  for (const auto v : verts(m)) {
    CHECK(same[*at] == uv[v]);
    ++at;
  }
}

TEST_CASE("tutte: no flips on random polygons, triangles and quads, and on all disks of the corpus") {
  const unsigned rounds = long_run() ? 1000 : 60;
  for (unsigned seed = 0; seed < rounds; ++seed) {
    CAPTURE(seed);
    const std::size_t n = seed % 20 == 0 ? (long_run() ? 10000 : 3000) : 3 + 7 * seed % 400;
    const auto check = [](const auto& m) {
      const auto t = tutte(m);
      CHECK(t.attached.empty());
      CHECK(map_distortion(m, t.uv).flipped == 0);
    };
    const auto m = random_polygons(seed, seed % 3 == 0 ? n : n / 4 + 1);
    if (seed % 3 == 0) check(m);
    else if (seed % 3 == 1) check(to_triangles(m));
    else check(subdivide_catmull_clark(m));
  }
  unsigned count = 0;
  for_each_corpus_disk([&](const std::string& name, const auto& m) {
    CAPTURE(name);
    const bool has_verts_of_two_edges = name == "polygon/star.obj";  // between the points of the star
    const auto t = tutte(m);
    CHECK(t.attached.empty() == !has_verts_of_two_edges);
    if (!has_verts_of_two_edges) CHECK(map_distortion(m, t.uv).flipped == 0);
    ++count;
  });
  CHECK(count > 1);
}

TEST_CASE("tutte: random triangles, joined to quads and larger polygons at random, flip only where pieces are attached") {
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    CAPTURE(round);
    const unsigned n = 3 + static_cast<unsigned>(random() % 12);
    const auto a = triangle_grid(n);
    // Two triangles of a square become a quad, or two squares beside each other a hexagon, whose two middle verts may have two edges left.
    std::vector<std::vector<unsigned>> all;
    for (std::size_t t = 0; t + 1 < a.num_polys(); t += 2) {
      const auto v = [&](std::size_t k) { return a.verts[3 * t + k].raw(); };
      const auto kind = random() % 4;
      const bool can_join = kind == 2 && (t / 2) % n + 1 < n;
      if (can_join) {
        const auto w = [&](std::size_t k) { return a.verts[3 * (t + 2) + k].raw(); };
        all.push_back({v(0), v(1), w(1), w(2), v(2), v(5)});
        t += 2;
      } else if (kind == 1) {
        all.push_back({v(0), v(1), v(2)});
        all.push_back({v(0), v(2), v(5)});
      } else {
        all.push_back({v(0), v(1), v(2), v(5)});
      }
    }
    const auto m = polygons(a.points, all);
    const auto t = tutte(m);
    for (const auto& piece : t.attached) {  // on the segment
      const auto x = t.uv[piece.at[0]], y = t.uv[piece.at[1]];
      for (const auto v : piece.verts) {
        CHECK(std::abs(detail::twice_area(x, y, t.uv[v])) < 1e-12);
        CHECK(!is_bound(m, v));
      }
    }
    std::set<unsigned> of_pieces;
    for (const auto& piece : t.attached)
      for (const auto v : piece.verts) of_pieces.insert(v.raw());
    for (const auto p : map_distortion(m, t.uv).flips) {
      bool touches = false;
      for (const auto v : adj_p2v(m, p)) touches = touches || of_pieces.count(v.raw()) > 0;
      CHECK(touches);
    }
  }
}

TEST_CASE("tutte: pieces that two verts separate from the boundary") {
  // A square with a smaller one in it; the polygon between them on the left and that on the right share 4 and 6, which separate 5 and 7.
  const std::vector<vec3> x{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 1, 0}, {3, 2, 0}, {2, 3, 0}, {1, 2, 0}, {2, 2, 0}};
  const auto m = polygons(x, {{0, 1, 4, 7, 6, 3}, {1, 2, 3, 6, 5, 4}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 4, 8}});
  const auto t = tutte(m);
  // All of this is attached at 1 and 3.
  REQUIRE(t.attached.size() == 2);
  for (const auto& piece : t.attached) {
    const bool is_small = piece.at == std::array{vert_id{4}, vert_id{6}};
    auto inside = piece.verts;
    std::sort(inside.begin(), inside.end());
    if (is_small) CHECK(inside == std::vector{vert_id{5}, vert_id{7}, vert_id{8}});
    else CHECK(inside == std::vector{vert_id{4}, vert_id{5}, vert_id{6}, vert_id{7}, vert_id{8}});
    if (!is_small) CHECK(piece.at == std::array{vert_id{1}, vert_id{3}});
  }
  CHECK(map_distortion(m, t.uv).flipped > 0);
  // A chain of two verts of two edges.
  const auto chain = polygons({{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {1, 1, 0}, {2, 1.5, 0}}, {{0, 1, 2, 5, 4}, {0, 4, 5, 2, 3}});
  const auto c = tutte(chain);
  REQUIRE(c.attached.size() == 1);
  CHECK(c.attached[0].verts.size() == 2);
  CHECK(std::set<unsigned>{c.attached[0].at[0].raw(), c.attached[0].at[1].raw()} == std::set<unsigned>{0, 2});
  // Boundary verts that separate pieces with boundary are no trouble.
  const auto two = polygons({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
  const auto one = polygons({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK(tutte(two).attached.empty());
  CHECK(tutte(one).attached.empty());
}

TEST_CASE("tutte: given positions and weights") {
  const auto m = grid<quadmesh>(4);
  std::vector<std::pair<vert_id, uv_point>> square;
  for (const auto v : verts(m))
    if (is_bound(m, v)) square.push_back({v, {3 * point(m, v).x - 1, 2 * point(m, v).y}});
  const auto t = tutte(m, square);
  for (const auto v : verts(m)) {
    CHECK(t.uv[v][0] == doctest::Approx(3 * point(m, v).x - 1).epsilon(1e-12));
    CHECK(t.uv[v][1] == doctest::Approx(2 * point(m, v).y).epsilon(1e-12));
  }
  auto weight = make_edge_map<double>(m, 1.0);
  std::mt19937 random(3);
  for (const auto e : edges(m)) weight[e] = 0.1 + static_cast<double>(random() % 100);
  const auto w = tutte(m, square, weight);
  CHECK(map_distortion(m, w.uv).flipped == 0);
  for (const auto v : verts(m)) {
    if (is_bound(m, v)) continue;
    double x = 0, all = 0;
    for (const auto e : adj_v2e(m, v)) {
      const auto [a, b] = end_verts(m, e);
      x += weight[e] * w.uv[a == v ? b : a][0], all += weight[e];
    }
    CHECK(w.uv[v][0] == doctest::Approx(x / all).epsilon(1e-12));
  }
  CHECK(map_distortion(m, tutte(m, {}, weight).uv).flipped == 0);
  const trimesh one({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK(tutte(one, {{vert_id{0}, {5.0, 5.0}}, {vert_id{1}, {6.0, 5.0}}, {vert_id{2}, {5.0, 6.0}}}).uv[vert_id{1}] == uv_point{6, 5});

  weight[*edges(m).begin()] = 0;
  CHECK_THROWS_AS((void)tutte(m, square, weight), invalid_argument);
  const auto refused = [&](auto change) {
    auto some = square;
    change(some);
    CHECK_THROWS_AS((void)tutte(m, some), invalid_argument);
  };
  refused([](auto& s) { s.pop_back(); });
  refused([](auto& s) { s.push_back(s[0]); });
  refused([](auto& s) { s[2].second[0] = std::numeric_limits<double>::quiet_NaN(); });
  refused([](auto& s) { s[2].second[1] = 0.5; });
  refused([](auto& s) { s[2].second = s[1].second; });
  refused([](auto& s) { for (auto& x : s) x.second[0] *= -1; });
  refused([](auto& s) { s.push_back({vert_id{12}, {0, 0}}); });
  CHECK_THROWS_AS((void)tutte(m, {{vert_id{1000}, {0.0, 0.0}}}), invalid_mesh);
}

TEST_CASE("tutte: surfaces that are no disks are refused, and the message says what to do") {
  const auto says = [](const polygonmesh& m, const char* what) {
    const std::string s = message_of(m);
    CAPTURE(s);
    CHECK(s.find(what) != std::string::npos);
  };
  const auto x = some_points(9);
  says(polygonmesh(), "no polys");
  says(polygons(x, {{0, 1, 2}, {3, 4, 5}}), "2 components");
  says(polygons(x, {{0, 1, 2}, {2, 3, 4}}), "2 components");
  says(polygons(x, {{0, 1, 2}, {0, 1, 3}}), "wound against");
  says(polygons(x, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), "has 3 polys");
  says(polygons(x, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}), "cut_along");
  says(polygons(x, {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}), "2 boundary loops");
  says(polygons(x, {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 3, 0, 5}}), "Moebius");
  // a strip that comes back to its first vert only
  says(polygons(x, {{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}, {4, 5, 6}, {5, 0, 6}}), "several fans");
  auto nan = x;
  nan[1].y = std::numeric_limits<double>::quiet_NaN();
  says(polygons(nan, {{0, 1, 2}}), "vert 1 has a coordinate that is not finite");
  says(polygons({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}), "has no length");
  const auto ball = icosphere(1);
  CHECK_THROWS_AS((void)tutte(ball), invalid_mesh);
  // a torus with a hole
  const auto torus = make_torus<quadmesh>({.cells = {8, 6}});
  surface_arrays a{{}, {0}, {}, 0};
  for (const auto v : verts(torus)) a.points.push_back(point(torus, v));
  for (const auto p : polys(torus)) {
    if (p == poly_id{0}) continue;
    for (const auto v : adj_p2v(torus, p)) a.verts.push_back(v);
    a.offsets.push_back(static_cast<std::uint32_t>(a.verts.size()));
  }
  says(polygonmesh(std::move(a)), "1 handles; cut it open with cut_along");
  const auto fine = grid<trimesh>(3);
  CHECK_THROWS_AS((void)tutte(fine, {.progress = [](double, const char*) { return false; }}), cancelled);
}

TEST_CASE("tutte: numbers of verts and a scale do not matter") {
  const auto m = grid_on<trimesh>(7, on_hill);
  const auto t = tutte(m);
  surface_arrays a{{}, {}, {}, 3};
  const auto n = static_cast<unsigned>(num_verts(m));
  for (unsigned v = 0; v < n; ++v) a.points.push_back(std::ldexp(1.0, 600) * point(m, vert_id{n - 1 - v}));
  for (const auto p : polys(m))
    for (const auto v : adj_p2v(m, p)) a.verts.push_back(vert_id{n - 1 - v.raw()});
  const trimesh other(std::move(a));
  const auto u = tutte(other);
  for (const auto v : verts(m))
    for (std::size_t k = 0; k < 2; ++k) CHECK(u.uv[vert_id{n - 1 - v.raw()}][k] == doctest::Approx(t.uv[v][k]).epsilon(1e-12));
}
