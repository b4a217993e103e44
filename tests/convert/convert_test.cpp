// Converting to another kind of mesh and back preserves connectivity, coordinates and properties.
#include <concino/concepts/archetypes.hpp>
#include <concino/convert.hpp>
#include <concino/mesh.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/soups.hpp>

#include <doctest/doctest.h>

#include <set>
#include <string>

namespace cn = concino;

namespace {

template<class R>
std::vector<unsigned> raw(const R& range) {
  std::vector<unsigned> all;
  for (const auto x : range) all.push_back(x.raw());
  return all;
}
template<class R>
std::set<unsigned> raw_set(const R& range) {
  const auto all = raw(range);
  return {all.begin(), all.end()};
}

template<class A, class B>
void same_mesh(const A& a, const B& b) {
  REQUIRE(cn::num_verts(a) == cn::num_verts(b));
  REQUIRE(cn::num_edges(a) == cn::num_edges(b));
  REQUIRE(cn::num_polys(a) == cn::num_polys(b));
  for (const auto v : cn::verts(a)) {
    CHECK(cn::to_vec3(cn::point(a, v)) == cn::to_vec3(cn::point(b, v)));
    CHECK(raw_set(cn::adj_v2v(a, v)) == raw_set(cn::adj_v2v(b, v)));
  }
  for (const auto p : cn::polys(a)) {
    if constexpr (cn::SurfaceMesh<A>) CHECK(raw(cn::adj_p2v(a, p)) == raw(cn::adj_p2v(b, p)));
    else CHECK(raw_set(cn::adj_p2v(a, p)) == raw_set(cn::adj_p2v(b, p)));
    CHECK(raw_set(cn::adj_p2p(a, p)) == raw_set(cn::adj_p2p(b, p)));
  }
}

/// Checks that the correspondence maps the adjacent elements of every element to those of its counterpart.
template<class C>
void names_agree(const C& c) {
  const auto& m = c.from();
  for (const auto v : cn::verts(m)) {
    const cn::vec3 x = cn::to_vec3(cn::point(m, v)), y = cn::to_vec3(cn::point(c.mesh, c.vert_of(v)));
    CHECK(x == y);
  }
  const auto stand_ins = [&](const auto& range) {
    std::set<std::size_t> all;
    for (const auto v : range) all.insert(cn::index_of(c.mesh, c.vert_of(v)));
    return all;
  };
  const auto indices = [&](const auto& range) {
    std::set<std::size_t> all;
    for (const auto v : range) all.insert(cn::index_of(c.mesh, v));
    return all;
  };
  for (const auto e : cn::edges(m)) CHECK(stand_ins(cn::adj_e2v(m, e)) == indices(cn::adj_e2v(c.mesh, c.edge_of(e))));
  for (const auto p : cn::polys(m)) CHECK(stand_ins(cn::adj_p2v(m, p)) == indices(cn::adj_p2v(c.mesh, c.poly_of(p))));
  if constexpr (cn::VolumeMesh<decltype(c.mesh)>)
    for (const auto f : cn::faces(m)) CHECK(stand_ins(cn::adj_f2v(m, f)) == indices(cn::adj_f2v(c.mesh, c.face_of(f))));
}

template<class M>
using general_of = std::conditional_t<cn::VolumeMesh<M>, cn::polyhedralmesh, cn::polygonmesh>;

/// A user's mesh type, to which verts and polys are added one by one. It contains a mesh of this library.
struct added {
  cn::trimesh inner;
};

}  // namespace

template<>
struct concino::mesh_traits<added> : concino::indexed_surface<added> {
  static constexpr int arity = 3;
  static const auto& tables(const added& m) { return m.inner.tables(); }
  static const vec3& point(const added& m, vert_id v) { return concino::point(m.inner, v); }
  static vert_id add_vert(added& m, const vec3& x) { return concino::add_vert(m.inner, x); }
  static poly_id add_poly(added& m, std::span<const vert_id> corners) {
    if (corners[0] == vert_id{13}) throw invalid_mesh("a poly cannot begin with vert 13");
    return concino::add_poly(m.inner, corners);
  }
};

