// poly_cut and merge_polys: one is the inverse of the other; what they refuse, values, and undoing.
#include <concino/edit.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh.hpp>

#include <support/random_poly_edits.hpp>
#include <support/simplex_edits.hpp>

#include <doctest/doctest.h>

#include <random>

namespace cn = concino;
using namespace cn::testing;
using lists = std::vector<std::vector<unsigned>>;

namespace {

template<class M>
cn::refusal why(const M& m, const cn::permission& p) {
  static_cast<void>(m);
  CHECK((p.reason == cn::refusal::none || !p.why.empty()));
  return p.reason;
}

}  // namespace

TEST_CASE("poly_cut: a hexagon, and back") {
  cn::polygonmesh m({{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}}, {{0, 1, 2, 3, 4, 5}});
  const auto c = cn::poly_cut(m, cn::poly_id{0}, cn::vert_id{1}, cn::vert_id{4});
  REQUIRE(c);
  CHECK(c.polys == std::array{cn::poly_id{0}, cn::poly_id{1}});
  CHECK(raw(cn::adj_p2v(m, c.polys[0])) == std::vector<unsigned>{1, 2, 3, 4});
  CHECK(raw(cn::adj_p2v(m, c.polys[1])) == std::vector<unsigned>{4, 5, 0, 1});
  CHECK(raw_set(cn::adj_e2v(m, c.edge)) == std::set<unsigned>{1, 4});
  keeps_all_laws(m), equals_rebuilt(m);
  const auto merged = cn::merge_polys(m, c.edge);
  REQUIRE(merged);
  CHECK(merged.poly == cn::poly_id{0});
  CHECK(cn::num_edges(m) == 6);
  CHECK(cn::total_measure(m) == doctest::Approx(12));
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("poly_cut: what is refused of polygons") {
  cn::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2, 3}, {1, 4, 5, 2}, {0, 2, 5}});
  const auto before = whole(m);
  const cn::poly_id p{0};
  const auto v = [](unsigned i) { return cn::vert_id{i}; };
  CHECK(why(m, cn::poly_cut(m, p, v(0), v(1))) == cn::refusal::wrong_set);
  CHECK(why(m, cn::poly_cut(m, p, v(0), v(3))) == cn::refusal::wrong_set);
  CHECK(why(m, cn::poly_cut(m, p, v(0), v(0))) == cn::refusal::wrong_set);
  CHECK(why(m, cn::poly_cut(m, p, v(0), v(5))) == cn::refusal::wrong_set);
  CHECK(why(m, cn::poly_cut(m, p, v(0), v(2))) == cn::refusal::same_verts);  // the edge of the triangle
  CHECK(why(m, cn::can_poly_cut(m, p, v(1), v(3))) == cn::refusal::none);
  const auto never = [](const cn::proposed_edit&) { return cn::permission{cn::refusal::invariant, "never"}; };
  CHECK(why(m, cn::poly_cut(m, p, v(1), v(3), {.keep = {never}})) == cn::refusal::invariant);
  CHECK_THROWS_WITH_AS(cn::poly_cut(m, cn::poly_id{9}, v(1), v(3)), "poly_cut: poly 9 is not a poly of the mesh", cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::can_poly_cut(m, p, v(99), v(3)), "can_poly_cut: vert 99 is not a vert of the mesh", cn::invalid_mesh);
  CHECK(whole(m) == before);
}

