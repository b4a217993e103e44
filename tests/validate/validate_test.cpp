// validate finds every kind of defect on a small mesh with exactly this defect.
#include <concino/concepts/archetypes.hpp>
#include <concino/validate/validate.hpp>

#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using tris = std::vector<std::array<int, 3>>;
using polygons = std::vector<std::vector<int>>;
using tets = std::vector<std::array<int, 4>>;
using cells = std::vector<std::vector<std::pair<int, bool>>>;

/// Checks that m has n defects, all of this kind, the first one at this element.
template<class M, class X>
void shows(const M& m, defect_kind kind, const X& element, std::size_t n = 1, const validate_options& options = {}) {
  const auto r = validate(m, options);
  for (const auto& d : r)
    if (d.kind != kind) FAIL_CHECK(d.what);
  CHECK(r.count(kind) == n);
  CHECK(r.count() == n);
  REQUIRE(r.size() > 0);
  CHECK(r[0].element == mesh_element<M>(element));
  CHECK(r[0].what.size() > 15);
  CHECK(r[0].what.find_first_of("0123456789") != std::string::npos);
}

/// Points in general position.
const std::vector<vec3> some = {{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {0.2, 0.3, 1}, {0.4, 0.2, -1}, {1, 1, 1}, {-1, 0.2, 0.5}, {-0.5, -1, 0.2}};
const polygons tet_faces = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

}  // namespace

TEST_CASE_TEMPLATE("validate: grids, disconnected and empty meshes have no defect", M, CONCINO_KINDS) {
  CHECK(validate(M()).is_clean());
  for (const unsigned n : {1u, 2u, 4u}) {
    const M m = grid<M>(n);
    const auto r = validate(m);
    for (const auto& d : r) FAIL_CHECK(d.what);
    CHECK(r.is_clean());
    CHECK(r.facts.manifold);
    CHECK(r.facts.orientable);
    CHECK(r.facts.components == 1);
    CHECK(r.facts.euler_characteristic == 1);
    CHECK(r.facts.genus == std::optional<std::size_t>(0));
    CHECK(r.facts.boundary_loops == (dimension_v<M> == 2 ? 1 : 0));
    CHECK(r.facts.closed == (dimension_v<M> == 3));
  }
  const M two = two_grids<M>(2);
  shows(two, defect_kind::isolated_vert, vert_id{num_verts(two) - 1});
  CHECK(validate(two).facts.components == 2);
  CHECK(validate(two).facts.euler_characteristic == 2);
}

TEST_CASE("validate: works on users' meshes") {
  shows(user_mesh::surface_example(), defect_kind::isolated_vert, user_mesh::vertex{7});
  shows(user_mesh::volume_example(), defect_kind::isolated_vert, user_mesh::vertex{9});
  CHECK(validate(user_mesh::volume_example()).facts.genus == std::optional<std::size_t>(0));
  // Meshes that native meshes reject.
  const user_mesh::surface twice({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 1}});
  CHECK(validate(twice).count(defect_kind::degenerate_element) == 1);
  const user_mesh::surface digon({{0, 0, 0}, {1, 0, 0}}, {{0, 1}});
  CHECK(validate(digon).count(defect_kind::degenerate_element) == 1);
  const user_mesh::surface loop({{0, 0, 0}}, {{0}});
  CHECK(validate(loop).count(defect_kind::degenerate_element) == 2);  // the poly and its edge
}