TEST_CASE_TEMPLATE("convert: any soup converts to the general kind and back unchanged", M, CONCINO_KINDS) {
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round) {
    const M m = cn::testing::random_soup<M>(random, 8 + static_cast<unsigned>(random() % 12), 1 + static_cast<unsigned>(random() % 20)).mesh();
    const auto there = cn::convert_with_correspondence<general_of<M>>(m);
    names_agree(there);
    if constexpr (cn::HexMesh<M>) continue;  // faces alone do not determine the hexes of a soup
    const auto back = cn::convert_with_correspondence<M>(there.mesh);
    names_agree(back);
    same_mesh(m, back.mesh);
  }
}

TEST_CASE_TEMPLATE("convert: grids convert to the general kind and back with all their properties", M, CONCINO_KINDS) {
  M m = cn::testing::grid<M>(3);
  auto heat = cn::vert_property<double>(m, "heat");
  for (const auto v : cn::verts(m)) heat[v] = 0.5 + v.raw();
  auto crease = cn::edge_property<int>(m, "crease");
  for (const auto e : cn::edges(m)) crease[e] = static_cast<int>(e.raw());
  auto name = cn::poly_property<std::string>(m, "name");
  for (const auto p : cn::polys(m)) name[p] = "poly number " + std::to_string(p.raw());
  if constexpr (cn::VolumeMesh<M>) {
    auto wall = cn::face_property<float>(m, "wall");
    for (const auto f : cn::faces(m)) wall[f] = static_cast<float>(f.raw());
  }
  *cn::mesh_property<std::string>(m, "title") = "a grid";
  const auto there = cn::convert_with_correspondence<general_of<M>>(m);
  const auto back = cn::convert_with_correspondence<M>(there.mesh);
  same_mesh(m, back.mesh);
  CHECK(cn::property_list(back.mesh).size() == cn::property_list(m).size());
  for (const auto v : cn::verts(m)) CHECK(cn::find_vert_property<double>(back.mesh, "heat")[back.vert_of(there.vert_of(v))] == heat[v]);
  for (const auto e : cn::edges(m)) CHECK(cn::find_edge_property<int>(back.mesh, "crease")[back.edge_of(there.edge_of(e))] == crease[e]);
  for (const auto p : cn::polys(m)) CHECK(cn::find_poly_property<std::string>(back.mesh, "name")[back.poly_of(there.poly_of(p))] == name[p]);
  if constexpr (cn::VolumeMesh<M>)
    for (const auto f : cn::faces(m))
      CHECK(cn::find_face_property<float>(back.mesh, "wall")[back.face_of(there.face_of(f))] == cn::find_face_property<float>(m, "wall")[f]);
  CHECK(*cn::find_mesh_property<std::string>(back.mesh, "title") == "a grid");
  CHECK(cn::property_list(cn::convert<general_of<M>>(m, {.properties = false})).empty());
}

TEST_CASE_TEMPLATE("convert: the new mesh has no gaps for deleted elements", M, CONCINO_KINDS) {
  M m = cn::testing::grid<M>(3);
  cn::remove_poly(m, cn::poly_id{1});
  cn::remove_vert(m, *cn::verts(m).begin());
  auto age = cn::vert_property<int>(m, "age");
  for (const auto v : cn::verts(m)) age[v] = static_cast<int>(v.raw());
  const auto c = cn::convert_with_correspondence<M>(m);
  names_agree(c);
  CHECK(cn::vert_index_bound(c.mesh) == cn::num_verts(m));
  CHECK(cn::poly_index_bound(c.mesh) == cn::num_polys(m));
  for (const auto v : cn::verts(m)) CHECK(cn::find_vert_property<int>(c.mesh, "age")[c.vert_of(v)] == age[v]);
  for (const auto& b : cn::check_laws(c.mesh)) FAIL_CHECK(b.law << ": " << b.what);
}

