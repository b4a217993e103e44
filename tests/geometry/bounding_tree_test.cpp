// The nearest poly and the polys that meet a ray or a box agree with brute force on every kind, and with known results.
#include <concino/geometry/bounding_tree.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>
#include <support/poly_triangles.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

template<class M>
concept can_be_searched = requires(M&& m) { bounding_tree(std::forward<M>(m)); };

template<class M>
M crooked(unsigned n, double amount = 0.3) {
  return M(jittered(grid_arrays<M>(n), amount / n));
}

}  // namespace

TEST_CASE_TEMPLATE("bounding_tree: the nearest point equals that of a brute-force search", M, CONCINO_KINDS) {
  const M m = crooked<M>(3);
  const auto tree = bounding_tree(m);
  point_stream at(1, -0.7, 1.7);
  for (int i = 0; i < 60; ++i) {
    const vec3 x = at();
    double least = infinity, own = infinity;
    const auto hit = tree.closest(x);
    REQUIRE(hit);
    for (const auto p : polys(m)) {
      const auto triangles = triangles_of(m, p);
      double d = infinity;
      for (const auto& t : triangles) d = std::min(d, distance_to(t, x));
      if (VolumeMesh<M> && std::abs(times_round(triangles, x)) > 0.5) d = 0;
      least = std::min(least, d);
      if (p == hit.poly) own = d;
    }
    CHECK(std::abs(hit.distance - least) < 1e-14);
    CHECK(std::abs(own - least) < 1e-14);
    CHECK(norm(hit.point - x) == hit.distance);
  }
}

TEST_CASE_TEMPLATE("bounding_tree: the hits of a ray equal those of a brute-force search", M, CONCINO_KINDS) {
  const M m = crooked<M>(3);
  const auto tree = bounding_tree(m);
  point_stream at(2, -0.5, 1.5);
  std::size_t met = 0;
  for (int i = 0; i < 60; ++i) {
    const vec3 o = at(), d = 3 * (at() - o);
    std::vector<std::pair<double, poly_t<M>>> expected;
    for (const auto p : polys(m)) {
      const auto triangles = triangles_of(m, p);
      double first = VolumeMesh<M> && std::abs(times_round(triangles, o)) > 0.5 ? 0 : infinity;
      for (const auto& t : triangles) first = std::min(first, met_at(t, o, d));
      if (first < infinity) expected.push_back({first, p});
    }
    std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const auto first = tree.ray(o, d);
    const auto all = tree.ray_all(o, d);
    CHECK(first.found == !expected.empty());
    REQUIRE(all.size() == expected.size());
    met += all.size();
    for (std::size_t k = 0; k < all.size(); ++k) {
      CHECK(std::abs(all[k].parameter - expected[k].first) < 1e-12);
      CHECK(all[k].poly == expected[k].second);
      CHECK(norm(all[k].point - (o + all[k].parameter * d)) < 1e-13);
    }
    if (!first) continue;
    CHECK(first.poly == expected[0].second);
    CHECK(first.parameter == all[0].parameter);
    // the ray ends between two hits
    const double end = all.size() > 1 ? 0.5 * (all[0].parameter + all[1].parameter) : infinity;
    CHECK(tree.ray(o, d, {.max_parameter = end}).poly == first.poly);
    CHECK(tree.ray_all(o, d, {.max_parameter = end}).size() == 1);
    CHECK(tree.ray(o, d, {.max_parameter = 0.5 * first.parameter}).found == (first.parameter == 0));
  }
  CHECK(met >= 10);
}

TEST_CASE_TEMPLATE("bounding_tree: the polys that meet a box equal those of a brute-force search", M, CONCINO_KINDS) {
  const M m = crooked<M>(3);
  const auto tree = bounding_tree(m);
  point_stream at(3, -0.2, 1.2);
  for (int i = 0; i < 40; ++i) {
    box b;
    const vec3 x = at();
    b.add(x);
    b.add(i % 2 ? at() : 0.9 * x + 0.1 * at());
    std::vector<poly_t<M>> expected;
    for (const auto p : polys(m)) {
      const auto triangles = triangles_of(m, p);
      bool meets = VolumeMesh<M> && std::abs(times_round(triangles, x)) > 0.5;
      for (const auto& t : triangles) meets = meets || reaches_into(t, b.min, b.max);
      if (meets) expected.push_back(p);
    }
    CHECK(tree.in_box(b) == expected);
  }
  box all;
  CHECK(tree.in_box(all).empty());
  all.min = {-infinity, -infinity, -infinity};
  all.max = {infinity, infinity, infinity};
  CHECK(tree.in_box(all).size() == num_polys(m));
  all.min.x = 7;
  CHECK(tree.in_box(all).empty());
}

TEST_CASE_TEMPLATE("bounding_tree: a box meets exactly the polys with which it has a common point", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto tree = bounding_tree(m);
  for (const auto v : verts(m)) {
    box b;
    b.add(to_vec3(point(m, v)));
    std::size_t around = 0;
    for ([[maybe_unused]] const auto p : adj_v2p(m, v)) ++around;
    CHECK(tree.in_box(b).size() == around);
  }
  box beside;
  beside.add({1 + 0x1p-52, 0, 0});
  beside.add({2, 1, 1});
  CHECK(tree.in_box(beside).empty());
  beside.min.x = 1;
  CHECK(!tree.in_box(beside).empty());
}

