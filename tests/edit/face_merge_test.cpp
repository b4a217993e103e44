// face_cut and face_merge, edge_split and edge_merge of polygons and polyhedra: inverses, what they refuse, values.
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

cn::face_id face_between(const cn::polyhedralmesh& m, unsigned p, unsigned q) {
  for (const auto f : cn::adj_p2f(m, cn::poly_id{p}))
    for (const auto x : cn::adj_f2p(m, f))
      if (x == cn::poly_id{q} && p != q) return f;
  return {};
}
std::vector<cn::vert_id> verts_of(const cn::polyhedralmesh& m, cn::face_id f) {
  std::vector<cn::vert_id> all;
  for (const auto v : cn::adj_f2v(m, f)) all.push_back(v);
  return all;
}
/// The faces of all polys as sets of verts.
std::multiset<std::set<std::set<unsigned>>> polys_by_faces(const cn::polyhedralmesh& m) {
  std::multiset<std::set<std::set<unsigned>>> all;
  for (const auto p : cn::polys(m)) {
    std::set<std::set<unsigned>> faces;
    for (const auto f : cn::adj_p2f(m, p)) faces.insert(raw_set(cn::adj_f2v(m, f)));
    all.insert(faces);
  }
  return all;
}
template<class M, class Edit>
void is_refused(M& m, cn::refusal reason, const Edit& edit) {
  const auto before = whole(m);
  const cn::permission p = edit(m);
  CHECK(p.reason == reason);
  CHECK_FALSE(p.why.empty());
  CHECK(whole(m) == before);
}

}  // namespace

