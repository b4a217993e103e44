// Property maps of CGAL's meshes are maps: algorithms read and write them without copies.
#include <concino/adapters/cgal_polyhedron.hpp>
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/concepts/views.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/graph/property_map.hpp>

#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/graph_traits_Surface_mesh.h>
#include <CGAL/boost/graph/properties_Polyhedron_3.h>

#include <doctest/doctest.h>
#include <support/cgal.hpp>

using namespace concino;

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using surface_mesh = CGAL::Surface_mesh<kernel::Point_3>;
using vertex = surface_mesh::Vertex_index;
using face = surface_mesh::Face_index;
using polyhedron = CGAL::Polyhedron_3<kernel, CGAL::Polyhedron_items_with_id_3>;

}  // namespace

static_assert(ReadableMap<surface_mesh::Property_map<vertex, double>, vertex> && WritableMap<surface_mesh::Property_map<vertex, double>, vertex, double>);
static_assert(WritableMap<const surface_mesh::Property_map<face, int>, face, int> && WritableMap<surface_mesh::Property_map<face, bool>, face, bool>);
static_assert(!ReadableMap<surface_mesh::Property_map<face, int>, vertex*>);

TEST_CASE("CGAL: property maps of Surface_mesh store predecessors, points and lengths") {
  auto m = testing::cgal_surface<kernel::Point_3>(testing::triangle_grid(3));
  const vertex a(0), b(15);
  auto from = m.add_property_map<vertex, vertex>("v:from").first;
  const auto d = dijkstra(m, a, {.predecessors = &from});
  CHECK(d[b] == doctest::Approx(std::sqrt(2.0)));
  CHECK(from[b] == vertex(10));
  CHECK(m.property_map<vertex, vertex>("v:from").first[b] == vertex(10));

  auto flat = m.add_property_map<vertex, kernel::Point_3>("v:flat", kernel::Point_3(0, 0, 0)).first;
  for (const vertex v : m.vertices()) flat[v] = kernel::Point_3(m.point(v).x(), 0, 0);
  CHECK(dijkstra(with_points(m, flat), a)[b] == doctest::Approx(1));

  const auto cost = m.add_property_map<vertex, double>("v:cost", 1.0).first;
  cost[vertex(10)] = 100;
  CHECK(dijkstra(m, a, [&](vertex v, vertex w) { return cost[v] + cost[w]; })[b] == 8);

  const auto closed = m.add_property_map<face, bool>("f:closed", false).first;
  closed[face(1)] = true;
  CHECK(bfs(m, face(0), {.may_enter = [&](face f) { return !closed[f]; }})[face(1)] == -1);
}

TEST_CASE("CGAL: property maps of a polyhedron are maps by handle") {
  const auto sm = testing::cgal_surface<kernel::Point_3>(testing::triangle_grid(3));
  polyhedron p;
  CGAL::copy_face_graph(sm, p);
  CGAL::set_halfedgeds_items_id(p);
  const auto first = p.vertices_begin(), last = std::prev(p.vertices_end());

  const auto points = as_map(get(CGAL::vertex_point, p));
  static_assert(ReadableMap<decltype(points), polyhedron::Vertex_handle>);
  points[first] = kernel::Point_3(-1, -1, 0);
  CHECK(first->point() == kernel::Point_3(-1, -1, 0));
  CHECK(dijkstra(with_points(p, points), first)[last] == dijkstra(p, first)[last]);

  const auto index = as_map(get(boost::vertex_index, p));
  CHECK(index[last] == 15);

  const auto hops = as_map(get(CGAL::dynamic_vertex_property_t<int>(), p));
  static_assert(WritableMap<decltype(hops), polyhedron::Vertex_handle, int>);
  const auto found = bfs(p, first);
  for (const auto v : verts(p)) hops[v] = found[v];
  CHECK(hops[last] == found[last]);

  const auto marked = as_map(get(CGAL::dynamic_edge_property_t<bool>(), p));
  for (const auto e : edges(p)) marked[e] = true;
  CHECK(marked[edge_t<polyhedron>(first->halfedge()->opposite())]);
}
