#include <concino/deform/skin.hpp>
#include <concino/deform/skin_weights.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/io/obj.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <numeric>
#include <sstream>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Bone 0 for x = 0, bone 1 for x = 1, between them in proportion.
template<class M>
skin_weights along_x(const M& m) {
  std::vector<skin_weight> all;
  for (const auto v : verts(m)) all.push_back({index_of(m, v), 0, 1 - point(m, v)[0]}), all.push_back({index_of(m, v), 1, +point(m, v)[0]});
  return {vert_index_bound(m), 2, all};
}

}  // namespace

TEST_CASE("skin_weights: sums are 1, duplicates add up, zeros are not stored") {
  const skin_weights w(3, 4, {{0, 3, 1}, {0, 1, 1}, {2, 0, 0.25}, {0, 3, 2}, {2, 2, 0}});
  CHECK(w.num_verts() == 3);
  CHECK(w.num_bones() == 4);
  CHECK(std::vector<std::uint32_t>(w.bones(0).begin(), w.bones(0).end()) == std::vector<std::uint32_t>{1, 3});
  CHECK(w.weight(0, 3) == 0.75);
  CHECK(w.weight(0, 1) == 0.25);
  CHECK(w.weight(0, 0) == 0);
  CHECK(w.bones(1).empty());
  CHECK(w.weight(2, 0) == 1);
  CHECK(w.bones(2).size() == 1);
  Eigen::SparseMatrix<double> matrix(2, 3);
  matrix.insert(0, 2) = 3;
  matrix.insert(0, 0) = 1;
  const skin_weights of_matrix(matrix);
  CHECK(of_matrix.weight(0, 2) == 0.75);
  CHECK(of_matrix.bones(1).empty());
  const skin_weights many(1, 5, {{0, 0, 1}, {0, 1, 4}, {0, 2, 1}, {0, 3, 2}, {0, 4, 1}});
  const auto two = many.at_most(2), four = many.at_most(4);
  CHECK(two.bones(0).size() == 2);
  CHECK(two.weight(0, 1) == doctest::Approx(2.0 / 3));
  CHECK(four.weight(0, 4) == 0);  // of equal ones the first
  CHECK(four.weight(0, 2) == doctest::Approx(0.125).epsilon(1e-15));
  CHECK(many.at_most(9).bones(0).size() == 5);
  CHECK(skin_weights().num_verts() == 0);
}

