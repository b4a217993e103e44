#include <concino/generate/subdivide_1_to_8.hpp>

#include <concino/generate/grid.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/quality/poly_quality.hpp>

#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

using namespace concino;
using namespace concino::testing;

namespace {

template<class Map>
double worst_of(const Map& values) {
  double worst = 1;
  for (const double x : values.values()) worst = std::min(worst, x);
  return worst;
}

std::vector<double> measures_of(const tetmesh& m) {
  std::vector<double> all;
  for (const poly_id p : polys(m)) all.push_back(measure(m, p));
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("subdivide_1_to_8: conforming cells of the same volume", M, tetmesh, hexmesh) {
  M m = grid<M>(2);
  if constexpr (TetMesh<M>) jitter(m, 0.2);  // hexes would not have planar faces
  const M s = subdivide_1_to_8(m);
  check_sound(s, 1);
  REQUIRE(num_polys(s) == 8 * num_polys(m));
  for (const vert_id v : verts(m)) CHECK(point(s, v) == point(m, v));
  for (const poly_id p : polys(m)) {
    double sum = 0;
    for (unsigned k = 0; k < 8; ++k) {
      const double part = measure(s, poly_id{8 * p.raw() + k});
      CHECK(part == doctest::Approx(measure(m, p) / 8).epsilon(1e-12));
      sum += part;
    }
    CHECK(sum == doctest::Approx(measure(m, p)).epsilon(1e-13));
  }
}

TEST_CASE_TEMPLATE("subdivide_1_to_8: properties, correspondence, repetition", M, tetmesh, hexmesh) {
  check_subdivision<true>(grid<M>(1), [](const auto& m, const subdivide_options& o) { return subdivide_1_to_8(m, o); });
}

TEST_CASE("subdivide_1_to_8: tets do not become flat") {
  // Tets with a longest edge of twice the shortest: their quality stays above a bound however often they are split.
  tetmesh m = make_grid<tetmesh>({.cells = {1, 1, 1}, .max = {1, 1.3, 0.8}});
  jitter(m, 0.2);
  const tetmesh first = subdivide_1_to_8(m), fourth = subdivide_1_to_8(m, {.times = 4});
  const double before = worst_of(quality(m, metric::mean_ratio));
  const double once = worst_of(quality(first, metric::mean_ratio));
  const double often = worst_of(quality(fourth, metric::mean_ratio));
  CHECK(once > 0.4 * before);
  CHECK(often > 0.95 * once);
}

TEST_CASE("subdivide_1_to_8: inverted and flat tets stay what they are") {
  const tetmesh inverted(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, std::vector<std::vector<unsigned>>{{0, 2, 1, 3}});
  for (const double v : measures_of(subdivide_1_to_8(inverted))) CHECK(v == doctest::Approx(-1.0 / 48).epsilon(1e-14));
  const tetmesh flat(std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, std::vector<std::vector<unsigned>>{{0, 1, 2, 3}});
  for (const double v : measures_of(subdivide_1_to_8(flat))) CHECK(v == 0);
}
