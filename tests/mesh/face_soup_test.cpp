#include <concino/mesh/face_soup.hpp>

#include <concino/mesh/to_polyhedra.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <array>

using namespace concino;
using namespace concino::detail;

TEST_CASE("face_soup: finds common faces, but not equal verts in another cyclic order") {
  // two tets at one face, and a third one that has the face in the same orientation
  cell_arrays c{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}}, {}, 4};
  for (const int v : {0, 1, 2, 3, 0, 2, 1, 4}) c.verts.push_back(vert_id{v});
  const polyhedra_arrays two = to_polyhedra(cell_arrays(c));
  CHECK(two.num_faces() == 7);
  CHECK(two.num_polys() == 2);
  CHECK(two.poly_offsets == std::vector<std::uint32_t>{0, 4, 8});
  CHECK(two.poly_faces[4] == face_id{0});
  CHECK(two.outward == std::vector<std::uint8_t>{1, 1, 1, 1, 0, 1, 1, 1});
  for (const int v : {0, 1, 2, 4}) c.verts.push_back(vert_id{v});
  const polyhedra_arrays three = to_polyhedra(std::move(c));
  CHECK(three.num_faces() == 7);
  CHECK(three.outward[8] == 1);

  face_soup soup;
  for (const auto& face : {std::array{0u, 1u, 2u, 3u}, std::array{0u, 2u, 1u, 3u}, std::array{3u, 2u, 1u, 0u}}) {
    for (const unsigned v : face) soup.face_verts.push_back(vert_id{v});
    soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_verts.size()));
  }
  soup.poly_offsets.push_back(3);
  const auto m = std::move(soup).unite(std::vector<vec3>(4));
  CHECK(m.num_faces() == 2);
  CHECK(m.poly_faces == std::vector<face_id>{face_id{0}, face_id{1}, face_id{0}});
  CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 0});
  CHECK(to_polyhedra(cell_arrays{}).num_polys() == 0);
}

TEST_CASE("face_soup: a triangle and a quad with its verts are two faces") {
  face_soup soup;
  for (const auto& face : {std::vector{0u, 1u, 2u}, {0u, 1u, 2u, 3u}, {2u, 1u, 0u}, {3u, 2u, 1u, 0u}}) {
    for (const unsigned v : face) soup.face_verts.push_back(vert_id{v});
    soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_verts.size()));
  }
  soup.poly_offsets.push_back(4);
  const auto m = std::move(soup).unite(std::vector<vec3>(4));
  CHECK(m.face_offsets == std::vector<std::uint32_t>{0, 3, 7});
  CHECK(m.poly_faces == std::vector<face_id>{face_id{0}, face_id{1}, face_id{0}, face_id{1}});
  CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 0, 0});
}

TEST_CASE("face_soup: a triangle never equals a quad, whatever face follows it") {
  for (const bool triangle_first : {false, true}) {
    std::vector<std::vector<unsigned>> lists = {{0, 1, 2}, {3, 0, 1}, {0, 1, 2, 3}};
    if (!triangle_first) std::swap(lists[0], lists[2]);
    face_soup soup;
    for (const auto& face : lists) {
      for (const unsigned v : face) soup.face_verts.push_back(vert_id{v});
      soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_verts.size()));
    }
    soup.poly_offsets.push_back(3);
    CHECK(std::move(soup).unite(std::vector<vec3>(4)).num_faces() == 3);
  }
}

TEST_CASE("face_soup: n^3 hexes have 3 n^2 (n + 1) faces") {
  for (const unsigned n : {1u, 2u, 3u}) {
    const auto m = to_polyhedra(testing::hex_grid(n));
    CHECK(m.num_polys() == n * n * n);
    CHECK(m.num_faces() == 3 * n * n * (n + 1));
    CHECK(m.face_verts.size() == 4 * m.num_faces());
  }
}
