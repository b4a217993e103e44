// Properties of OpenMesh's meshes are maps, without copies.
#include <support/openmesh.hpp>

#include <concino/concepts/maps.hpp>
#include <concino/concepts/views.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/graph/shortest_path.hpp>

#include <OpenMesh/Core/Utils/PropertyManager.hh>

using namespace concino;
using namespace concino::testing::om;
using OpenMesh::EdgeHandle;
using OpenMesh::FaceHandle;
using OpenMesh::VertexHandle;

namespace {

template<class M, class P> using map_t = decltype(as_map(std::declval<M&>(), P()));
using verts_of_doubles = map_t<only_one, OpenMesh::VPropHandleT<double>>;
using const_doubles = map_t<const only_one, OpenMesh::VPropHandleT<double>>;
using flags = map_t<only_one, OpenMesh::EPropHandleT<bool>>;
using manager = OpenMesh::PropertyManager<OpenMesh::VPropHandleT<double>>;

static_assert(ReadableMap<verts_of_doubles, VertexHandle> && WritableMap<verts_of_doubles, VertexHandle, double>);
static_assert(WritableMap<const verts_of_doubles, VertexHandle, double>);  // the map is const, its values are not
static_assert(ReadableMap<const_doubles, VertexHandle> && !WritableMap<const_doubles, VertexHandle, double>);
static_assert(ReadableMap<flags, EdgeHandle> && WritableMap<flags, EdgeHandle, bool>);
static_assert(ReadableMap<manager, VertexHandle> && WritableMap<manager, VertexHandle, double> && !WritableMap<const manager, VertexHandle, double>);
static_assert(ReadableMap<verts_of_doubles, OpenMesh::SmartVertexHandle> && !ReadableMap<verts_of_doubles, FaceHandle>);
static_assert(std::is_trivially_copyable_v<verts_of_doubles> && sizeof(verts_of_doubles) == sizeof(void*));

}  // namespace

TEST_CASE("OpenMesh: a map from as_map refers to the property") {
  only_one m;
  fill(m, two_grids<only_one>(2));
  OpenMesh::VPropHandleT<double> vh;
  OpenMesh::EPropHandleT<bool> eh;
  OpenMesh::FPropHandleT<std::string> fh;
  m.add_property(vh);
  m.add_property(eh);
  m.add_property(fh);
  const auto u = as_map(m, vh);
  const auto marked = as_map(m, eh);
  const auto name = as_map(m, fh);
  CHECK(&u[m.vertex_handle(3)] == &m.property(vh, m.vertex_handle(3)));
  for (const auto v : verts(m)) u[v] = 2.5;
  for (const auto e : edges(m)) marked[e] = e.idx() % 2 == 0;
  for (const auto f : polys(m)) name[f] = "f" + std::to_string(f.idx());
  CHECK(m.property(vh, m.vertex_handle(7)) == 2.5);
  CHECK(m.property(eh, m.edge_handle(2)));
  CHECK(!m.property(eh, m.edge_handle(3)));
  CHECK(m.property(fh, m.face_handle(1)) == "f1");

  const only_one& read = m;
  const auto w = as_map(read, vh);
  CHECK(w[OpenMesh::make_smart(m.vertex_handle(7), m)] == 2.5);

  // New elements have values too, also in a map created before them.
  const VertexHandle added = m.add_vertex({0, 0, 1});
  u[added] = 4;
  CHECK(w[added] == 4);

  CHECK_THROWS_AS(as_map(m, OpenMesh::VPropHandleT<double>()), invalid_argument);
}

TEST_CASE("OpenMesh: standard attributes of the mesh are maps") {
  tri_float m;
  fill(m, two_grids<tri_float>(2));
  m.request_vertex_colors();
  const auto colour = as_map(m, m.vertex_colors_pph());
  colour[m.vertex_handle(1)] = tri_float::Color(1, 2, 3);
  CHECK(m.color(m.vertex_handle(1))[2] == 3);
  CHECK(as_map(m, m.points_property_handle())[m.vertex_handle(1)] == m.point(m.vertex_handle(1)));
}

TEST_CASE("OpenMesh: properties can be lengths, barriers and predecessors of shortest paths") {
  only_one m;
  fill(m, testing::triangle_grid(4));
  OpenMesh::EPropHandleT<double> length_handle;
  m.add_property(length_handle);
  const auto length = as_map(m, length_handle);
  for (const auto e : edges(m)) length[e] = m.calc_edge_length(e);
  auto is_wall = OpenMesh::makeTemporaryProperty<EdgeHandle, bool>(m);
  auto from = OpenMesh::makeTemporaryProperty<VertexHandle, VertexHandle>(m);

  const VertexHandle s = m.vertex_handle(0), t = m.vertex_handle(24);
  const auto along = [&](VertexHandle a, VertexHandle b) { return length[m.edge_handle(m.find_halfedge(a, b))]; };
  const auto d = dijkstra(m, s, along), straight = dijkstra(m, s);
  for (const auto v : verts(m)) CHECK(d[v] == doctest::Approx(straight[v]).epsilon(1e-12));

  for (const auto e : edges(m)) is_wall[e] = false;
  is_wall[m.edge_handle(m.find_halfedge(m.vertex_handle(0), m.vertex_handle(6)))] = true;
  const auto around = dijkstra(m, s, along, {.may_cross = [&](EdgeHandle e) { return !is_wall[e]; }, .predecessors = &from});
  CHECK(around[t] > d[t]);
  CHECK(from[s] == s);
  const auto path = path_to(from, t);
  CHECK(path.front() == s);
  CHECK(path.back() == t);
}

TEST_CASE("OpenMesh: properties can be values and results of harmonic maps") {
  only_one m;
  fill(m, testing::triangle_grid(4));
  OpenMesh::VProp<double> given(m), u(m);
  std::vector<std::pair<VertexHandle, double>> fixed;
  for (const auto v : verts(m)) {
    if (!m.is_boundary(v)) continue;
    given[v] = m.point(v)[0];
    fixed.push_back({v, given[v]});
  }
  const auto solution = harmonic_map(m, fixed, cotangent);
  for (const auto v : verts(m)) u[v] = solution[v];
  for (const auto v : verts(m)) CHECK(u[v] == doctest::Approx(m.point(v)[0]));
}

TEST_CASE("OpenMesh: properties can be the points of a mesh") {
  only_one m;
  fill(m, testing::triangle_grid(4));
  OpenMesh::VPropHandleT<OpenMesh::Vec3f> h;
  m.add_property(h);
  const auto lifted = as_map(m, h);
  for (const auto v : verts(m)) lifted[v] = {static_cast<float>(m.point(v)[0]), 0, static_cast<float>(m.point(v)[1] * 3)};
  const auto view = with_points(m, lifted);
  const auto kept = with_points(m, as_map(m, h));
  static_assert(TriMesh<decltype(view)> && Embedded<decltype(view)>);
  CHECK(total_measure(m) == doctest::Approx(1));
  CHECK(total_measure(view) == doctest::Approx(3));
  CHECK(total_measure(kept) == doctest::Approx(3));
  OpenMesh::VProp<OpenMesh::Vec3d> flat(OpenMesh::Vec3d(0, 0, 0), m);
  CHECK(total_measure(with_points(m, flat)) == 0);
}
