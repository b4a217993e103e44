#include <concino/mesh/standard_cells.hpp>

#include <doctest/doctest.h>

#include <array>
#include <random>

using namespace concino;
using namespace concino::detail;

namespace {

const cell_shape shapes[] = {cell_shape::tet, cell_shape::hex, cell_shape::prism, cell_shape::pyramid};

/// One cell of each shape with unit edges, in the standard order.
std::vector<vec3> unit_cell(cell_shape s) {
  const std::vector<vec3> cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  if (s == cell_shape::tet) return {cube[0], cube[1], cube[3], cube[4]};
  if (s == cell_shape::prism) return {cube[0], cube[1], cube[3], cube[4], cube[5], cube[7]};
  if (s == cell_shape::pyramid) return {cube[0], cube[1], cube[2], cube[3], cube[4]};
  return cube;
}
double six_volumes_of(cell_shape s) { return s == cell_shape::tet ? 1 : s == cell_shape::prism ? 3 : s == cell_shape::pyramid ? 2 : 6; }

std::vector<vert_id> ids(std::initializer_list<unsigned> list) {
  std::vector<vert_id> r;
  for (const unsigned i : list) r.push_back(vert_id{i});
  return r;
}
std::vector<vert_id> first_ids(unsigned n) {
  std::vector<vert_id> r;
  for (unsigned i = 0; i < n; ++i) r.push_back(vert_id{i});
  return r;
}

}  // namespace

TEST_CASE("standard cells: tables are closed, wound outward, and agree with those of the meshes") {
  for (const cell_shape s : shapes) {
    const standard_cell& t = table_of(s);
    int runs[8][8] = {};
    for (unsigned f = 0; f < t.num_faces; ++f)
      for (unsigned i = 0; i < t.face_size[f]; ++i) ++runs[t.face_vert[f][i]][t.face_vert[f][(i + 1) % t.face_size[f]]];
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b) {
        CHECK(runs[a][b] <= 1);
        CHECK(runs[a][b] == runs[b][a]);
      }
    CHECK(six_volumes(s, first_ids(t.num_verts).data(), unit_cell(s)) == doctest::Approx(six_volumes_of(s)));
  }
  for (unsigned f = 0; f < 4; ++f)
    for (unsigned i = 0; i < 3; ++i) CHECK(table_of(cell_shape::tet).face_vert[f][i] == tet_shape::face_vert[f][i]);
  for (unsigned f = 0; f < 6; ++f)
    for (unsigned i = 0; i < 4; ++i) CHECK(table_of(cell_shape::hex).face_vert[f][i] == hex_shape::face_vert[f][i]);
}

TEST_CASE("standard cells: a mirrored cell is put right once, a flat one left alone") {
  for (const cell_shape s : shapes) {
    const standard_cell& t = table_of(s);
    auto points = unit_cell(s);
    auto v = first_ids(t.num_verts);
    CHECK_FALSE(make_positive(s, v.data(), points));
    CHECK(v == first_ids(t.num_verts));
    for (vec3& p : points) p.x = -p.x;
    CHECK(make_positive(s, v.data(), points));
    CHECK(six_volumes(s, v.data(), points) == doctest::Approx(six_volumes_of(s)));
    CHECK_FALSE(make_positive(s, v.data(), points));
    v = first_ids(t.num_verts);
    for (vec3& p : points) p.z = 0;
    CHECK_FALSE(make_positive(s, v.data(), points));
    CHECK(v == first_ids(t.num_verts));
  }
}

TEST_CASE("compare_cycles") {
  const auto a = ids({4, 7, 1, 9});
  CHECK(compare_cycles(a.data(), ids({1, 9, 4, 7}).data(), 4) == 1);
  CHECK(compare_cycles(a.data(), ids({7, 4, 9, 1}).data(), 4) == -1);
  CHECK(compare_cycles(a.data(), ids({4, 1, 7, 9}).data(), 4) == 0);
  CHECK(compare_cycles(a.data(), ids({4, 7, 1, 8}).data(), 4) == 0);
}

TEST_CASE("cell_recogniser: every shape from its faces, in any order and from any corner") {
  std::mt19937 random(5);
  cell_recogniser known;
  for (const cell_shape s : shapes)
    for (int round = 0; round < 50; ++round) {
      const standard_cell& t = table_of(s);
      std::vector<unsigned> order(t.num_faces), name(t.num_verts);
      std::iota(order.begin(), order.end(), 0u);
      std::iota(name.begin(), name.end(), 100u);
      std::shuffle(order.begin(), order.end(), random);
      std::shuffle(name.begin(), name.end(), random);
      known.clear();
      for (const unsigned f : order) {
        known.begin_face();
        const auto turn = static_cast<unsigned>(random() % t.face_size[f]);
        const bool backwards = random() % 2;
        for (unsigned i = 0; i < t.face_size[f]; ++i) {
          const unsigned k = backwards ? t.face_size[f] - 1 - i : i;
          known.push(vert_id{name[t.face_vert[f][(k + turn) % t.face_size[f]]]});
        }
        if (backwards) known.reverse_face();
      }
      REQUIRE(known.recognise() == s);
      // positive as listed: the same shape in the points of the original
      std::vector<vec3> points(200);
      for (unsigned i = 0; i < t.num_verts; ++i) points[name[i]] = unit_cell(s)[i];
      CHECK(six_volumes(s, known.cell, points) == doctest::Approx(six_volumes_of(s)));
    }
}

TEST_CASE("cell_recogniser: cells that only count like a standard one are general") {
  cell_recogniser known;
  const auto recognise = [&](std::initializer_list<std::initializer_list<unsigned>> faces) {
    known.clear();
    for (const auto& f : faces) {
      known.begin_face();
      for (const unsigned v : f) known.push(vert_id{v});
    }
    return known.recognise();
  };
  CHECK(recognise({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) == cell_shape::tet);
  CHECK(recognise({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 4}}) == cell_shape::general);
  CHECK(recognise({{0, 2, 1}, {0, 2, 1}, {0, 3, 2}, {1, 2, 3}}) == cell_shape::general);
  CHECK(recognise({{0, 2, 1}, {0, 1, 2}, {0, 2, 1}, {0, 1, 2}}) == cell_shape::general);
  CHECK(recognise({{0, 2, 1}, {0, 1, 3}, {0, 3, 2}}) == cell_shape::general);
  CHECK(recognise({{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7}, {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 8}}) == cell_shape::general);
  CHECK(recognise({{0, 1, 2, 3, 4}, {0, 1, 5}, {1, 2, 5}, {2, 3, 5}, {3, 4, 5}, {4, 0, 5}}) == cell_shape::general);
  CHECK(recognise({}) == cell_shape::general);
}

TEST_CASE("face_soup: common faces are found, of equal verts in another cycle too are not") {
  // two tets on one face, a third whose copy of it runs the same way
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
