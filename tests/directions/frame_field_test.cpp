#include <concino/directions/frame_field.hpp>
#include <concino/directions/frame_singularities.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/cylinder.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/graph/components.hpp>

#include <support/kinds.hpp>
#include <support/motions.hpp>
#include <support/permuted.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace concino;
using namespace concino::testing;

namespace {

/// How far the nearest vector of a frame, or its opposite, is from a unit vector.
double distance_to(const orthonormal_frame& f, const vec3& n) {
  double best = 2;
  for (const vec3& e : f) best = std::min({best, norm(e - n), norm(e + n)});
  return best;
}

template<class Map, class R>
void check_orthonormal(const Map& frames, const R& elements) {
  for (const auto x : elements) {
    const orthonormal_frame& f = frames[x];
    for (const std::size_t k : {0u, 1u, 2u}) CHECK(norm(cross(f[k], f[(k + 1) % 3]) - f[(k + 2) % 3]) < 1e-12);
  }
}

/// The sum of the indices where lines end on the boundary, and how many ends there are.
template<class M>
std::pair<double, int> ends_on_boundary(const M& m, const singular_lines<M>& s) {
  std::pair<double, int> sum{0, 0};
  for (std::size_t i = 0; i < s.faces.size(); ++i)
    if (is_boundary(m, s.faces[i])) sum.first += (4 - s.valences[i]) / 4.0, ++sum.second;
  return sum;
}

/// Lines end on the boundary only.
template<class M>
void check_ends(const M& m, const singular_lines<M>& s) {
  for (const auto v : verts(s.lines)) {
    const bool on_boundary = v.raw() < s.faces.size() && is_boundary(m, s.faces[v.raw()]);
    CHECK((num_elements(adj_v2v(s.lines, v)) == 1) == on_boundary);
  }
}

}  // namespace

TEST_CASE("harmonics of degree 4: their products are Legendre polynomials, frames are found again") {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    const vec3 x{normal(random), normal(random), normal(random)};
    return x / norm(x);
  };
  const concino::detail::closest_frame closest;
  for (int i = 0; i < 50; ++i) {
    const vec3 x = direction(), y = direction();
    const double t = dot(x, y);
    CHECK(concino::detail::dot(concino::detail::harmonics_at(x), concino::detail::harmonics_at(y)) == doctest::Approx((35 * t * t * t * t - 30 * t * t + 3) / 8));
    orthonormal_frame f = concino::detail::some_frame(x);
    f = concino::detail::closest_aligned_frame(concino::detail::harmonics_at(y), x);
    const auto h = concino::detail::harmonics_of(f);
    CHECK(concino::detail::dot(h, h) == doctest::Approx(1));
    const auto around = concino::detail::harmonics_around(x);
    CHECK(concino::detail::dot(h, around) == doctest::Approx(concino::detail::dot(around, around)));
    const orthonormal_frame found = closest(h, {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}});
    for (const vec3& e : f) CHECK(distance_to(found, e) < 1e-9);
    // the nearest frame is not farther than many others
    const auto q = concino::detail::harmonics_at(y);
    auto sum = q;
    concino::detail::add(sum, h);
    const double best = concino::detail::dot(sum, concino::detail::harmonics_of(closest(sum, f)));
    for (int j = 0; j < 200; ++j) {
      const vec3 n = direction();
      CHECK(concino::detail::dot(sum, concino::detail::harmonics_of(concino::detail::closest_aligned_frame(sum, n))) <= best + 1e-9);
    }
    const orthonormal_frame turned{-f[1], f[2], -f[0]};
    const orthonormal_frame back = concino::detail::turned_to(turned, f);
    for (const std::size_t k : {0u, 1u, 2u}) CHECK(norm(back[k] - f[k]) < 1e-14);
  }
}

TEST_CASE_TEMPLATE("frame_field: a box has its axes, and no singular edge", M, CONCINO_ALL_VOLUME_KINDS) {
  const M m(scaled(rotated(grid_arrays<M>(3)), 0.5));
  const auto frames = frame_field(m);
  CHECK(frames.has_converged);
  CHECK(frames.energy < 1e-16);
  check_orthonormal(frames.verts, verts(m));
  check_orthonormal(frames.polys, polys(m));
  for (const vec3& axis : {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}}) {
    for (const auto v : verts(m)) CHECK(distance_to(frames.verts[v], rotated(axis)) < 1e-8);
    for (const auto p : polys(m)) CHECK(distance_to(frames.polys[p], rotated(axis)) < 1e-8);
  }
  const auto s = singular_edges(frames);
  CHECK(s.faces.empty());
  CHECK(num_verts(s.lines) == 0);
  const auto g = only_embedded_mesh(m);
  const auto thin = frame_field(g);
  CHECK(thin.rounds == frames.rounds);
  for (const auto v : verts(m)) CHECK(thin.verts.data()[index_of(m, v)] == frames.verts[v]);
  CHECK(singular_edges(thin).faces.empty());
}

