#include <concino/mesh/element_map.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/maps.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

struct window { const trimesh* mesh; };  // a view of a mesh

template<class M> concept has_vert_maps = requires { make_vert_map<double>(std::declval<M>(), 0.0); };
template<class M> concept has_face_maps = requires { make_face_map<double>(std::declval<M>(), 0.0); };

}  // namespace

template<>
struct concino::mesh_traits<window> {
  using vert = vert_id;
  static constexpr bool is_view = true;
  static std::size_t vert_index_bound(const window& w) { return concino::vert_index_bound(*w.mesh); }
  static std::size_t index_of(const window& w, vert_id v) { return concino::index_of(*w.mesh, v); }
};

TEST_CASE_TEMPLATE("element maps: have a value per element, which can be set and read", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  auto v = make_vert_map<double>(m, -1);
  auto e = make_edge_map<std::string>(m, "none");
  auto p = make_poly_map<int>(m);
  static_assert(WritableMap<decltype(v), vert_id, double> && ReadableMap<const decltype(p), poly_id> && !ReadableMap<decltype(v), poly_id>);
  static_assert(std::same_as<decltype(v), vert_map<M, double>> && std::same_as<decltype(p), poly_map<const M&, int>>);
  CHECK(v.values().size() == vert_index_bound(m));
  CHECK(e.values().size() == edge_index_bound(m));
  int next = 0;
  for (const auto x : polys(m)) p[x] = next++;
  next = 0;
  for (const auto x : polys(m)) CHECK(p[x] == next++);
  for (const auto x : edges(m)) CHECK(e[x] == "none");
  v[vert_id{3}] = 2.5;
  CHECK(v[vert_id{3}] == 2.5);
  CHECK(v[vert_id{2}] == -1);
  CHECK(&v.mesh() == &m);
  if constexpr (VolumeMesh<M>) {
    auto f = make_face_map<float>(m, 1);
    CHECK(f.values().size() == face_index_bound(m));
  } else {
    static_assert(!has_face_maps<const M&>);
  }
}

TEST_CASE("element maps: of bool return references too") {
  const auto m = grid<trimesh>(1);
  auto marked = make_vert_map<bool>(m);
  marked[vert_id{2}] = true;
  const auto copy = marked;
  marked = make_vert_map<bool>(m, true);
  marked[vert_id{1}] = false;
  static_assert(std::same_as<decltype(copy[vert_id{0}]), bool>);
  CHECK((copy[vert_id{2}] && !copy[vert_id{1}]));
  CHECK((marked[vert_id{2}] && !marked[vert_id{1}]));
}

TEST_CASE("element maps: reject temporary meshes and copy views") {
  static_assert(has_vert_maps<trimesh&> && has_vert_maps<const trimesh&> && !has_vert_maps<trimesh> && !has_vert_maps<const trimesh>);
  static_assert(has_vert_maps<window> && has_vert_maps<window&> && !has_vert_maps<int&>);
  const auto m = grid<trimesh>(1);
  auto d = make_vert_map<int>(window{&m}, 4);
  d[vert_id{1}] += 3;
  CHECK(d[vert_id{1}] == 7);
  CHECK(d.mesh().mesh == &m);
}

TEST_CASE("element maps: work on empty meshes and with opaque descriptors") {
  const trimesh none;
  CHECK(make_vert_map<int>(none, 1).values().empty());
  const auto m = grid<hexmesh>(1);
  const auto g = only_mesh(m);
  auto d = make_face_map<int>(g, 0);
  for (const auto f : faces(g)) d[f] += 1;
  for (const auto f : faces(g)) CHECK(d[f] == 1);
}
