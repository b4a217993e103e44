#include <concino/geometry/polygon.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <numbers>

using namespace concino;
using namespace concino::testing;

TEST_CASE("shape_of: is accurate for a polygon far from the origin") {
  const int n = 12;
  std::vector<vec3> x;
  std::vector<std::vector<int>> poly(1);
  for (int i = 0; i < n; ++i) {
    x.push_back({1e6 + std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n) - 1e6, 0});
    poly[0].push_back(i);
  }
  const polygonmesh m(x, poly);
  const polygon_shape s = shape_of(m, adj_p2v(m, poly_id{0}));
  CHECK(s.area.z == doctest::Approx(n / 2.0 * std::sin(2 * std::numbers::pi / n)).epsilon(1e-9));
  CHECK(norm(s.mean - vec3{1e6, -1e6, 0}) < 1e-9);
}

TEST_CASE("shape_of: loops of fewer than three verts have no area") {
  const trimesh m({{1, 2, 3}, {4, 5, 6}}, {});
  CHECK(shape_of(m, std::vector<vert_id>{}).area == vec3{});
  CHECK(shape_of(m, std::vector<vert_id>{vert_id{0}}).mean == vec3{1, 2, 3});
  CHECK(shape_of(m, std::vector<vert_id>{vert_id{0}, vert_id{1}}).area == vec3{});
  CHECK(shape_of(m, std::vector<vert_id>{vert_id{0}, vert_id{1}}).mean == vec3{2.5, 3.5, 4.5});
}

TEST_CASE_TEMPLATE("area_vector_of: equals the area of shape_of to the bit", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.1));
  if constexpr (SurfaceMesh<M>)
    for (const auto p : polys(m)) CHECK(area_vector_of(m, adj_p2v(m, p)) == shape_of(m, adj_p2v(m, p)).area);
  else
    for (const auto f : faces(m)) CHECK(area_vector_of(m, adj_f2v(m, f)) == shape_of(m, adj_f2v(m, f)).area);
  for (const std::size_t n : {0u, 1u, 2u}) CHECK(area_vector_of(m, std::vector<vert_id>(n, vert_id{1})) == vec3{});
}
