// CGAL::Surface_mesh obeys all laws in every state after editing, and algorithms take and return its indices.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/graph.hpp>
#include <concino/validate/check_laws.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <doctest/doctest.h>
#include <support/cgal.hpp>
#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/models.hpp>

#include <algorithm>
#include <iterator>
#include <random>
#include <ranges>

using namespace concino;

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using surface_mesh = CGAL::Surface_mesh<kernel::Point_3>;
using vertex = surface_mesh::Vertex_index;
using edge = surface_mesh::Edge_index;
using face = surface_mesh::Face_index;

/// A class as users derive it: its members have names of CGAL's members and another meaning.
class derived : public surface_mesh {
 public:
  int next = 0, point = 0;
};
class twice_derived : public derived {};
class hidden : surface_mesh {};
class of_triangles : public surface_mesh {};

template<class R, class X>
concept walkable = std::ranges::forward_range<R> && std::same_as<std::ranges::range_value_t<R>, X>;

}  // namespace

template<>
struct concino::mesh_traits<of_triangles> : concino::mesh_traits<surface_mesh> { static constexpr int arity = 3; };

static_assert(testing::models_in_all_forms<surface_mesh>(testing::surface | testing::embedded | testing::mutable_points));
static_assert(testing::models_in_all_forms<derived>(testing::models<surface_mesh>()));
static_assert(testing::models_in_all_forms<twice_derived>(testing::models<surface_mesh>()));
static_assert(testing::models_in_all_forms<of_triangles>(testing::models<surface_mesh>() | testing::fixed_arity));
static_assert(!AnyMesh<hidden> && !AnyMesh<surface_mesh*> && !AnyMesh<vertex> && !AnyMesh<kernel::Point_3> && !AnyMesh<void>);

static_assert(std::same_as<vert_t<derived>, vertex> && std::same_as<edge_t<derived>, edge> && std::same_as<poly_t<derived>, face>);
static_assert(walkable<decltype(verts(surface_mesh())), vertex> && walkable<decltype(edges(surface_mesh())), edge> &&
              walkable<decltype(polys(surface_mesh())), face>);
static_assert(walkable<decltype(adj_v2v(surface_mesh(), vertex())), vertex> && walkable<decltype(adj_v2e(surface_mesh(), vertex())), edge> &&
              walkable<decltype(adj_v2p(surface_mesh(), vertex())), face> && walkable<decltype(adj_e2v(surface_mesh(), edge())), vertex> &&
              walkable<decltype(adj_e2p(surface_mesh(), edge())), face> && walkable<decltype(adj_p2v(surface_mesh(), face())), vertex> &&
              walkable<decltype(adj_p2e(surface_mesh(), face())), edge> && walkable<decltype(adj_p2p(surface_mesh(), face())), face>);

namespace {

/// Checks that all laws hold, and that the counts are those of the elements.
template<class M>
void check_sound(const M& m) {
  for (const auto& b : check_laws(m)) FAIL_CHECK(b.law << ": " << b.what);
  CHECK(num_verts(m) == m.number_of_vertices());
  CHECK(num_edges(m) == m.number_of_edges());
  CHECK(num_polys(m) == m.number_of_faces());
  CHECK(m.is_valid(false));
}

/// Distances from the vert with the smallest coordinates, in ascending order, so that they do not depend on the numbers of the verts.
std::vector<double> distances(const surface_mesh& m) {
  const auto all = verts(m);
  const vertex first = *std::min_element(all.begin(), all.end(), [&](vertex v, vertex w) { return m.point(v) < m.point(w); });
  std::vector<double> r;
  const auto d = dijkstra(m, first);
  for (const vertex v : all) r.push_back(d[v]);
  std::sort(r.begin(), r.end());
  return r;
}

/// Fans of triangles that share only a vert.
surface_arrays fans() {
  surface_arrays s{{}, {}, {}, 3};
  for (int i = 0; i < 8; ++i) s.points.push_back({i, i * i, 0});
  for (const unsigned v : {0u, 1u, 2u, 0u, 2u, 3u, 0u, 4u, 5u, 0u, 6u, 7u}) s.verts.push_back(vert_id{v});
  return s;
}

}  // namespace

TEST_CASE("Surface_mesh: laws hold for empty, open, closed and disconnected meshes, isolated verts, several fans") {
  check_sound(surface_mesh());
  check_sound(testing::cgal_surface<kernel::Point_3>(testing::triangle_grid(4)));
  check_sound(testing::cgal_surface<kernel::Point_3>(testing::polygon_grid(3)));
  check_sound(testing::cgal_surface<kernel::Point_3>(testing::two_grids_arrays<quadmesh>(3)));
  check_sound(testing::cgal_surface<kernel::Point_3>(testing::rolled_grid(3, 4)));
  check_sound(testing::cgal_surface<kernel::Point_3>(testing::holed_board(2)));
  check_sound(testing::cgal_surface<kernel::Point_3>(fans()));
}

TEST_CASE("Surface_mesh: removed elements are not part of the mesh, before and after garbage collection and reuse") {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    surface_mesh m = testing::cgal_surface<kernel::Point_3>(
        round % 3 == 0 ? testing::polygon_grid(3) : round % 3 == 1 ? testing::triangle_grid(5) : testing::rolled_grid(4, 5));
    m.set_recycle_garbage(round % 2 == 0);
    m.add_vertex(kernel::Point_3(9, 9, 9));
    for (int step = 0; step < 12 && m.number_of_faces() > 0; ++step) {
      std::vector<face> all(polys(m).begin(), polys(m).end());
      const face f = all[random() % all.size()];
      switch (random() % 4) {
        case 0: m.point(m.target(CGAL::Euler::add_center_vertex(m.halfedge(f), m))) = kernel::Point_3(step, round, 1); break;
        case 1:
          if (round % 3 == 1 && CGAL::Euler::does_satisfy_link_condition(m.edge(m.halfedge(f)), m)) {
            CGAL::Euler::collapse_edge(m.edge(m.halfedge(f)), m);
            break;
          }
          [[fallthrough]];
        default: CGAL::Euler::remove_face(m.halfedge(f), m);
      }
      check_sound(m);
    }
    if (num_verts(m) == 0) continue;
    const auto with_garbage = distances(m);
    m.collect_garbage();
    check_sound(m);
    CHECK(distances(m) == with_garbage);
  }
}

