// The origins of edges and faces follow from those of their verts: of split, new, merged and copied ones.
#include <concino/mesh/correspondence.hpp>

#include <concino/edit.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

using namespace concino;

namespace {

template<class M>
std::uint32_t edge_between(const M& m, std::uint32_t a, std::uint32_t b) {
  for (const edge_id e : edges(m)) {
    const auto [first, second] = end_verts(m, e);
    if ((first.raw() == a && second.raw() == b) || (first.raw() == b && second.raw() == a)) return e.raw();
  }
  FAIL("no such edge");
  return 0;
}

template<class M>
std::uint32_t face_of(const M& m, std::initializer_list<std::uint32_t> corners) {
  for (const face_id f : faces(m)) {
    std::size_t size = 0, met = 0;
    for (const vert_id v : adj_f2v(m, f)) ++size, met += std::count(corners.begin(), corners.end(), v.raw()) == 1;
    if (size == corners.size() && met == size) return f.raw();
  }
  FAIL("no such face");
  return 0;
}

/// The origins of verts: all of the mesh before stay, then come those in `added`.
correspondence with_added_verts(std::uint32_t before, std::initializer_list<std::initializer_list<origin>> added) {
  correspondence c;
  for (std::uint32_t v = 0; v < before; ++v) c.verts.add(v);
  for (const auto& origins : added) c.verts.add(origins);
  return c;
}

element_origins copies_of_all(std::size_t n) {
  std::vector<std::uint32_t> all(n);
  for (std::size_t i = 0; i < n; ++i) all[i] = static_cast<std::uint32_t>(i);
  return element_origins(std::move(all));
}

polygonmesh square() { return polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}); }

void check_only_origin(const element_origins& all, std::uint32_t i, std::uint32_t before, double weight) {
  REQUIRE(all[i].size() == 1);
  CHECK(all[i][0].index == before);
  CHECK(all[i][0].weight == weight);
}

}  // namespace

TEST_CASE("origins of edges: the parts of a split edge have the fraction of it as weight") {
  const polygonmesh m = square();
  // at 1/8, 3/8 and 7/8 of the edge from 0 to 1; weights need not sum to 1, and origins may have any order
  for (const bool reversed : {false, true}) {
    const polygonmesh split({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.125, 0, 0}, {0.375, 0, 0}, {0.875, 0, 0}}, {{0, 4, 5, 6, 1, 2, 3}});
    correspondence c = reversed ? with_added_verts(4, {{{1, 0.5}, {0, 3.5}}, {{1, 3}, {0, 5}}, {{1, 7}, {0, 1}}})
                                : with_added_verts(4, {{{0, 3.5}, {1, 0.5}}, {{0, 5}, {1, 3}}, {{0, 1}, {1, 7}}});
    match_edges_and_faces(m, split, c);
    const std::uint32_t whole = edge_between(m, 0, 1);
    check_only_origin(c.edges, edge_between(split, 0, 4), whole, 0.125);
    check_only_origin(c.edges, edge_between(split, 4, 5), whole, 0.25);
    check_only_origin(c.edges, edge_between(split, 5, 6), whole, 0.5);
    check_only_origin(c.edges, edge_between(split, 6, 1), whole, 0.125);
    check_only_origin(c.edges, edge_between(split, 1, 2), edge_between(m, 1, 2), 1);
    check_only_origin(c.edges, edge_between(split, 0, 3), edge_between(m, 0, 3), 1);
    CHECK(c.faces.size() == 0);
  }
}

TEST_CASE("origins of edges: an origin may be listed twice, and origins with weights of 0 count equally") {
  const polygonmesh m = square();
  const polygonmesh split({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.25, 0, 0}, {0.5, 0, 0}}, {{0, 4, 5, 1, 2, 3}});
  correspondence c = with_added_verts(4, {{{0, 1}, {1, 1}, {0, 2}}, {{0, 0}, {1, 0}}});
  match_edges_and_faces(m, split, c);
  const std::uint32_t whole = edge_between(m, 0, 1);
  check_only_origin(c.edges, edge_between(split, 0, 4), whole, 0.25);
  check_only_origin(c.edges, edge_between(split, 4, 5), whole, 0.25);
  check_only_origin(c.edges, edge_between(split, 5, 1), whole, 0.5);
}

TEST_CASE("origins of edges: an edge without length has its edge as origin, with the weight 0") {
  const polygonmesh m = square();
  const polygonmesh split({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 0}, {0.5, 0, 0}}, {{0, 4, 5, 1, 2, 3}});
  correspondence c = with_added_verts(4, {{{0, 1}, {1, 1}}, {{1, 2}, {0, 2}}});
  match_edges_and_faces(m, split, c);
  check_only_origin(c.edges, edge_between(split, 4, 5), edge_between(m, 0, 1), 0);
}

