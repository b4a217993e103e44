// Every OpenMesh mesh, and every class derived from one, is a SurfaceMesh with OpenMesh's own handles.
#include <support/kinds.hpp>
#include <support/openmesh.hpp>

#include <support/models.hpp>

#include <concino/graph/dijkstra.hpp>

#include <doctest/doctest.h>

#include <ranges>

using namespace concino;
using namespace concino::testing::om;
using concino::testing::models_in_all_forms;

namespace {

constexpr int poly_mesh = testing::surface | testing::embedded | testing::mutable_points;
constexpr int tri_mesh = poly_mesh | testing::fixed_arity;

static_assert(models_in_all_forms<poly_double>(poly_mesh) && models_in_all_forms<poly_eigen>(poly_mesh) &&
              models_in_all_forms<poly_homogeneous>(poly_mesh));
static_assert(models_in_all_forms<tri_float>(tri_mesh) && models_in_all_forms<tri_own>(tri_mesh) && models_in_all_forms<only_one>(tri_mesh));
// A mesh with points in the plane is Embedded, but its points cannot leave the plane. Connectivity alone has no points.
static_assert(models_in_all_forms<tri_planar>(testing::surface | testing::embedded | testing::fixed_arity));
static_assert(models_in_all_forms<OpenMesh::PolyConnectivity>(testing::surface));
static_assert(models_in_all_forms<OpenMesh::TriConnectivity>(testing::surface | testing::fixed_arity));
static_assert(models_in_all_forms<OpenMesh::ArrayKernel>(testing::nothing) && models_in_all_forms<OpenMesh::VertexHandle>(testing::nothing));

static_assert(std::same_as<vert_t<mine>, OpenMesh::VertexHandle> && std::same_as<edge_t<mine>, OpenMesh::EdgeHandle> &&
              std::same_as<poly_t<mine>, OpenMesh::FaceHandle>);
static_assert(!is_view_v<mine>);
static_assert(std::same_as<decltype(point(std::declval<const tri_float&>(), OpenMesh::VertexHandle())), const OpenMesh::Vec3f&>);

template<class M>
consteval bool walks_are_forward_ranges() {
  using m = const M&;
  return std::ranges::forward_range<decltype(verts(std::declval<m>()))> && std::ranges::forward_range<decltype(edges(std::declval<m>()))> &&
         std::ranges::forward_range<decltype(polys(std::declval<m>()))> &&
         std::ranges::forward_range<decltype(adj_v2v(std::declval<m>(), vert_t<M>()))> &&
         std::ranges::forward_range<decltype(adj_v2e(std::declval<m>(), vert_t<M>()))> &&
         std::ranges::forward_range<decltype(adj_v2p(std::declval<m>(), vert_t<M>()))> &&
         std::ranges::forward_range<decltype(adj_e2v(std::declval<m>(), edge_t<M>()))> &&
         std::ranges::forward_range<decltype(adj_e2p(std::declval<m>(), edge_t<M>()))> &&
         std::ranges::forward_range<decltype(adj_p2v(std::declval<m>(), poly_t<M>()))> &&
         std::ranges::forward_range<decltype(adj_p2e(std::declval<m>(), poly_t<M>()))> &&
         std::ranges::forward_range<decltype(adj_p2p(std::declval<m>(), poly_t<M>()))>;
}
static_assert(walks_are_forward_ranges<only_one>());

}  // namespace

TEST_CASE_TEMPLATE("OpenMesh: with any traits laws hold, and rings and points are right", M, CONCINO_FIRST_OF(tri_float, tri_own, tri_planar, only_one, poly_double, poly_eigen,
                   poly_homogeneous)) {
  M m;
  CHECK(num_verts(m) == 0);
  CHECK(!(verts(m).begin() != verts(m).end()));
  const surface_arrays s = two_grids<M>(3);
  fill(m, s);
  check_laws_hold<>(m);
  check_rings(m);
  CHECK(num_verts(m) == s.points.size());
  CHECK(vert_index_bound(m) == s.points.size());
  CHECK(num_edges(m) == m.n_edges());
  CHECK(num_polys(m) == m.n_faces());
  for (const auto v : verts(m)) CHECK(norm(to_vec3(point(m, v)) - s.points[index_of(m, v)]) < 1e-6);
}

