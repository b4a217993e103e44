// edge_collapse: counts, topology, descriptors and points; refusals are those of the link condition by its definition.
#include <concino/edit/edge_collapse.hpp>
#include <concino/edit/edge_split.hpp>
#include <concino/edit/merge_verts.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>

#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <random>

namespace cn = concino;
using cn::testing::edge_between_verts;
using cn::testing::element_counts;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::polys_as_sets;
using cn::testing::raw;
using cn::testing::topology;

namespace {

/// Collapses random edges and compares each answer with the definition. Returns how many were collapsed.
template<class M>
unsigned collapse_at_random(M& m, std::mt19937& random, unsigned tries) {
  unsigned done = 0;
  const auto before = topology(m);
  const auto singular = cn::testing::singular_links(m);
  for (unsigned i = 0; i < tries && cn::num_edges(m) > 0; ++i) {
    const std::vector<unsigned> all = raw(cn::edges(m));
    const cn::edge_id e{all[random() % all.size()]};
    const auto ends = cn::end_verts(m, e);
    const bool expected = cn::testing::obeys_link_condition(polys_as_sets(m), ends.first.raw(), ends.second.raw());
    CHECK(bool(cn::can_edge_collapse(m, e)) == expected);
    const auto old = expected ? std::vector<double>() : cn::testing::whole(m);
    const std::size_t polys = cn::num_polys(m), at_edge = cn::num_elements(cn::adj_e2p(m, e)), verts = cn::num_verts(m);
    const bool keeps_second = i % 3 == 0;
    const double at = 0.25 * double(random() % 5);
    const cn::vec3 a = cn::point(m, ends.first), b = cn::point(m, ends.second);
    const auto made = cn::edge_collapse(m, e, {.at = at, .keeps_second = keeps_second});
    CHECK(bool(made) == expected);
    if (!made) {
      CHECK(made.reason == cn::refusal::link_condition);
      CHECK(cn::testing::whole(m) == old);
      continue;
    }
    ++done;
    CHECK(made.vert == (keeps_second ? ends.second : ends.first));
    CHECK_FALSE(cn::contains(m, keeps_second ? ends.first : ends.second));
    CHECK(cn::distance(cn::point(m, made.vert), (1 - at) * a + at * b) < 1e-12);
    CHECK(cn::num_polys(m) == polys - at_edge);
    CHECK(cn::num_verts(m) == verts - 1);
    CHECK(topology(m) == before);
    if (cn::dimension_v<M> == 2) CHECK(cn::testing::singular_links(m) == singular);
    if (done % 8 == 0) keeps_all_laws(m);
  }
  keeps_all_laws(m);
  equals_rebuilt(m);
  return done;
}

template<class M>
void is_refused(M m, unsigned a, unsigned b) {
  const auto before = cn::testing::whole(m);
  const cn::edge_id e = edge_between_verts(m, a, b);
  CHECK(cn::can_edge_collapse(m, e).reason == cn::refusal::link_condition);
  const auto made = cn::edge_collapse(m, e);
  CHECK(made.reason == cn::refusal::link_condition);
  CHECK_FALSE(made.why.empty());
  CHECK(cn::testing::whole(m) == before);
}

}  // namespace

TEST_CASE("edge_collapse: an edge of a grid") {
  cn::trimesh m = cn::testing::grid<cn::trimesh>(4);
  cn::edge_id inner;
  for (const auto e : cn::edges(m)) {
    const auto ends = cn::end_verts(m, e);
    if (!cn::is_boundary(m, ends.first) && !cn::is_boundary(m, ends.second)) inner = e;
  }
  const auto ends = cn::end_verts(m, inner);
  const cn::vec3 a = cn::to_vec3(cn::point(m, ends.first)), b = cn::to_vec3(cn::point(m, ends.second));
  std::vector<std::pair<unsigned, std::vector<unsigned>>> expected;  // the polys that remain, and their corners
  for (const auto p : cn::polys(m)) {
    std::vector<unsigned> corners = raw(cn::adj_p2v(m, p));
    std::replace(corners.begin(), corners.end(), ends.second.raw(), ends.first.raw());
    if (std::set<unsigned>(corners.begin(), corners.end()).size() == 3) expected.emplace_back(p.raw(), corners);
  }
  const auto old = element_counts(m);
  const double area = cn::total_measure(m);
  const auto made = cn::edge_collapse(m, inner, {.at = 0.25});
  REQUIRE(made);
  CHECK(made.vert == ends.first);
  CHECK(cn::to_vec3(cn::point(m, made.vert)) == 0.75 * a + 0.25 * b);
  const auto now = element_counts(m);
  CHECK(now == std::vector<std::ptrdiff_t>{old[0] - 1, old[1] - 3, old[2] - 2});
  std::vector<std::pair<unsigned, std::vector<unsigned>>> remaining;
  for (const auto p : cn::polys(m)) remaining.emplace_back(p.raw(), raw(cn::adj_p2v(m, p)));
  CHECK(remaining == expected);
  CHECK(cn::total_measure(m) == doctest::Approx(area));
  keeps_all_laws(m);
}

