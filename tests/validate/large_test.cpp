// Meshes with verts of very high degree, and very large polygons and polyhedra.
#include <concino/validate/validate.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr unsigned many = 30000;
constexpr unsigned few = 1000;  // few, as a polyhedron searches its faces linearly

/// n points on a circle, one above and one below its centre.
std::vector<vec3> wheel(unsigned n) {
  std::vector<vec3> x;
  for (unsigned i = 0; i < n; ++i) {
    const double a = 2 * std::numbers::pi * i / n;
    x.push_back({std::cos(a), std::sin(a), 0});
  }
  x.push_back({0, 0, 1});
  x.push_back({0, 0, -1});
  return x;
}
std::vector<std::vector<unsigned>> cone_sides(unsigned n) {
  std::vector<std::vector<unsigned>> r;
  for (unsigned i = 0; i < n; ++i) {
    r.push_back({i, (i + 1) % n, n});
    r.push_back({(i + 1) % n, i, n + 1});
  }
  return r;
}

}  // namespace

TEST_CASE("validate: two fans of 30,000 triangles, closed and with three polys at boundary edges") {
  const auto r = validate(trimesh(wheel(many), cone_sides(many)));
  for (const auto& d : r) FAIL_CHECK(d.what);
  CHECK(r.facts.manifold);
  CHECK(r.facts.closed);
  CHECK(r.facts.genus == std::optional<std::size_t>(0));
  auto sides = cone_sides(many);
  auto x = wheel(many);
  x.push_back({0, 0, 2});
  for (unsigned i = 0; i < many; ++i) sides.push_back({i, (i + 1) % many, many + 2});
  const auto crowded = validate(trimesh(x, sides));
  CHECK(crowded.count(defect_kind::non_manifold_edge) == many);
  CHECK(crowded.count() == many);
  CHECK(crowded.size() == 100);
  CHECK_FALSE(crowded.facts.manifold);
}

TEST_CASE("validate: a polygon of 30,000 verts, and a polyhedron of 2,000 faces") {
  auto x = wheel(many);
  std::vector<std::vector<unsigned>> ring(1);
  for (unsigned i = 0; i < many; ++i) ring[0].push_back(i);
  x.resize(many);
  const auto flat = validate(polygonmesh(x, ring));
  CHECK(flat.is_clean());
  CHECK(flat.facts.boundary_loops == 1);

  std::vector<std::vector<std::pair<unsigned, bool>>> cell(1);
  for (unsigned f = 0; f < 2 * few; ++f) cell[0].push_back({f, true});
  const auto r = validate(polyhedralmesh(wheel(few), cone_sides(few), cell));
  for (const auto& d : r) FAIL_CHECK(d.what);
  CHECK(r.facts.genus == std::optional<std::size_t>(0));
  CHECK(r.facts.euler_characteristic == 1);
}

TEST_CASE("validate: 30,000 tets around one edge, as a closed ring and without one tet") {
  std::vector<std::vector<unsigned>> tets;
  for (unsigned i = 0; i < many; ++i) tets.push_back({i, (i + 1) % many, many, many + 1});
  for (auto& t : tets) std::swap(t[2], t[3]);
  const auto whole = validate(tetmesh(wheel(many), tets), {.kinds = defect_kinds().without({defect_kind::inverted_cell})});
  CHECK(whole.is_clean());
  CHECK(whole.facts.components == 1);
  CHECK(whole.facts.euler_characteristic == 1);
  tets.pop_back();
  const auto cut = validate(tetmesh(wheel(many), tets), {.kinds = defect_kinds().without({defect_kind::inverted_cell})});
  CHECK(cut.is_clean());
  CHECK(cut.facts.genus == std::optional<std::size_t>(0));
}
