#include <concino/io/detail/cells/orient.hpp>

#include <concino/mesh/support/to_polyhedra.hpp>

#include <support/meshes.hpp>
#include <support/poly_volume.hpp>

#include <doctest/doctest.h>

#include <random>

using namespace concino;
using namespace concino::testing;
using namespace concino::detail;

TEST_CASE("orient_polyhedra: restores outward flags after random changes") {
  for (const polyhedra_arrays& right : {polyhedra_grid(3), to_polyhedra(tet_grid(2)), to_polyhedra(jittered(hex_grid(3), 0.05))}) {
    polyhedra_arrays m = right;
    CHECK(orient_polyhedra(m) == 0);
    CHECK(m.outward == right.outward);
    std::mt19937 random(11);
    std::size_t changed = 0;
    for (std::size_t p = 0; p < m.num_polys(); ++p) {
      bool any = false;
      if (p % 3 != 0)
        for (std::uint32_t i = m.poly_offsets[p]; i < m.poly_offsets[p + 1]; ++i)
          if (random() % 2 || p % 3 == 1) {
            m.outward[i] = !m.outward[i];
            any = true;
          }
      changed += any;
    }
    CHECK(orient_polyhedra(m) == changed);
    CHECK(m.outward == right.outward);
  }
}

TEST_CASE("orient_polyhedra: the faces of a cavity are oriented into the cavity") {
  // a cube of edge length 3 around one of edge length 1
  polyhedra_arrays m;
  for (const auto& [low, high] : {std::pair{0.0, 3.0}, std::pair{1.0, 2.0}})
    for (const auto& [x, y, z] : {std::array{low, low, low},
                                  {high, low, low},
                                  {high, high, low},
                                  {low, high, low},
                                  {low, low, high},
                                  {high, low, high},
                                  {high, high, high},
                                  {low, high, high}})
      m.points.push_back({x, y, z});
  m.face_offsets = {0};
  m.poly_offsets = {0, 12};
  for (unsigned shift : {0u, 8u})
    for (unsigned f = 0; f < 6; ++f) {
      for (const unsigned v : standard_cell_of(cell_shape::hex).face_vert[f]) m.face_verts.push_back(vert_id{v + shift});
      m.face_offsets.push_back(static_cast<std::uint32_t>(m.face_verts.size()));
      m.poly_faces.push_back(face_id{f + (shift ? 6 : 0)});
      m.outward.push_back(shift == 0);
    }
  CHECK(testing::six_times_poly_volume(m, 0) == doctest::Approx(6 * 26));
  polyhedra_arrays copy = m;
  CHECK(orient_polyhedra(copy) == 0);
  for (auto& o : copy.outward) o = !o;
  CHECK(orient_polyhedra(copy) == 1);
  CHECK(copy.outward == m.outward);
  // in each of the two shells one face is wrong: the majority decides, and the cavity is not inverted
  for (const std::size_t outer : {0u, 3u, 5u})
    for (const std::size_t inner : {6u, 7u, 11u}) {
      copy.outward[outer] = !copy.outward[outer];
      copy.outward[inner] = !copy.outward[inner];
      CHECK(orient_polyhedra(copy) == 1);
      CHECK(copy.outward == m.outward);
    }
}

TEST_CASE("orient_polyhedra: orients open polyhedra; flat and empty ones do not change") {
  polyhedra_arrays m = to_polyhedra(hex_grid(1));
  m.poly_offsets.back() = 5;  // without the last face
  m.poly_faces.pop_back();
  m.outward.pop_back();
  m.outward[2] = 0;
  CHECK(orient_polyhedra(m) == 1);
  CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 1, 1, 1});
  for (vec3& p : m.points) p.z = 0;
  for (auto& o : m.outward) o = 0;
  CHECK(orient_polyhedra(m) == 0);
  polyhedra_arrays none;
  CHECK(orient_polyhedra(none) == 0);
}

TEST_CASE("orient_polyhedra: an open component gets the orientation of most of its faces, or of the first") {
  struct row {
    std::vector<std::vector<unsigned>> faces;
    std::vector<std::uint8_t> expected;
  };
  for (const row& r : {row{{{0, 2, 3}, {0, 2, 1}}, {1, 0}},
                       {{{0, 1, 2}, {0, 1, 3}}, {1, 0}},
                       {{{7, 8, 9}, {0, 1, 2}, {0, 1, 3}}, {1, 1, 0}},
                       {{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}}, {1, 0, 1}},
                       {{{0, 1, 2}, {1, 2, 3}, {3, 2, 4}}, {0, 1, 1}},
                       {{{0, 1, 2}, {1, 0, 3}}, {1, 1}},
                       {{{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}, {1, 1, 1}}}) {
    polyhedra_arrays m{{}, {0}, {}, {0}, {}, {}};
    for (int i = 0; i < 10; ++i) m.points.push_back({1.0 * i, 1.0 * i * i, 0});
    for (const auto& f : r.faces) {
      for (const unsigned v : f) m.face_verts.push_back(vert_id{v});
      m.face_offsets.push_back(static_cast<std::uint32_t>(m.face_verts.size()));
      m.poly_faces.push_back(face_id{m.poly_faces.size()});
      m.outward.push_back(1);
    }
    m.poly_offsets.push_back(static_cast<std::uint32_t>(m.poly_faces.size()));
    const bool changes = m.outward != r.expected;
    CHECK(orient_polyhedra(m) == changes);
    CHECK(m.outward == r.expected);
  }
}

TEST_CASE("orient: an open poly is turned over or not whatever the order of its verts") {
  // five faces of a cube, and a vert far away in another face, from which the volume has another sign
  const std::vector<vec3> points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  const std::vector<std::vector<unsigned>> faces = {{0, 3, 2, 1}, {1, 2, 6, 5}, {2, 7, 4, 5}, {0, 4, 7, 3}, {0, 1, 5, 4}};
  std::vector<unsigned char> first;
  for (std::size_t turn = 0; turn < 4; ++turn) {
    polyhedra_arrays m;
    m.points = points;
    m.face_offsets = {0};
    m.poly_offsets = {0, 5};
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (std::size_t i = 0; i < 4; ++i) m.face_verts.push_back(vert_id{faces[f][(i + turn) % 4]});
      m.face_offsets.push_back(static_cast<std::uint32_t>(m.face_verts.size()));
      m.poly_faces.push_back(face_id{f});
      m.outward.push_back(1);
    }
    orient_polyhedra(m);
    const std::vector<unsigned char> outward(m.outward.begin(), m.outward.end());
    if (turn == 0) first = outward;
    CHECK(outward == first);
    CHECK(orient_polyhedra(m) == 0);
  }
}
