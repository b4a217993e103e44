// Surface_mesh works with points of every kind: inexact and exact kernels, the plane, arrays, and types that are not points.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/graph/dijkstra.hpp>
#include <concino/mesh/trimesh.hpp>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>

#include <doctest/doctest.h>
#include <support/cgal.hpp>
#include <support/kinds.hpp>
#include <support/models.hpp>

#include <array>

using namespace concino;

namespace {

using inexact = CGAL::Exact_predicates_inexact_constructions_kernel;
using exact = CGAL::Exact_predicates_exact_constructions_kernel;
using floats = CGAL::Simple_cartesian<float>;
template<class P> using mesh = CGAL::Surface_mesh<P>;

constexpr int in_space = testing::surface | testing::embedded | testing::mutable_points;

}  // namespace

static_assert(testing::models_in_all_forms<mesh<inexact::Point_3>>(in_space) && testing::models_in_all_forms<mesh<exact::Point_3>>(in_space));
static_assert(testing::models_in_all_forms<mesh<vec3>>(in_space) && testing::models_in_all_forms<mesh<std::array<float, 3>>>(in_space));
static_assert(testing::models_in_all_forms<mesh<inexact::Point_2>>(testing::surface | testing::embedded));
static_assert(testing::models_in_all_forms<mesh<inexact::Weighted_point_3>>(testing::surface | testing::embedded));  // set_point would lose the weight
static_assert(testing::models_in_all_forms<mesh<int>>(testing::surface) && testing::models_in_all_forms<mesh<std::array<double, 2>*>>(testing::surface));

// Coordinates of kernels are converted to doubles; other points are returned as they are.
static_assert(std::same_as<decltype(point(mesh<exact::Point_3>(), CGAL::SM_Vertex_index())), vec3>);
static_assert(std::same_as<decltype(point(mesh<std::array<float, 3>>(), CGAL::SM_Vertex_index())), const std::array<float, 3>&>);

TEST_CASE_TEMPLATE("Surface_mesh: distances equal those on a trimesh", P, CONCINO_FIRST_OF(inexact::Point_3, exact::Point_3, floats::Point_3, inexact::Weighted_point_3, vec3,
                   std::array<double, 3>)) {
  surface_arrays arrays = testing::jittered(testing::triangle_grid(4), 0.05);
  for (vec3& x : arrays.points) x = {double(float(x.x)), double(float(x.y)), double(float(x.z))};
  const auto m = testing::cgal_surface<P>(arrays);
  const trimesh native(arrays);
  const auto d = dijkstra(m, CGAL::SM_Vertex_index(0));
  const auto expected = dijkstra(native, vert_id{0});
  for (const auto v : m.vertices()) {
    CHECK(to_vec3(point(m, v)) == arrays.points[v]);
    CHECK(d[v] == expected[vert_id{v.idx()}]);
  }
}

TEST_CASE("Surface_mesh: points of the plane lie at z = 0") {
  const auto m = testing::cgal_surface<inexact::Point_2>(testing::triangle_grid(2));
  for (const auto v : m.vertices()) CHECK(to_vec3(point(m, v)) == testing::triangle_grid(2).points[v]);
  CHECK(dijkstra(m, CGAL::SM_Vertex_index(0))[CGAL::SM_Vertex_index(2)] == 1);
}

TEST_CASE("Surface_mesh: numbers that are not doubles are rounded") {
  mesh<exact::Point_3> m;
  const exact::FT third = exact::FT(1) / 3;
  const auto v = m.add_vertex(exact::Point_3(third, third * third, 7));
  const vec3 x = point(m, v);
  CHECK(x.x == doctest::Approx(1.0 / 3).epsilon(1e-15));
  CHECK(x.y == doctest::Approx(1.0 / 9).epsilon(1e-15));
  CHECK(x.z == 7);
  CHECK(m.point(v).x() == third);
}

TEST_CASE_TEMPLATE("Surface_mesh: set_point moves a point", P, CONCINO_FIRST_OF(inexact::Point_3, exact::Point_3, floats::Point_3, vec3, std::array<float, 3>)) {
  auto m = testing::cgal_surface<P>(testing::triangle_grid(1));
  const CGAL::SM_Vertex_index v(2);
  set_point(m, v, vec3{1.5, -2, 3});
  CHECK(to_vec3(point(m, v)) == vec3{1.5, -2, 3});
  set_point(m, v, std::array{1, 2, 3});
  CHECK(to_vec3(point(m, v)) == vec3{1, 2, 3});
}