TEST_CASE("validate: finds points that are not finite") {
  for (const double x : {std::nan(""), std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    trimesh s = grid<trimesh>(2);
    set_point(s, vert_id{3}, vec3{0, x, 0});
    shows(s, defect_kind::non_finite_point, vert_id{3});
    hexmesh h = grid<hexmesh>(2);
    set_point(h, vert_id{3}, vec3{x, 0, 0});
    shows(h, defect_kind::non_finite_point, vert_id{3});
  }
}

TEST_CASE("validate: finds topological defects of surfaces") {
  shows(trimesh(some, tris{{0, 1, 2}, {0, 2, 1}, {3, 4, 5}, {3, 5, 6}, {3, 6, 7}}), defect_kind::duplicated_element, poly_id{1});
  const std::vector<vec3> six(some.begin(), some.begin() + 5);
  const auto edge_of = [](const auto& m, int a, int b) {
    for (const auto e : edges(m)) {
      int hits = 0;
      for (const auto v : adj_e2v(m, e)) hits += v == vert_id{a} || v == vert_id{b};
      if (hits == 2) return e;
    }
    return edge_id{};
  };
  const trimesh book(six, tris{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  shows(book, defect_kind::non_manifold_edge, edge_of(book, 0, 1));
  CHECK(validate(book)[0].others.size() == 3);
  CHECK_FALSE(validate(book).facts.manifold);
  CHECK_FALSE(validate(book).facts.genus);
  const trimesh bow(six, tris{{0, 1, 2}, {0, 3, 4}});
  shows(bow, defect_kind::non_manifold_vert, vert_id{0});
  CHECK(validate(bow).facts.boundary_loops == 1);
  const trimesh two({{0, 0, 0}, {1, 0, 0}, {0.3, 1, 0}, {0.2, -1, 1}}, {{0, 1, 2}, {0, 1, 3}});
  shows(two, defect_kind::inconsistent_winding, edge_of(two, 0, 1));
  CHECK(validate(two).facts.orientable);
  CHECK(validate(two).facts.manifold);
  const trimesh moebius(six, tris{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
  const auto r = validate(moebius);
  shows(moebius, defect_kind::not_orientable, std::get<edge_id>(r[0].element));
  CHECK_FALSE(r.facts.orientable);
  CHECK(r.facts.manifold);
  CHECK(r.facts.boundary_loops == 1);
  CHECK_FALSE(r.facts.genus);
  // a component that can be oriented is reported beside one that cannot
  std::vector<vec3> both = six;
  for (const vec3& x : {vec3{7, 0, 0}, vec3{8, 0, 0}, vec3{7, 1, 0}, vec3{7, 0, 1}}) both.push_back(x);
  const auto mixed = validate(trimesh(both, tris{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}, {5, 6, 7}, {5, 6, 8}}));
  CHECK(mixed.count(defect_kind::not_orientable) == 1);
  CHECK(mixed.count(defect_kind::inconsistent_winding) == 1);
  CHECK(mixed.count() == 2);
}

TEST_CASE("validate: finds geometric defects of surfaces") {
  const std::vector<std::vector<vec3>> flat = {{{0, 0, 0}, {1, 0, 0}, {3, 0, 0}}, {{0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}},
                                               {{1e6, 0.1, 0.7}, {1e6 + 1, 0.2, 0.8}, {1e6 + 3, 0.4, 1.0}}};
  for (const auto& x : flat) shows(trimesh(x, tris{{0, 1, 2}}), defect_kind::zero_size, poly_id{0});
  shows(polygonmesh({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}, {1.5, 1.5, 1.5}}, {{0, 1, 2, 3, 4}}), defect_kind::zero_size, poly_id{0});
  // An edge without length, and its triangle.
  const trimesh needle({{0, 0, 0}, {0, 0, 0}, {1, 1, 0}}, {{0, 1, 2}});
  shows(needle, defect_kind::zero_size, std::get<edge_id>(validate(needle)[0].element), 2);
  shows(polygonmesh({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}), defect_kind::zero_size, edge_id{0});
  shows(polygonmesh({{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}, {{0, 1, 2}}), defect_kind::zero_size, edge_id{0}, 4);

  shows(polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}}, {{0, 1, 2, 3}}), defect_kind::non_planar, poly_id{0});
  CHECK(validate(polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}, {{0, 1, 2, 3}})).is_clean());

  const std::vector<std::vector<vec3>> crossing = {
      {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},                                // a bow tie with area 0
      {{0, 0, 0}, {3, 2, 0}, {3, 0, 0}, {0, 1, 0}},                                // a bow tie with an area
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 0, 0}, {0, 2, 0}},                     // a vert on an edge
      {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {5, 1, 0}, {3, 1, 0}, {3, 3, 0}},          // a spike; two verts at one point
      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}, {-1, 1, 0}, {1, 1, 0}}};  // two verts at one point
  for (auto x : crossing)
    for (int turn = 0; turn < 2; ++turn) {
      std::vector<int> ring;
      for (std::size_t i = 0; i < x.size(); ++i) ring.push_back(static_cast<int>(i));
      shows(polygonmesh(x, polygons{ring}), defect_kind::self_touching, poly_id{0});
      for (vec3& p : x) p = {p.z + 5, p.x + 0.5 * p.y, p.y};  // rotated and translated
    }
  CHECK(validate(polygonmesh(polygon_grid(3))).is_clean());
  // Many corners: a comb whose last tooth is too long, or not.
  for (const bool too_long : {false, true}) {
    std::vector<vec3> x = {{0, -1, 0}, {4000, -1, 0}};
    for (int i = 2000; i-- > 0;) {
      x.push_back({2 * i + 1.5, 0, 0});
      x.push_back({2 * i + 1, too_long && i == 1234 ? -1.0 : 50.0, 0});
    }
    std::vector<int> ring;
    for (std::size_t i = 0; i < x.size(); ++i) ring.push_back(static_cast<int>(i));
    const polygonmesh comb(x, polygons{ring});
    if (too_long) shows(comb, defect_kind::self_touching, poly_id{0});
    else CHECK(validate(comb).is_clean());
  }
}

