#include <concino/generate/revolve.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/convert/convert.hpp>
#include <concino/mesh/property.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = 3.14159265358979323846;

/// A square of cells in the plane y = 0, from x = inner to inner + 1.
template<class M>
M profile(unsigned n, double inner) {
  M m = grid<M>(n);
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    set_point(m, v, vec3{inner + x.x, 0, x.y});
  }
  return m;
}

/// The volume between the axis distances `inner` and inner + 1 of height 1, of n segments of the angle `step`.
double ring_volume(double inner, std::size_t n, double step) { return static_cast<double>(n) * std::sin(step) / 2 * ((inner + 1) * (inner + 1) - inner * inner); }

}  // namespace

TEST_CASE_TEMPLATE("revolve: rings of the known volume", M, CONCINO_SURFACE_KINDS) {
  const M m = profile<M>(2, 1);
  for (const double angle : {360.0, -360.0}) {
    const auto v = revolve(m, {0, 0, 0}, {0, 0, 2}, 7, {.angle_deg = angle});
    check_sound(v, 0);
    CHECK(num_verts(v) == 7 * num_verts(m));
    CHECK(num_polys(v) == 7 * num_polys(m));
    CHECK(total_measure(v) == doctest::Approx(ring_volume(1, 7, 2 * pi / 7)).epsilon(1e-12));
  }
  for (const double angle : {90.0, -200.0}) {
    const auto v = revolve(m, {0, 0, 5}, {0, 0, 1}, 5, {.angle_deg = angle});
    check_sound(v, 1);
    CHECK(num_verts(v) == 6 * num_verts(m));
    CHECK(total_measure(v) == doctest::Approx(ring_volume(1, 5, std::abs(angle) / 5 * pi / 180)).epsilon(1e-12));
    for (const vert_id x : verts(m)) CHECK(point(v, x) == point(m, x));
    const double last = angle * pi / 180;
    for (const vert_id x : verts(m)) {
      const vec3 start = point(m, x), end = point(v, vert_id{5 * num_verts(m) + x.raw()});
      CHECK(norm(end - vec3{start.x * std::cos(last), start.x * std::sin(last), start.z}) < 1e-14);
    }
  }
  CHECK(num_polys(revolve(M(), {0, 0, 0}, {0, 0, 1}, 3)) == 0);
  CHECK(total_measure(revolve(only_embedded_mesh(m), {0, 0, 0}, {0, 0, 2}, 7)) == doctest::Approx(ring_volume(1, 7, 2 * pi / 7)).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("revolve: verts on the axis are not repeated", M, trimesh, polygonmesh) {
  const M m = profile<M>(2, 0);
  std::size_t on_axis = 0;
  for (const auto v : verts(m)) on_axis += to_vec3(point(m, v)).x == 0;
  const auto whole = revolve(m, {0, 0, 0}, {0, 0, 1}, 6);
  check_sound(whole, 1);
  CHECK(num_verts(whole) == on_axis + 6 * (num_verts(m) - on_axis));
  CHECK(total_measure(whole) == doctest::Approx(ring_volume(0, 6, pi / 3)).epsilon(1e-12));
  const auto part = revolve(m, {0, 0, 0}, {0, 0, 1}, 2, {.angle_deg = 45});
  check_sound(part, 1);
  CHECK(num_verts(part) == on_axis + 3 * (num_verts(m) - on_axis));
  CHECK(total_measure(part) == doctest::Approx(ring_volume(0, 2, pi / 8)).epsilon(1e-12));
}

TEST_CASE("revolve: properties and correspondence") {
  polygonmesh m = profile<polygonmesh>(1, 0);
  const auto place = vert_property<vec3>(m, "place");
  for (const vert_id v : verts(m)) place[v] = point(m, v);
  const auto name = poly_property<int>(m, "name");
  for (const poly_id p : polys(m)) name[p] = 3 + static_cast<int>(p.raw());
  correspondence c;
  const auto v = revolve(m, {0, 0, 0}, {0, 0, 1}, 5, {.correspondence = &c});
  REQUIRE(c.verts.size() == num_verts(v));
  REQUIRE(c.polys.size() == num_polys(v));
  for (const vert_id x : verts(v)) {
    const vec3 at = find_vert_property<vec3>(v, "place")[x], now = point(v, x);
    CHECK(at == to_vec3(point(m, vert_id{c.verts.only(x.raw())})));
    CHECK(std::abs(at.x - std::hypot(now.x, now.y)) < 1e-14);
    CHECK(at.z == now.z);
  }
  for (const poly_id p : polys(v)) CHECK(find_poly_property<int>(v, "name")[p] == 3 + static_cast<int>(c.polys.only(p.raw())));
  CHECK(property_list(revolve(m, {0, 0, 0}, {0, 0, 1}, 5, {.properties = false})).empty());
}

TEST_CASE("revolve: errors name what is wrong") {
  const trimesh m = profile<trimesh>(1, 1);
  const vec3 origin, z{0, 0, 1};
  CHECK_THROWS_WITH_AS(revolve(m, origin, z, 2), "revolve: segments is 2; it must be at least 3", invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, origin, z, 0, {.angle_deg = 10}), "revolve: segments is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, origin, z, 1, {.angle_deg = -180}), "revolve: segments is 1; it must be at least 2", invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, origin, z, 3, {.angle_deg = 0}), "revolve: angle_deg is 0; it must be between -360 and 360, and not 0", invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, origin, z, 3, {.angle_deg = 361}), doctest::Contains("revolve: angle_deg is 361"), invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, origin, z, 3, {.angle_deg = std::nan("")}), doctest::Contains("revolve: angle_deg is "), invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, origin, origin, 3), "revolve: axis is 0; it must have a direction", invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, origin, vec3{0, 0, std::numeric_limits<double>::infinity()}, 3), "revolve: axis.z is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, vec3{std::nan(""), 0, 0}, z, 3), "revolve: centre.x is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, origin, z, std::size_t{1} << 31), doctest::Contains("revolve: segments asks for "), invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(m, vec3{1.5, 0, 0}, z, 8), doctest::Contains("move to both of its sides; it must not cross the axis"), invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(profile<trimesh>(2, 1), vec3{1.5, 0, 0}, z, 8), doctest::Contains("so that their cells would overlap"), invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(grid<trimesh>(1), vec3{-1, 0, 0}, z, 8), doctest::Contains("revolve: poly 0 moves parallel to itself"), invalid_argument);
  CHECK_THROWS_WITH_AS(revolve(profile<quadmesh>(2, 0), origin, z, 8), doctest::Contains("on the axis, where its cells are no hexes; turn convert<polygonmesh>(m)"), unsupported);
  trimesh bad = m;
  set_point(bad, vert_id{1}, vec3{0, std::nan(""), 0});
  CHECK_THROWS_WITH_AS(revolve(bad, origin, z, 3), "revolve: the point of vert 1 is not finite", invalid_mesh);
  trimesh line = m;
  for (const vert_id v : verts(line)) set_point(line, v, vec3{0, 0, static_cast<double>(v.raw())});
  CHECK_THROWS_WITH_AS(revolve(line, origin, z, 3), "revolve: poly 0 has no area; remove it first", invalid_mesh);
}

TEST_CASE("revolve: cells of polygons that are not convex are listed") {
  std::vector<poly_id> inverted{poly_id{7}};
  revolve(profile<trimesh>(2, 0), {0, 0, 0}, {0, 0, 1}, 6, {.inverted = &inverted});
  CHECK(inverted.empty());
  const std::vector<vec3> x{{1, 0, 0}, {2, 0, 0}, {1.25, 0, 0.25}, {1, 0, 1}, {0.5, 0, 0}, {0.5, 0, 1}};
  const std::vector<std::vector<unsigned>> quads{{4, 0, 3, 5}, {0, 1, 2, 3}};  // the second one with a reflex vert, 2
  revolve(quadmesh(x, quads), {0, 0, 0}, {0, 0, 1}, 12, {.angle_deg = 60, .inverted = &inverted});
  REQUIRE(inverted.size() == 12);
  for (unsigned k = 0; k < 12; ++k) CHECK(inverted[k] == poly_id{2 * k + 1});
}
