#include <concino/skeleton/tube.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/graph/components.hpp>
#include <concino/io/skeleton.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/skeleton/bones.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/skeletons.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <map>
#include <set>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

/// Closed, manifold and oriented, with the genus of the number of cycles; the smallest volume that it encloses.
template<class G>
void check_tube(const G& g, const skeleton_tube_options& options = {}) {
  const quadmesh m = tube(g, options);
  std::map<std::array<std::uint32_t, 2>, int> directed;
  for (const auto p : polys(m)) {
    std::vector<std::uint32_t> loop;
    for (const auto v : adj_p2v(m, p)) loop.push_back(v.raw());
    REQUIRE(loop.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) CHECK(++directed[{loop[i], loop[(i + 1) % 4]}] == 1);
  }
  for (const auto& [e, n] : directed) CHECK(directed.count({e[1], e[0]}) == 1);
  for (const auto v : verts(m)) {  // the polys at a vert are one fan
    const std::size_t n = num_elements(adj_v2p(m, v));
    CHECK(n == num_elements(adj_v2e(m, v)));
    std::set<std::uint32_t> seen;
    auto p = *adj_v2p(m, v).begin();
    for (std::size_t i = 0; i < n; ++i) {
      seen.insert(p.raw());
      std::uint32_t next = 0, k = 0;
      std::vector<vert_id> loop;
      for (const auto w : adj_p2v(m, p)) loop.push_back(w);
      while (!(loop[k] == v)) ++k;
      next = loop[(k + 3) % 4].raw();
      for (const auto q : adj_v2p(m, v)) {
        std::vector<vert_id> other;
        for (const auto w : adj_p2v(m, q)) other.push_back(w);
        for (std::size_t c = 0; c < 4; ++c)
          if (other[c] == v && other[(c + 1) % 4].raw() == next) p = q;
      }
    }
    CHECK(seen.size() == n);
  }
  const auto components = static_cast<std::size_t>(connected_components(g).count);
  CHECK(static_cast<std::size_t>(connected_components(m).count) == components);
  std::size_t num_ends = 0, num_vertices = 0;
  for (const auto v : verts(g)) {
    ++num_vertices;
    num_ends += num_elements(adj_v2v(g, v));
  }
  const auto cycles = static_cast<long>(num_ends / 2 + components) - static_cast<long>(num_vertices);
  const long euler = static_cast<long>(num_verts(m)) - static_cast<long>(num_edges(m)) + static_cast<long>(num_polys(m));
  CHECK(euler == 2 * static_cast<long>(components) - 2 * cycles);
}

double enclosed_volume(const quadmesh& m) {
  double v = 0;
  for (const auto p : polys(m)) v += dot(area_vector(m, p), point(m, *adj_p2v(m, p).begin())) / 3;
  return v;
}

}  // namespace

TEST_CASE("tube: is a closed manifold whose genus is the number of cycles") {
  check_tube(y_skeleton());
  for (const std::uint32_t n : {3u, 4u, 7u, 30u}) check_tube(cycle_skeleton(n));
  check_tube(theta_skeleton());
  check_tube(skeleton({{1, 2, 3}}), {.radius = 1});
  CHECK(num_polys(tube(skeleton({{1, 2, 3}}), {.radius = 1})) == 6);
  // A joint with many bones, and points that coincide.
  std::vector<vec3> points{{0, 0, 0}};
  std::vector<std::array<std::uint32_t, 2>> pairs;
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (std::uint32_t i = 1; i <= 40; ++i) {
    points.push_back({normal(random), normal(random), normal(random)});
    pairs.push_back({0, i});
    if (i % 7 == 0) check_tube(skeleton_of_pairs(points, pairs), {.radius = 0.1});
  }
  points[3] = points[0];
  check_tube(skeleton_of_pairs(points, pairs), {.radius = 0.1});
}

TEST_CASE("tube: goes around the curve at the distance of the radii, and faces outward") {
  const skeleton line = skeleton_of_pairs({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1}, {1, 2}, {2, 3}}, {0.5, 0.5, 0.5, 0.5});
  const quadmesh m = tube(line);
  CHECK(num_polys(m) == 2 * 5 + 3 * 4);
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    if (x.x > 0.5 && x.x < 2.5) CHECK(std::hypot(x.y, x.z) == doctest::Approx(0.5));
  }
  CHECK(enclosed_volume(m) > 1);
  CHECK(enclosed_volume(m) < 3.14159 * 0.25 * 4);
  CHECK(enclosed_volume(tube(y_skeleton())) > 0);
  // A ring of squares: twice the square of the radius, times the length.
  const double ring = enclosed_volume(tube(cycle_skeleton(200)));
  CHECK(ring == doctest::Approx(2 * 0.09 * length(bones(cycle_skeleton(200))[0])).epsilon(0.02));
}

TEST_CASE("tube: around the skeletons of the corpus") {
  for (const char* file : {"skeletons/cactus.skel", "skeletons/stickwoman.cg", "skeletons/moebius.cg"}) {
    const auto path = corpus(file);
    if (path.empty()) {
      skip(std::string(file) + " is absent");
      continue;
    }
    CAPTURE(file);
    check_tube(load_skeleton(path), {.radius = 0.01});
  }
}

TEST_CASE("tube: of the edges of a mesh, and on the archetype") {
  const trimesh m(grid_arrays<trimesh>(2));
  check_tube(m, {.radius = 0.05});
  CHECK(num_polys(tube(only_embedded_mesh(m), {.radius = 0.05})) == num_polys(tube(m, {.radius = 0.05})));
}

TEST_CASE("tube: refuses graphs without verts or radii") {
  const skeleton y = y_skeleton(), bare(y.points(), y.edges());
  CHECK_THROWS_WITH_AS((void)tube(skeleton()), "tube: the graph has no verts", invalid_argument);
  CHECK_THROWS_WITH_AS((void)tube(bare), "tube: vert 0 has radius 0; set radii, or pass {.radius = r}", invalid_argument);
  for (const double r : {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS((void)tube(bare, {.radius = r}), invalid_argument);
}
