#include <concino/generate/agglomerate.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/mesh/element_map.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

/// Labels of the halves or quarters of the unit square or cube, by the mean point of each poly.
template<class M>
poly_map<M, int> quarters(const M& m) {
  auto labels = make_poly_map<int>(m, 0);
  for (const poly_t<M> p : polys(m)) {
    vec3 sum;
    double n = 0;
    for (const vert_t<M> v : adj_p2v(m, p)) sum += to_vec3(point(m, v)), n += 1;
    labels[p] = 10 * (sum.x > n / 2) - (sum.y > n / 2);
  }
  return labels;
}

/// The label 0 for all polys except `others`.
template<class M, class... P>
poly_map<M, short> all_but(const M& m, P... others) {
  auto labels = make_poly_map<short>(m, 0);
  short next = 1;
  ((labels[poly_id{others}] = next++), ...);
  return labels;
}

}  // namespace

TEST_CASE_TEMPLATE("agglomerate: transfers properties and returns the correspondence", M, CONCINO_KINDS) {
  M m = make_grid<M>({.cells = {4, 4, 4}});
  jitter(m, 0.1);
  const auto labels = quarters(m);
  const auto density = poly_property<double>(m, "density");
  const auto mass = poly_property<double>(m, "mass");
  const auto cells = poly_property<int>(m, "cells");
  const auto name = poly_property<int>(m, "name");
  const auto place = vert_property<vec3>(m, "place");
  const auto crease = edge_property<int>(m, "crease");
  set_property_rule(m, element_kind::poly, "mass", property_rule::sum);
  set_property_rule(m, element_kind::poly, "cells", property_rule::sum);
  for (const poly_t<M> p : polys(m)) {
    density[p] = 1 + p.raw() % 7;
    mass[p] = density[p] * measure(m, p);
    cells[p] = 1;
    name[p] = labels[p];
  }
  for (const vert_t<M> v : verts(m)) place[v] = to_vec3(point(m, v));
  for (const edge_t<M> e : edges(m)) crease[e] = 1 + static_cast<int>(e.raw());
  if constexpr (VolumeMesh<M>) {
    const auto wall = face_property<vec3>(m, "wall");
    for (const face_t<M> f : faces(m)) wall[f] = centroid(m, f);
  }
  correspondence c;
  const auto a = agglomerate(m, labels, {.correspondence = &c});
  CHECK(property_list(a).size() == property_list(m).size());
  const auto new_density = find_poly_property<double>(a, "density");
  const auto new_mass = find_poly_property<double>(a, "mass");
  const auto new_cells = find_poly_property<int>(a, "cells");
  int all_cells = 0;
  for (const poly_id p : polys(a)) {
    CHECK(new_density[p] * measure(a, p) == doctest::Approx(new_mass[p]).epsilon(1e-12));
    CHECK(static_cast<int>(c.polys[p.raw()].size()) == new_cells[p]);
    all_cells += new_cells[p];
    for (const origin x : c.polys[p.raw()]) {
      CHECK(labels[poly_id{x.index}] == (find_poly_property<int>(a, "name")[p]));
      CHECK(x.weight == doctest::Approx(measure(m, poly_id{x.index})).epsilon(1e-14));
    }
  }
  CHECK(all_cells == static_cast<int>(num_polys(m)));
  for (const vert_id v : verts(a)) CHECK(find_vert_property<vec3>(a, "place")[v] == to_vec3(point(a, v)));
  for (const edge_id e : edges(a)) {
    const int construct_from_arrays = find_edge_property<int>(a, "crease")[e] - 1;
    REQUIRE(construct_from_arrays >= 0);
    CHECK(c.edges.only(e.raw()) == static_cast<unsigned>(construct_from_arrays));
    const edge_id before{static_cast<unsigned>(construct_from_arrays)};
    CHECK(edge_length(a, e) == edge_length(m, before));
  }
  if constexpr (VolumeMesh<M>)
    for (const face_id f : faces(a)) CHECK(norm(find_face_property<vec3>(a, "wall")[f] - centroid(a, f)) < 1e-12);

  CHECK(property_list(agglomerate(m, labels, {.properties = false})).empty());
  // The mesh without properties, as an archetype.
  const auto bare = only_embedded_mesh(m);
  auto bare_labels = make_poly_map<long>(bare, 0);
  for (const auto p : polys(bare)) bare_labels[p] = labels[bare.base(p)];
  correspondence of_bare;
  const auto b = agglomerate(bare, bare_labels, {.correspondence = &of_bare});
  CHECK(property_list(b).empty());
  CHECK(of_bare.verts.size() == c.verts.size());
  for (std::size_t i = 0; i < c.verts.size(); ++i) CHECK(of_bare.verts.only(i) == c.verts.only(i));
  for (std::size_t i = 0; i < c.edges.size(); ++i) CHECK(of_bare.edges.only(i) == c.edges.only(i));
  for (std::size_t i = 0; i < c.faces.size(); ++i) CHECK(of_bare.faces.only(i) == c.faces.only(i));
}

