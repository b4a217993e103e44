#include <concino/mesh/support/face_soup.hpp>

#include <concino/mesh/support/to_polyhedra.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
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

TEST_CASE("face_soup: equal faces are found among any number of faces with the same smallest vert") {
  // 400 triangles and quads of vert 0, then the same again in another order: turned, and every third one reversed
  std::vector<std::vector<unsigned>> faces;
  for (unsigned i = 1; i <= 20; ++i)
    for (unsigned j = 1; j <= 20; ++j) faces.push_back(i % 2 ? std::vector{0u, i, 20 + j} : std::vector{0u, i, 20 + j, 41u});
  const std::size_t n = faces.size();
  face_soup soup;
  const auto add = [&](const std::vector<unsigned>& face) {
    for (const unsigned v : face) soup.face_verts.push_back(vert_id{v});
    soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_verts.size()));
  };
  for (const auto& face : faces) add(face);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t f = k * 7 % n;
    std::vector<unsigned> face = faces[f];
    std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(f % face.size()), face.end());
    if (f % 3 == 0) std::reverse(face.begin(), face.end());
    add(face);
  }
  soup.poly_offsets = {0, static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(2 * n)};
  const polyhedra_arrays m = std::move(soup).unite(std::vector<vec3>(42));
  REQUIRE(m.num_faces() == n);
  for (std::size_t f = 0; f < n; ++f) CHECK(m.poly_faces[f] == face_id{f});
  for (std::size_t k = 0; k < n; ++k) {
    CHECK(m.poly_faces[n + k] == face_id{k * 7 % n});
    CHECK(m.outward[n + k] == (k * 7 % n % 3 != 0));
  }
}

TEST_CASE("face_soup: outward says how the listed faces run") {
  face_soup soup;
  for (const auto& face : {std::array{0u, 1u, 2u}, std::array{2u, 1u, 0u}, std::array{1u, 2u, 0u}}) {
    for (const unsigned v : face) soup.face_verts.push_back(vert_id{v});
    soup.face_offsets.push_back(static_cast<std::uint32_t>(soup.face_verts.size()));
  }
  soup.poly_offsets = {0, 1, 2, 3};
  const polyhedra_arrays m = std::move(soup).unite(std::vector<vec3>(3), {0, 1, 1});
  CHECK(m.num_faces() == 1);
  CHECK(m.outward == std::vector<std::uint8_t>{0, 0, 1});
}