TEST_CASE("face_cut and face_merge: a face between two hexes, and one at the boundary") {
  cn::polyhedralmesh m(extrude(quad_grid(1), 2));
  const auto start = polys_by_faces(m);
  const auto wall = face_between(m, 0, 1);
  const auto v = verts_of(m, wall);
  REQUIRE(cn::can_face_cut(m, wall, v[0], v[2]));
  const auto c = cn::face_cut(m, wall, v[0], v[2]);
  REQUIRE(c);
  CHECK(raw_set(cn::adj_f2v(m, c.faces[0])) == std::set<unsigned>{v[0].raw(), v[1].raw(), v[2].raw()});
  CHECK(raw_set(cn::adj_f2v(m, c.faces[1])) == std::set<unsigned>{v[2].raw(), v[3].raw(), v[0].raw()});
  CHECK(cn::num_elements(cn::adj_e2f(m, c.edge)) == 2);
  for (const auto f : c.faces) CHECK(cn::num_elements(cn::adj_f2p(m, f)) == 2);
  CHECK(cn::total_measure(m) == doctest::Approx(1));
  keeps_all_laws(m), equals_rebuilt(m);
  const auto merged = cn::face_merge(m, c.faces[0], c.faces[1]);
  REQUIRE(merged);
  CHECK(polys_by_faces(m) == start);
  CHECK(cn::num_elements(cn::adj_f2p(m, merged.face)) == 2);
  keeps_all_laws(m), equals_rebuilt(m);

  cn::face_id top;
  for (const auto f : cn::faces(m)) {
    bool is_top = true;
    for (const auto x : cn::adj_f2v(m, f)) is_top = is_top && cn::point(m, x).z == 1;
    if (is_top) top = f;
  }
  const auto t = verts_of(m, top);
  const auto at_boundary = cn::face_cut(m, top, t[3], t[1]);
  REQUIRE(at_boundary);
  CHECK(raw_set(cn::adj_f2v(m, at_boundary.faces[0])) == std::set<unsigned>{t[3].raw(), t[0].raw(), t[1].raw()});
  CHECK(cn::total_measure(m) == doctest::Approx(1));
  REQUIRE(cn::face_merge(m, at_boundary.faces[1], at_boundary.faces[0]));
  CHECK(polys_by_faces(m) == start);
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("face_cut and face_merge: what is refused") {
  cn::polyhedralmesh m(extrude(quad_grid(1), 2));
  const auto wall = face_between(m, 0, 1);
  const auto v = verts_of(m, wall);
  is_refused(m, cn::refusal::wrong_set, [&](auto& x) -> cn::permission { return cn::face_cut(x, wall, v[0], v[1]); });
  is_refused(m, cn::refusal::wrong_set, [&](auto& x) -> cn::permission { return cn::face_cut(x, wall, v[0], v[0]); });
  is_refused(m, cn::refusal::wrong_set, [&](auto& x) -> cn::permission { return cn::face_cut(x, wall, v[0], cn::vert_id{v[2].raw() < 4 ? 11u : 0u}); });
  is_refused(m, cn::refusal::wrong_set, [&](auto& x) -> cn::permission { return cn::face_merge(x, wall, wall); });
  const auto other = *cn::adj_p2f(m, cn::poly_id{0}).begin();
  is_refused(m, cn::refusal::wrong_set, [&](auto& x) -> cn::permission { return cn::face_merge(x, wall, other); });
  CHECK_THROWS_WITH_AS(cn::face_cut(m, cn::face_id{99}, v[0], v[2]), "face_cut: face 99 is not a face of the mesh", cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::face_merge(m, wall, cn::face_id{99}), "face_merge: face 99 is not a face of the mesh", cn::invalid_mesh);
  const auto c = cn::face_cut(m, wall, v[0], v[2]);
  REQUIRE(c);
  is_refused(m, cn::refusal::wrong_set, [&](auto& x) -> cn::permission { return cn::face_cut(x, c.faces[0], v[0], v[2]); });

  // a tet: its faces cannot be merged, as two faces would have the same verts or three would be left
  cn::polyhedralmesh tet;
  std::vector<cn::vert_id> w;
  for (const cn::vec3& x : {cn::vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) w.push_back(cn::add_vert(tet, x));
  const auto a = cn::add_face(tet, {w[0], w[2], w[1]}), b = cn::add_face(tet, {w[0], w[1], w[3]}), d = cn::add_face(tet, {w[1], w[2], w[3]}), e = cn::add_face(tet, {w[0], w[3], w[2]});
  is_refused(tet, cn::refusal::loose_face, [&](auto& x) -> cn::permission { return cn::face_cut(x, a, w[0], w[1]); });
  is_refused(tet, cn::refusal::loose_face, [&](auto& x) -> cn::permission { return cn::edge_split(x, cn::edge_id{0}); });
  cn::add_poly(tet, {{a, true}, {b, true}, {d, true}, {e, true}});
  is_refused(tet, cn::refusal::degenerate, [&](auto& x) -> cn::permission { return cn::face_merge(x, a, b); });
  is_refused(tet, cn::refusal::wrong_number, [&](auto& x) -> cn::permission { return cn::edge_merge(x, w[0]); });
  is_refused(tet, cn::refusal::link_condition, [&](auto& x) -> cn::permission { return cn::edge_collapse(x, cn::edge_id{0}); });
}

TEST_CASE("face_merge: the chain of edges goes with the verts inside") {
  cn::polyhedralmesh m(extrude(quad_grid(1), 2));
  const auto start = polys_by_faces(m);
  const auto wall = face_between(m, 0, 1);
  const auto v = verts_of(m, wall);
  const auto c = cn::face_cut(m, wall, v[0], v[2]);
  REQUIRE(c);
  REQUIRE(cn::edge_split(m, c.edge));
  CHECK(cn::num_verts(m) == 13);
  keeps_all_laws(m), equals_rebuilt(m);
  cn::face_id f, g;
  for (const auto x : cn::faces(m))
    if (cn::num_elements(cn::adj_f2p(m, x)) == 2) (f.is_none() ? f : g) = x;
  REQUIRE(cn::face_merge(m, f, g));
  CHECK(cn::num_verts(m) == 12);
  CHECK(polys_by_faces(m) == start);
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("edge_split and edge_merge: polygons, with values") {
  cn::polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}, {3, 0, 0}, {3, 1, 0}}, {{0, 1, 2, 3}, {1, 4, 5, 2}});
  auto value = cn::vert_property<double>(m, "value");
  auto of_edge = cn::edge_property<double>(m, "edge");
  auto corner = cn::corner_property<double>(m, "corner");
  for (const auto v : cn::verts(m)) value[v] = 10 * v.raw();
  for (const auto e : cn::edges(m)) of_edge[e] = 1 + e.raw();
  for (const auto p : cn::polys(m))
    for (std::size_t i = 0; i < 4; ++i) corner.of(p)[i] = 100 * p.raw() + static_cast<double>(i);
  const auto e = edge_between_verts(m, 1, 2);
  const double before = of_edge[e];
  const auto start = polys_as_sets(m);
  const auto r = cn::edge_split(m, e, 0.25);
  REQUIRE(r);
  CHECK(cn::to_vec3(cn::point(m, r.vert)) == cn::vec3{2, 0.25, 0});
  CHECK(value[r.vert] == doctest::Approx(12.5));
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{0})) == std::vector<unsigned>{0, 1, 6, 2, 3});
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{1})) == std::vector<unsigned>{1, 4, 5, 2, 6});
  CHECK(corner.of(cn::poly_id{0})[2] == doctest::Approx(0.75 * 1 + 0.25 * 2));
  for (const auto x : cn::adj_v2e(m, r.vert)) CHECK(of_edge[x] == before);
  keeps_all_laws(m), equals_rebuilt(m);
  const auto back = cn::edge_merge(m, r.vert);
  REQUIRE(back);
  CHECK(polys_as_sets(m) == start);
  CHECK(of_edge[back.edge] == before);
  CHECK(corner.of(cn::poly_id{0})[2] == 2);
  keeps_all_laws(m), equals_rebuilt(m);
  is_refused(m, cn::refusal::wrong_number, [](auto& x) -> cn::permission { return cn::edge_merge(x, cn::vert_id{1}); });
  REQUIRE(cn::edge_merge(m, cn::vert_id{0}));  // a corner of the shape
  is_refused(m, cn::refusal::same_verts, [](auto& x) -> cn::permission { return cn::edge_merge(x, cn::vert_id{3}); });  // a triangle
  CHECK_THROWS_WITH_AS(cn::edge_merge(m, cn::vert_id{0}), "edge_merge: vert 0 is not a vert of the mesh", cn::invalid_mesh);
}