TEST_CASE_TEMPLATE("bounding_tree: results on the archetype are the same", M, CONCINO_KINDS) {
  const M m = crooked<M>(2);
  const auto g = only_embedded_mesh(m);
  const auto tree = bounding_tree(m);
  const auto same = bounding_tree(g);
  point_stream at(4, 0.2, 1.5);
  for (int i = 0; i < 20; ++i) {
    const vec3 x = at(), y = at();
    CHECK(g.base(same.closest(x).poly) == tree.closest(x).poly);
    CHECK(same.closest(x).distance == tree.closest(x).distance);
    const auto hit = tree.ray(x, y - x);
    const auto other = same.ray(x, y - x);
    CHECK(hit.found == other.found);
    if (hit) CHECK(g.base(other.poly) == hit.poly);
    box b;
    b.add(x);
    b.add(y);
    CHECK(same.in_box(b).size() == tree.in_box(b).size());
    CHECK(same.locate(x).has_value() == tree.locate(x).has_value());
    if (VolumeMesh<M>) CHECK(same.is_inside(x) == tree.is_inside(x));
  }
}

TEST_CASE_TEMPLATE("bounding_tree: results scale exactly with powers of two, up to sizes whose squares overflow", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.1);
  const M m(arrays);
  const auto tree = bounding_tree(m);
  for (const int power : {20, -20, 900, -900}) {
    const double s = std::ldexp(1.0, power);
    auto scaled = arrays;
    for (vec3& x : scaled.points) x *= s;
    const M n(scaled);
    const auto large = bounding_tree(n);
    point_stream at(5, -0.5, 1.5);
    for (int i = 0; i < 20; ++i) {
      const vec3 x = at(), d = at() - x;
      const auto a = tree.closest(x), b = large.closest(s * x);
      CHECK(a.poly == b.poly);
      CHECK(s * a.point == b.point);
      CHECK(s * a.distance == b.distance);
      const auto r = tree.ray(x, d), q = large.ray(s * x, s * d);
      CHECK(r.found == q.found);
      CHECK(r.parameter == q.parameter);
      CHECK(tree.locate(x) == large.locate(s * x));
    }
  }
}

TEST_CASE_TEMPLATE("bounding_tree: queries from very far away are right", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto tree = bounding_tree(m);
  for (const double far : {1e20, 1e100, 1e300}) {
    const auto hit = tree.closest({-far, -far, 0});
    CHECK(norm(hit.point) < 2);
    CHECK(std::abs(hit.distance - std::sqrt(2) * far) <= 1e-15 * far);
    CHECK(!tree.locate({0.5, far, 0}));
    CHECK(!tree.ray({far, far, far}, {1, 1, 1}));
    CHECK(tree.locate({0.3, 0.3, far}) == (SurfaceMesh<M> ? tree.locate({0.3, 0.3, 0}) : std::nullopt));
    if (far > 1e100) continue;  // farther away, products of coordinates overflow
    const auto met = tree.ray({0.3, 0.3, far}, {0, 0, -far});
    REQUIRE(met);
    CHECK(norm(met.point - vec3{0.3, 0.3, met.point.z}) < 1e-12);  // rounding decides which of the polys on the ray is first
  }
}

TEST_CASE_TEMPLATE("bounding_tree: a tree works without polys, and with polys without area or volume", M, CONCINO_KINDS) {
  const M none;
  const auto empty = bounding_tree(none);
  box b;
  b.add({0, 0, 0});
  CHECK(!empty.closest({0, 0, 0}));
  CHECK(!empty.ray({0, 0, 0}, {1, 0, 0}));
  CHECK(empty.ray_all({0, 0, 0}, {1, 0, 0}).empty());
  CHECK(empty.in_box(b).empty());
  CHECK(!empty.locate({0, 0, 0}));
  CHECK(!empty.is_inside({0, 0, 0}));
  for (const int flat : {1, 2, 3}) {  // projected to a plane, a line, a point
    auto arrays = grid_arrays<M>(2);
    for (vec3& x : arrays.points) x = {flat < 3 ? x.x : 0.25, flat < 2 ? x.y : 0.25, 0.25};
    const M m(arrays);
    const auto tree = bounding_tree(m);
    const vec3 x{flat < 3 ? 0.4 : 0.25, 0.25, 1};
    CHECK(tree.closest(x).distance == 0.75);
    CHECK(tree.closest({x.x, x.y, 0.25}).distance == 0);
    b = {};
    b.add({x.x, x.y, 0.25});
    CHECK(!tree.in_box(b).empty());
    if (flat > 1) CHECK(!tree.ray(x, {0, 0, -1}));  // the polys are parallel to the ray, which meets their edges only
  }
}

