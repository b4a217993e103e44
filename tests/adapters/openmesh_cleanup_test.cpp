// OpenMesh: remove_unreferenced and garbage_collect.
#include <concino/concepts/end_verts.hpp>
#include <concino/edit/garbage_collect.hpp>
#include <concino/edit/remove_unreferenced.hpp>

#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;
namespace om = concino::testing::om;

TEST_CASE_TEMPLATE("OpenMesh: remove_unreferenced", M, CONCINO_FIRST_OF(om::tri_float, om::tri_status, om::poly_double)) {
  M m;
  om::fill(m, om::two_grids<M>(2));
  const std::size_t n = cn::num_verts(m), edges = cn::num_edges(m);
  CHECK(cn::remove_unreferenced(m) == cn::removed_counts{1});
  CHECK(cn::num_verts(m) == n - 1);
  CHECK(cn::num_edges(m) == edges);
  om::check_laws_hold(m);
  const std::vector<OpenMesh::FaceHandle> all(cn::polys(m).begin(), cn::polys(m).end());
  for (const auto p : all) cn::remove_poly(m, p);
  CHECK(cn::remove_unreferenced(m) == cn::removed_counts{n - 1});
  CHECK(cn::num_verts(m) == 0);
  om::check_laws_hold(m);
}

TEST_CASE_TEMPLATE("OpenMesh: garbage_collect", M, CONCINO_FIRST_OF(om::tri_float, om::tri_status, om::poly_double, om::mine)) {
  M m;
  om::fill(m, om::two_grids<M>(3));
  OpenMesh::VPropHandleT<int> of_vert;
  OpenMesh::EPropHandleT<std::string> of_edge;
  m.add_property(of_vert), m.add_property(of_edge);
  for (const auto v : cn::verts(m)) m.property(of_vert, v) = v.idx();
  for (const auto e : cn::edges(m)) m.property(of_edge, e) = "a long name of edge " + std::to_string(e.idx());
  for (const bool with_gaps : {false, true}) {
    if (with_gaps) {
      for (int p = 0; p < static_cast<int>(m.n_faces()); p += 3) cn::remove_poly(m, OpenMesh::FaceHandle(p));
      cn::remove_vert(m, OpenMesh::VertexHandle(5));
      cn::remove_unreferenced(m);
    }
    const M before = m;
    const auto map = cn::garbage_collect(m);
    CHECK(m.n_vertices() == cn::num_verts(before));
    CHECK(m.n_edges() == cn::num_edges(before));
    CHECK(m.n_faces() == cn::num_polys(before));
    om::check_laws_hold(m);
    om::check_rings(m);
    for (int i = 0; i < static_cast<int>(before.n_vertices()); ++i) {
      const OpenMesh::VertexHandle v(i);
      REQUIRE(map[v].has_value() == cn::contains(before, v));
      if (!map[v]) continue;
      CHECK(m.point(*map[v]) == before.point(v));
      CHECK(m.property(of_vert, *map[v]) == before.property(of_vert, v));
    }
    for (int i = 0; i < static_cast<int>(before.n_edges()); ++i) {
      const OpenMesh::EdgeHandle e(i);
      REQUIRE(map[e].has_value() == cn::contains(before, e));
      if (!map[e]) continue;
      CHECK(m.property(of_edge, *map[e]) == before.property(of_edge, e));
      const auto old = cn::end_verts(before, e), now = cn::end_verts(m, *map[e]);
      CHECK((map[old.first] == now.first && map[old.second] == now.second));
    }
    for (int i = 0; i < static_cast<int>(before.n_faces()); ++i) {
      const OpenMesh::FaceHandle p(i);
      REQUIRE(map[p].has_value() == cn::contains(before, p));
      if (!map[p]) continue;
      std::vector<OpenMesh::VertexHandle> old, now;
      for (const auto v : cn::adj_p2v(before, p)) old.push_back(*map[v]);
      for (const auto v : cn::adj_p2v(m, *map[p])) now.push_back(v);
      CHECK(old == now);
    }
    if (!with_gaps) CHECK(map[OpenMesh::VertexHandle(5)] == OpenMesh::VertexHandle(5));
  }
  for (const auto p : std::vector<OpenMesh::FaceHandle>(cn::polys(m).begin(), cn::polys(m).end())) cn::remove_poly(m, p);
  cn::remove_unreferenced(m);
  cn::garbage_collect(m);
  CHECK(m.n_vertices() + m.n_edges() + m.n_faces() == 0);
  CHECK(cn::garbage_collect(m)[OpenMesh::VertexHandle(0)] == std::nullopt);
}