TEST_CASE("edge_split and edge_merge: an edge of four hexes, and back, at random edges, with undo") {
  cn::polyhedralmesh m(extrude(quad_grid(2), 2));
  const auto start = polys_by_faces(m);
  std::mt19937 random(1);
  for (unsigned i = 0; i < 60; ++i) {
    const auto e = some_edge(m, random);
    const std::size_t polys = cn::num_elements(cn::adj_e2p(m, e));
    const auto before = whole(m);
    {
      cn::transaction<cn::polyhedralmesh> t(m);
      REQUIRE(cn::edge_split(m, e));
    }
    CHECK(whole(m) == before);
    const auto r = cn::edge_split(m, e);
    REQUIRE(r);
    CHECK(cn::num_elements(cn::adj_v2p(m, r.vert)) == polys);
    CHECK(cn::total_measure(m) == doctest::Approx(1));
    if (i % 16 == 0) keeps_all_laws(m), equals_rebuilt(m);
    REQUIRE(cn::edge_merge(m, r.vert));
    CHECK(polys_by_faces(m) == start);
  }
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("edge_split: a polygon and a triangle at the edge, and an edge of three polygons") {
  cn::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -1, 0}, {0, -1, 0}, {0, 0, 1}, {1, 0, 1}}, {{0, 1, 2}, {1, 0, 4, 3}, {0, 1, 6, 5}});
  const auto r = cn::edge_split(m, edge_between_verts(m, 0, 1));
  REQUIRE(r);
  CHECK(cn::num_polys(m) == 3);
  CHECK(cn::num_elements(cn::adj_p2v(m, cn::poly_id{0})) == 4);
  CHECK(cn::num_elements(cn::adj_v2e(m, r.vert)) == 2);
  keeps_all_laws(m), equals_rebuilt(m);
  REQUIRE(cn::edge_merge(m, r.vert));
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("edge_collapse: polygons lose a corner, triangles vanish") {
  // a quad and a triangle at the edge 1 2
  cn::polygonmesh m({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {4, 1, 0}, {4, -1, 0}, {4, 3, 0}}, {{0, 1, 2, 3}, {1, 4, 2}, {1, 5, 4}, {2, 4, 6}});
  auto value = cn::vert_property<double>(m, "value");
  value[cn::vert_id{1}] = 1, value[cn::vert_id{2}] = 3;
  const auto e = edge_between_verts(m, 1, 2);
  is_refused(m, cn::refusal::link_condition, [&](auto& x) -> cn::permission { return cn::edge_collapse(x, e); });  // both ends are at the boundary
  const auto edge = edge_between_verts(m, 0, 1);
  const auto r = cn::edge_collapse(m, edge, {.at = 0.25, .keeps_second = true});
  REQUIRE(r);
  CHECK(r.vert == cn::vert_id{1});
  CHECK(cn::to_vec3(cn::point(m, r.vert)) == cn::vec3{0.5, 0, 0});
  CHECK(value[r.vert] == doctest::Approx(0.25));
  CHECK(raw(cn::adj_p2v(m, cn::poly_id{0})) == std::vector<unsigned>{1, 2, 3});
  keeps_all_laws(m), equals_rebuilt(m);
}

