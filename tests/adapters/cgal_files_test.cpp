// A second opinion on PLY and STL files: CGAL reads ours, and we read those of CGAL.
#include <concino/io/load.hpp>
#include <concino/io/save.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <doctest/doctest.h>

#include <fstream>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using soup_point = CGAL::Simple_cartesian<double>::Point_3;
struct cgal_soup {
  std::vector<soup_point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

/// Whether a mesh has these points, to so many parts of one, and these polygons.
bool is_same(const polygonmesh& ours, const cgal_soup& theirs, double within) {
  if (num_verts(ours) != theirs.points.size() || num_polys(ours) != theirs.polygons.size()) return false;
  bool is = true;
  for (const vert_id v : verts(ours)) {
    const soup_point& q = theirs.points[v.raw()];
    is = is && norm(point(ours, v) - vec3{q.x(), q.y(), q.z()}) <= within;
  }
  for (const poly_id p : polys(ours)) {
    std::vector<std::size_t> here;
    for (const vert_id v : adj_p2v(ours, p)) here.push_back(v.raw());
    is = is && here == theirs.polygons[p.raw()];
  }
  return is;
}

template<class Read>
cgal_soup read_by_cgal(const std::string& path, bool binary, const Read& read) {
  cgal_soup soup;
  std::ifstream in(path, std::ios::binary);
  if (binary) CGAL::IO::set_binary_mode(in);
  CHECK(read(in, soup));
  return soup;
}
template<class Write>
void write_by_cgal(const std::string& path, bool binary, const Write& write) {
  std::ofstream out(path, std::ios::binary);
  if (binary) CGAL::IO::set_binary_mode(out);
  else out.precision(17);
  CHECK(write(out));
}

}  // namespace

TEST_CASE("cgal_files: CGAL reads PLY and STL files of ours, and we read those of CGAL") {
  const temporary_folder dir;
  for (const bool binary : {false, true}) {
    CAPTURE(binary);
    polygonmesh m = grid<polygonmesh>(3);
    for (vec3& p : m.points()) p = {p.x + 0.1, p.y / 3, p.x * p.y};
    save(m, dir / "ours.ply", {.binary = binary});
    const cgal_soup ply = read_by_cgal(dir / "ours.ply", binary, [](std::istream& in, cgal_soup& s) { return CGAL::IO::read_PLY(in, s.points, s.polygons); });
    CHECK(is_same(m, ply, 0));
    write_by_cgal(dir / "theirs.ply", binary, [&](std::ostream& out) { return CGAL::IO::write_PLY(out, ply.points, ply.polygons); });
    CHECK(is_same(load<polygonmesh>(dir / "theirs.ply"), ply, 1e-15));

    polygonmesh triangles(grid_arrays<trimesh>(3));
    for (vec3& p : triangles.points()) p = {p.x + 0.1, p.y / 3, p.x * p.y};
    save(triangles, dir / "ours.stl", {.binary = binary});
    const cgal_soup stl = read_by_cgal(dir / "ours.stl", binary, [](std::istream& in, cgal_soup& s) { return CGAL::IO::read_STL(in, s.points, s.polygons); });
    CHECK(is_same(load<polygonmesh>(dir / "ours.stl"), stl, 1e-6));
    write_by_cgal(dir / "theirs.stl", binary, [&](std::ostream& out) { return CGAL::IO::write_STL(out, stl.points, stl.polygons); });
    CHECK(is_same(load<polygonmesh>(dir / "theirs.stl"), stl, 1e-6));
  }
}
