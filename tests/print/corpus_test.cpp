// Real surfaces: supports against the integral of rays, hulls, and build directions of turned parts.
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/convex_hull.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/io/load.hpp>
#include <concino/concepts/views/with_points.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/print.hpp>

#include <support/corpus.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <vector>

using namespace concino;

namespace {

/// The volume of supports by rays along z through the centres of n x n cells: from each overhanging poly to the next one below that faces up.
double supports_by_rays(const trimesh& m, const overhang_report<trimesh>& o, int n) {
  const auto tree = bounding_tree(m);
  auto hangs = make_poly_map<bool>(m);
  for (const auto p : o.polys) hangs[p] = true;
  const box b = bounding_box(m);
  const vec3 cell = (b.max - b.min) / n;
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      double floor = o.plate;
      for (const auto& hit : tree.ray_all({b.min.x + (i + 0.5) * cell.x, b.min.y + (j + 0.5) * cell.y, b.min.z - 1}, {0, 0, 1})) {
        if (normal(m, hit.poly).z > 0) floor = hit.point.z;
        else if (hangs[hit.poly]) sum += (hit.point.z - floor) * cell.x * cell.y;
      }
    }
  return sum;
}

void check_supports(const std::filesystem::path& path) {
  const trimesh m = load<trimesh>(path);
  const auto o = overhangs(m);
  CHECK(o.support_volume > 0);
  CHECK(o.support_volume == doctest::Approx(supports_by_rays(m, o, 120)).epsilon(0.02));
  CHECK(o.contact_area >= o.area * (1 - 1e-9));
}

}  // namespace

TEST_CASE("corpus: supports of a bunny agree with the integral of rays") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/bunny.obj");
  check_supports(path);
}

TEST_CASE("corpus: supports of a cactus agree with the integral of rays") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/cactus.off");
  check_supports(path);
}

TEST_CASE("corpus: the hull is smaller than its part; a turned part has the same cost") {
  CONCINO_CORPUS_OR_SKIP(path, "tri/3holes.obj");
  check_supports(path);
  const trimesh m = load<trimesh>(path);
  std::vector<vec3> points;
  auto turned = make_vert_map<vec3>(m);
  for (const auto v : verts(m)) {
    points.push_back(point(m, v));
    turned[v] = testing::rotated(point(m, v));
  }
  const polygonmesh hull(convex_hull(points).surface);
  CHECK(total_measure(hull) < total_measure(m));  // areas
  CHECK(num_verts(hull) + num_polys(hull) == num_edges(hull) + 2);
  const auto d = best_build_direction(m, {.samples = 1, .accuracy_deg = 5});
  CHECK(best_build_direction(with_points(m, turned), {.samples = 1, .accuracy_deg = 5}).cost == doctest::Approx(d.cost).epsilon(1e-6));
}