TEST_CASE("edge_collapse: what is refused of polygons") {
  const std::vector<cn::vec3> x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {0.5, 2, 0}, {0.5, -1, 0}};
  cn::polygonmesh one(x, lists{{0, 1, 2}});
  is_refused(one, cn::refusal::link_condition, [](auto& m) -> cn::permission { return cn::edge_collapse(m, cn::edge_id{0}); });
  cn::polygonmesh prism({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
  REQUIRE(cn::edge_collapse(prism, edge_between_verts(prism, 0, 3)));
  keeps_all_laws(prism);
  CHECK(cn::validate(prism).facts.euler_characteristic == 2);
  CHECK_THROWS_AS(cn::edge_collapse(prism, cn::edge_id{999}), cn::invalid_mesh);
}

TEST_CASE("edge_collapse: two polygons would share two verts that no edge joins") {
  // left and right of the edge 0 1 are two polygons that meet at vert 6 above
  cn::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {1, -1, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 3, 0}, {-2, 0, 0}, {3, 0, 0}},
                    {{2, 3, 1, 0}, {0, 1, 5, 4}, {7, 2, 0, 4, 6}, {1, 3, 8, 6, 5}});
  REQUIRE(cn::check_laws(m).empty());
  const auto e = edge_between_verts(m, 0, 1);
  const auto before = whole(m);
  const cn::permission p = cn::edge_collapse(m, e);
  CHECK(p.reason == cn::refusal::link_condition);
  CHECK(p.why == cn::can_edge_collapse(m, e).why);
  CHECK(p.why == "two polys would share more than one chain of edges or one disk of faces");
  CHECK(whole(m) == before);
}

TEST_CASE("edge_collapse: polyhedra") {
  cn::polyhedralmesh m(extrude(quad_grid(2), 2));
  const auto start = whole(m);
  // an edge inside: its four hexes become prisms
  cn::edge_id inside;
  for (const auto e : cn::edges(m))
    if (cn::num_elements(cn::adj_e2p(m, e)) == 4 && inside.is_none()) inside = e;
  const auto ends = cn::end_verts(m, inside);
  const bool first = cn::is_boundary(m, ends.first);
  const double volume = cn::total_measure(m);
  const auto at_edge = raw(cn::adj_e2p(m, inside));
  cn::transaction<cn::polyhedralmesh> t(m);
  const auto r = cn::edge_collapse(m, inside, {.at = first ? 0.0 : 1.0});
  REQUIRE(r);
  CHECK(cn::num_polys(m) == 8);
  for (const unsigned p : at_edge) CHECK(cn::num_elements(cn::adj_p2v(m, cn::poly_id{p})) == 7);
  CHECK(cn::total_measure(m) == doctest::Approx(volume));
  keeps_all_laws(m), equals_rebuilt(m);
  t.roll_back();
  CHECK(whole(m) == start);
}

TEST_CASE("edge_collapse: tets as polyhedra, as those of a tetmesh") {
  std::mt19937 random(5);
  const auto tets = grid<cn::tetmesh>(2);
  lists faces;
  cn::polyhedralmesh m;
  for (const auto v : cn::verts(tets)) cn::add_vert(m, cn::point(tets, v));
  std::vector<cn::face_id> number(cn::face_index_bound(tets));
  for (const auto f : cn::faces(tets)) {
    std::vector<cn::vert_id> v;
    for (const auto x : cn::adj_f2v(tets, f)) v.push_back(x);
    number[f.raw()] = cn::add_face(m, std::span<const cn::vert_id>(v));
  }
  for (const auto p : cn::polys(tets)) {
    std::vector<cn::face_id> its;
    std::vector<std::uint8_t> outward;
    for (const auto f : cn::adj_p2f(tets, p)) its.push_back(number[f.raw()]), outward.push_back(cn::face_is_outward(tets, p, f));
    cn::traits<cn::polyhedralmesh>::add_poly(m, std::span<const cn::face_id>(its), std::span<const std::uint8_t>(outward));
  }
  unsigned same = 0, both = 0;
  for (const auto e : cn::edges(tets)) {
    const auto ends = cn::end_verts(tets, e);
    const auto f = edge_between_verts(m, ends.first.raw(), ends.second.raw());
    cn::tetmesh a = tets;
    cn::polyhedralmesh b = m;
    const bool is_swapped = cn::end_verts(m, f).first != ends.first;
    const auto x = cn::edge_collapse(a, e, {.at = 0.0});
    const auto y = cn::edge_collapse(b, f, {.at = is_swapped ? 1.0 : 0.0, .keeps_second = is_swapped});
    CHECK(bool(x) == bool(y));
    same += bool(x) == bool(y);
    if (!x || !y) continue;
    ++both;
    CHECK(polys_as_sets(a) == polys_as_sets(b));
    CHECK(cn::num_faces(a) == cn::num_faces(b));
    if (both % 8 == 0) keeps_all_laws(b), equals_rebuilt(b);
  }
  CHECK(both > 5);
  MESSAGE(same << " of " << cn::num_edges(tets) << " edges agree, " << both << " are collapsed");
}