TEST_CASE("skin_weights: bad input") {
  CHECK_THROWS_WITH_AS(skin_weights(1, 1, {{0, 1, 1}}), "skin_weights: vert 0 and bone 1 have a weight, but there are 1 verts and 1 bones", invalid_argument);
  CHECK_THROWS_AS(skin_weights(1, 1, {{1, 0, 1}}), invalid_argument);
  CHECK_THROWS_WITH_AS(skin_weights(1, 1, {{0, 0, -0.5}}), "skin_weights: the weight of bone 0 at vert 0 is -0.5; it must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_AS(skin_weights(1, 1, {{0, 0, not_a_number}}), invalid_argument);
  CHECK_THROWS_AS(skin_weights(1, 2, {{0, 0, 1e308}, {0, 1, 1e308}}), invalid_argument);
  CHECK_THROWS_WITH_AS(skin_weights(1, 2, {{0, 0, 0}}), "skin_weights: the sum of the weights at vert 0 is 0; it must be finite and more than 0", invalid_argument);
  CHECK_THROWS_AS((void)skin_weights(1, 2, {{0, 0, 1}}).at_most(0), invalid_argument);
}

TEST_CASE_TEMPLATE("skin: equals the closed forms of both ways of blending", M, CONCINO_ALL_KINDS) {
  const M m(grid_arrays<M>(4));
  const auto w = along_x(m);
  const double angle = 2;
  const std::vector<affine_map> bend{affine_map(), rotation({0.5, 0.25, 0}, {0, 0, 1}, angle)};
  const auto linear = skin(m, w, bend, linear_blend), dual = skin(m, w, bend, dual_quaternions);
  for (const auto v : verts(m)) {
    const vec3 p = to_vec3(point(m, v));
    CHECK(distance(linear[v], (1 - p.x) * p + p.x * bend[1](p)) < 1e-14);
    // the angle t of the blend: tan(t / 2) = x sin(a / 2) / (1 - x + x cos(a / 2)), about the same line
    const double half = std::atan2(p.x * std::sin(angle / 2), 1 - p.x + p.x * std::cos(angle / 2));
    CHECK(distance(dual[v], rotation({0.5, 0.25, 0}, {0, 0, 1}, 2 * half)(p)) < 1e-14);
  }
  // Half of a screw is half of its angle and half of its way, and a rigid motion of all bones is one of the mesh.
  const std::vector<affine_map> screw{affine_map(), translation({0, 0, 3}) * rotation({1, 2, 0}, {0, 0, 1}, 1)};
  std::vector<skin_weight> halves;
  for (const auto v : verts(m)) halves.push_back({index_of(m, v), 0, 1}), halves.push_back({index_of(m, v), 1, 1});
  const skin_weights half(vert_index_bound(m), 2, halves);
  const auto x = skin(m, half, screw, dual_quaternions);
  const affine_map f = translation({1, 2, 3}) * rotation({0, 0, 0}, {1, 2, 3}, 0.7);
  const auto g = only_embedded_mesh(m);
  const auto y = skin(g, half, std::vector<affine_map>{f, f}, dual_quaternions), z = skin(g, half, std::vector<affine_map>{f, f}, linear_blend);
  for (const auto v : verts(m)) CHECK(distance(x[v], (translation({0, 0, 1.5}) * rotation({1, 2, 0}, {0, 0, 1}, 0.5))(to_vec3(point(m, v)))) < 1e-14 * 10);
  for (const auto v : verts(g)) {
    CHECK(distance(y[v], rotated(to_vec3(point(g, v))) + vec3{1, 2, 3}) < 1e-14);
    CHECK(distance(z[v], rotated(to_vec3(point(g, v))) + vec3{1, 2, 3}) < 1e-14);
  }
}

TEST_CASE("skin: rotations of more than half a turn are blended the short way, and the four cases of quaternions") {
  const trimesh m(triangle_grid(1));
  std::vector<skin_weight> halves;
  for (const auto v : verts(m)) halves.push_back({v.raw(), 0, 1}), halves.push_back({v.raw(), 1, 1});
  const skin_weights half(num_verts(m), 2, halves);
  for (const vec3 axis : {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}, vec3{1, 2, 3}})
    for (const double angle : {0.1, 3.0, -3.0, 1.0}) {
      const auto x = skin(m, half, std::vector<affine_map>{rotation({0, 0, 0}, axis, 3 + angle), rotation({0, 0, 0}, axis, 3 - angle)}, dual_quaternions);
      const double expected = std::abs(angle) > std::numbers::pi / 2 ? 3 + std::numbers::pi : 3;
      for (const auto v : verts(m)) CHECK(distance(x[v], rotation({0, 0, 0}, axis, expected)(point(m, v))) < 1e-13);
    }
}

