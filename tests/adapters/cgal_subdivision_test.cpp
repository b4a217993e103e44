// Smooth subdivisions agree with those of CGAL, on closed and open meshes.
#include <concino/adapters/cgal_surface_mesh.hpp>

#include <concino/generate/icosphere.hpp>
#include <concino/generate/subdivide_catmull_clark.hpp>
#include <concino/generate/subdivide_loop.hpp>
#include <concino/generate/subdivide_root3.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/measure.hpp>

#include <support/cgal.hpp>
#include <support/meshes.hpp>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/subdivision_method_3.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

using namespace concino;
namespace ct = concino::testing;
using kernel_point = CGAL::Simple_cartesian<double>::Point_3;
using surface = CGAL::Surface_mesh<kernel_point>;

namespace {

/// The points of a mesh, sorted by cells of a tenth of their least distance, so that rounding does not change the order.
template<class M>
std::vector<vec3> sorted_points(const M& m) {
  std::vector<vec3> all;
  for (const auto v : verts(m)) all.push_back(to_vec3(point(m, v)));
  const auto key = [](const vec3& x) { return std::array<double, 3>{std::round(x.x * 1e7), std::round(x.y * 1e7), std::round(x.z * 1e7)}; };
  std::sort(all.begin(), all.end(), [&](const vec3& a, const vec3& b) { return key(a) < key(b); });
  return all;
}

/// Checks that both subdivide to the same points and as many elements.
template<class Ours, class Theirs>
void agrees(const surface& m, const Ours& ours, const Theirs& theirs) {
  for (const unsigned times : {1u, 2u, 3u}) {
    const auto s = ours(m, subdivide_options{.times = times});
    surface t = m;
    theirs(t, CGAL::parameters::number_of_iterations(times));
    REQUIRE(num_verts(s) == num_verts(t));
    REQUIRE(num_polys(s) == num_polys(t));
    REQUIRE(num_edges(s) == num_edges(t));
    const auto a = sorted_points(s), b = sorted_points(t);
    for (std::size_t i = 0; i < a.size(); ++i) CHECK(norm(a[i] - b[i]) < 1e-12);
    CHECK(total_measure(s) == doctest::Approx(total_measure(t)).epsilon(1e-12));
  }
}

surface jittered(surface_arrays a) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> near(-0.1, 0.1);
  for (vec3& x : a.points) x += {near(random), near(random), near(random)};
  return ct::cgal_surface<kernel_point>(a);
}
surface_arrays icosphere_arrays() {
  const trimesh m = icosphere(1);
  surface_arrays a{m.points(), {}, {}, 3};
  for (const poly_id p : polys(m))
    for (const vert_id v : adj_p2v(m, p)) a.verts.push_back(v);
  return a;
}

}  // namespace

TEST_CASE("CGAL: Loop subdivision agrees") {
  const auto loop = [](const auto& m, const subdivide_options& o) { return subdivide_loop(m, o); };
  const auto theirs = [](surface& m, const auto& times) { CGAL::Subdivision_method_3::Loop_subdivision(m, times); };
  agrees(jittered(icosphere_arrays()), loop, theirs);
  agrees(jittered(ct::triangle_grid(3)), loop, theirs);
}

TEST_CASE("CGAL: Catmull-Clark subdivision agrees") {
  const auto catmull_clark = [](const auto& m, const subdivide_options& o) { return subdivide_catmull_clark(m, o); };
  const auto theirs = [](surface& m, const auto& times) { CGAL::Subdivision_method_3::CatmullClark_subdivision(m, times); };
  agrees(jittered(icosphere_arrays()), catmull_clark, theirs);
  agrees(jittered(ct::polygon_grid(2)), catmull_clark, theirs);
}

TEST_CASE("CGAL: root-3 subdivision agrees") {
  const auto root3 = [](const auto& m, const subdivide_options& o) { return subdivide_root3(m, o); };
  const auto theirs = [](surface& m, const auto& times) { CGAL::Subdivision_method_3::Sqrt3_subdivision(m, times); };
  agrees(jittered(icosphere_arrays()), root3, theirs);
  agrees(jittered(ct::triangle_grid(3)), root3, theirs);
}
