#include <concino/mesh/support/cell_recogniser.hpp>

#include <support/unit_cells.hpp>

#include <doctest/doctest.h>

#include <numeric>
#include <random>

using namespace concino;
using namespace concino::detail;
using namespace concino::testing;

TEST_CASE("cell_recogniser: recognises every shape, in any order of its faces and verts") {
  std::mt19937 random(5);
  cell_recogniser known;
  for (const cell_shape s : shapes)
    for (int round = 0; round < 50; ++round) {
      const standard_cell& t = standard_cell_of(s);
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
      // the volume is positive in the recognised order of the verts
      std::vector<vec3> points(200);
      for (unsigned i = 0; i < t.num_verts; ++i) points[name[i]] = unit_cell(s)[i];
      CHECK(six_times_volume(s, known.cell, points) == doctest::Approx(six_volumes_of(s)));
    }
}

TEST_CASE("cell_recogniser: cells that only have the counts of a standard shape are general") {
  cell_recogniser known;
  const auto recognise = [&](std::initializer_list<std::initializer_list<unsigned>> list) {
    known.clear();
    for (const auto& f : list) {
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