TEST_CASE("validate: finds topological defects of volumes") {
  const auto upright = [](tets list) {  // reverses tets of negative volume
    for (auto& t : list) {
      const auto x = [&](std::size_t i) { return some[static_cast<std::size_t>(t[i])]; };
      if (dot(cross(x(1) - x(0), x(2) - x(0)), x(3) - x(0)) < 0) std::swap(t[0], t[1]);
    }
    return tetmesh(some, list);
  };
  const validate_options all_used = {.kinds = defect_kinds().without({defect_kind::isolated_vert})};
  const auto find_face = [](const auto& m, std::vector<int> wanted) {
    for (const auto f : faces(m)) {
      std::size_t hits = 0;
      for (const auto v : adj_f2v(m, f))
        for (const int w : wanted) hits += v == vert_id{w};
      if (hits == wanted.size()) return f;
    }
    return face_id{};
  };
  const auto three = upright({{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}});
  shows(three, defect_kind::non_manifold_face, find_face(three, {0, 1, 2}), 1, all_used);
  CHECK_FALSE(validate(three).facts.manifold);
  CHECK(validate(three).facts.components == 1);
  const auto edge = upright({{0, 1, 2, 3}, {0, 1, 4, 7}});
  const auto edge_report = validate(edge, all_used);
  shows(edge, defect_kind::non_manifold_edge, std::get<edge_id>(edge_report[0].element), 1, all_used);
  CHECK(edge_report.facts.components == 2);
  const auto corner = upright({{0, 1, 2, 3}, {0, 4, 6, 7}});
  shows(corner, defect_kind::non_manifold_vert, vert_id{0}, 1, all_used);
  const auto overlap = upright({{0, 1, 2, 3}, {0, 1, 2, 5}});
  shows(overlap, defect_kind::inconsistent_winding, find_face(overlap, {0, 1, 2}), 1, all_used);
  CHECK(validate(overlap).facts.orientable);

  // A ring of three hexes, closed with a reflection. It has no points, as some hexes would be flat or inverted.
  std::vector<vec3> x(12);
  const hexmesh ring(x, std::vector<std::array<int, 8>>{{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}, {8, 9, 10, 11, 1, 0, 3, 2}});
  const auto bare = only_mesh(ring);
  const auto found = validate(bare);
  REQUIRE(found.size() == 1);
  CHECK(found.count() == 1);
  CHECK(found[0].kind == defect_kind::not_orientable);
  CHECK_FALSE(found.facts.orientable);
  CHECK(found.facts.manifold);
  CHECK(found.facts.euler_characteristic == 0);
  // Closed without a reflection, it is a solid torus.
  const hexmesh torus(x, std::vector<std::array<int, 8>>{{0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 6, 7, 8, 9, 10, 11}, {8, 9, 10, 11, 0, 1, 2, 3}});
  const auto good = validate(only_mesh(torus));
  CHECK(good.is_clean());
  CHECK(good.facts.genus == std::optional<std::size_t>(1));

  const auto twice = validate(tetmesh(some, tets{{0, 1, 2, 3}, {0, 1, 2, 3}}), {.kinds = {defect_kind::duplicated_element}});
  CHECK(twice.count() == 1);
  CHECK(twice[0].element == mesh_element<tetmesh>(poly_id{1}));
}

