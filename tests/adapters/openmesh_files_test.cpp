// A second opinion on PLY and STL files: OpenMesh reads ours, and we read those of OpenMesh.
#include <OpenMesh/Core/IO/MeshIO.hh>

#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/kinds.hpp>
#include <support/openmesh.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace concino::testing::om;

namespace {

/// Whether a mesh has the points and polygons of one of OpenMesh, which keeps floats, and writes six digits.
bool is_same(const polygonmesh& ours, const poly_double& theirs) {
  if (num_verts(ours) != theirs.n_vertices() || num_polys(ours) != theirs.n_faces() || num_edges(ours) != theirs.n_edges()) return false;
  bool is = true;
  for (const vert_id v : verts(ours)) {
    const auto& q = theirs.point(OpenMesh::VertexHandle(static_cast<int>(v.raw())));
    is = is && norm(point(ours, v) - vec3{q[0], q[1], q[2]}) < 1e-5;
  }
  for (const poly_id p : polys(ours)) {
    auto corner = theirs.cfv_begin(OpenMesh::FaceHandle(static_cast<int>(p.raw())));
    std::vector<unsigned> here, there;
    for (const vert_id v : adj_p2v(ours, p)) here.push_back(v.raw()), there.push_back(static_cast<unsigned>((corner++)->idx()));
    std::rotate(here.begin(), std::min_element(here.begin(), here.end()), here.end());
    std::rotate(there.begin(), std::min_element(there.begin(), there.end()), there.end());
    is = is && here == there;
  }
  return is;
}

}  // namespace

TEST_CASE("openmesh_files: OpenMesh reads PLY and STL files of ours, and we read those of OpenMesh") {
  const temporary_folder dir;
  for (const bool binary : {false, true})
    for (const std::string extension : {".ply", ".stl"}) {
      CAPTURE(extension);
      CAPTURE(binary);
      polygonmesh m = extension == ".ply" ? grid<polygonmesh>(3) : polygonmesh(grid_arrays<trimesh>(3));
      for (vec3& p : m.points()) p = {p.x + 0.1, p.y / 3, p.x * p.y};
      save(m, dir / ("ours" + extension), {.binary = binary});
      m = load<polygonmesh>(dir / ("ours" + extension));  // .stl numbers verts anew
      poly_double read;
      OpenMesh::IO::Options options;
      REQUIRE(OpenMesh::IO::read_mesh(read, dir / ("ours" + extension), options));
      CHECK(is_same(m, read));
      REQUIRE(OpenMesh::IO::write_mesh(read, dir / ("theirs" + extension), binary ? OpenMesh::IO::Options::Binary : OpenMesh::IO::Options::Default));
      CHECK(is_same(load<polygonmesh>(dir / ("theirs" + extension)), read));
    }
}