TEST_CASE("origins of edges: none for edges that do not lie on an old edge") {
  const polygonmesh m = square();
  // vert 4 is at the middle of an edge, 5 has no origin, 6 is a copy of 0, 7 and 8 have the origins 0, 1 and 3, 9 is where 4 is
  correspondence c = with_added_verts(4, {{{0, 1}, {1, 1}}, {}, {{0, 1}}, {{0, 1}, {1, 1}, {3, 1}}, {{0, 2}, {1, 1}, {3, 1}}, {{0, 1}, {1, 1}}});
  const polygonmesh next({{}, {}, {}, {}, {}, {}, {}, {}, {}, {}}, {{0, 2, 5, 4}, {5, 4, 6}, {4, 5, 3}, {0, 6, 3}, {7, 8, 2}, {5, 9, 2}});
  match_edges_and_faces(m, next, c);
  for (const auto& [a, b] : {std::pair{0u, 2u}, {2u, 5u}, {5u, 4u}, {5u, 6u}, {5u, 3u}, {4u, 3u}, {0u, 6u}, {7u, 8u}, {8u, 2u}, {5u, 9u}})
    CHECK(c.edges[edge_between(next, a, b)].empty());
  check_only_origin(c.edges, edge_between(next, 4, 6), edge_between(m, 0, 1), 0.5);
  check_only_origin(c.edges, edge_between(next, 6, 3), edge_between(m, 0, 3), 1);
  check_only_origin(c.edges, edge_between(next, 0, 3), edge_between(m, 0, 3), 1);
}

TEST_CASE_TEMPLATE("origins of edges: none where the ends are merged or without origin, whichever end it is", M, CONCINO_KINDS) {
  const M m = testing::grid<M>(2);
  for (const vert_id v : verts(m)) {
    correspondence c;
    for (const vert_id w : verts(m)) {
      if (w == v) c.verts.add(element_origins::none);
      else c.verts.add(w.raw());
    }
    match_edges_and_faces(m, m, c);
    for (const edge_id e : edges(m)) {
      const auto ends = end_verts(m, e);
      if (ends.first == v || ends.second == v) CHECK(c.edges[e.raw()].empty());
      else check_only_origin(c.edges, e.raw(), e.raw(), 1);
    }
    if constexpr (VolumeMesh<M>)
      for (const face_id f : faces(m)) {
        bool is_known = true;
        for (const vert_id w : adj_f2v(m, f)) is_known = is_known && w != v;
        CHECK(c.faces.only(f.raw()) == (is_known ? f.raw() : element_origins::none));
      }
  }
}

TEST_CASE_TEMPLATE("origins of faces: none for faces whose verts are copies of one vert or of the ends of an edge", M, CONCINO_VOLUME_KINDS) {
  const M m = testing::grid<M>(1);
  correspondence one, two;
  one.verts = element_origins(std::vector<std::uint32_t>(num_verts(m), 1));
  const auto ends = end_verts(m, edge_id{0});
  for (const vert_id v : verts(m)) two.verts.add(v.raw() % 2 == 0 ? ends.first.raw() : ends.second.raw());
  for (correspondence* c : {&one, &two}) {
    match_edges_and_faces(m, m, *c);
    REQUIRE(c->faces.size() == num_faces(m));
    for (const face_id f : faces(m)) CHECK(c->faces[f.raw()].empty());
  }
  for (const edge_id e : edges(m)) CHECK(one.edges[e.raw()].empty());
}

TEST_CASE("origins of faces: the face with no other verts, else one that has all of them") {
  // Below the pyramid over the square 0 1 2 3 there is a flat poly between the square and the triangles 0 1 2 and 0 2 3.
  polyhedralmesh m;
  std::vector<vert_id> v;
  for (const vec3& x : {vec3{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}) v.push_back(add_vert(m, x));
  const auto face = [&](std::initializer_list<std::size_t> corners) {
    std::vector<vert_id> of;
    for (const std::size_t k : corners) of.push_back(v[k]);
    return add_face(m, std::span<const vert_id>(of));
  };
  const face_id bottom = face({0, 3, 2, 1});
  const face_id a = face({0, 1, 4}), b = face({1, 2, 4}), c = face({2, 3, 4}), d = face({3, 0, 4});
  add_poly(m, {{bottom, true}, {a, true}, {b, true}, {c, true}, {d, true}});
  const tetmesh tets({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}}, {{0, 1, 2, 4}, {0, 2, 3, 4}});
  correspondence to_tets;
  to_tets.verts = copies_of_all(5);
  match_edges_and_faces(m, tets, to_tets);
  CHECK(to_tets.faces.only(face_of(tets, {0, 1, 2})) == bottom.raw());
  CHECK(to_tets.faces.only(face_of(tets, {0, 2, 3})) == bottom.raw());
  CHECK(to_tets.faces.only(face_of(tets, {1, 2, 4})) == b.raw());
  CHECK(to_tets.faces[face_of(tets, {0, 2, 4})].empty());

  const face_id first = face({0, 1, 2}), second = face({0, 2, 3});
  add_poly(m, {{bottom, false}, {first, false}, {second, false}});
  correspondence to_parts;
  to_parts.verts = copies_of_all(5);
  match_edges_and_faces(m, tets, to_parts);
  CHECK(to_parts.faces.only(face_of(tets, {0, 1, 2})) == first.raw());
  CHECK(to_parts.faces.only(face_of(tets, {0, 2, 3})) == second.raw());
  correspondence same;
  same.verts = copies_of_all(5);
  match_edges_and_faces(m, m, same);
  for (const face_id f : faces(m)) CHECK(same.faces.only(f.raw()) == f.raw());
}

