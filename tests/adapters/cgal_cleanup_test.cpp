// CGAL::Surface_mesh: remove_unreferenced and garbage_collect.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/edit/garbage_collect.hpp>
#include <concino/edit/remove_unreferenced.hpp>

#include <support/cgal.hpp>
#include <support/kinds.hpp>
#include <support/rebuilt.hpp>

#include <CGAL/boost/graph/Euler_operations.h>

#include <doctest/doctest.h>

namespace cn = concino;
using cn::testing::keeps_all_laws;

TEST_CASE("CGAL::Surface_mesh: remove_unreferenced") {
  auto m = cn::testing::cgal_surface<cn::vec3>(cn::testing::two_grids_arrays<cn::trimesh>(2));
  const std::size_t n = cn::num_verts(m);
  const auto isolated = m.add_vertex();
  CHECK(cn::remove_unreferenced(m) == cn::removed_counts{2});
  CHECK_FALSE(cn::contains(m, isolated));
  CHECK(cn::num_verts(m) == n - 1);
  CHECK(m.is_valid(false));
  keeps_all_laws(m);
}

TEST_CASE("CGAL::Surface_mesh: garbage_collect") {
  auto m = cn::testing::cgal_surface<cn::vec3>(cn::testing::two_grids_arrays<cn::trimesh>(3));
  using mesh = decltype(m);
  using vert = cn::vert_t<mesh>;
  using edge = cn::edge_t<mesh>;
  using poly = cn::poly_t<mesh>;
  auto name = m.add_property_map<vert, std::string>("v:name").first;
  auto length = m.add_property_map<edge, double>("e:length").first;
  for (const vert v : cn::verts(m)) name[v] = "a long name of vert " + std::to_string(v.idx());
  for (const edge e : cn::edges(m)) length[e] = e.idx();
  for (const bool with_gaps : {false, true}) {
    if (with_gaps)
      for (unsigned p = 0; p < m.num_faces(); p += 4)
        if (!m.is_removed(poly(p))) CGAL::Euler::remove_face(m.halfedge(poly(p)), m);
    if (with_gaps) cn::remove_unreferenced(m);
    const mesh before = m;
    const auto old_name = before.property_map<vert, std::string>("v:name").first;
    const auto old_length = before.property_map<edge, double>("e:length").first;
    const auto map = cn::garbage_collect(m);
    CHECK_FALSE(m.has_garbage());
    CHECK(m.num_vertices() == cn::num_verts(before));
    CHECK(m.num_edges() == cn::num_edges(before));
    CHECK(m.num_faces() == cn::num_polys(before));
    CHECK(m.is_valid(false));
    keeps_all_laws(m);
    for (unsigned i = 0; i < before.num_vertices(); ++i) {
      REQUIRE(map[vert(i)].has_value() == cn::contains(before, vert(i)));
      if (!map[vert(i)]) continue;
      CHECK(m.point(*map[vert(i)]) == before.point(vert(i)));
      CHECK(name[*map[vert(i)]] == old_name[vert(i)]);
    }
    for (unsigned i = 0; i < before.num_edges(); ++i) {
      REQUIRE(map[edge(i)].has_value() == cn::contains(before, edge(i)));
      if (!map[edge(i)]) continue;
      CHECK(length[*map[edge(i)]] == old_length[edge(i)]);
      const auto old = cn::end_verts(before, edge(i)), now = cn::end_verts(m, *map[edge(i)]);
      CHECK((map[old.first] == now.first && map[old.second] == now.second));
    }
    for (unsigned i = 0; i < before.num_faces(); ++i) {
      REQUIRE(map[poly(i)].has_value() == cn::contains(before, poly(i)));
      if (!map[poly(i)]) continue;
      std::vector<vert> old, now;
      for (const vert v : cn::adj_p2v(before, poly(i))) old.push_back(*map[v]);
      for (const vert v : cn::adj_p2v(m, *map[poly(i)])) now.push_back(v);
      CHECK(old == now);
    }
  }
}
