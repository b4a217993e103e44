#include <concino/mesh/support/face_merger.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace concino;

namespace {

std::vector<vert_id> ids(const std::vector<unsigned>& numbers) {
  std::vector<vert_id> all;
  for (const unsigned v : numbers) all.push_back(vert_id{v});
  return all;
}

/// One poly of all faces that were added.
struct merged_faces {
  face_merger merger;
  polyhedra_arrays m;

  explicit merged_faces(std::size_t bound) : merger(bound) {}
  void add(const std::vector<unsigned>& numbers) {
    const std::vector<vert_id> face = ids(numbers);
    const auto merged = merger.add(face.data(), face.size());
    m.poly_faces.push_back(merged.face);
    m.outward.push_back(merged.order > 0);
  }
  const polyhedra_arrays& finish() {
    m.poly_offsets = {0, static_cast<std::uint32_t>(m.poly_faces.size())};
    merger.finish(m);
    return m;
  }
};

}  // namespace

TEST_CASE("face_merger: equal cycles are one face; the order says whether their directions are equal") {
  merged_faces faces(6);
  faces.add({4, 1, 2});
  faces.add({1, 2, 4});
  faces.add({4, 2, 1});
  faces.add({1, 2, 3, 4});
  faces.add({1, 3, 2, 4});  // the same verts in another order
  faces.add({0, 3, 4});     // the same sum, and another smallest vert
  faces.add({3, 2, 1, 4});
  CHECK(faces.merger.num_faces() == 4);
  CHECK(faces.merger.num_corners() == 14);
  const polyhedra_arrays& m = faces.finish();
  CHECK(m.face_offsets == std::vector<std::uint32_t>{0, 3, 7, 11, 14});
  CHECK(m.face_verts == ids({4, 1, 2, 1, 2, 3, 4, 1, 3, 2, 4, 0, 3, 4}));
  CHECK(m.poly_faces == std::vector<face_id>{face_id{0}, face_id{0}, face_id{0}, face_id{1}, face_id{2}, face_id{3}, face_id{1}});
  CHECK(m.outward == std::vector<std::uint8_t>{1, 1, 0, 1, 1, 1, 0});
}

TEST_CASE("face_merger: without a face, the arrays are empty") {
  merged_faces faces(0);
  const polyhedra_arrays& m = faces.finish();
  CHECK(m.face_offsets == std::vector<std::uint32_t>{0});
  CHECK(m.face_verts.empty());
}

TEST_CASE("face_merger: finds all equal faces, also if a vert is the smallest one of many") {
  std::mt19937 random(3);
  for (const unsigned bound : {5u, 8u, 40u}) {
    // as many different faces as are listed, each later a few times more, turned and reversed
    std::vector<std::vector<unsigned>> different, listed;
    const auto canonical = [](std::vector<unsigned> face) {
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      if (face.back() < face[1]) std::reverse(face.begin() + 1, face.end());
      return face;
    };
    std::vector<std::size_t> number;
    std::vector<std::uint8_t> is_outward;
    for (int k = 0; k < 3000; ++k) {
      std::vector<unsigned> face(bound);
      for (unsigned v = 0; v < bound; ++v) face[v] = v;
      std::shuffle(face.begin() + 1, face.end(), random);
      face.resize(3 + random() % 3);
      std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(random() % face.size()), face.end());
      const std::vector<unsigned> key = canonical(face);
      number.push_back(static_cast<std::size_t>(std::find_if(different.begin(), different.end(), [&](const auto& d) { return canonical(d) == key; }) - different.begin()));
      if (number.back() == different.size()) different.push_back(face);
      const std::vector<unsigned>& first = different[number.back()];
      const auto at = std::find(face.begin(), face.end(), first[0]) - face.begin();
      is_outward.push_back(face[(static_cast<std::size_t>(at) + 1) % face.size()] == first[1]);
      listed.push_back(face);
    }
    merged_faces faces(bound);
    for (const auto& face : listed) faces.add(face);
    const polyhedra_arrays& m = faces.finish();
    REQUIRE(m.num_faces() == different.size());
    CHECK(m.outward == is_outward);
    bool all = true;
    for (std::size_t k = 0; k < listed.size(); ++k) all &= m.poly_faces[k] == face_id{number[k]};
    for (std::size_t f = 0; f < different.size(); ++f)
      all &= std::vector<vert_id>(m.face_verts.begin() + m.face_offsets[f], m.face_verts.begin() + m.face_offsets[f + 1]) == ids(different[f]);
    CHECK(all);
  }
}