TEST_CASE_TEMPLATE("bounding_tree: queries and polys with points that are not finite throw; isolated verts do not matter", M, CONCINO_KINDS) {
  const M m = grid<M>(1);
  const auto tree = bounding_tree(m);
  for (const double bad : {no_number, infinity}) {
    CHECK_THROWS_AS(tree.closest({0, bad, 0}), invalid_argument);
    CHECK_THROWS_AS(tree.locate({0, bad, 0}), invalid_argument);
    CHECK_THROWS_AS(tree.is_inside({0, bad, 0}), invalid_argument);
    CHECK_THROWS_AS(tree.ray({0, bad, 0}, {1, 0, 0}), invalid_argument);
    CHECK_THROWS_AS(tree.ray({0, 0, 0}, {1, bad, 0}), invalid_argument);
    CHECK_THROWS_AS(tree.ray_all({0, 0, 0}, {1, bad, 0}), invalid_argument);
    auto arrays = two_grids_arrays<M>(1);
    arrays.points.back().x = bad;  // the vert has no polys, so it does not matter
    const M isolated(arrays);
    CHECK(bounding_tree(isolated).closest({-1, 0, 0}).distance == 1);
    arrays.points[0].y = bad;
    const M broken(arrays);
    CHECK_THROWS_AS(bounding_tree(broken), invalid_mesh);
  }
  CHECK_THROWS_AS(tree.ray({0, 0, 0}, {0, 0, 0}), invalid_argument);
  CHECK_THROWS_AS(tree.ray({0, 0, 0}, {1, 0, 0}, {.max_parameter = -1}), invalid_argument);
  CHECK_THROWS_AS(tree.ray({0, 0, 0}, {1, 0, 0}, {.max_parameter = no_number}), invalid_argument);
  CHECK(!tree.in_box({{no_number, 0, 0}, {1, 1, 1}}).size());
}

TEST_CASE("bounding_tree: rays through verts and edges of a closed surface hit it, at 0 if they start on it") {
  auto arrays = grid_arrays<tetmesh>(4);
  const tetmesh m(arrays);
  const auto tree = bounding_tree(m);
  for (int i = 0; i <= 8; ++i)
    for (int j = 0; j <= 8; ++j) {
      const double x = i / 8.0, y = j / 8.0;
      CHECK(tree.ray({x, y, 2}, {0, 0, -1}).parameter == 1);
      CHECK(tree.ray({x, 3, y}, {0, -0.5, 0}).parameter == 4);
      CHECK(tree.ray({x, y, 1}, {0, 0, 1}).parameter == 0);
      CHECK(!tree.ray({x, y, 1 + 0x1p-52}, {0.3, 0.2, 1}));
      CHECK(tree.ray({x, y, 0.5}, {0.1, 0.2, 0.3}).parameter == 0);
    }
}

TEST_CASE("bounding_tree: rays at verts and edges of a surface never miss it") {
  const auto arrays = jittered(triangle_grid(8), 0.05);
  const trimesh m(arrays);
  const auto tree = bounding_tree(m);
  point_stream at(6, -1, 2);
  for (const auto e : edges(m)) {
    std::size_t around = 0;
    for ([[maybe_unused]] const auto p : adj_e2p(m, e)) ++around;
    if (around != 2) continue;
    std::vector<vec3> ends;
    for (const auto v : adj_e2v(m, e)) ends.push_back(point(m, v));
    for (const double t : {0.3, 0.5, 0.77}) {
      const vec3 target = ends[0] + t * (ends[1] - ends[0]), o = target + 0.2 * at() + vec3{0, 0, 3};  // the ray is steep, so it meets no poly at a small angle
      const auto all = tree.ray_all(o, target - o);
      CHECK(std::any_of(all.begin(), all.end(), [](const auto& hit) { return std::abs(hit.parameter - 1) < 1e-12; }));
    }
  }
}

TEST_CASE("bounding_tree: a tree works with coincident polys and with polys of very different sizes") {
  std::vector<vec3> x;
  std::vector<std::array<unsigned, 3>> t;
  for (unsigned i = 0; i < 3000; ++i) {
    const double s = i < 1000 ? 1 : std::pow(0.5, (i - 1000) / 3);
    for (const vec3& p : {vec3{s, 0, 0}, {2 * s, 0, 0}, {s, s, 0}}) x.push_back(p);
    t.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const trimesh m(x, t);
  const auto tree = bounding_tree(m);
  CHECK(tree.closest({3, 0, 0}).poly == poly_id{0});  // the first of a thousand
  CHECK(tree.closest({3, 0, 0}).point == vec3{2, 0, 0});
  CHECK(tree.ray({1.5, 0.1, 1}, {0, 0, -1}).poly == poly_id{0});
  CHECK(tree.ray_all({1.5, 0.1, 1}, {0, 0, -1}).size() == 1003);
  CHECK(tree.locate({0x1.8p-300, 0x1p-305, 0}).has_value());
}

TEST_CASE("bounding_tree: a tree stores a copy of a view or the address of a mesh, and rejects temporaries") {
  static_assert(can_be_searched<trimesh&> && can_be_searched<const trimesh&> && !can_be_searched<trimesh> && !can_be_searched<int&>);
  const trimesh m = grid<trimesh>(1);
  CHECK(&bounding_tree(m).mesh() == &m);
}
