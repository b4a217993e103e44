#include <concino/fields/heat_geodesics.hpp>

#include <concino/generate/icosphere.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/operators/virtual_refinement.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/geodesic_errors.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE_TEMPLATE("heat_geodesics: converge to straight lines on the square and in the cube", M, CONCINO_KINDS) {
  const unsigned n = VolumeMesh<M> ? 3 : 10;
  const M coarse = square_or_cube<M>(n), fine = square_or_cube<M>(2 * n);
  const heat_geodesics_options heat_alone{.clamp = false};
  const auto before = prepare_heat_geodesics(coarse, heat_alone), after = prepare_heat_geodesics(fine, heat_alone);
  for (const vec3& at : {vec3{0, 0, 0}, vec3{0.5, 0.5, VolumeMesh<M> ? 0.5 : 0}}) {
    const double e = error_from(before, nearest(coarse, at)), f = error_from(after, nearest(fine, at));
    CHECK(e < (VolumeMesh<M> ? 0.08 : 0.03));
    CHECK(f < 0.9 * e);
    CHECK(error_from(prepare_heat_geodesics(fine, {.clamp = true}), nearest(fine, at)) < (std::is_same_v<M, polyhedralmesh> ? 0.02 : 0.002));
  }
}

TEST_CASE("heat_geodesics: converge to arcs on the sphere") {
  double before = 1;
  for (const unsigned k : {2u, 3u, 4u}) {
    const trimesh m = icosphere(k);
    const vec3 from = point(m, vert_id{5});
    const auto arc = [&](const vec3& x) { return std::atan2(norm(cross(x, from)), dot(x, from)); };
    const deviation e = error_of(heat_geodesics(m, vert_id{5}, {.clamp = true}), arc);
    CHECK(e.mean / e.farthest < 0.75 * before);
    before = e.mean / e.farthest;
  }
  CHECK(before < 0.002);
}

TEST_CASE("heat_geodesics: are right where heat underflows") {
  surface_arrays a{{}, {}, {}, 3};
  const unsigned length = 3000;
  for (unsigned i = 0; i <= length; ++i)
    for (unsigned j = 0; j <= 1; ++j) a.points.push_back({double(i), double(j), 0});
  for (unsigned i = 0; i < length; ++i)
    for (const unsigned v : {0u, 2u, 3u, 0u, 3u, 1u}) a.verts.push_back(vert_id{2 * i + v});
  const trimesh strip(a);
  CHECK(heat_geodesics(strip, vert_id{0}, {.clamp = true})[vert_id{2 * length}] == doctest::Approx(length).epsilon(1e-3));
  CHECK(heat_geodesics(strip, vert_id{0}, {.time = 0.01, .clamp = true})[vert_id{2 * length}] == doctest::Approx(length).epsilon(1e-3));
  CHECK(heat_geodesics(strip, vert_id{0}, {.boundary = heat_boundary::dirichlet, .clamp = true})[vert_id{2 * length}] > 0.5 * length);
  const auto sudden = heat_geodesics(strip, vert_id{0}, {.time = 1e-300, .clamp = true});  // there is no heat, so distances are those of edge paths
  CHECK(sudden[vert_id{2 * length}] == doctest::Approx(length).epsilon(0.1));

  trimesh shorter = strip;  // with gaps in the indices
  remove_part(shorter, [](const vec3& x) { return x.x < 5; });
  CHECK(heat_geodesics(shorter, vert_id{10}, {.clamp = true})[vert_id{2 * length}] == doctest::Approx(length - 5).epsilon(1e-3));

  for (const double power : {2.0, 3.0}) {
    auto arrays = triangle_grid(25);
    for (vec3& x : arrays.points) x = {std::pow(x.x, power), std::pow(x.y, power), 0};
    const trimesh m(arrays);
    const auto heat = prepare_heat_geodesics(m, {.clamp = true});
    const deviation e = error_of(heat.distance_from(vert_id{0}), [](const vec3& x) { return norm(x); });
    CHECK(e.mean <= 0.03 * e.mean_distance);
  }
}

TEST_CASE("heat_geodesics: work on very thin hexahedra, whose Laplacian makes heat negative") {
  auto arrays = hex_grid(10);
  for (vec3& x : arrays.points) x = {std::pow(x.x, 3), std::pow(x.y, 3), std::pow(x.z, 3)};
  const hexmesh m(arrays);
  CHECK(error_from(prepare_heat_geodesics(m, {.clamp = false}), vert_id{0}) < 0.1);
  CHECK(error_from(prepare_heat_geodesics(m, {.clamp = true}), vert_id{0}) < 0.01);
  const hexmesh wide = grid<hexmesh>(1);
  // a quarter of the area of the face between two verts, divided by the length of the edge
  CHECK(concino::detail::lower_positive_stiffness(wide).coeff(1, 0) == doctest::Approx(-0.25));
}