TEST_CASE("convert: the error names the poly that the new mesh cannot hold") {
  const cn::polygonmesh mixed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 2, 3}, {1, 4, 2}});
  CHECK_THROWS_WITH_AS(cn::convert<cn::trimesh>(mixed), doctest::Contains("poly 0 has 4 verts"), cn::unsupported);
  CHECK_THROWS_WITH_AS(cn::convert<cn::quadmesh>(mixed), doctest::Contains("poly 1 has 3 verts"), cn::unsupported);
  const auto hexes = cn::testing::grid<cn::hexmesh>(2);
  CHECK_THROWS_WITH_AS(cn::convert<cn::tetmesh>(hexes), doctest::Contains("poly 0 is a hex of 6 faces"), cn::unsupported);
  cn::trimesh grid = cn::testing::grid<cn::trimesh>(4);
  CHECK_THROWS_WITH_AS(cn::convert<added>(grid), doctest::Contains("a poly cannot begin with vert 13"), cn::unsupported);
}

TEST_CASE("convert: a mesh type without arrays is built by adding verts and polys") {
  cn::trimesh m = cn::testing::grid<cn::trimesh>(2);
  cn::vert_property<int>(m, "lost");
  cn::convert_report report;
  const auto c = cn::convert_with_correspondence<added>(m, {.report = &report});
  names_agree(c);
  same_mesh(m, c.mesh.inner);
  REQUIRE(report.lost.size() == 1);
  CHECK(report.lost[0].find("vert property \"lost\"") != std::string::npos);
  const auto back = cn::convert_with_correspondence<cn::trimesh>(c.mesh);
  same_mesh(m, back.mesh);
}

TEST_CASE("convert: transfer copies the values of maps") {
  const auto m = cn::testing::grid<cn::tetmesh>(2);
  const auto c = cn::convert_with_correspondence<cn::polyhedralmesh>(m);
  auto from = cn::make_poly_map<int>(m);
  auto to = cn::make_poly_map<int>(c.mesh, -1);
  for (const auto p : cn::polys(m)) from[p] = static_cast<int>(p.raw());
  c.transfer(from, to);
  for (const auto p : cn::polys(m)) CHECK(to[c.poly_of(p)] == from[p]);
  auto walls = cn::make_face_map<int>(m);
  auto taken = cn::make_face_map<int>(c.mesh, -1);
  for (const auto f : cn::faces(m)) walls[f] = static_cast<int>(f.raw());
  c.transfer(walls, taken);
  for (const auto f : cn::faces(m)) CHECK(taken[c.face_of(f)] == walls[f]);
}

TEST_CASE("convert: the boundary of a volume, a view, becomes a surface") {
  const auto m = cn::testing::grid<cn::hexmesh>(2);
  const auto c = cn::convert_with_correspondence<cn::quadmesh>(cn::boundary(m));
  CHECK(cn::num_polys(c.mesh) == 24);
  CHECK(cn::num_verts(c.mesh) == 26);
  names_agree(c);
}

TEST_CASE("convert: progress is reported, and can cancel") {
  const auto m = cn::testing::grid<cn::trimesh>(2);
  double last = -1;
  cn::convert<cn::polygonmesh>(m, {.progress = [&](double fraction, const char*) {
                                 CHECK(fraction >= last);
                                 last = fraction;
                                 return true;
                               }});
  CHECK(last == 1);
  CHECK_THROWS_AS(cn::convert<cn::polygonmesh>(m, {.progress = [](double, const char*) { return false; }}), cn::cancelled);
}

TEST_CASE("convert: empty meshes convert to empty meshes") {
  const cn::tetmesh none;
  CHECK(cn::num_polys(cn::convert<cn::polyhedralmesh>(none)) == 0);
  const cn::polyhedralmesh one_vert(cn::point_list{{1, 2, 3}}, cn::index_lists{}, cn::face_lists{});
  CHECK(cn::num_verts(cn::convert<cn::tetmesh>(one_vert)) == 1);
}