TEST_CASE_TEMPLATE("edge_collapse: agrees with the definition on grids with boundary", M, cn::trimesh, cn::tetmesh) {
  std::mt19937 random(5);
  M m = cn::testing::grid<M>(cn::dimension_v<M> == 2 ? 5 : 2);
  CHECK(collapse_at_random(m, random, 60) > 8);
}

TEST_CASE("edge_collapse: agrees with the definition on a sphere, until four triangles are left") {
  std::mt19937 random(6);
  cn::trimesh m = cn::icosphere(1);
  CHECK(collapse_at_random(m, random, 200) > 30);
  while (cn::num_polys(m) > 4) REQUIRE(collapse_at_random(m, random, 200) > 0);
  for (const auto e : cn::edges(m)) CHECK_FALSE(cn::can_edge_collapse(m, e));
}

TEST_CASE_TEMPLATE("edge_collapse: agrees with the definition on non-manifold soups", M, cn::trimesh, cn::tetmesh, cn::polygonmesh) {
  std::mt19937 random(7);
  unsigned done = 0;
  for (unsigned round = 0; round < 50; ++round) {
    const auto grid = cn::testing::grid<std::conditional_t<cn::dimension_v<M> == 2, cn::trimesh, cn::tetmesh>>(cn::dimension_v<M> == 2 ? 3 : 2);
    std::vector<cn::vec3> points;
    std::vector<std::vector<unsigned>> polys;
    for (const auto v : cn::verts(grid)) points.push_back(cn::to_vec3(cn::point(grid, v)));
    for (const auto p : cn::polys(grid))
      if (random() % 4 < 2) polys.push_back(raw(cn::adj_p2v(grid, p)));
    for (unsigned i = 0; i < round % 4; ++i) polys.push_back(cn::testing::some_of(random, static_cast<unsigned>(points.size()), cn::dimension_v<M> + 1));
    M m(points, polys);
    done += collapse_at_random(m, random, 10);
  }
  CHECK(done > 60);
}

TEST_CASE("edge_collapse: what the link condition refuses") {
  const std::vector<cn::vec3> x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {0, 2, 2}};
  using lists = std::vector<std::vector<unsigned>>;
  is_refused(cn::trimesh(x, lists{{0, 1, 2}}), 0, 1);                                      // the last triangle
  is_refused(cn::tetmesh(x, lists{{0, 1, 2, 3}}), 0, 1);                                   // the last tet
  is_refused(cn::trimesh(x, lists{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), 0, 1);      // a tetrahedron would become two equal triangles
  is_refused(cn::trimesh(x, lists{{0, 1, 2}, {1, 3, 2}, {1, 4, 3}, {3, 4, 5}}), 1, 3);  // the ends are at different places of the boundary
  is_refused(cn::trimesh(x, lists{{0, 1, 2}, {1, 0, 2}}), 0, 1);                            // a sphere of two triangles
  // two ends of the line along which three sheets meet
  is_refused(cn::trimesh(x, lists{{0, 1, 2}, {0, 2, 5}, {0, 1, 3}, {0, 3, 6}, {0, 1, 4}, {0, 4, 7}}), 0, 1);
}