TEST_CASE_TEMPLATE("OpenMesh: laws of points hold, and only a point that is NaN breaks one", M, CONCINO_FIRST_OF(only_one, poly_double)) {
  M m;
  check_laws_hold<M>(m);
  fill(m, two_grids<M>(2));
  check_laws_hold<M>(m);
  set_point(m, m.vertex_handle(3), vec3{0, 0, std::numeric_limits<double>::quiet_NaN()});
  CHECK(check_laws(m).size() == 1);
}

TEST_CASE("OpenMesh: laws hold for connectivity without points") {
  only_one m;
  fill(m, two_grids<only_one>(2));
  const OpenMesh::PolyConnectivity& c = *OpenMesh::make_smart(m.vertex_handle(0), m).mesh();
  check_laws_hold<>(c);
  CHECK(num_edges(c) == m.n_edges());
}

TEST_CASE("OpenMesh: algorithms take handles and smart handles, and return handles") {
  only_one m;
  fill(m, two_grids<only_one>(2));
  const OpenMesh::VertexHandle s = m.vertex_handle(0);
  const auto d = dijkstra(m, s);
  const double x = d[m.vertex_handle(4)];
  CHECK(x == doctest::Approx(std::sqrt(0.5)));
  const OpenMesh::SmartVertexHandle smart = OpenMesh::make_smart(s, m);
  CHECK(dijkstra(m, smart)[smart] == 0);
  CHECK(dijkstra(m, {smart})[m.vertex_handle(4)] == x);
  CHECK(index_of(m, smart.halfedge().face()) == static_cast<std::size_t>(smart.halfedge().face().idx()));
  CHECK(contains(m, smart));
  CHECK(contains(m, OpenMesh::make_smart(m.edge_handle(0), m)));
  CHECK(!contains(m, OpenMesh::VertexHandle()));
  CHECK(!contains(m, OpenMesh::VertexHandle(static_cast<int>(m.n_vertices()))));
  CHECK(!contains(m, OpenMesh::FaceHandle(-7)));
  CHECK_THROWS_AS(dijkstra(m, OpenMesh::VertexHandle()), invalid_mesh);
  const auto across = dijkstra(m, m.face_handle(0));  // a face is a source, so the distances are those of polys
  CHECK(across[m.face_handle(1)] > 0);
  for (const OpenMesh::EdgeHandle e : adj_v2e(m, s)) {
    const OpenMesh::HalfedgeHandle h = m.halfedge_handle(e, 0);
    CHECK((m.to_vertex_handle(h) == s || m.from_vertex_handle(h) == s));
  }
}

TEST_CASE("OpenMesh: polys are in the order in which they were added") {
  poly_double m;
  fill(m, two_grids<poly_double>(2));
  for (const auto p : polys(m)) {
    std::vector<int> here, there;
    for (const auto v : adj_p2v(m, p)) here.push_back(v.idx());
    for (const auto v : m.fv_range(p)) there.push_back(v.idx());
    CHECK(here == there);
  }
  CHECK(adj_p2v(m, m.face_handle(0)).begin().operator*() == m.vertex_handle(0));
}

TEST_CASE("OpenMesh: points may have two coordinates, or more than three") {
  tri_planar flat;
  flat.add_vertex({1, 2});
  CHECK(to_vec3(point(flat, flat.vertex_handle(0))) == vec3{1, 2, 0});
  poly_homogeneous m;
  m.add_vertex({1, 2, 3, 4});
  set_point(m, m.vertex_handle(0), vec3{5, 6, 7});
  CHECK(m.point(m.vertex_handle(0)) == OpenMesh::Vec4d(5, 6, 7, 4));
}
