// Add shortest paths and harmonic maps to a CGAL program, by the two lines marked below. The mesh is CGAL's and is not copied. CGAL's indices name vertices
// and faces, and results go into CGAL's property maps. Removed faces do not count from the moment they are removed, without collect_garbage().
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/fields.hpp>
#include <concino/graph.hpp>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/generators.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cn = concino;

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Vertex = Mesh::Vertex_index;

int main() {
  // A hill of 24 x 24 squares, each cut into two triangles, with a lake at its foot, where there are no faces.
  Mesh m;
  const auto on_hill = [](double x, double y) { return Point(x, y, 6 * std::exp(-0.02 * ((x - 12) * (x - 12) + (y - 12) * (y - 12)))); };
  CGAL::make_grid(24, 24, m, [&](unsigned i, unsigned j) { return on_hill(i, j); }, true);
  std::vector<Mesh::Face_index> lake;
  for (auto f : m.faces()) {
    const Point p = m.point(m.target(m.halfedge(f)));
    if (std::abs(p.x() - 5) < 2.5 && std::abs(p.y() - 19) < 2.5) lake.push_back(f);
  }
  for (auto f : lake) CGAL::Euler::remove_face(m.halfedge(f), m);
  const auto at = [&](double x, double y) {
    return *std::find_if(m.vertices_begin(), m.vertices_end(), [&](Vertex v) { return m.point(v) == on_hill(x, y); });
  };
  const Vertex home = at(0, 24), summit = at(12, 12), far = at(24, 0);

  const auto distance = cn::dijkstra(m, home);                              // one line: the distance of every vertex from home
  const auto warmth = cn::harmonic_map(m, {{home, 20.0}, {summit, -5.0}});  // and another: the temperature, warm at home and cold on the summit

  fmt::print("{} vertices, {} faces, {} removed\n", m.number_of_vertices(), m.number_of_faces(), m.number_of_removed_faces());
  fmt::print("from home to the summit: {:.4f}, to the far corner: {:.4f}\n", distance[summit], distance[far]);
  fmt::print("temperature in the far corner: {:.4f}\n", warmth[far]);

  // Climbing costs more. Anything callable can give the lengths, and a property map of CGAL stores the predecessors on the paths.
  auto before = m.add_property_map<Vertex, Vertex>("v:before").first;
  const auto effort = [&](Vertex v, Vertex w) {
    const auto step = m.point(w) - m.point(v);
    return std::sqrt(step.squared_length()) + 3 * std::abs(step.z());
  };
  const auto tiring = cn::dijkstra(m, home, effort, {.predecessors = &before});
  double highest = 0;
  for (Vertex v = far; v != home; v = before[v]) highest = std::max(highest, m.point(v).z());
  fmt::print("the easiest path to the far corner costs {:.4f} and climbs no higher than {:.4f}\n", tiring[far], highest);
}
