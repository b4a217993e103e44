// Trees over real meshes: points inside the bunny, and cells of volumes of every kind.
#include <concino/geometry/bounding_tree.hpp>

#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/self_intersections.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/poly_triangles.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

void check_inside(const std::filesystem::path& file, int rounds) {
  const auto m = load<trimesh>(file.string());
  const auto tree = bounding_tree(m);
  std::vector<corners3> all;
  for (const auto p : polys(m)) all.push_back(triangles_of(m, p)[0]);
  const box b = bounding_box(m);
  point_stream at(1, 0, 1);
  int inside = 0;
  for (int i = 0; i < rounds; ++i) {
    const vec3 t = at(), x{b.min.x + t.x * (b.max.x - b.min.x), b.min.y + t.y * (b.max.y - b.min.y), b.min.z + t.z * (b.max.z - b.min.z)};
    const double times = times_round(all, x);
    CHECK(tree.is_inside(x) == (std::abs(times) > 0.5));
    CHECK(tree.is_inside(x, {.rule = inside_rule::parity}) == (std::lround(times) % 2 != 0));
    inside += times > 0.5;
    double least = 1e9;
    for (const corners3& c : all)
      if (norm(c[0] - x) < least + 0.3) least = std::min(least, distance_to(c, x));
    CHECK(std::abs(tree.closest(x).distance - least) < 1e-14);
  }
  CHECK(inside > 0);
  CHECK(inside < rounds);
  unsigned k = 0;
  for (const auto v : verts(m))
    if (k++ % 50 == 0) {
      CHECK(tree.is_inside(point(m, v)));
      CHECK(tree.closest(point(m, v)).distance == 0);
    }
}

template<class M>
void check_cells(const std::filesystem::path& file) {
  CAPTURE(file.string());
  const auto m = load<M>(file.string());
  const auto tree = bounding_tree(m);
  std::size_t k = 0;
  const std::size_t step = 1 + num_polys(m) / 100;
  for (const auto p : polys(m)) {
    if (k++ % step != 0) continue;
    const vec3 x = centroid(m, p);
    const auto found = tree.locate(x);
    REQUIRE(found);
    CHECK(std::abs(times_round(triangles_of(m, *found), x)) > 0.5);
    for (const auto v : adj_p2v(m, p)) {
      const auto at_corner = tree.locate(point(m, v));
      REQUIRE(at_corner);
      CHECK(tree.is_inside(point(m, v)));
    }
  }
}

}  // namespace

TEST_CASE("bounding_tree: finds the inside of the bunny") {
  CONCINO_CORPUS_OR_SKIP(file, "tri/bunny.obj");
  check_inside(file, 40);
}

TEST_CASE("bounding_tree: finds the inside of two overlapping spheres") {
  CONCINO_CORPUS_OR_SKIP(file, "tri/two_spheres.obj");
  check_inside(file, 200);
}

TEST_CASE("bounding_tree: the bunny does not intersect itself") {
  CONCINO_CORPUS_OR_SKIP(file, "tri/bunny.obj");
  CHECK(self_intersections(load<trimesh>(file.string())).empty());
}

TEST_CASE("bounding_tree: locates the centroids and corners of cells in volumes") {
  CONCINO_CORPUS_OR_SKIP(tets, "tet/sphere_octant.mesh");
  CONCINO_CORPUS_OR_SKIP(crown, "tet/quarter_crown.mesh");
  CONCINO_CORPUS_OR_SKIP(hollow, "hex/hollow_sphere.mesh");
  CONCINO_CORPUS_OR_SKIP(rocker, "hex/rockerarm.mesh");
  CONCINO_CORPUS_OR_SKIP(voronoi, "polyhedral/eight_voronoi.hedra");
  CONCINO_CORPUS_OR_SKIP(agglomerated, "polyhedral/agglomerated_crown.hedra");
  check_cells<tetmesh>(tets);
  check_cells<tetmesh>(crown);
  check_cells<hexmesh>(hollow);
  check_cells<hexmesh>(rocker);
  check_cells<polyhedralmesh>(voronoi);
  check_cells<polyhedralmesh>(agglomerated);
}
