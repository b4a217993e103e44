// The users' meshes of lesson 15 conform, with boundaries, several components and isolated verts, and algorithms give the same results on them as
// on native meshes.
#include <concino/adapters/doctest.hpp>
#include <concino/mesh.hpp>

#include "../../examples/15_test_your_own_mesh/adapters.hpp"

#include <support/soups.hpp>

namespace cn = concino;

TEST_CASE_TEMPLATE("winged edges: a grid with a hole and an isolated vert conforms", M, cn::trimesh, cn::quadmesh) {
  M grid = cn::testing::grid<M>(5);
  cn::remove_poly(grid, cn::poly_id{12});
  std::vector<double> xyz;
  for (const auto v : cn::verts(grid)) {
    const cn::vec3 x = cn::point(grid, v);
    xyz.insert(xyz.end(), {x.x, x.y, x.z});
  }
  xyz.insert(xyz.end(), {9, 9, 9});
  std::vector<std::vector<int>> faces;
  for (const auto p : cn::polys(grid)) {
    faces.emplace_back();
    for (const auto v : cn::adj_p2v(grid, p)) faces.back().push_back(static_cast<int>(v.raw()));
  }
  cn::check_conformance([&] { return wings::Mesh(xyz, faces); });
  const wings::Mesh m(xyz, faces);
  CHECK(cn::num_edges(m) == cn::num_edges(grid));
  const auto ours = cn::dijkstra(m, cn::vert_id{0});
  const auto theirs = cn::dijkstra(grid, cn::vert_id{0});
  for (const auto v : cn::verts(grid)) CHECK(ours[v] == doctest::Approx(theirs[v]).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("half-faces: grids of every kind of volume conform", M, cn::tetmesh, cn::hexmesh, cn::polyhedralmesh) {
  const M grid = cn::testing::grid<M>(2);
  hfm::PolyhedralMesh cells;
  for (const auto v : cn::verts(grid)) {
    const cn::vec3 x = cn::point(grid, v);
    cells.addVertex(static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z));
  }
  cells.addVertex(9, 9, 9);
  for (const auto f : cn::faces(grid)) {
    std::vector<int> corners;
    for (const auto v : cn::adj_f2v(grid, f)) corners.push_back(static_cast<int>(v.raw()));
    cells.addFace(corners);
  }
  for (const auto p : cn::polys(grid)) {
    std::vector<int> halves;
    for (const auto f : cn::adj_p2f(grid, p)) halves.push_back(static_cast<int>(2 * f.raw() + !cn::face_is_outward(grid, p, f)));
    cells.addCell(halves);
  }
  cn::check_conformance([&] { return indexed_volume_of(cells); });
  const indexed_volume_of m(cells);
  CHECK(cn::num_faces(m) == cn::num_faces(grid));
  CHECK(cn::bfs(m, cn::poly_id{0}).values().back() == cn::bfs(grid, cn::poly_id{0}).values().back());
}

TEST_CASE("corner table: a mesh with two components conforms") {
  const CornerTable corners({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 7, 0, 0, 8, 0, 0, 7, 1, 0}, {0, 1, 2, 0, 2, 3, 4, 5, 6});
  cn::check_conformance([&] { return indexed_corners(corners); });
  const indexed_corners m(corners);
  CHECK(cn::connected_components(m).count == 2);
}