TEST_CASE("validate: finds defects of polys and faces of volumes") {
  const std::vector<vec3> four(some.begin(), some.begin() + 4), five(some.begin(), some.begin() + 5);
  const auto tet = cells{{{0, true}, {1, true}, {2, true}, {3, true}}};
  CHECK(validate(polyhedralmesh(four, tet_faces, tet)).is_clean());
  polygons more = tet_faces;
  more.push_back({0, 1, 2, 3});
  shows(polyhedralmesh(four, more, tet), defect_kind::unreferenced_face, face_id{4}, 1, {.kinds = defect_kinds().without({defect_kind::duplicated_element, defect_kind::non_planar})});
  more.back() = {1, 2, 0};
  const auto copy = validate(polyhedralmesh(four, more, tet));
  CHECK(copy.count(defect_kind::duplicated_element) == 1);
  CHECK(copy.count(defect_kind::unreferenced_face) == 1);
  CHECK(copy.count() == 2);
  CHECK(copy.facts.manifold);
  CHECK(copy.facts.euler_characteristic == 1);

  const auto turned = cells{{{0, true}, {1, true}, {2, false}, {3, true}}};
  shows(polyhedralmesh(four, tet_faces, turned), defect_kind::inconsistent_winding, poly_id{0});
  CHECK_FALSE(validate(polyhedralmesh(four, tet_faces, turned)).facts.manifold);

  const std::vector<vec3> roof = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  const polyhedralmesh open(roof, polygons{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, tet);
  shows(open, defect_kind::open_cell, poly_id{0});
  CHECK(validate(open)[0].others.size() == 4);
  CHECK_FALSE(validate(open).facts.closed);
  CHECK(validate(open).facts.boundary_loops == 1);

  const polyhedralmesh lens(std::vector<vec3>(some.begin(), some.begin() + 3), polygons{{0, 1, 2}, {1, 0, 2}}, cells{{{0, true}, {1, true}}});
  shows(lens, defect_kind::degenerate_element, poly_id{0}, 1, {.kinds = defect_kinds().without({defect_kind::duplicated_element})});

  // Two tets that share an edge, as one polyhedron.
  const polyhedralmesh pinched(std::vector<vec3>{some[0], some[1], some[2], some[3], some[4], some[7]},
                               polygons{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 4, 1}, {0, 1, 5}, {0, 5, 4}, {1, 4, 5}},
                               cells{{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}, {5, true}, {6, true}, {7, true}}});
  const auto r = validate(pinched);
  shows(pinched, defect_kind::non_manifold_edge, std::get<edge_id>(r[0].element));
  CHECK(r[0].others == std::vector<mesh_element<polyhedralmesh>>{poly_id{0}});

  shows(tetmesh(four, tets{{0, 2, 1, 3}}), defect_kind::inverted_cell, poly_id{0});
  shows(tetmesh({{0, 0, 0}, {1, 0, 0}, {0.2, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}), defect_kind::zero_size, poly_id{0});
  shows(tetmesh({{0.1, 0.7, 0.3}, {1, 0, 0.3}, {0.2, 1, 0.3}, {1, 1, 0.3}}, {{0, 1, 2, 3}}), defect_kind::zero_size, poly_id{0});
  hexmesh cube = grid<hexmesh>(1);
  set_point(cube, vert_id{7}, vec3{1, 1, 3});
  CHECK(validate(cube).count(defect_kind::non_planar) > 0);
}

TEST_CASE("validate: obeys the options kinds, limit, tolerances and progress") {
  std::vector<vec3> x;
  for (int i = 0; i < 30; ++i) x.push_back({i, i * i, 0});
  const trimesh loose(x, tris{{0, 1, 2}});
  CHECK(validate(loose).size() == 27);
  const auto few = validate(loose, {.max_per_kind = 4});
  CHECK(few.size() == 4);
  CHECK(few.count(defect_kind::isolated_vert) == 27);
  CHECK(few.count() == 27);
  CHECK_FALSE(few.is_clean());
  CHECK(validate(loose, {.kinds = {defect_kind::zero_size}}).is_clean());

  const trimesh sliver({{0, 0, 0}, {1, 0, 0}, {0.5, 0.001, 0}}, {{0, 1, 2}});
  CHECK(validate(sliver).is_clean());
  shows(sliver, defect_kind::zero_size, poly_id{0}, 1, {.size_tolerance = 0.001});
  const trimesh narrow({{0, 0, 0}, {1, 0, 0}, {1, 0.01, 0}}, {{0, 1, 2}});
  shows(narrow, defect_kind::zero_size, edge_id{2}, 1, {.length_tolerance = 0.02});
  const tetmesh thin({{0, 0, 0}, {1, 0, 0}, {0.2, 1, 0}, {1, 1, 0.001}}, {{0, 1, 2, 3}});
  CHECK(validate(thin).is_clean());
  shows(thin, defect_kind::zero_size, poly_id{0}, 1, {.size_tolerance = 0.001});
  const quadmesh bent({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}}, {{0, 1, 2, 3}});
  shows(bent, defect_kind::non_planar, poly_id{0}, 1, {.planarity_tolerance = 0.01});

  for (const double bad : {-1.0, std::nan("")}) {
    CHECK_THROWS_AS(validate(bent, {.length_tolerance = bad}), invalid_argument);
    CHECK_THROWS_AS(validate(bent, {.size_tolerance = bad}), invalid_argument);
    CHECK_THROWS_AS(validate(bent, {.planarity_tolerance = bad}), invalid_argument);
  }
  double last = 0;
  std::size_t calls = 0;
  const auto watch = [&](double fraction, const char*) {
    CHECK(fraction >= last);
    last = fraction;
    ++calls;
    return true;
  };
  validate(grid<tetmesh>(12), {.progress = watch});
  CHECK(last == 1);
  CHECK(calls > 8);
  const auto stop = [](double fraction, const char*) { return fraction < 0.5; };
  CHECK_THROWS_AS(validate(grid<hexmesh>(2), {.progress = stop}), cancelled);
}