TEST_CASE_TEMPLATE("frame_field: a cylinder has four lines from the base to the top", M, CONCINO_VOLUME_KINDS) {
  const M m = make_cylinder<M>({.cells = {16, 4}, .height = 1.5});
  const auto frames = frame_field(m);
  CHECK(frames.has_converged);
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v), radial = vec3{x.x, x.y, 0} / std::max(std::hypot(x.x, x.y), 1e-9);
    if (x.z == 0 || x.z == 1.5) CHECK(distance_to(frames.verts[v], {0, 0, 1}) < 1e-8);
    if (arity_v<M> != 4 && std::hypot(x.x, x.y) > 1 - 1e-9) CHECK(distance_to(frames.verts[v], radial) < 1e-8);
    if (is_boundary(m, v) && std::hypot(x.x, x.y) > 1 - 1e-9 && x.z > 0 && x.z < 1.5) CHECK(norm(frames.verts[v][0] - vert_normal(m, v)) < 1e-8);
  }
  const auto s = singular_edges(frames);
  check_ends(m, s);
  CHECK(connected_components(s.lines).count == 4);
  CHECK(ends_on_boundary(m, s).second == 8);
  for (const int valence : s.valences) CHECK(valence == 3);
  for (const auto v : verts(s.lines)) CHECK(num_elements(adj_v2v(s.lines, v)) <= 2);
  double low = 1, high = 0;
  for (const auto v : verts(s.lines)) low = std::min(low, s.lines.point(v).z), high = std::max(high, s.lines.point(v).z);
  CHECK(low == 0);
  CHECK(high == 1.5);
}

TEST_CASE_TEMPLATE("frame_field: on the boundary of a ball the indices sum to 2", M, CONCINO_VOLUME_KINDS) {
  const M m = make_sphere<M>({.cells = 3});
  const auto frames = frame_field(m);
  for (const auto v : verts(m))
    if (is_boundary(m, v)) CHECK(norm(frames.verts[v][0] - vert_normal(m, v)) < 1e-8);
  const auto s = singular_edges(frames);
  check_ends(m, s);
  CHECK(ends_on_boundary(m, s) == std::pair{2.0, 8});
  CHECK(connected_components(s.lines).count == 1);
  CHECK(frames.energy > 0);
  // the same each time
  const auto again = frame_field(m);
  for (const auto v : verts(m)) CHECK(again.verts[v] == frames.verts[v]);
  CHECK(again.energy == frames.energy);
}

TEST_CASE("frame_field: does not depend on the order of elements, on motions and scale") {
  const tetmesh m = make_cylinder<tetmesh>({.cells = {16, 4}, .height = 1.5});
  const auto frames = frame_field(m);
  const std::size_t num_singular = singular_edges(frames).faces.size();
  const auto other = permute(m, 7);
  const auto there = frame_field(other.mesh);
  CHECK(there.energy == doctest::Approx(frames.energy).epsilon(1e-9));
  CHECK(there.rounds == frames.rounds);
  for (const auto v : verts(m))
    for (const vec3& e : frames.verts[v]) CHECK(distance_to(there.verts[other.verts[v.raw()]], e) < 1e-6);
  CHECK(singular_edges(there).faces.size() == num_singular);
  tetmesh moved = m;
  for (const auto v : verts(m)) set_point(moved, v, 8 * rotated(point(m, v)));
  const auto at_moved = frame_field(moved);
  CHECK(at_moved.energy == doctest::Approx(8 * frames.energy).epsilon(1e-6));
  CHECK(at_moved.rounds == frames.rounds);
  for (const auto v : verts(m))
    for (const vec3& e : frames.verts[v]) CHECK(distance_to(at_moved.verts[v], rotated(e)) < 1e-4);
}

TEST_CASE("frame_field: at sharp edges that are not right angles, a vector follows the edge") {
  tetmesh m = make_grid<tetmesh>({.cells = {4, 4, 4}});
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    set_point(m, v, vec3{x.x + 0.5 * x.y, 0.8 * x.y, x.z});
  }
  const auto frames = frame_field(m);
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    const double u = x.x - 0.5 * x.y / 0.8;
    if ((std::abs(u) < 1e-9 || std::abs(u - 1) < 1e-9) && (x.y < 1e-9 || x.y > 0.8 - 1e-9)) CHECK(distance_to(frames.verts[v], {0, 0, 1}) < 1e-8);
  }
  CHECK(singular_edges(frames).faces.empty());
  // a boundary that is smooth throughout: the corners are not sharp any more
  const auto smooth = frame_field(m, {.sharp_angle = 180});
  for (const auto v : verts(m))
    if (is_boundary(m, v)) CHECK(norm(smooth.verts[v][0] - vert_normal(m, v)) < 1e-8);
}

TEST_CASE("frame_field: bad input") {
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const tetmesh empty;
  CHECK_THROWS_WITH_AS((void)frame_field(empty), "frame_field: the mesh has no polys", invalid_mesh);
  const tetmesh m(tet_grid(2));
  CHECK_THROWS_WITH_AS((void)frame_field(m, {.sharp_angle = not_a_number}), "frame_field: sharp_angle must be from 0 to 180 degrees", invalid_argument);
  CHECK_THROWS_WITH_AS((void)frame_field(m, {.max_rounds = 0}), "frame_field: max_rounds must be 1 or more", invalid_argument);
  CHECK_THROWS_WITH_AS((void)frame_field(m, {.tolerance = -1}), "frame_field: tolerance must be from 0 to 1", invalid_argument);
  CHECK_THROWS_AS((void)frame_field(m, {.progress = [](double, std::string_view) { return false; }}), cancelled);
  const auto one = frame_field(m, {.max_rounds = 1});
  CHECK(one.rounds == 1);
  CHECK(!one.has_converged);
  auto bad = m;
  set_point(bad, vert_id{4}, vec3{not_a_number, 0, 0});
  CHECK_THROWS_AS((void)frame_field(bad), invalid_mesh);
  auto inverted = m;
  set_point(inverted, vert_id{0}, vec3{2, 2, 2});
  CHECK_THROWS_AS((void)frame_field(inverted), invalid_mesh);
  // two components, and a vert of no poly
  const tetmesh two(two_grids_arrays<tetmesh>(2));
  const auto frames = frame_field(two);
  CHECK(frames.has_converged);
  CHECK(singular_edges(frames).faces.empty());
  for (const auto v : verts(two)) CHECK(distance_to(frames.verts[v], {1, 0, 0}) < 1e-8);
}
