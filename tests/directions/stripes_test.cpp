#include <concino/directions/stripes.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double turn = 2 * std::numbers::pi;

template<class M>
std::vector<unsigned char> singular_polys(const M& m, const stripes_result<M>& s) {
  std::vector<unsigned char> is_singular(poly_index_bound(m));
  for (const auto& x : s.singular) is_singular[index_of(m, x.poly)] = 1;
  return is_singular;
}

/// The cosine of the angle is a function of the verts, but for singular polys.
template<class M>
void check_agreement(const M& m, const stripes_result<M>& s) {
  const auto is_singular = singular_polys(m, s);
  std::vector<double> cosine(vert_index_bound(m), 2);
  for (const auto p : polys(m)) {
    if (is_singular[index_of(m, p)]) continue;
    std::size_t k = 0;
    for (const auto v : adj_p2v(m, p)) {
      const double c = std::cos(s.angles.of(p)[k++]);
      double& known = cosine[index_of(m, v)];
      if (known < 2) CHECK(std::abs(known - c) < 1e-9);
      known = c;
    }
  }
}

/// A field along d, of a flat mesh.
template<class M>
auto field_along(const M& m, const vec3& d, int symmetry) {
  return direction_field(m, {.symmetry = symmetry, .hard = {{*verts(m).begin(), d}}});
}

}  // namespace

TEST_CASE_TEMPLATE("stripes: of a plane are at the distances asked for", M, CONCINO_ALL_SURFACE_KINDS) {
  const M m(rotated(grid_arrays<M>(5)));
  const vec3 along = rotated(vec3{0.8, 0.6, 0});
  for (const int n : {1, 2}) {
    const double frequency = 1.7;
    const auto s = stripes(m, field_along(m, along, n), frequency);
    CHECK(s.energy < 1e-12);
    CHECK(s.singular.empty());
    check_agreement(m, s);
    for (const auto p : polys(m)) {
      std::vector<vec3> x;
      for (const auto v : adj_p2v(m, p)) x.push_back(point(m, v));
      const auto angles = s.angles.of(p);
      double sign = 0;  // of lines it may be one or the other
      for (std::size_t k = 1; k < x.size(); ++k) {
        const double wanted = turn * frequency * dot(along, x[k] - x[0]), found = angles[k] - angles[0];
        if (sign == 0 && std::abs(wanted) > 1e-6) sign = found / wanted > 0 ? 1 : -1;
        if (n == 1) CHECK(sign >= 0);
        CHECK(std::abs(found - (sign == 0 ? 1 : sign) * wanted) < 1e-6);
      }
    }
    const auto lines = stripe_lines(s);
    CHECK(!lines.empty());
    const double first = frequency * dot(along, lines[0][0]);
    for (const auto& line : lines)
      for (const vec3& x : line) CHECK(std::abs(std::remainder(frequency * dot(along, x) - first, 1)) < 1e-6);
  }
  const auto g = only_embedded_mesh(m);
  const auto thin = stripes(g, direction_field(g, {.symmetry = 2}), 2);
  CHECK(thin.energy < 1e-12);
  CHECK(thin.singular.empty());
  CHECK(!stripe_lines(thin).empty());
}

TEST_CASE("stripes: around a tube, seven circles; they scale with the mesh") {
  const std::size_t around = 24, tube = 20;
  const quadmesh m = make_torus<quadmesh>({.cells = {around, tube}});
  direction_field_options<quadmesh> options{.symmetry = 1};
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    const double r = std::hypot(x.x, x.y);
    const vec3 out = vec3{x.x, x.y, 0} / r;
    options.hard.push_back({v, (r - 1) * vec3{0, 0, 1} - x.z * out});
  }
  const double length = static_cast<double>(tube) * 2 * 0.4 * std::sin(std::numbers::pi / tube);
  const auto s = stripes(m, direction_field(m, options), 7 / length);
  CHECK(s.singular.empty());
  check_agreement(m, s);
  CHECK(stripe_lines(s).size() == 7 * around);
  quadmesh large = m;
  for (const auto v : verts(m)) set_point(large, v, 8 * to_vec3(point(m, v)));
  const auto scaled_up = stripes(large, direction_field(large, options), 7 / length / 8);
  CHECK(scaled_up.energy == doctest::Approx(s.energy / 64));
  CHECK(scaled_up.singular.empty());
  CHECK(stripe_lines(scaled_up).size() == 7 * around);
}

TEST_CASE_TEMPLATE("stripes: of a sphere meet, but for singular polys", M, CONCINO_SURFACE_KINDS) {
  const M m = make_sphere<M>({.cells = 6});
  const auto s = stripes(m, direction_field(m, {.symmetry = 2}), 1.5);
  check_agreement(m, s);
  int turns = 0;
  for (const auto& x : s.singular) turns += x.field_turns;
  CHECK(turns == 4);  // a field of lines on a sphere turns by half around four points
  CHECK(s.energy > 0);
  CHECK(s.singular.size() < num_polys(m) / 4);
  const auto again = stripes(m, direction_field(m, {.symmetry = 2}), 1.5);
  CHECK(std::equal(s.angles.values().begin(), s.angles.values().end(), again.angles.values().begin()));
}

TEST_CASE("stripes: bad input") {
  const trimesh m = icosphere(1);
  const auto lines = direction_field(m, {.symmetry = 2});
  const auto crosses = direction_field(m, {.symmetry = 4});
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH_AS((void)stripes(m, crosses, 1), "stripes: the field has symmetry 4; 1 or 2 is needed", invalid_argument);
  for (const double f : {0.0, -1.0, not_a_number, std::numeric_limits<double>::infinity()})
    CHECK_THROWS_WITH_AS((void)stripes(m, lines, f), "stripes: the frequency must be finite and above 0", invalid_argument);
  for (const double f : {1e5, 1e20, 1e308})
    CHECK_THROWS_WITH_AS((void)stripes(m, lines, f), "stripes: more than 1,000 stripes would cross an edge; choose a lower frequency", invalid_argument);
  CHECK_THROWS_AS((void)stripes(m, lines, 1, {.progress = [](double, std::string_view) { return false; }}), cancelled);
  const trimesh other = icosphere(2);
  CHECK_THROWS_WITH_AS((void)stripes(other, lines, 1), "stripes: the field is one of another mesh", invalid_argument);
  // two components, and a vert of no poly
  const trimesh two(two_grids_arrays<trimesh>(3));
  const auto s = stripes(two, direction_field(two, {.symmetry = 2}), 2);
  CHECK(s.energy < 1e-12);
  CHECK(s.singular.empty());
}