TEST_CASE_TEMPLATE("agglomerate: merges a jittered grid into four quarters", M, CONCINO_KINDS) {
  M m = make_grid<M>({.cells = {4, 4, 4}});
  jitter(m, 0.1);
  const auto labels = quarters(m);
  const auto a = agglomerate(m, labels);
  check_sound(a, 1);
  CHECK(num_polys(a) == 4);
  CHECK(total_measure(a) == doctest::Approx(1).epsilon(1e-13));
  double part[4] = {};
  for (const poly_t<M> p : polys(m)) part[labels[p] == -1 ? 0 : labels[p] == 0 ? 1 : labels[p] == 9 ? 2 : 3] += measure(m, p);
  for (const poly_id p : polys(a)) CHECK(measure(a, p) == doctest::Approx(part[p.raw()]).epsilon(1e-12));
  // The archetype has the same result.
  const auto bare = only_embedded_mesh(m);
  auto bare_labels = make_poly_map<long>(bare, 0);
  for (const auto p : polys(bare)) bare_labels[p] = labels[bare.base(p)];
  const auto b = agglomerate(bare, bare_labels);
  CHECK(num_verts(b) == num_verts(a));
  CHECK(num_edges(b) == num_edges(a));
  for (const vert_id v : verts(a)) CHECK(point(b, v) == point(a, v));
}

TEST_CASE_TEMPLATE("agglomerate: different labels keep the mesh, one label gives its boundary", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {3, 3, 3}});
  auto labels = make_poly_map<unsigned>(m, 7u);
  const auto one = agglomerate(m, labels);
  CHECK(num_polys(one) == 1);
  CHECK(total_measure(one) == doctest::Approx(1).epsilon(1e-14));
  for (const poly_t<M> p : polys(m)) labels[p] = static_cast<unsigned>(index_of(m, p));
  const auto same = agglomerate(m, labels);
  check_sound(same, 1);
  CHECK(num_verts(same) == num_verts(m));
  CHECK(num_edges(same) == num_edges(m));
  for (const poly_t<M> p : polys(m)) CHECK(measure(same, poly_id{index_of(m, p)}) == doctest::Approx(measure(m, p)).epsilon(1e-14));
  CHECK(num_polys(agglomerate(M(), make_poly_map<int>(m, 0))) == 0);
}

TEST_CASE("agglomerate: drops interior verts and keeps flat corners") {
  const auto m = make_grid<quadmesh>({.cells = {4, 2}});
  const auto a = agglomerate(m, quarters(m));
  CHECK(num_polys(a) == 4);
  CHECK(num_verts(a) == 15);
  auto halves = make_poly_map<bool>(m, false);
  for (const poly_id p : polys(m)) halves[p] = p.raw() % 4 > 1;
  const auto h = agglomerate(m, halves);
  CHECK(num_verts(h) == 13);
  CHECK(adj_p2v(h, poly_id{0}).size() == 8);
}

TEST_CASE("agglomerate: works on a user's mesh") {
  const user_mesh::surface s = user_mesh::surface_example();
  auto labels = make_poly_map<int>(s, 1);
  const auto a = agglomerate(s, labels);
  CHECK(num_polys(a) == 1);
  CHECK(num_verts(a) == 7);
  const user_mesh::volume w = user_mesh::volume_example();
  const auto b = agglomerate(w, make_poly_map<int>(w, 1));
  CHECK(num_polys(b) == 1);
  CHECK(num_faces(b) == 9);
  CHECK(total_measure(b) == doctest::Approx(4.0 / 3));
}