TEST_CASE("merge_polys: across a chain of edges with all that is inside") {
  // two polygons that share the chain 1, 2, 3
  cn::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {1.2, 0.5, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2, 3, 4}, {1, 5, 6, 3, 2}});
  const auto e = edge_between_verts(m, 1, 2);
  REQUIRE(cn::can_merge_polys(m, e));
  const auto r = cn::merge_polys(m, e);
  REQUIRE(r);
  CHECK(raw(cn::adj_p2v(m, r.poly)) == std::vector<unsigned>{0, 1, 5, 6, 3, 4});
  CHECK_FALSE(cn::contains(m, cn::vert_id{2}));
  CHECK(cn::num_edges(m) == 6);
  CHECK(cn::total_measure(m) == doctest::Approx(2));
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("merge_polys: what is refused of polygons") {
  const std::vector<cn::vec3> x{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {3, 1, 0}, {3, 3, 0}, {1, 3, 0}};
  cn::polygonmesh ring(x, lists{{0, 1, 2, 6, 5, 4}, {2, 3, 0, 4, 7, 6}});  // two chains: an annulus
  CHECK(why(ring, cn::merge_polys(ring, edge_between_verts(ring, 0, 4))) == cn::refusal::link_condition);
  cn::polygonmesh filled(x, lists{{0, 1, 2, 6, 5, 4}, {2, 3, 0, 4, 7, 6}, {4, 5, 6, 7}});
  CHECK(why(filled, cn::merge_polys(filled, edge_between_verts(filled, 0, 4))) == cn::refusal::link_condition);
  CHECK(why(filled, cn::merge_polys(filled, edge_between_verts(filled, 0, 1))) == cn::refusal::wrong_number);
  CHECK(why(filled, cn::can_merge_polys(filled, edge_between_verts(filled, 4, 5))) == cn::refusal::none);
  cn::polygonmesh pillow(x, lists{{0, 1, 2, 3}, {3, 2, 1, 0}});
  CHECK(why(pillow, cn::merge_polys(pillow, cn::edge_id{0})) == cn::refusal::link_condition);  // all of a boundary
  cn::polygonmesh turned(x, lists{{0, 1, 5, 4}, {1, 2, 6, 5}, {0, 4, 7, 3}});
  CHECK(why(turned, cn::merge_polys(turned, edge_between_verts(turned, 1, 5))) == cn::refusal::none);
  cn::polygonmesh wound(x, lists{{0, 1, 5, 4}, {1, 5, 6, 2}});
  CHECK(why(wound, cn::merge_polys(wound, edge_between_verts(wound, 1, 5))) == cn::refusal::winding);
  cn::polygonmesh touching(x, lists{{0, 1, 5, 4}, {1, 2, 4, 5}});  // they share vert 4 too, next to the edge: a chain
  CHECK(why(touching, cn::merge_polys(touching, edge_between_verts(touching, 1, 5))) == cn::refusal::none);
  cn::polygonmesh apart(x, lists{{0, 1, 5, 4}, {1, 2, 0, 6, 5}});  // they share vert 0 apart from the edge
  CHECK(why(apart, cn::merge_polys(apart, edge_between_verts(apart, 1, 5))) == cn::refusal::link_condition);
  cn::polygonmesh three({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  CHECK(why(three, cn::merge_polys(three, edge_between_verts(three, 0, 1))) == cn::refusal::wrong_number);
  cn::polygonmesh tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
  REQUIRE(cn::merge_polys(tet, edge_between_verts(tet, 0, 1)));
  const auto before = whole(tet);
  CHECK(why(tet, cn::merge_polys(tet, edge_between_verts(tet, 2, 3))) == cn::refusal::same_verts);  // two quads on the same verts
  CHECK(whole(tet) == before);
  CHECK_THROWS_WITH_AS(cn::merge_polys(tet, cn::edge_id{77}), "merge_polys: edge 77 is not an edge of the mesh", cn::invalid_mesh);
}

TEST_CASE("poly_cut and merge_polys of polyhedra: a box of two hexes") {
  cn::polyhedralmesh m(extrude(quad_grid(1), 2));
  REQUIRE(cn::num_polys(m) == 2);
  cn::face_id wall;
  for (const auto f : cn::faces(m))
    if (cn::num_elements(cn::adj_f2p(m, f)) == 2) wall = f;
  const auto loop_of = [&] {
    std::vector<cn::edge_id> loop;
    for (const auto e : cn::edges(m)) {
      const auto ends = cn::end_verts(m, e);
      if (cn::point(m, ends.first).z == 0.5 && cn::point(m, ends.second).z == 0.5) loop.push_back(e);
    }
    return loop;
  };
  const auto merged = cn::merge_polys(m, wall);
  REQUIRE(merged);
  CHECK(merged.poly == cn::poly_id{0});
  CHECK(cn::num_polys(m) == 1);
  CHECK(cn::num_faces(m) == 10);
  CHECK(cn::total_measure(m) == doctest::Approx(1));
  keeps_all_laws(m), equals_rebuilt(m);
  auto loop = loop_of();
  std::swap(loop[0], loop[2]);  // any order
  const auto cut = cn::poly_cut(m, merged.poly, loop);
  REQUIRE(cut);
  CHECK(cut.polys[0] == merged.poly);
  CHECK(cn::num_elements(cn::adj_f2p(m, cut.face)) == 2);
  CHECK(cn::measure(m, cut.polys[0]) == doctest::Approx(0.5));
  CHECK(cn::num_faces(m) == 11);
  keeps_all_laws(m), equals_rebuilt(m);
  CHECK(polys_as_sets(m) == polys_as_sets(cn::polyhedralmesh(extrude(quad_grid(1), 2))));

  // refusals
  const auto before = whole(m);
  const cn::poly_id p = cut.polys[0];
  std::vector<cn::edge_id> rim;
  for (const auto e : cn::adj_f2e(m, cut.face)) rim.push_back(e);
  CHECK(why(m, cn::poly_cut(m, p, rim)) == cn::refusal::degenerate);  // a part of one face
  rim.pop_back();
  CHECK(why(m, cn::poly_cut(m, p, rim)) == cn::refusal::wrong_set);
  CHECK(why(m, cn::poly_cut(m, p, {rim[0], rim[0], rim[1]})) == cn::refusal::wrong_set);
  CHECK(why(m, cn::poly_cut(m, p, {})) == cn::refusal::wrong_set);
  std::vector<cn::edge_id> two_faces;  // around two neighbouring faces: parts of two and four
  const auto faces = [&] {
    std::vector<cn::face_id> all;
    for (const auto f : cn::adj_p2f(m, p)) all.push_back(f);
    return all;
  }();
  for (const auto f : {faces[0], faces[2]})
    for (const auto e : cn::adj_f2e(m, f)) {
      const auto known = std::find(two_faces.begin(), two_faces.end(), e);
      if (known != two_faces.end()) two_faces.erase(known);
      else two_faces.push_back(e);
    }
  CHECK(why(m, cn::poly_cut(m, p, two_faces)) == cn::refusal::degenerate);
  CHECK_THROWS_WITH_AS(cn::poly_cut(m, p, {cn::edge_id{999}}), "poly_cut: edge 999 is not an edge of the mesh", cn::invalid_mesh);
  CHECK(why(m, cn::merge_polys(m, faces[1] == cut.face ? faces[0] : faces[1])) == cn::refusal::wrong_number);
  CHECK(whole(m) == before);
}

TEST_CASE("merge_polys: three hexes around an edge, two of which share one face and an edge apart from it") {
  cn::polyhedralmesh m(extrude(quad_grid(2), 1));  // four hexes around a vertical edge
  std::vector<cn::face_id> inside;
  for (const auto f : cn::faces(m))
    if (cn::num_elements(cn::adj_f2p(m, f)) == 2) inside.push_back(f);
  REQUIRE(inside.size() == 4);
  REQUIRE(cn::merge_polys(m, inside[0]));
  std::size_t merged = 1;
  for (const auto f : inside)
    if (cn::contains(m, f) && cn::merge_polys(m, f)) ++merged;
  CHECK(merged == 3);  // the last one goes across two faces, and removes the edge between them
  CHECK(cn::num_polys(m) == 1);
  CHECK(cn::total_measure(m) == doctest::Approx(1));
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("merge_polys: across a disk of faces with a vert inside") {
  // a cube of which the upper half is one poly, and the lower one of four, which are merged first
  cn::polyhedralmesh m(extrude(quad_grid(2), 2));
  auto labels = cn::make_poly_map<int>(m, 0);
  for (const auto p : cn::polys(m)) labels[p] = [&] {
    for (const auto v : cn::adj_p2v(m, p))
      if (cn::point(m, v).z == 1) return 7;
    return -3;
  }();
  const auto r = cn::merge_polys(m, labels);
  REQUIRE(r);
  REQUIRE(r.polys.size() == 2);
  CHECK(cn::num_polys(m) == 2);
  keeps_all_laws(m), equals_rebuilt(m);
  const auto between = [&] {
    for (const auto f : cn::faces(m))
      if (cn::num_elements(cn::adj_f2p(m, f)) == 2) return f;
    return cn::face_id{};
  }();
  const std::size_t verts = cn::num_verts(m);
  REQUIRE(cn::merge_polys(m, between));
  CHECK(cn::num_verts(m) == verts - 1);  // the one in the middle
  CHECK(cn::num_polys(m) == 1);
  CHECK(cn::total_measure(m) == doctest::Approx(1));
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("merge_polys: labels; descriptors of what is not touched stay") {
  auto m = grid<cn::polygonmesh>(4);
  auto labels = cn::make_poly_map<long>(m, 0);
  for (const auto p : cn::polys(m)) labels[p] = p.raw() < 4 ? 1000 : p.raw();  // the first row of blocks in part
  std::vector<std::vector<unsigned>> untouched;
  for (const auto p : cn::polys(m))
    if (p.raw() >= 4) untouched.push_back(raw(cn::adj_p2v(m, p)));
  const double area = cn::total_measure(m);
  const auto r = cn::merge_polys(m, labels);
  REQUIRE(r);
  CHECK(r.polys.size() == 29);
  CHECK(r.polys.back() == cn::poly_id{0});
  for (unsigned i = 4; i < 32; ++i) CHECK(raw(cn::adj_p2v(m, cn::poly_id{i})) == untouched[i - 4]);
  CHECK(cn::total_measure(m) == doctest::Approx(area));
  keeps_all_laws(m), equals_rebuilt(m);
  auto bad = cn::make_poly_map<int>(m, 0);
  for (const auto p : cn::polys(m)) bad[p] = p.raw() == 0 || p.raw() == 31 ? -5 : static_cast<int>(p.raw());
  const auto before = whole(m);
  const auto refused = cn::merge_polys(m, bad);
  CHECK(why(m, refused) == cn::refusal::link_condition);
  CHECK(refused.label == -5);
  CHECK(whole(m) == before);
  cn::polygonmesh empty;
  CHECK(cn::merge_polys(empty, cn::make_poly_map<int>(empty, 0)));
}

TEST_CASE("poly_cut and merge_polys: values follow, by the rules of properties, and all can be undone") {
  cn::polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {3, 0, 0}, {3, 1, 0}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
  auto sum = cn::poly_property<double>(m, "sum");
  auto mean = cn::poly_property<double>(m, "mean");
  cn::set_property_rule(m, cn::element_kind::poly, "sum", cn::property_rule::sum);
  auto label = cn::poly_property<int>(m, "label");
  auto corner = cn::corner_property<double>(m, "corner");
  auto of_edge = cn::edge_property<int>(m, "edge");
  sum[cn::poly_id{0}] = 6, sum[cn::poly_id{1}] = 3, mean[cn::poly_id{0}] = 1, mean[cn::poly_id{1}] = 4, label[cn::poly_id{0}] = 5, label[cn::poly_id{1}] = 8;
  for (const auto p : cn::polys(m))
    for (double& x : corner.of(p)) x = 10 + p.raw();
  for (const auto e : cn::edges(m)) of_edge[e] = 1 + static_cast<int>(e.raw());
  const auto start = whole(m);
  cn::transaction<cn::polygonmesh> t(m);
  const auto c = cn::poly_cut(m, cn::poly_id{0}, cn::vert_id{1}, cn::vert_id{3});
  REQUIRE(c);
  CHECK(sum[c.polys[0]] == doctest::Approx(3));
  CHECK(sum[c.polys[1]] == doctest::Approx(3));
  CHECK(mean[c.polys[1]] == doctest::Approx(1));
  CHECK(label[c.polys[1]] == 5);
  CHECK(of_edge[c.edge] == 0);
  for (const double x : corner.of(c.polys[1])) CHECK(x == 10);
  REQUIRE(cn::merge_polys(m, c.edge));
  CHECK(sum[cn::poly_id{0}] == doctest::Approx(6));
  const auto r = cn::merge_polys(m, edge_between_verts(m, 1, 2));
  REQUIRE(r);
  CHECK(sum[r.poly] == doctest::Approx(9));
  CHECK(mean[r.poly] == doctest::Approx((2.0 * 1 + 1.0 * 4) / 3));
  for (const auto e : cn::edges(m)) CHECK(of_edge[e] != 0);
  keeps_all_laws(m);
  auto edits = t.commit();
  const auto after = whole(m);
  edits.undo();
  CHECK(whole(m) == start);
  CHECK(label[cn::poly_id{1}] == 8);
  edits.redo();
  CHECK(whole(m) == after);
}

TEST_CASE("poly_cut and merge_polys are inverses, at random") {
  std::mt19937 random(3);
  auto m = grid<cn::polygonmesh>(5);
  unsigned done = 0;
  for (unsigned i = 0; i < 500; ++i) {
    const auto p = some_poly(m, random);
    std::vector<cn::vert_id> v;
    for (const auto x : cn::adj_p2v(m, p)) v.push_back(x);
    const auto shape = polys_as_sets(m);
    const auto c = cn::poly_cut(m, p, v[random() % v.size()], v[random() % v.size()]);
    if (!c) continue;
    ++done;
    const auto r = cn::merge_polys(m, c.edge);
    REQUIRE(r);
    CHECK(polys_as_sets(m) == shape);
    CHECK(r.poly == p);
  }
  CHECK(done > 100);
  keeps_all_laws(m), equals_rebuilt(m);
}
