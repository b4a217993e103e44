// Heat geodesics on a real mesh, against great circles.
#include <concino/fields/heat_geodesics.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace concino;
using namespace concino::testing;

TEST_CASE("corpus: heat geodesics on the sphere are great circles, and no longer than ways along edges") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/sphere.obj");
  const auto m = load<trimesh>(path.string());
  const auto d = heat_geodesics(m).distance_from(vert_id{0});
  const vec3 from = point(m, vert_id{0});
  double mean = 0, largest = 0;
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    const double wrong = std::abs(d[v] - 0.5 * std::atan2(norm(cross(x, from)), dot(x, from)));
    mean += wrong / static_cast<double>(num_verts(m));
    largest = std::max(largest, wrong);
  }
  CHECK(mean < 0.00378 / 5);  // what the heat method has without logarithms, over 5
  CHECK(largest < 0.00636 / 2);
  CHECK(d[vert_id{1}] <= 0.117679207958);
  CHECK(d[vert_id{1000}] <= 0.81338924806);
  CHECK(d[vert_id{6461}] == doctest::Approx(1.56212943384).epsilon(0.002));
}