TEST_CASE("agglomerate: throws if the polys of a label are not a disk") {
  const auto m = make_grid<quadmesh>({.cells = {4, 4}});
  CHECK_THROWS_WITH_AS(agglomerate(m, all_but(m, 5)),
                       "agglomerate: the polys with label 0, poly 0 among them, do not form a disk: they have more than one boundary; random_labels() gives labels "
                       "that can be merged",
                       invalid_mesh);
  CHECK_THROWS_WITH_AS(agglomerate(m, all_but(m, 1, 4, 5)), doctest::Contains("they are not connected across edges"), invalid_mesh);
  CHECK_THROWS_WITH_AS(agglomerate(m, all_but(m, 5, 10)), doctest::Contains("their boundary passes twice through vert 12"), invalid_mesh);
  const quadmesh closed({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                        {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  CHECK_THROWS_WITH_AS(agglomerate(closed, all_but(closed)), doctest::Contains("they have no boundary"), invalid_mesh);
  CHECK(num_polys(agglomerate(closed, all_but(closed, 0))) == 2);
  const trimesh turned({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}});
  CHECK_THROWS_WITH_AS(agglomerate(turned, all_but(turned)), doctest::Contains("two of them run in the same direction along edge"), invalid_mesh);
  const trimesh book({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  CHECK_THROWS_WITH_AS(agglomerate(book, all_but(book)), doctest::Contains("more than two of them meet at edge 0"), invalid_mesh);
  // A torus without one quad has one border, and a handle.
  surface_arrays t{{}, {}, {}, 4};
  for (unsigned j = 0; j < 4; ++j)
    for (unsigned i = 0; i < 4; ++i) {
      t.points.push_back({i, j, i * j});
      for (const unsigned v : {4 * j + i, 4 * j + (i + 1) % 4, (j + 1) % 4 * 4 + (i + 1) % 4, (j + 1) % 4 * 4 + i}) t.verts.push_back(vert_id{v});
    }
  const quadmesh torus(t);
  CHECK_THROWS_WITH_AS(agglomerate(torus, all_but(torus, 5)), doctest::Contains("they have a handle"), invalid_mesh);
}

TEST_CASE_TEMPLATE("agglomerate: throws if the polys of a label are not a ball", M, hexmesh, polyhedralmesh) {
  const M m = make_grid<M>({.cells = {3, 3, 3}});
  CHECK_THROWS_WITH_AS(agglomerate(m, all_but(m, 13)), doctest::Contains("do not form a ball: they have more than one boundary"), invalid_mesh);
  CHECK_THROWS_WITH_AS(agglomerate(m, all_but(m, 4, 13, 22)), doctest::Contains("they have a handle"), invalid_mesh);
  CHECK_THROWS_WITH_AS(agglomerate(m, all_but(m, 1, 3, 9)), doctest::Contains("they are not connected across faces"), invalid_mesh);
  CHECK_THROWS_WITH_AS(agglomerate(m, all_but(m, 0, 4)), doctest::Contains("their boundary passes twice through edge"), invalid_mesh);
  const M eight = make_grid<M>({.cells = {2, 2, 2}});  // the other six cells surround two opposite ones, which touch in the middle vert
  CHECK_THROWS_WITH_AS(agglomerate(eight, all_but(eight, 0, 7)), doctest::Contains("their boundary touches itself at a vert"), invalid_mesh);
  CHECK(num_polys(agglomerate(m, all_but(m, 4))) == 2);
}

TEST_CASE("agglomerate: throws if polyhedra are not conforming") {
  auto arrays = polyhedra_grid(1);
  arrays.outward.back() = !arrays.outward.back();
  const polyhedralmesh wrong(arrays);
  const auto labels = all_but(wrong);
  CHECK_THROWS_AS(agglomerate(wrong, labels), invalid_mesh);
  const tetmesh crowd({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, -1}}, {{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 2, 1, 5}});
  CHECK_THROWS_WITH_AS(agglomerate(crowd, all_but(crowd)), doctest::Contains("more than two of them meet at face"), invalid_mesh);
}