TEST_CASE("skin: the rig bends its elbow, and dual quaternions keep its volume better") {
  const auto skin_file = corpus("skeletons/arm_rig/arm.obj"), joints = corpus("skeletons/arm_rig/arm.skt"), weights_file = corpus("skeletons/arm_rig/arm.skw");
  if (skin_file.empty() || joints.empty() || weights_file.empty()) return skip("arm_rig is absent");
  const auto m = load_obj<trimesh>(skin_file);
  std::vector<vec3> at;
  std::vector<int> father;
  std::ifstream in(joints);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string j, name;
    int index = 0, parent = 0;
    vec3 x;
    if (words >> j >> index >> name >> parent >> x.x >> x.y >> x.z && j == "j") at.push_back(x), father.push_back(parent);
  }
  REQUIRE(at.size() == 25);
  std::vector<skin_weight> all;
  std::ifstream in_weights(weights_file);
  for (std::size_t b = 0, v = 0; in_weights >> b >> v;) {
    double w = 0;
    in_weights >> w;
    all.push_back({v, b, w});
  }
  const skin_weights w(num_verts(m), at.size(), all);
  const auto bent = [&](double angle) {  // at joint 3, the elbow
    std::vector<affine_map> transforms(at.size());
    for (std::size_t j = 1; j < at.size(); ++j) {
      transforms[j] = transforms[static_cast<std::size_t>(father[j])];
      if (j == 3) transforms[j] = transforms[j] * rotation(at[3], cross(at[3] - at[1], at[5] - at[3]), angle);
    }
    return transforms;
  };
  const auto rest = skin(m, w, bent(0), dual_quaternions), rest_linear = skin(m, w, bent(0), linear_blend);
  double size = 0;
  for (const auto v : verts(m)) size = std::max(size, distance(point(m, v), point(m, vert_id{0})));
  const auto linear = skin(m, w, bent(1.5), linear_blend), dual = skin(m, w, bent(1.5), dual_quaternions);
  const affine_map below = bent(1.5)[5];
  double sum = 0;
  for (const auto v : verts(m)) {
    CHECK(distance(rest[v], point(m, v)) < 1e-12 * size);
    CHECK(distance(rest_linear[v], point(m, v)) < 1e-12 * size);
    double hand = 0;  // bones below the elbow
    for (std::size_t k = 0; k < w.bones(v.raw()).size(); ++k) hand += w.bones(v.raw())[k] >= 3 ? w.weights(v.raw())[k] : 0;
    if (hand == 1) CHECK(distance(dual[v], below(point(m, v))) < 1e-12 * size);
    if (hand == 0) CHECK(distance(dual[v], point(m, v)) < 1e-12 * size);
    const auto row = w.weights(v.raw());
    CHECK(std::abs(std::accumulate(row.begin(), row.end(), 0.0) - 1) < 1e-14);
    sum += distance(dual[v], linear[v]);
  }
  CHECK(sum > 1);
  const auto fewer = w.at_most(2);
  for (const auto v : verts(m)) {
    CHECK(fewer.bones(v.raw()).size() <= 2);
    const auto row = fewer.weights(v.raw());
    CHECK(std::abs(std::accumulate(row.begin(), row.end(), 0.0) - 1) < 1e-14);
  }
  CHECK(skin(m, fewer, bent(1.5), linear_blend).values().size() == num_verts(m));
}

TEST_CASE("skin: bad input") {
  const trimesh m(triangle_grid(2));
  const auto w = along_x(m);
  const std::vector<affine_map> two(2), three(3);
  CHECK_THROWS_WITH_AS((void)skin(m, w, three, linear_blend), "skin: there are 3 transforms and weights of 2 bones", invalid_argument);
  const trimesh other(triangle_grid(3));
  CHECK_THROWS_WITH_AS((void)skin(other, w, two, linear_blend), "skin: the weights are for 9 verts, and the mesh has an index bound of 16", invalid_argument);
  std::vector<affine_map> bad(2);
  bad[1].x = {2, 0, 0};
  CHECK_THROWS_WITH_AS((void)skin(m, w, bad, dual_quaternions), "skin: the transform of bone 1 is not a rotation and a translation; blend it with linear_blend", invalid_argument);
  CHECK(skin(m, w, bad, linear_blend)[vert_id{8}].x == 2);
  bad[1].x = {not_a_number, 0, 0};
  CHECK_THROWS_WITH_AS((void)skin(m, w, bad, linear_blend), "skin: the transform of bone 1 is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS((void)skin(m, skin_weights(9, 2, {{0, 0, 1}}), two, linear_blend), "skin: vert 1 has no weights", invalid_argument);
  auto broken = m;
  set_point(broken, vert_id{4}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_AS((void)skin(broken, w, two, linear_blend), invalid_mesh);
  const trimesh empty;
  CHECK(skin(empty, skin_weights(0, 2, {}), two, linear_blend).values().empty());
}