TEST_CASE("heat_geodesics: obey the options") {
  const auto m = square_or_cube<trimesh>(16);
  const auto quads = square_or_cube<quadmesh>(16);
  const vert_id middle = nearest(m, {0.5, 0.5, 0});
  const double averaged = error_from(prepare_heat_geodesics(m, {.clamp = false}), middle);
  CHECK(averaged < error_from(prepare_heat_geodesics(m, {.boundary = heat_boundary::neumann, .clamp = false}), middle));
  CHECK(averaged < error_from(prepare_heat_geodesics(m, {.boundary = heat_boundary::dirichlet, .clamp = false}), middle));
  CHECK(error_from(prepare_heat_geodesics(m, {.boundary = heat_boundary::dirichlet, .clamp = false}), vert_id{0}) < 0.12);
  CHECK(error_from(prepare_heat_geodesics(m, uniform, {.clamp = false}), middle) < 0.1);
  CHECK(error_from(prepare_heat_geodesics(quads, virtual_refinement, {.clamp = false}), middle) < 0.02);
  CHECK(error_from(prepare_heat_geodesics(m, cotangent, {.clamp = false}), middle) == doctest::Approx(averaged));
  CHECK(prepare_heat_geodesics(m, {.time = 0.01}).time() == 0.01);

  struct counting : ldlt {
    int* factorised = nullptr;
    explicit counting(int* n) : factorised(n) {}
    counting(const counting& c) : ldlt(), factorised(c.factorised) {}
    void factorize(const Eigen::SparseMatrix<double>& a) {
      ++*factorised;
      ldlt::factorize(a);
    }
  };
  int n = 0;
  const auto ball = icosphere(1);
  const auto heat = prepare_heat_geodesics(ball, {.clamp = true}, counting(&n));
  CHECK(n == 2);
  heat.distance_from(vert_id{0});
  heat.distance_from(vert_id{7});
  CHECK(n == 2);
  const auto shared = heat;
  CHECK(shared.distance_from(vert_id{3})[vert_id{3}] == 0);
}

TEST_CASE("heat_geodesics: throw if an argument is invalid") {
  const auto m = grid<quadmesh>(2);
  const auto heat = prepare_heat_geodesics(m, {.clamp = true});
  CHECK_THROWS_WITH_AS(heat.distance_from(vert_id{9}), "heat_geodesics: a source is not a vert of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(heat.distance_from(std::vector<vert_id>()), "heat_geodesics: there is no source; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(heat.distance_from({{vert_id{1}, std::nan("")}}), "heat_geodesics: the initial distance at vert 1 is not finite",
                       invalid_argument);
  CHECK_THROWS_AS(heat.distance_from(poly_id{4}, {0, 0, 0}), invalid_mesh);
  CHECK_THROWS_AS(heat.distance_from(poly_id{0}, {0, 0, infinity}), invalid_argument);
  CHECK_THROWS_WITH_AS(heat.distance_from(poly_id{0}, {0, 0, 30}),
                       doctest::Contains("heat_geodesics: the position of the source is not in poly 0, but "), invalid_argument);
  CHECK_THROWS_WITH_AS(prepare_heat_geodesics(m, {.time = -1}), "heat_geodesics: time is -1; it must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_AS(prepare_heat_geodesics(m, {.time = infinity}), invalid_argument);
  const polygonmesh square({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS(prepare_heat_geodesics(square, cotangent), unsupported);
  CHECK_THROWS_AS(prepare_heat_geodesics(m, {.progress = [](double, const char*) { return false; }}), cancelled);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK_THROWS_WITH_AS(prepare_heat_geodesics(flat), doctest::Contains("heat_geodesics: poly 0 has no area"), invalid_mesh);
  const trimesh endless({{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(prepare_heat_geodesics(endless), invalid_mesh);
}

TEST_CASE("heat_geodesics: are accurate on polygons with many short edges") {
  const polygonmesh m = jigsaw(14, 5, 0.2);  // edges are a sixth as long as polys are wide
  const double edge = concino::detail::mean_edge_length(m);
  const auto heat = prepare_heat_geodesics(m, {.clamp = true}), alone = prepare_heat_geodesics(m, {.clamp = false});
  CHECK(heat.time() > 4 * edge * 4 * edge);
  for (const vert_id s : {vert_id{0}, vert_id{100}, vert_id{37}}) {
    const vec3 from = point(m, s);
    const auto straight = [&](const vec3& x) { return distance(x, from); };
    CHECK(error_of(heat.distance_from(s), straight).largest < 0.1 * edge);
    CHECK(error_of(alone.distance_from(s), straight).mean < 3 * edge);
  }
}