TEST_CASE("edge_collapse: verts at which parts of a surface only touch do not become one") {
  cn::trimesh m = cn::icosphere(1);
  const cn::edge_id e{0};
  const auto ends = cn::end_verts(m, e);
  const auto opposite = [&](cn::vert_id v) {
    for (const auto w : cn::verts(m))
      if (cn::norm(cn::point(m, v) + cn::point(m, w)) < 1e-9) return w;
    return v;
  };
  const auto far = opposite(ends.second);
  REQUIRE(cn::merge_verts(m, ends.first, {opposite(ends.first)}));
  auto one = m;
  CHECK(cn::edge_collapse(one, e, {.at = 0.5}));  // the other end is manifold
  CHECK(cn::testing::singular_links(one) == cn::testing::singular_links(m));
  REQUIRE(cn::merge_verts(m, ends.second, {far}));
  CHECK(cn::edge_collapse(m, e).reason == cn::refusal::link_condition);

  // a vert at the boundary that a closed part touches, and another vert of the boundary
  cn::trimesh d(std::vector<cn::vec3>(7), std::vector<std::vector<unsigned>>{{0, 1, 2}, {1, 3, 2}, {0, 4, 5}, {0, 5, 6}, {0, 6, 4}, {4, 6, 5}});
  const auto singular = cn::testing::singular_links(d);
  CHECK(cn::edge_collapse(d, edge_between_verts(d, 0, 1)));
  CHECK(cn::testing::singular_links(d) == singular);
}

TEST_CASE("edge_collapse: is refused at a quad that has both ends, but not the edge") {
  cn::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}, {0, 2, 4}});
  const auto before = cn::testing::whole(m);
  const auto e = cn::testing::edge_between_verts(m, 0, 2);
  CHECK(cn::edge_collapse(m, e).reason == cn::refusal::link_condition);
  CHECK(cn::edge_collapse(m, e, {.only_simplices = true}).reason == cn::refusal::not_simplices);
  const auto side = cn::testing::edge_between_verts(m, 0, 1);
  CHECK(cn::can_edge_collapse(m, side, {.only_simplices = true}).reason == cn::refusal::not_simplices);
  CHECK(cn::edge_split(m, side, 0.5, {.only_simplices = true}).reason == cn::refusal::not_simplices);
  CHECK(cn::can_edge_split(m, side, 0.5, {.only_simplices = true}).reason == cn::refusal::not_simplices);
  CHECK(cn::testing::whole(m) == before);
}

TEST_CASE("edge_collapse: refuses quads, and throws for edges of other meshes and parameters outside the edge; nothing changes") {
  cn::quadmesh q = cn::testing::grid<cn::quadmesh>(2);
  for (const auto e : cn::edges(q)) CHECK(cn::edge_collapse(q, e).reason == cn::refusal::not_simplices);
  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  const auto old = cn::testing::whole(m);
  CHECK_THROWS_WITH_AS(cn::edge_collapse(m, cn::edge_id{99}), "edge_collapse: edge 99 is not an edge of the mesh", cn::invalid_mesh);
  CHECK_THROWS_AS(cn::can_edge_collapse(m, cn::edge_id{99}), cn::invalid_mesh);
  for (const double t : {-0.1, 1.5, std::numeric_limits<double>::quiet_NaN()}) CHECK_THROWS_AS(cn::edge_collapse(m, cn::edge_id{0}, {.at = t}), cn::invalid_argument);
  CHECK(cn::testing::whole(m) == old);
}

TEST_CASE("edge_collapse: a fan of 3000 triangles") {
  std::vector<cn::vec3> points{{0, 0, 1}, {0.1, 0, 1}};
  std::vector<std::vector<unsigned>> fan;
  const unsigned n = 3000;
  for (unsigned i = 0; i < n; ++i) {
    points.push_back({std::cos(i), std::sin(i), 0});
    if (i > 0) fan.push_back({0, i + 1, i + 2});
  }
  fan.push_back({0, n + 1, 1}), fan.push_back({0, 1, 2});
  cn::trimesh m(points, fan);
  for (unsigned i = 0; i < 10; ++i) {
    CHECK(cn::edge_collapse(m, edge_between_verts(m, 2000 + 3 * i, 2001 + 3 * i)));
    if (i == 5) CHECK(cn::edge_collapse(m, edge_between_verts(m, 0, 1000), {.at = 1}));  // the centre now lies on the boundary
    if (i > 5) CHECK(cn::edge_collapse(m, edge_between_verts(m, 0, 1000 + i)).reason == cn::refusal::link_condition);
  }
  CHECK(cn::num_polys(m) == n - 11);
  keeps_all_laws(m);
}