template<class M> concept can_convert = requires(M&& m) { cn::convert<cn::polygonmesh>(static_cast<M&&>(m)); };
TEST_CASE_TEMPLATE("convert: the correspondence maps each new element to its original", M, CONCINO_KINDS) {
  M m = cn::testing::grid<M>(2);
  cn::remove_poly(m, cn::poly_id{0});
  const auto there = cn::convert_with_correspondence<general_of<M>>(m);
  const cn::correspondence c = there.correspondence();
  CHECK(c.verts.size() == cn::vert_index_bound(there.mesh));
  CHECK(c.edges.size() == cn::edge_index_bound(there.mesh));
  CHECK(c.polys.size() == cn::poly_index_bound(there.mesh));
  for (const auto v : cn::verts(m)) CHECK(c.verts.only(there.vert_of(v).raw()) == v.raw());
  for (const auto e : cn::edges(m)) CHECK(c.edges.only(there.edge_of(e).raw()) == e.raw());
  for (const auto p : cn::polys(m)) CHECK(c.polys.only(there.poly_of(p).raw()) == p.raw());
  if constexpr (cn::VolumeMesh<M>) {
    CHECK(c.faces.size() == cn::face_index_bound(there.mesh));
    for (const auto f : cn::faces(m)) CHECK(c.faces.only(there.face_of(f).raw()) == f.raw());
  }
  // Edges and faces follow from the verts.
  cn::correspondence from_verts{c.verts, {}, {}, c.polys};
  cn::match_edges_and_faces(m, there.mesh, from_verts);
  for (std::size_t i = 0; i < c.edges.size(); ++i) CHECK(from_verts.edges.only(i) == c.edges.only(i));
  for (std::size_t i = 0; i < c.faces.size(); ++i) CHECK(from_verts.faces.only(i) == c.faces.only(i));
}

TEST_CASE_TEMPLATE("convert: submeshes and meshes with other points keep their properties", M, CONCINO_KINDS) {
  M m = cn::testing::grid<M>(3);
  const auto u = cn::vert_property<double>(m, "u");
  const auto e = cn::edge_property<int>(m, "e");
  const auto p = cn::poly_property<std::string>(m, "p");
  cn::set_property_rule(m, cn::element_kind::vert, "u", cn::property_rule::sum);
  for (const auto v : cn::verts(m)) u[v] = 0.25 * v.raw();
  for (const auto x : cn::edges(m)) e[x] = static_cast<int>(x.raw());
  for (const auto x : cn::polys(m)) p[x] = std::to_string(x.raw());
  const auto part = cn::submesh(m, [](const cn::poly_id x) { return x.raw() % 3 == 1; });
  static_assert(cn::ShowsProperties<decltype(part)> && !cn::HasProperties<decltype(part)>);
  static_assert(!cn::ShowsProperties<decltype(cn::submesh(cn::only_mesh(m), [](const auto&) { return true; }))>);
  CHECK(cn::find_vert_property<double>(part, "u")[cn::vert_id{1}] == 0.25);
  const auto c = cn::convert_with_correspondence<M>(part);
  CHECK(cn::property_list(c.mesh).size() == 3);
  CHECK(cn::property_list(c.mesh)[0].rule == cn::property_rule::sum);
  for (const auto v : cn::verts(part)) CHECK(cn::find_vert_property<double>(c.mesh, "u")[c.vert_of(v)] == u[v]);
  for (const auto x : cn::edges(part)) CHECK(cn::find_edge_property<int>(c.mesh, "e")[c.edge_of(x)] == e[x]);
  for (const auto x : cn::polys(part)) CHECK(cn::find_poly_property<std::string>(c.mesh, "p")[c.poly_of(x)] == p[x]);

  const auto places = cn::make_vert_map<cn::vec3>(m, cn::vec3{1, 2, 3});
  const auto moved = cn::with_points(m, places);
  static_assert(cn::ShowsProperties<decltype(moved)>);
  CHECK(cn::property_list(cn::convert<M>(moved)).size() == 3);
}

template<class M> concept can_correspond = requires(M&& m) { cn::convert_with_correspondence<cn::polygonmesh>(static_cast<M&&>(m)); };

TEST_CASE("convert: accepts temporaries; only the correspondence needs an lvalue") {
  const cn::trimesh m(std::vector<cn::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}});
  const cn::polygonmesh polygons = cn::convert<cn::polygonmesh>(m);
  CHECK(cn::num_polys(polygons) == 2);
  CHECK(cn::num_edges(cn::convert<cn::trimesh>(cn::convert<cn::polygonmesh>(m))) == 5);
  const auto c = cn::convert_with_correspondence<cn::polygonmesh>(m);
  CHECK(c.poly_of(cn::poly_id{1}) == cn::poly_id{1});
  static_assert(can_convert<cn::trimesh> && can_convert<const cn::trimesh&>);
  static_assert(!can_correspond<cn::trimesh> && can_correspond<const cn::trimesh&>);
}