TEST_CASE("Surface_mesh: laws hold if everything is removed, for joined meshes and for copies") {
  surface_mesh m = testing::cgal_surface<kernel::Point_3>(testing::triangle_grid(2));
  for (int i = 0; i < 8; ++i) CGAL::Euler::remove_face(m.halfedge(*polys(m).begin()), m);
  CHECK(m.has_garbage());
  CHECK(num_verts(m) == 0);
  CHECK(vert_index_bound(m) == 9);
  check_sound(m);
  m += testing::cgal_surface<kernel::Point_3>(fans());
  check_sound(m);
  const surface_mesh copy = m;
  check_sound(copy);
  CHECK(num_polys(copy) == 4);
}

TEST_CASE("Surface_mesh: contains is true exactly for elements of the mesh") {
  surface_mesh m = testing::cgal_surface<kernel::Point_3>(testing::triangle_grid(2));
  CHECK(contains(m, vertex(8)));
  CHECK(!contains(m, vertex(9)));
  CHECK(!contains(m, vertex()));
  CHECK(!contains(m, edge()));
  CHECK(!contains(m, face()));
  CHECK(contains(m, edge(15)));
  CHECK(!contains(m, edge(16)));
  CHECK(contains(m, face(0)));
  const face f(0);
  const edge border(m.edge(m.halfedge(vertex(1), vertex(0))));
  CGAL::Euler::remove_face(m.halfedge(f), m);
  CHECK(!contains(m, f));
  CHECK(!contains(m, border));
  CHECK_THROWS_AS(dijkstra(m, f), invalid_mesh);
  CHECK_THROWS_AS(bfs(m, vertex(77)), invalid_mesh);
}

TEST_CASE("Surface_mesh: algorithms take and return handles") {
  const surface_mesh m = testing::cgal_surface<kernel::Point_3>(testing::triangle_grid(4));
  const trimesh native(testing::triangle_grid(4));
  const vertex a(0), b(24);
  const auto d = dijkstra(m, a);
  const auto expected = dijkstra(native, vert_id{0});
  for (const vertex v : m.vertices()) CHECK(d[v] == expected[vert_id{v.idx()}]);
  const std::vector<vertex> path = shortest_path(m, a, b);
  CHECK(path.front() == a);
  CHECK(path.back() == b);
  const auto hops = bfs(m, face(0));
  const auto expected_hops = bfs(native, poly_id{0});
  for (const face f : m.faces()) CHECK(hops[f] == expected_hops[poly_id{f.idx()}]);
  auto length = make_edge_map<double>(m);
  for (const edge e : m.edges()) length[e] = 2;
  CHECK(length[m.edge(m.halfedge(a))] == 2);
  // The option may_cross takes CGAL's edges.
  const auto barred = bfs(m, face(0), {.may_cross = [&](edge e) { return m.is_border(e) || e != m.edge(m.halfedge(face(0))); }});
  CHECK(num_polys(m) == 32);
  CHECK(barred[face(0)] == 0);
}

TEST_CASE("Surface_mesh: the ring of a poly has CGAL's order, that of an edge is source and target") {
  const surface_mesh m = testing::cgal_surface<kernel::Point_3>(testing::polygon_grid(2));
  for (const face f : m.faces()) {
    std::vector<vertex> ring, theirs;
    for (const vertex v : adj_p2v(m, f)) ring.push_back(v);
    for (const vertex v : m.vertices_around_face(m.halfedge(f))) theirs.push_back(v);
    CHECK(ring == theirs);
  }
  for (const edge e : m.edges()) {
    const auto ends = adj_e2v(m, e);
    CHECK(*ends.begin() == m.source(m.halfedge(e)));
    CHECK(*(ends.begin() + 1) == m.target(m.halfedge(e)));
  }
}

TEST_CASE("Surface_mesh: derived classes work, and may declare that all polys are triangles") {
  derived m;
  static_cast<surface_mesh&>(m) = testing::cgal_surface<kernel::Point_3>(testing::triangle_grid(3));
  CHECK(check_laws(m).empty());
  CHECK(bfs(m, vertex(0))[vertex(15)] == bfs(static_cast<const surface_mesh&>(m), vertex(0))[vertex(15)]);
  of_triangles t;
  static_cast<surface_mesh&>(t) = m;
  static_assert(TriMesh<of_triangles>);
  CHECK(check_laws(t).empty());
}

TEST_CASE("Surface_mesh: two edges with the same ends are found by check_laws") {
  surface_mesh m;
  const vertex a = m.add_vertex(), b = m.add_vertex();
  const auto h = m.add_edge(a, b), k = m.add_edge(a, b);
  const auto link = [&](auto x, auto y, face f) {  // a polygon of the half-edges x and y
    m.set_next(x, y);
    m.set_next(y, x);
    m.set_face(x, f);
    m.set_face(y, f);
    m.set_halfedge(f, x);
  };
  link(h, m.opposite(k), m.add_face());
  link(k, m.opposite(h), m.add_face());
  m.set_halfedge(a, m.opposite(h));
  m.set_halfedge(b, h);
  REQUIRE(m.is_valid(false));
  CHECK(!check_laws(m).empty());
}
