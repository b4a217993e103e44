#include <concino/graph/cut_along.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/graph/boundary_loops.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/closed_surfaces.hpp>
#include <support/disk.hpp>
#include <support/random_meshes.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <random>
#include <set>

using namespace concino;
using namespace concino::testing;

namespace {

/// Checks that the polys are the same, with the same points.
template<class M>
void check_same_polys(const M& m, const cut_along_result<M>& cut) {
  const polygonmesh c(cut.surface);
  REQUIRE(num_polys(c) == num_polys(m));
  REQUIRE(cut.verts.size() == num_verts(c));
  REQUIRE(cut.polys.size() == num_polys(c));
  for (const auto v : verts(c)) CHECK(norm(to_vec3(point(c, v)) - to_vec3(point(m, cut.verts[v.raw()]))) == 0);
  std::size_t n = 0;
  for (const auto v : verts(m)) CHECK(cut.verts[n++] == v);
  for (const auto p : polys(c)) {
    auto it = adj_p2v(c, p).begin();
    for (const auto v : adj_p2v(m, cut.polys[p.raw()])) {
      REQUIRE(cut.verts[(*it).raw()] == v);
      ++it;
    }
  }
}

template<class M>
edge_t<M> edge_between(const M& m, unsigned a, unsigned b) {
  for (const auto e : edges(m)) {
    unsigned found = 0;
    for (const auto v : adj_e2v(m, e)) found += index_of(m, v) == a || index_of(m, v) == b;
    if (found == 2) return e;
  }
  return {};
}

}  // namespace

TEST_CASE("cut_along: a cut may divide a grid, begin at its boundary, or be interior") {
  const quadmesh m = grid<quadmesh>(4);  // vert (i, j) is number 5 j + i
  const auto cut = [&](unsigned edges_of_way) {
    std::vector<edge_id> way;
    for (unsigned j = 0; j < edges_of_way; ++j) way.push_back(edge_between(m, 5 * j + 2, 5 * j + 7));
    const auto r = cut_along(m, way);
    check_same_polys(m, r);
    return quadmesh(r.surface);
  };
  CHECK(num_verts(cut(0)) == 25);
  CHECK(num_verts(cut(1)) == 26);
  CHECK(num_verts(cut(3)) == 28);
  CHECK(topology_of(cut(3)).pieces == 1);
  CHECK(num_verts(cut(4)) == 30);
  CHECK(topology_of(cut(4)).pieces == 2);
  CHECK(topology_of(cut(4)).chi == 2);

  const auto slit = cut_along(m, {edge_between(m, 7, 12), edge_between(m, 12, 17)});
  CHECK(slit.verts.size() == 26);
  CHECK(slit.verts.back() == vert_id{12});
  CHECK(boundary_loops(quadmesh(slit.surface)).count == 2);
  CHECK(cut_along(m, {edge_between(m, 7, 12)}).verts.size() == 25);  // both ends are interior, so the cut does not open
  CHECK(cut_along(m, {edge_between(m, 0, 1)}).verts.size() == 25);   // the edge is on the boundary already
}

TEST_CASE_TEMPLATE("cut_along: cutting all edges separates all polys", M, CONCINO_SURFACE_KINDS) {
  for (const M& m : {two_grids<M>(2), from_quads<M>(rolled_grid(4, 3, true)), from_quads<M>(holed_board(2)), M()}) {
    std::vector<edge_id> all;
    for (const auto e : edges(m)) all.push_back(e);
    const auto cut = cut_along(m, all);
    check_same_polys(m, cut);
    CHECK(cut.surface.arity == static_cast<unsigned>(arity_v<M>));
    const auto shape = topology_of(M(cut.surface));
    CHECK(shape.pieces == static_cast<int>(num_polys(m)));
    CHECK(shape.chi == static_cast<int>(num_polys(m)));
  }
}

TEST_CASE_TEMPLATE("cut_along: transfers properties by the correspondence", M, CONCINO_SURFACE_KINDS) {
  M m = grid<M>(4);
  const auto u = vert_property<double>(m, "u");
  const auto crease = edge_property<int>(m, "crease");
  const auto label = poly_property<int>(m, "label");
  const auto charge = vert_property<double>(m, "charge");
  set_property_rule(m, element_kind::vert, "charge", property_rule::sum);
  double total = 0;
  for (const auto v : verts(m)) u[v] = v.raw(), total += charge[v] = 1 + v.raw();
  for (const auto e : edges(m)) crease[e] = 1 + static_cast<int>(e.raw());
  for (const auto p : polys(m)) label[p] = static_cast<int>(p.raw());
  std::vector<edge_id> some;
  for (const auto e : edges(m))
    if (e.raw() % 3 == 0) some.push_back(e);
  const auto cut = cut_along(m, some);
  CHECK(cut.verts.size() > num_verts(m));
  M c(cut.surface);
  transfer_properties(m, c, cut.correspondence(m));
  double parted = 0;
  for (const auto v : verts(c)) {
    CHECK(find_vert_property<double>(c, "u")[v] == u[cut.verts[v.raw()]]);
    parted += find_vert_property<double>(c, "charge")[v];
  }
  CHECK(parted == doctest::Approx(total).epsilon(1e-14));
  for (const auto p : polys(c)) CHECK(find_poly_property<int>(c, "label")[p] == label[cut.polys[p.raw()]]);
  for (const auto e : edges(c)) {
    const auto ends = end_verts(c, e);
    CHECK(find_edge_property<int>(c, "crease")[e] == crease[edge_between(m, cut.verts[ends.first.raw()].raw(), cut.verts[ends.second.raw()].raw())]);
  }
}

