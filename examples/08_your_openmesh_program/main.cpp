// Add shortest paths and harmonic maps to an OpenMesh program, by the two lines marked below. The mesh class is derived from one of OpenMesh, and the mesh is
// not copied. OpenMesh's handles name verts and faces, and its properties are read and written in place. Deleted faces do not count from the moment
// they are deleted, without garbage_collection().
#include <concino/adapters/openmesh.hpp>
#include <concino/fields.hpp>
#include <concino/graph.hpp>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace cn = concino;
using OpenMesh::EdgeHandle;
using OpenMesh::VertexHandle;

struct Traits : OpenMesh::DefaultTraitsDouble {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};

/// A pipe of radius 1 along the z-axis: length + 1 rings of `around` verts.
class Pipe : public OpenMesh::TriMesh_ArrayKernelT<Traits> {
  int around_;

 public:
  Pipe(int around, int length) : around_(around) {
    for (int k = 0; k <= length; ++k)
      for (int i = 0; i < around; ++i) add_vertex({std::cos(6.283185307 * i / around), std::sin(6.283185307 * i / around), double(k)});
    for (int k = 0; k < length; ++k)
      for (int i = 0; i < around; ++i) {
        add_face(at(i, k), at(i + 1, k), at(i + 1, k + 1));
        add_face(at(i, k), at(i + 1, k + 1), at(i, k + 1));
      }
  }
  VertexHandle at(int i, int k) const { return VertexHandle(k * around_ + i % around_); }
};

int main() {
  Pipe m(24, 20);
  // Cut a slit into the upper side, half way along: delete 16 of the 24 squares of a ring, two triangles each.
  for (unsigned i = 0; i < 16; ++i)
    for (unsigned half : {0u, 1u}) m.delete_face(m.face_handle(2 * (10 * 24 + (i + 22) % 24) + half));
  std::vector<VertexHandle> mouth;
  std::vector<std::pair<VertexHandle, double>> ends;
  for (int i = 0; i < 24; ++i) {
    mouth.push_back(m.at(i, 0));
    ends.push_back({m.at(i, 0), 100.0});
    ends.push_back({m.at(i, 20), 0.0});
  }

  const auto distance = cn::dijkstra(m, mouth);      // one line: the distance of every vert from the mouth of the pipe
  const auto heat = cn::harmonic_map(m, ends);       // and another: the temperature, hot at one end and cold at the other

  fmt::print("{} vertices, {} of {} faces are left\n", cn::num_verts(m), cn::num_polys(m), m.n_faces());
  const VertexHandle behind = m.at(6, 11), below = m.at(18, 11);
  fmt::print("behind the slit: {:.4f} away, {:.4f} degrees; below it: {:.4f} away, {:.4f} degrees\n", distance[behind], heat[behind], distance[below],
             heat[below]);

  // A property of OpenMesh can give the lengths: here the lower half of the pipe is rough. Another property stores the predecessors on the paths.
  OpenMesh::EPropHandleT<double> resistance;
  m.add_property(resistance, "resistance");
  for (EdgeHandle e : m.edges()) m.property(resistance, e) = m.calc_edge_length(e) * (m.calc_edge_midpoint(e)[1] < 0 ? 3 : 1);
  OpenMesh::VProp<VertexHandle> before(m);
  const auto slow = cn::as_map(m, resistance);
  const auto effort = [&](VertexHandle v, VertexHandle w) { return slow[m.edge_handle(m.find_halfedge(v, w))]; };
  const auto tiring = cn::dijkstra(m, m.at(6, 0), effort, {.predecessors = &before});

  const auto path = cn::path_to(before, m.at(6, 20));
  double lowest = 1;
  for (VertexHandle v : path) lowest = std::min(lowest, m.point(v)[1]);
  fmt::print("the easiest path through the pipe costs {:.4f}, has {} edges, and goes down to y = {:.4f}\n", tiring[path.back()], path.size() - 1, lowest);
}
