// Writes pages of one mesh and its field through the native mesh, OpenMesh, CGAL and views of arrays, which pages.mjs compares:
//   same_pages <folder>

#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/adapters/eigen.hpp>
#include <concino/adapters/openmesh.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>
#include <concino/render.hpp>

#include <CGAL/Simple_cartesian.h>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <cmath>
#include <string>
#include <vector>

namespace cn = concino;

namespace {

struct in_doubles : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};

template<class M>
void write_page(const M& m, const std::string& path) {
  auto u = cn::make_vert_map<double>(m, 0.0);
  for (const auto v : cn::verts(m)) u[v] = std::sin(3 * cn::to_vec3(cn::point(m, v)).x) + cn::to_vec3(cn::point(m, v)).y;
  cn::scene s;
  s.add(m, {.field = u, .isolines = 8, .edges = true, .inspect = true, .name = "ring"});
  cn::save_html(s, path, {.camera = cn::view_options{.towards = {0.4, 0.7, 1}}});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = std::string(argv[1]) + "/same_";
  const auto native = cn::make_torus<cn::trimesh>({.cells = {18, 9}});
  write_page(native, folder + "native.html");

  OpenMesh::TriMesh_ArrayKernelT<in_doubles> open;
  CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> cgal;
  Eigen::MatrixX3d points(static_cast<int>(cn::num_verts(native)), 3);
  Eigen::MatrixX3i triangles(static_cast<int>(cn::num_polys(native)), 3);
  for (const auto v : cn::verts(native)) {
    const cn::vec3 x = cn::point(native, v);
    open.add_vertex({x.x, x.y, x.z});
    cgal.add_vertex({x.x, x.y, x.z});
    points.row(static_cast<int>(v.raw())) << x.x, x.y, x.z;
  }
  for (const auto p : cn::polys(native)) {
    const auto& ring = cn::adj_p2v(native, p);
    std::vector<OpenMesh::VertexHandle> in_open;
    std::vector<CGAL::SM_Vertex_index> in_cgal;
    int k = 0;
    for (const auto v : ring) {
      in_open.emplace_back(static_cast<int>(v.raw()));
      in_cgal.emplace_back(v.raw());
      triangles(static_cast<int>(p.raw()), k++) = static_cast<int>(v.raw());
    }
    open.add_face(in_open);
    cgal.add_face(in_cgal);
  }
  write_page(open, folder + "openmesh.html");
  write_page(cgal, folder + "cgal.html");
  write_page(cn::view_tri(points, triangles), folder + "arrays.html");
}