TEST_CASE_TEMPLATE("cut_along: polys stay neighbours exactly at edges that are not cut, on 1,000 random meshes", M, CONCINO_SURFACE_KINDS) {
  std::mt19937 random(11);
  for (int round = 0; round < 1000; ++round) {
    const M m = round % 100 == 0 ? from_quads<M>(holed_board(1)) : random_mesh<M>(random);
    std::vector<edge_id> cut;
    std::vector<unsigned char> is_cut(edge_index_bound(m));
    for (const auto e : edges(m))
      if (random() % 3 == 0) {
        cut.push_back(e);
        is_cut[e.raw()] = 1;
      }
    const auto r = cut_along(m, cut);
    check_same_polys(m, r);
    const M c(r.surface);
    std::vector<poly_id> there(poly_index_bound(m));  // the poly of c for each poly of m
    for (const auto p : polys(c)) there[r.polys[p.raw()].raw()] = p;
    // Polys that share an edge that is not cut are still neighbours.
    for (const auto e : edges(m)) {
      if (is_cut[e.raw()]) continue;
      for (const auto p : adj_e2p(m, e))
        for (const auto q : adj_e2p(m, e)) {
          bool neighbours = p == q;
          for (const auto x : adj_p2p(c, there[p.raw()])) neighbours = neighbours || x == there[q.raw()];
          REQUIRE(neighbours);
        }
    }
    // c has a vert for each fan of polys between cut edges at a vert of m, and one for each vert that is not on the cut.
    std::size_t fans = 0;
    for (const auto v : verts(m)) {
      std::vector<poly_id> star;
      for (const auto p : adj_v2p(m, v)) star.push_back(p);
      bool on_cut = false;
      for (const auto e : adj_v2e(m, v)) on_cut = on_cut || is_cut[e.raw()];
      if (star.empty() || !on_cut) {
        ++fans;
        continue;
      }
      std::vector<std::size_t> label(star.size());
      for (std::size_t i = 0; i < star.size(); ++i) label[i] = i;
      for (const auto e : adj_v2e(m, v)) {
        if (is_cut[e.raw()]) continue;
        std::vector<std::size_t> here;
        for (const auto p : adj_e2p(m, e))
          for (std::size_t i = 0; i < star.size(); ++i)
            if (star[i] == p) here.push_back(i);
        for (const std::size_t i : here)
          for (const std::size_t old = label[i]; auto& l : label)
            if (l == old) l = label[here[0]];
      }
      fans += std::set<std::size_t>(label.begin(), label.end()).size();
    }
    REQUIRE(num_verts(c) == fans);
  }
}

TEST_CASE("cut_along: separates three polys at an edge, and does not split other verts") {
  const trimesh fan({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const auto cut = cut_along(fan, {edge_between(fan, 0, 1)});
  check_same_polys(fan, cut);
  CHECK(cut.verts.size() == 9);
  const trimesh bow({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  CHECK(cut_along(bow, {edge_between(bow, 1, 2)}).verts.size() == 5);
  CHECK(cut_along(bow, {edge_between(bow, 0, 2)}).verts.size() == 6);
}

TEST_CASE_TEMPLATE("cut_along: runs on the archetype of a surface with points", M, CONCINO_SURFACE_KINDS) {
  const M m = grid<M>(2);
  const auto s = only_embedded_mesh(m);
  std::vector<edge_t<decltype(s)>> all;
  for (const auto e : edges(s)) all.push_back(e);
  const auto cut = cut_along(s, all);
  check_same_polys(s, cut);
  CHECK(cut.surface.arity == 0);
  check_same_polys(user_mesh::surface_example(), cut_along(user_mesh::surface_example(), {}));
}

TEST_CASE("cut_along: throws if an edge is not in the mesh") {
  const quadmesh m = grid<quadmesh>(2);
  CHECK_THROWS_WITH_AS(cut_along(m, {edge_id{12}}), "cut_along: one of the edges is not an edge of the mesh; take them from edges(m)",
                       invalid_mesh);
  CHECK_THROWS_AS(cut_along(m, {edge_id{}}), invalid_mesh);
  const auto first = submesh(m, [](poly_id p) { return p == poly_id{0}; });
  CHECK_THROWS_AS(cut_along(first, {edge_between(m, 7, 8)}), invalid_mesh);
}