TEST_CASE_TEMPLATE("correspondence: each origin is checked, of each kind of elements that has properties", M, CONCINO_KINDS) {
  M m = testing::grid<M>(1), to = testing::grid<M>(1);
  const auto check_kind = [&](element_kind kind, element_origins correspondence::*origins, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      std::vector<std::uint32_t> all(n, 0);
      all[i] = static_cast<std::uint32_t>(n);
      correspondence c;
      c.verts = copies_of_all(num_verts(m)), c.edges = copies_of_all(num_edges(m)), c.polys = copies_of_all(num_polys(m));
      if constexpr (VolumeMesh<M>) c.faces = copies_of_all(num_faces(m));
      c.*origins = element_origins(all);
      CHECK_THROWS_AS(transfer_properties(m, to, c), invalid_argument);
      CHECK(property_list(to).empty());
      all[i] = static_cast<std::uint32_t>(n - 1);
      c.*origins = element_origins(all);
      M good = to;
      CHECK_NOTHROW(transfer_properties(m, good, c));
      CHECK(property_list(good).size() == 1);
    }
    CHECK(remove_property(m, kind, "u"));
  };
  vert_property<int>(m, "u");
  check_kind(element_kind::vert, &correspondence::verts, num_verts(m));
  edge_property<int>(m, "u");
  check_kind(element_kind::edge, &correspondence::edges, num_edges(m));
  poly_property<int>(m, "u");
  check_kind(element_kind::poly, &correspondence::polys, num_polys(m));
  if constexpr (VolumeMesh<M>) {
    face_property<int>(m, "u");
    check_kind(element_kind::face, &correspondence::faces, num_faces(m));
  }
}

TEST_CASE_TEMPLATE("correspondence: needs the origins of those kinds of elements only that have properties", M, CONCINO_KINDS) {
  const auto transferred = [](const M& m, const correspondence& c) {
    M to = testing::grid<M>(1);
    transfer_properties(m, to, c);
    return property_list(to).size();
  };
  M of_polys = testing::grid<M>(1), of_edges = of_polys;
  poly_property<int>(of_polys, "u");
  correspondence only_polys, only_edges;
  only_polys.polys = copies_of_all(num_polys(of_polys));
  CHECK(transferred(of_polys, only_polys) == 1);
  edge_property<int>(of_edges, "u");
  only_edges.edges = copies_of_all(num_edges(of_edges));
  CHECK(transferred(of_edges, only_edges) == 1);
  if constexpr (VolumeMesh<M>) {
    M m = testing::grid<M>(1), to = m;
    const auto u = face_property<int>(m, "u");
    for (const face_id f : faces(m)) u[f] = static_cast<int>(f.raw());
    correspondence only_faces, only_verts;
    only_faces.faces = copies_of_all(num_faces(m));
    CHECK(transferred(m, only_faces) == 1);
    only_verts.verts = copies_of_all(num_verts(m));
    transfer_properties(m, to, only_verts);
    for (const face_id f : faces(m)) CHECK(find_face_property<int>(to, "u")[f] == static_cast<int>(f.raw()));
  }
}

TEST_CASE("correspondence: values are transferred only if each origin has one") {
  const std::vector<double> values = {1, 2};
  CHECK(transfer_values(element_origins({1, 0, 1}), std::span(values), property_rule::copy) == std::vector<double>{2, 1, 2});
  for (std::size_t i = 0; i < 4; ++i) {
    std::vector<std::uint32_t> beyond(4, 1);
    beyond[i] = 2;
    CHECK_THROWS_AS(transfer_values(element_origins(beyond), std::span(values), property_rule::copy), invalid_argument);
  }
}

TEST_CASE_TEMPLATE("correspondence: elements at removed verts are no origins", M, CONCINO_KINDS) {
  const M whole = testing::grid<M>(2);
  M m = whole;
  remove_vert(m, vert_id{0});
  correspondence c;
  for (const vert_id v : verts(whole)) c.verts.add(v.raw());
  match_edges_and_faces(m, whole, c);
  for (const edge_id e : edges(whole)) {
    const auto ends = end_verts(whole, e);
    if (ends.first == vert_id{0} || ends.second == vert_id{0}) CHECK(c.edges[e.raw()].empty());
  }
  if constexpr (VolumeMesh<M>)
    for (const face_id f : adj_v2f(whole, vert_id{0})) CHECK(c.faces[f.raw()].empty());
}
