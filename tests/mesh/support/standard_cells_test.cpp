#include <concino/mesh/support/standard_cells.hpp>

#include <concino/mesh/detail/cells/shapes.hpp>

#include <support/unit_cells.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace concino;
using namespace concino::detail;
using namespace concino::testing;

namespace {

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

TEST_CASE("standard cells: tables are closed, oriented outward, and agree with the meshes") {
  for (const cell_shape s : shapes) {
    const standard_cell& t = standard_cell_of(s);
    int runs[8][8] = {};
    for (unsigned f = 0; f < t.num_faces; ++f)
      for (unsigned i = 0; i < t.face_size[f]; ++i) ++runs[t.face_vert[f][i]][t.face_vert[f][(i + 1) % t.face_size[f]]];
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b) {
        CHECK(runs[a][b] <= 1);
        CHECK(runs[a][b] == runs[b][a]);
      }
    CHECK(six_times_volume(s, first_ids(t.num_verts).data(), unit_cell(s)) == doctest::Approx(six_volumes_of(s)));
  }
  for (unsigned f = 0; f < 4; ++f)
    for (unsigned i = 0; i < 3; ++i) CHECK(standard_cell_of(cell_shape::tet).face_vert[f][i] == tet_shape::face_vert[f][i]);
  for (unsigned f = 0; f < 6; ++f)
    for (unsigned i = 0; i < 4; ++i) CHECK(standard_cell_of(cell_shape::hex).face_vert[f][i] == hex_shape::face_vert[f][i]);
}

TEST_CASE("standard cells: the verts of an inverted cell are reordered, those of a flat one are not") {
  for (const cell_shape s : shapes) {
    const standard_cell& t = standard_cell_of(s);
    auto points = unit_cell(s);
    auto v = first_ids(t.num_verts);
    CHECK_FALSE(make_volume_positive(s, v.data(), points));
    CHECK(v == first_ids(t.num_verts));
    for (vec3& p : points) p.x = -p.x;
    CHECK(make_volume_positive(s, v.data(), points));
    CHECK(six_times_volume(s, v.data(), points) == doctest::Approx(six_volumes_of(s)));
    CHECK_FALSE(make_volume_positive(s, v.data(), points));
    v = first_ids(t.num_verts);
    for (vec3& p : points) p.z = 0;
    CHECK_FALSE(make_volume_positive(s, v.data(), points));
    CHECK(v == first_ids(t.num_verts));
  }
}

TEST_CASE("standard cells: compare_cycles compares up to rotation and reversal") {
  const auto a = ids({4, 7, 1, 9});
  CHECK(compare_cycles(a.data(), ids({1, 9, 4, 7}).data(), 4) == 1);
  CHECK(compare_cycles(a.data(), ids({7, 4, 9, 1}).data(), 4) == -1);
  CHECK(compare_cycles(a.data(), ids({4, 1, 7, 9}).data(), 4) == 0);
  CHECK(compare_cycles(a.data(), ids({4, 7, 1, 8}).data(), 4) == 0);
}
