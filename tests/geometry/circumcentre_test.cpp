#include <concino/geometry/circumcentre.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/convert/convert.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/polyhedralmesh.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

std::vector<vec3> random_points(std::size_t n, double scale) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::vector<vec3> points(n);
  for (vec3& x : points) x = scale * vec3{coordinate(random), coordinate(random), coordinate(random)};
  return points;
}

}  // namespace

TEST_CASE("circumcentre: is equally far from the verts of triangles, in their planes") {
  for (const double scale : {1.0, 1e-300, 1e300}) {
    CAPTURE(scale);
    const auto x = random_points(300, scale);
    for (std::size_t i = 0; i < x.size(); i += 3) {
      const trimesh m({x[i], x[i + 1], x[i + 2]}, {{0, 1, 2}});
      const vec3 c = circumcentre(m, poly_id{0}) / scale, a = x[i] / scale, b = x[i + 1] / scale, d = x[i + 2] / scale;
      const double r = norm(c - a);
      CHECK(norm(c - b) == doctest::Approx(r).epsilon(1e-9));
      CHECK(norm(c - d) == doctest::Approx(r).epsilon(1e-9));
      CHECK(std::abs(dot(c - a, cross(b - a, d - a))) <= 1e-9 * r);
    }
  }
}

TEST_CASE_TEMPLATE("circumcentre: is equally far from the verts of tets, and of their faces", M, tetmesh, polyhedralmesh) {
  const auto x = random_points(400, 1);
  for (std::size_t i = 0; i < x.size(); i += 4) {
    const M m = [&] {
      const std::vector<vec3> four(x.begin() + static_cast<std::ptrdiff_t>(i), x.begin() + static_cast<std::ptrdiff_t>(i) + 4);
      if constexpr (TetMesh<M>) return M(cell_arrays{four, {vert_id{0}, vert_id{1}, vert_id{2}, vert_id{3}}, 4});
      else return convert<M>(tetmesh(cell_arrays{four, {vert_id{0}, vert_id{1}, vert_id{2}, vert_id{3}}, 4}));
    }();
    const vec3 c = circumcentre(m, poly_id{0});
    for (const auto v : verts(m)) CHECK(norm(c - point(m, v)) == doctest::Approx(norm(c - x[i])).epsilon(1e-8));
    CHECK(circumcentre(only_embedded_mesh(m), *polys(only_embedded_mesh(m)).begin()) == c);
    for (const auto f : faces(m)) {
      const vec3 d = circumcentre(m, f);
      vec3 first;
      std::size_t n = 0;
      for (const auto v : adj_f2v(m, f)) {
        if (n++ == 0) first = point(m, v);
        CHECK(norm(d - point(m, v)) == doctest::Approx(norm(d - first)).epsilon(1e-8));
      }
      CHECK(std::abs(dot(normal(m, f), d - first)) < 1e-8 * (1 + norm(d)));
    }
  }
}

TEST_CASE("circumcentre: of a right triangle it is the middle of the long side, exactly, at any power of 2") {
  for (const int e : {-1000, -1, 0, 10, 1000}) {
    const double s = std::ldexp(1.0, e);
    const trimesh m({{0, 0, 0}, {2 * s, 0, 0}, {0, s, 0}}, {{0, 1, 2}});
    CHECK(circumcentre(m, poly_id{0}) == vec3{s, s / 2, 0});
  }
}

TEST_CASE("circumcentre: is not finite where there is none") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(!is_finite(circumcentre(trimesh({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}), poly_id{0})));
  CHECK(!is_finite(circumcentre(trimesh({{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}), poly_id{0})));
  CHECK(!is_finite(circumcentre(trimesh({{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}, {{0, 1, 2}}), poly_id{0})));
  CHECK(!is_finite(circumcentre(tetmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}}), poly_id{0})));
}

TEST_CASE("circumcentre: refuses other polys") {
  const quadmesh m({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS((void)circumcentre(m, poly_id{0}), "circumcentre: poly 0 has 4 verts; only triangles and tets have one", invalid_argument);
}
