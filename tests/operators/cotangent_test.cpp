#include <concino/operators/cotangent.hpp>

#include <concino/operators/laplacian.hpp>

#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <Eigen/Core>

#include <algorithm>

using namespace concino;
using namespace concino::testing;

namespace {

/// A mesh that lists the edges of a poly from edge `turn` on, or in reverse. Half-edges that store their targets begin with the last edge.
struct spun : user_mesh::surface {
  std::size_t turn = 0;
  bool back = false;
};

}  // namespace

template<>
struct concino::mesh_traits<spun> : concino::mesh_traits<user_mesh::surface> {
  static std::vector<edge> adj_p2e(const spun& m, poly p) {
    const user_mesh::polygon& ring = at(m, p);
    std::vector<edge> r;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const int a = ring[(i + m.turn) % ring.size()], b = ring[(i + m.turn + 1) % ring.size()];
      for (const edge e : edges(m))
        if (at(m, e) == std::pair{std::min(a, b), std::max(a, b)}) r.push_back(e);
    }
    if (m.back) std::reverse(r.begin(), r.end());
    return r;
  }
};

TEST_CASE("cotangent weights: do not depend on the first edge of a poly") {
  const std::vector<std::array<double, 3>> x = {{0, 0, 0}, {2, 0.1, 0}, {2.3, 1.5, 0.2}, {-0.3, 1.1, 0.4}};
  const std::vector<user_mesh::polygon> triangles = {{0, 1, 2}, {0, 2, 3}};
  const Eigen::MatrixXd expected = laplacian(user_mesh::surface(x, triangles), cotangent);
  for (const std::size_t turn : {0u, 1u, 2u})
    for (const bool back : {false, true}) {
      const spun m{{x, triangles}, turn, back};
      CHECK((Eigen::MatrixXd(laplacian(m, cotangent)) - expected).cwiseAbs().maxCoeff() < 1e-14);
    }
}

TEST_CASE("cotangent weights: of a triangle equal products of gradients of the hat functions") {
  const std::array<vec3, 3> x = {vec3{0.1, 0.3, -1}, vec3{2, 0.5, 0.4}, vec3{0.7, 1.9, 0.2}};
  const concino::detail::simplex_weights<2> w(x);
  const vec3 normal = cross(x[1] - x[0], x[2] - x[0]);
  vec3 gradient[3];  // of the hat function at vert i: orthogonal to the opposite edge in the plane, with length 1 / height
  for (std::size_t i = 0; i < 3; ++i) {
    const vec3 edge = x[(i + 2) % 3] - x[(i + 1) % 3];
    gradient[i] = cross(normal, edge) / dot(normal, normal);
    CHECK(dot(gradient[i], x[i] - x[(i + 1) % 3]) == doctest::Approx(1));
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) CHECK(w(i, j) == doctest::Approx(-0.5 * norm(normal) * dot(gradient[i], gradient[j])));
}

TEST_CASE("cotangent weights: of a tet are right") {
  const std::array<vec3, 4> x = {vec3{0.1, 0.3, -1}, vec3{2, 0.5, 0.4}, vec3{0.7, 1.9, 0.2}, vec3{0.3, 0.2, 2}};
  const concino::detail::simplex_weights<3> w(x);
  const double volume = std::abs(dot(cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0])) / 6;
  vec3 gradient[4];
  for (std::size_t i = 0; i < 4; ++i) {
    const vec3 a = x[(i + 1) % 4], normal = cross(x[(i + 2) % 4] - a, x[(i + 3) % 4] - a);
    gradient[i] = normal / dot(normal, x[i] - a);
  }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) CHECK(w(i, j) == doctest::Approx(-volume * dot(gradient[i], gradient[j])));
}
