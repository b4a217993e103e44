// Exact geodesics on real meshes, and heat geodesics compared with them.
#include <concino/fields/exact_geodesics.hpp>
#include <concino/fields/heat_geodesics.hpp>

#include <support/corpus_meshes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

using namespace concino;
using namespace concino::testing;

namespace {

/// Checks that the mean error of the heat method is at most this percentage of the largest distance.
void compare(const concino::testing::corpus_path& path, double percent) {
  CAPTURE(path);
  const auto m = load<trimesh>(path.string());
  const vert_id s{0};
  const auto d = exact_geodesics(m, s);
  const auto heat = heat_geodesics(m, s);
  double mean = 0, n = 0, largest = 0;
  for (const auto v : verts(m)) {
    if (!std::isfinite(d[v])) continue;
    mean += std::abs(heat[v] - d[v]);
    n += 1;
    largest = std::max(largest, d[v]);
    CHECK(d[v] >= distance(point(m, v), point(m, s)) * (1 - 1e-14));
    for (const auto w : adj_v2v(m, v)) CHECK(d[w] <= (d[v] + distance(point(m, v), point(m, w))) * (1 + 1e-14));
  }
  CHECK(mean / n <= percent / 100 * largest);
}

}  // namespace

TEST_CASE("corpus: heat geodesics are close to exact ones, which are between straight lines and edge paths") {
  CONCINO_CORPUS_OR_SKIP(torus, "tri/torus.obj");
  CONCINO_CORPUS_OR_SKIP(socket, "tri/socket_genus7.off");
  CONCINO_CORPUS_OR_SKIP(spheres, "tri/two_spheres.obj");
  CONCINO_CORPUS_OR_SKIP(disk, "tri/circle_disk.obj");
  CONCINO_CORPUS_OR_SKIP(holes, "tri/3holes.obj");
  CONCINO_CORPUS_OR_SKIP(spot, "tri/spot_textured.obj");
  compare(torus, 3.5);  // a coarse mesh
  compare(socket, 6);   // a mesh of very long and thin triangles
  compare(spheres, 0.3);
  compare(disk, 0.4);
  compare(holes, 3);
  compare(spot, 2);
}

TEST_CASE("corpus: exact geodesics on the sphere are great circles up to the size of its triangles") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/sphere.obj");
  const auto m = load<trimesh>(path.string());
  const auto d = prepare_exact_geodesics(m).distance_from(vert_id{0});
  const vec3 from = point(m, vert_id{0});
  double largest = 0;
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    largest = std::max(largest, std::abs(d[v] - 0.5 * std::atan2(norm(cross(x, from)), dot(x, from))));
  }
  CHECK(largest < 0.0025);  // the largest distance is 1.56
  CHECK(d[vert_id{1}] <= 0.117679207958);  // the length of a path along edges
  CHECK(d[vert_id{1000}] <= 0.81338924806);
}
