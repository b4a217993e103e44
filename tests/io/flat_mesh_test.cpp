#include <concino/io/flat_mesh.hpp>

#include <concino/edit.hpp>
#include <concino/io/detail/formats/flat_mesh_of.hpp>
#include <concino/mesh.hpp>

#include <support/kinds.hpp>
#include <support/meshes.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;
using concino::detail::flat_mesh_of;
using concino::detail::list_collector;

namespace {

template<class T, class R>
bool is_same_list(std::span<const T> flat, const R& range) {
  std::size_t k = 0;
  for (const auto x : range)
    if (k == flat.size() || flat[k++].raw() != x.raw()) return false;
  return k == flat.size();
}

}  // namespace

TEST_CASE_TEMPLATE("flat_mesh: refers to the arrays of a native mesh without copies", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(2));
  flat_mesh_of<M> flat(m);
  CHECK(flat.dimension == dimension_v<M>);
  CHECK(flat.arity == static_cast<std::uint32_t>(arity_v<M>));
  CHECK(flat.points.data() == &point(m, vert_id{0}));
  CHECK(flat.points.size() == num_verts(m));
  CHECK(flat.num_polys == num_polys(m));
  CHECK(flat.vert_indices.empty());
  CHECK(flat.vert_index(1) == 1);
  if constexpr (dimension_v<M> == 2 || arity_v<M> != 0) {
    CHECK(flat.poly_verts.size() == num_polys(m));
    CHECK(flat.poly_verts.values.data() == adj_p2v(m, poly_id{0}).begin());
    for (const auto p : polys(m)) CHECK(is_same_list(flat.poly_verts[p.raw()], adj_p2v(m, p)));
  } else {
    CHECK(flat.poly_verts.size() == 0);
  }
  if constexpr (dimension_v<M> == 3) {
    const flat_polyhedra& all = flat.polyhedra();
    CHECK(&flat.polyhedra() == &all);
    CHECK(all.face_verts.size() == num_faces(m));
    CHECK(all.poly_faces.size() == num_polys(m));
    CHECK(all.poly_faces.values.data() == adj_p2f(m, poly_id{0}).begin());
    if constexpr (arity_v<M> == 0) CHECK(all.face_verts.values.data() == adj_f2v(m, face_id{0}).begin());
    for (const auto f : faces(m)) CHECK(is_same_list(all.face_verts[f.raw()], adj_f2v(m, f)));
    std::size_t k = 0;
    for (const auto p : polys(m)) {
      CHECK(is_same_list(all.poly_faces[p.raw()], adj_p2f(m, p)));
      for (const auto f : adj_p2f(m, p)) CHECK((all.outward[k++] != 0) == face_is_outward(m, p, f));
    }
    CHECK(k == all.outward.size());
  }
}

