// Views of spans and containers, polygons and polyhedra among them, pass the conformance kit.
#include <concino/adapters/doctest.hpp>
#include <concino/adapters/span.hpp>
#include <concino/mesh.hpp>

#include <array>
#include <vector>

namespace cn = concino;

TEST_CASE("spans: triangles and polygons conform") {
  const std::vector<std::array<double, 3>> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}, {9, 9, 9}};
  const std::vector<std::array<int, 3>> triangles = {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}};
  cn::check_conformance([&] { return cn::view_tri(points, triangles); });
  const std::vector<int> offsets = {0, 4, 7, 10}, corners = {0, 1, 2, 3, 1, 4, 2, 4, 5, 2};
  cn::check_conformance([&] { return cn::view_polygons(points, offsets, corners); });
}

TEST_CASE("spans: polyhedra conform") {
  const std::vector<std::array<float, 3>> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
  const std::vector<unsigned> face_offsets = {0, 3, 6, 9, 12, 15, 18, 21}, face_verts = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 1, 4, 3, 1, 2, 4, 2, 3, 4};
  const std::vector<unsigned> poly_offsets = {0, 4, 8}, poly_faces = {0, 1, 2, 3, 3, 4, 5, 6};
  const std::vector<char> outward = {1, 1, 1, 1, 0, 1, 1, 1};
  cn::check_conformance([&] { return cn::view_polyhedra(points, face_offsets, face_verts, poly_offsets, poly_faces, outward); });
}
