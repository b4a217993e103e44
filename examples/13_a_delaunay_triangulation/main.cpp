// Use a Delaunay triangulation of CGAL as a tet mesh. CGAL builds and owns it; one line numbers its elements, and every algorithm for volumes runs on it:
// here a shortest path, a harmonic map between two points, its hull as a surface, and its cells as a mesh of this library.
#include <concino/adapters/cgal_triangulation.hpp>
#include <concino/convert.hpp>
#include <concino/fields.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/mesh.hpp>
#include <concino/mesh/boundary.hpp>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <fmt/core.h>

#include <random>

namespace cn = concino;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

int main() {
  CGAL::Delaunay_triangulation_3<Kernel> t;
  std::mt19937 random(1);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  for (int i = 0; i < 1000; ++i) {
    const double x = unit(), y = unit(), z = unit();
    t.insert(Point(x, y, z));
  }
  const auto a = t.insert(Point(0, 0, 0)), b = t.insert(Point(1, 1, 1));

  const auto m = cn::indexed(t);                                    // the finite cells: a TetMesh
  const auto distance = cn::dijkstra(m, m.vert(a));                 // CGAL's handles go in ...
  const auto path = cn::shortest_path(m, m.vert(a), m.vert(b));
  fmt::print("{} verts, {} edges, {} faces, {} tets\n", cn::num_verts(m), cn::num_edges(m), cn::num_faces(m), cn::num_polys(m));
  fmt::print("from corner to corner: {:.3f}, in {} edges; the straight line has length {:.3f}\n", distance[m.vert(b)], path.size() - 1, std::sqrt(3.0));
  fmt::print("half way: ({:.2f}, {:.2f}, {:.2f})\n", m.handle(path[path.size() / 2])->point().x(), m.handle(path[path.size() / 2])->point().y(),
             m.handle(path[path.size() / 2])->point().z());  // ... and come out

  const auto u = cn::harmonic_map(m, {{m.vert(a), 0.0}, {m.vert(b), 1.0}});
  std::size_t nearer = 0;
  for (const auto v : cn::verts(m)) nearer += u[v] < 0.5;
  fmt::print("by the harmonic map, {} verts are nearer to the first corner, {} to the second\n", nearer, cn::num_verts(m) - nearer);

  const auto hull = cn::boundary(m);
  const auto own = cn::convert<cn::tetmesh>(m);
  fmt::print("the hull: {} triangles of area {:.3f}; the same tets in a tetmesh: volume {:.3f}\n", cn::num_polys(hull), cn::total_measure(hull), cn::total_measure(own));
}