TEST_CASE_TEMPLATE("flat_mesh: numbers have no gaps for removed elements", M, CONCINO_ALL_KINDS) {
  M m(grid_arrays<M>(2));
  auto number = poly_property<int>(m, "number");
  auto name = vert_property<int>(m, "name");
  for (const auto p : polys(m)) number[p] = static_cast<int>(p.raw());
  for (const auto v : verts(m)) name[v] = static_cast<int>(v.raw());
  auto edge_number = edge_property<int>(m, "edge");
  for (const auto e : edges(m)) edge_number[e] = static_cast<int>(e.raw());
  auto corner_number = corner_property<int>(m, "corner");
  for (const auto p : polys(m))
    for (std::uint32_t k = 0; k < num_elements(adj_p2v(m, p)); ++k) corner_number[{p, k}] = static_cast<int>(100 * p.raw() + k);
  remove_poly(m, poly_id{0});
  remove_poly(m, poly_id{2});
  std::vector<vert_id> alone;
  for (const auto v : verts(m))
    if (adj_v2p(m, v).begin() == adj_v2p(m, v).end()) alone.push_back(v);
  for (const auto v : alone) remove_vert(m, v);
  flat_mesh_of<M> made(m);
  flat_mesh& flat = made;
  REQUIRE(flat.points.size() == num_verts(m));
  REQUIRE(flat.num_polys == num_polys(m));
  const auto names = flat.vert_values<int>("name"), numbers = flat.poly_values<int>("number");
  CHECK(!flat.vert_values<double>("name"));
  CHECK(!flat.poly_values<int>("name"));
  std::size_t i = 0;
  for (const auto v : verts(m)) {
    CHECK(flat.points[i] == point(m, v));
    CHECK(flat.vert_index(i) == v.raw());
    CHECK(names[i++] == static_cast<int>(v.raw()));
  }
  i = 0;
  const auto same_points = [&](std::span<const vert_id> corners, const auto& range) {
    std::size_t k = 0;
    for (const auto v : range) CHECK(flat.points[corners[k++].raw()] == point(m, v));
    CHECK(k == corners.size());
  };
  for (const auto p : polys(m)) {
    CHECK(flat.poly_index(i) == p.raw());
    CHECK(numbers[i] == static_cast<int>(p.raw()));
    if constexpr (dimension_v<M> == 2 || arity_v<M> != 0) same_points(flat.poly_verts[i], adj_p2v(m, p));
    if constexpr (dimension_v<M> == 3) {
      std::size_t k = 0;
      for (const auto f : adj_p2f(m, p)) same_points(flat.polyhedra().face_verts[flat.polyhedra().poly_faces[i][k++].raw()], adj_f2v(m, f));
    }
    ++i;
  }
  const auto edge_numbers = flat.edge_values<int>("edge");
  CHECK(!flat.edge_values<double>("edge"));
  REQUIRE(flat.edge_verts().size() == num_edges(m));
  i = 0;
  for (const auto e : edges(m)) {
    CHECK(edge_numbers[i] == static_cast<int>(e.raw()));
    same_points(flat.edge_verts()[i++], adj_e2v(m, e));
  }
  if constexpr (dimension_v<M> == 3) {
    auto face_number = face_property<int>(m, "face");
    for (const auto f : faces(m)) face_number[f] = static_cast<int>(f.raw());
    const auto face_numbers = flat.face_values<int>("face");
    i = 0;
    for (const auto f : faces(m)) CHECK(face_numbers[i++] == static_cast<int>(f.raw()));
    CHECK(!flat.corner_values<int>("corner"));
  } else {
    const auto corner_numbers = flat.corner_values<int>("corner");
    CHECK(!flat.corner_values<int>("edge"));
    CHECK(!flat.face_values<int>("face"));
    i = 0;
    for (const auto p : polys(m))
      for (std::size_t k = 0; k < num_elements(adj_p2v(m, p)); ++k) CHECK(corner_numbers[i++] == static_cast<int>(100 * p.raw() + k));
  }
}

TEST_CASE("flat_mesh: lists are not copied as long as they are contiguous") {
  const std::vector<vert_id> all = {vert_id{0}, vert_id{1}, vert_id{2}, vert_id{3}, vert_id{4}, vert_id{5}, vert_id{6}};
  const vert_id* const v = all.data();
  list_collector<vert_id> equal(false), different(false), apart(false), none(false), empty(false);
  equal.refer_to(v, v + 2), equal.refer_to(v + 2, v + 4);
  CHECK(equal.lists().arity == 2);
  CHECK(equal.lists().values.data() == v);
  CHECK(equal.lists().size() == 2);
  CHECK(equal.lists()[1][0] == vert_id{2});
  different.refer_to(v, v + 2), different.refer_to(v + 2, v + 4), different.refer_to(v + 4, v + 7);
  CHECK(different.lists().arity == 0);
  CHECK(different.lists().values.data() == v);
  CHECK(different.lists().size() == 3);
  CHECK(different.lists()[2].size() == 3);
  apart.refer_to(v, v + 2), apart.refer_to(v + 3, v + 5), apart.refer_to(v + 5, v + 7);
  CHECK(apart.lists().values.data() != v);
  CHECK(apart.lists().values.size() == 6);
  CHECK(apart.lists()[1][0] == vert_id{3});
  CHECK(apart.lists()[2][1] == vert_id{6});
  CHECK(none.lists().size() == 0);
  empty.refer_to(v, v), empty.refer_to(v, v), empty.refer_to(v, v + 1);
  CHECK(empty.lists().size() == 3);
  CHECK(empty.lists()[1].empty());
  CHECK(empty.lists()[2][0] == vert_id{0});
}
