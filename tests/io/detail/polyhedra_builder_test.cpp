#include <concino/io/detail/polyhedra_builder.hpp>

#include <concino/mesh/to_polyhedra.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

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

TEST_CASE("regular_poly_check: accepts polyhedra that are oriented outward, at any place and of any moderate size") {
  for (polyhedra_arrays m : some_meshes())
    for (const double scale : {1.0, 1e-30, 1e30})
      for (const double shift : {0.0, 100.0}) {
        std::vector<vec3> points = m.points;
        for (vec3& x : points) x = (x + vec3(shift, shift, -shift)) * scale;
        regular_poly_check<vert_id> is_regular(points);
        std::size_t accepted = 0;
        for (std::size_t p = 0; p < m.num_polys(); ++p) accepted += is_regular(list_of(faces_of(m, p)).data());
        CHECK(accepted + 1 >= m.num_polys());  // the faces of one may have equal sums of verts by chance
      }
}

TEST_CASE("regular_poly_check: what it accepts has no fault and does not change when it is oriented") {
  std::mt19937 random(5);
  std::size_t accepted = 0, rejected = 0;
  for (const polyhedra_arrays& m : some_meshes()) {
    const auto number_of_verts = static_cast<unsigned>(m.points.size());
    regular_poly_check<vert_id> is_regular(m.points);
    faces_check<vert_id> check;
    face_list_decoder<vert_id> decode;
    poly_orienter<vert_id> orient(m.points);
    for (int round = 0; round < 2000; ++round) {
      face_list faces = faces_of(m, random() % m.num_polys());
      std::vector<vert_id>& one = faces[random() % faces.size()];
      switch (random() % 8) {
        case 0: std::reverse(one.begin(), one.end()); break;
        case 1: one[random() % one.size()] = one[random() % one.size()]; break;
        case 2: one[random() % one.size()] = vert_id{random() % number_of_verts}; break;
        case 3: faces.push_back(one); break;
        case 4: faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(random() % faces.size())); break;
        case 5: one.pop_back(); break;
        case 6:
          for (auto& face : faces) std::reverse(face.begin(), face.end());
          break;
        default: std::rotate(one.begin(), one.begin() + 1, one.end());
      }
      const std::vector<vert_id> list = list_of(faces);
      if (!is_regular(list.data())) {
        ++rejected;
        continue;
      }
      ++accepted;
      REQUIRE(check(list.data()) == face_fault::none);
      CHECK(!orient(decode(list.data())));
      REQUIRE(is_regular.faces().size() == faces.size());
      for (std::size_t f = 0; f < faces.size(); ++f) {
        const auto& found = is_regular.faces()[f];
        std::uint32_t sum = found.size;
        for (const vert_id v : faces[f]) sum += v.raw();
        CHECK(std::equal(faces[f].begin(), faces[f].end(), found.verts, found.verts + found.size));
        CHECK(found.smallest == std::min_element(faces[f].begin(), faces[f].end())->raw());
        CHECK(found.sum == sum);
      }
    }
  }
  CHECK(accepted > 500);
  CHECK(rejected > 3000);
}

TEST_CASE("regular_poly_check: rejects flat polyhedra, points that are not finite, and large polyhedra") {
  const std::vector<vec3> flat = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  const std::vector<vert_id> tet = list_of({{vert_id{0}, vert_id{2}, vert_id{1}}, {vert_id{0}, vert_id{1}, vert_id{3}}, {vert_id{1}, vert_id{2}, vert_id{3}}, {vert_id{2}, vert_id{0}, vert_id{3}}});
  CHECK_FALSE(regular_poly_check<vert_id>(flat)(tet.data()));
  std::vector<vec3> points = flat;
  points[3] = {0, 0, 1};
  CHECK(regular_poly_check<vert_id>(points)(tet.data()));
  points[3].z = 1e-30;
  CHECK_FALSE(regular_poly_check<vert_id>(points)(tet.data()));
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e200}) {
    points[3].z = bad;
    CHECK_FALSE(regular_poly_check<vert_id>(points)(tet.data()));
  }
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
    const bool is_regular = regular_poly_check<vert_id>(corners)(list_of(faces).data());
    if (n > 32) CHECK_FALSE(is_regular);
    polyhedra_builder<vert_id> builder(corners);
    const std::vector<vert_id> list = list_of(faces);
    CHECK(builder.add(list.data(), list.size()) == face_fault::none);
    CHECK(builder.num_turned() == 0);
    CHECK(builder.finish(std::move(corners)).num_faces() == n + 2);
  }
}

TEST_CASE("polyhedra_builder: gives the mesh whose faces are added, and turns polys outward") {
  for (const polyhedra_arrays& m : some_meshes())
    for (const bool is_reserved : {false, true})
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
          REQUIRE(builder.add(list.data(), list.size()) == face_fault::none);
          if (is_reserved && p == 3) builder.reserve_times(static_cast<double>(m.num_polys()) / 4);
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
