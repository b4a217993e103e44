#include <concino/io/detail/cells/polyhedra_builder.hpp>

#include <concino/mesh/support/to_polyhedra.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace concino;
using namespace concino::testing;
using namespace concino::detail;

namespace {

using face_list = std::vector<std::vector<vert_id>>;

/// The faces of poly p, as seen from outside.
face_list faces_of(const polyhedra_arrays& m, std::size_t p) {
  face_list faces;
  for (std::uint32_t i = m.poly_offsets[p]; i < m.poly_offsets[p + 1]; ++i) {
    const std::uint32_t f = m.poly_faces[i].raw();
    faces.emplace_back(m.face_verts.begin() + m.face_offsets[f], m.face_verts.begin() + m.face_offsets[f + 1]);
    if (!m.outward[i]) std::reverse(faces.back().begin(), faces.back().end());
  }
  return faces;
}
std::vector<vert_id> list_of(const face_list& faces) {
  std::vector<vert_id> list{vert_id{faces.size()}};
  for (const auto& face : faces) {
    list.push_back(vert_id{face.size()});
    list.insert(list.end(), face.begin(), face.end());
  }
  return list;
}

std::vector<polyhedra_arrays> some_meshes() { return {polyhedra_grid(3), to_polyhedra(tet_grid(2)), to_polyhedra(jittered(hex_grid(3), 0.05))}; }

}  // namespace

TEST_CASE("polyhedra_builder: takes polyhedra with few and many faces as they are, if they are oriented outward") {
  // prisms over polygons of n corners have n + 2 faces and 2 n verts
  for (const unsigned n : {3u, 20u, 32u, 33u, 62u, 63u, 64u, 65u, 200u}) {
    std::vector<vec3> corners;
    face_list faces(2);
    for (unsigned k = 0; k < n; ++k) {
      const double angle = 6.283185307179586 * k / n;
      corners.push_back({std::cos(angle), std::sin(angle), 0});
      corners.push_back({std::cos(angle), std::sin(angle), 1});
      const unsigned next = (k + 1) % n;
      faces[0].push_back(vert_id{2 * (n - 1 - k)});
      faces[1].push_back(vert_id{2 * k + 1});
      faces.push_back({vert_id{2 * k}, vert_id{2 * next}, vert_id{2 * next + 1}, vert_id{2 * k + 1}});
    }
    polyhedra_builder<vert_id> builder(corners);
    const std::vector<vert_id> list = list_of(faces);
    CHECK(builder.add(list.data()) == face_fault::none);
    CHECK(builder.num_turned() == 0);
    CHECK(builder.finish(std::move(corners)).num_faces() == n + 2);
  }
}

TEST_CASE("polyhedra_builder: gives the mesh whose faces are added, and turns polys outward") {
  for (const polyhedra_arrays& m : some_meshes())
    for (const std::size_t turned_every : {std::size_t{0}, std::size_t{3}}) {
      polyhedra_builder<vert_id> builder(m.points);
      std::size_t turned = 0;
      for (std::size_t p = 0; p < m.num_polys(); ++p) {
        face_list faces = faces_of(m, p);
        if (turned_every && p % turned_every == 1) {
          for (auto& face : faces) std::reverse(face.begin(), face.end());
          ++turned;
        }
        const std::vector<vert_id> list = list_of(faces);
        REQUIRE(builder.add(list.data()) == face_fault::none);
      }
      CHECK(builder.num_turned() == turned);
      const polyhedra_arrays built = builder.finish(std::vector<vec3>(m.points));
      CHECK(built.points == m.points);
      CHECK(built.poly_offsets == m.poly_offsets);
      CHECK(built.num_faces() == m.num_faces());
      bool all = true;
      for (std::size_t p = 0; p < m.num_polys(); ++p) {
        const face_list expected = faces_of(m, p), found = faces_of(built, p);
        for (std::size_t f = 0; f < expected.size(); ++f)
          all &= expected[f].size() == found[f].size() && compare_cycles(expected[f].data(), found[f].data(), found[f].size()) == 1;
      }
      CHECK(all);
    }
}
