// smooth_points with options.slides: verts move along feature lines, and over the boundary of volumes.
#include <concino/remesh/smooth_points.hpp>

#include <concino/generate/boundary_surface.hpp>
#include <concino/generate/cylinder.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/io/load_any.hpp>
#include <concino/mesh.hpp>

#include <support/corpus_meshes.hpp>
#include <support/kinds.hpp>
#include <support/permuted.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// Moves each coordinate of each vert by up to `noise` of an edge, but those that `keeps(x)` names, and z in surfaces.
template<class M, class F>
void add_noise(M& m, double edge, double noise, unsigned seed, const F& keeps) {
  std::mt19937 random(seed);
  for (const auto v : verts(m)) {
    vec3 x = point(m, v);
    for (unsigned i = 0; i < 3; ++i) {
      const double d = noise * edge * (2 * std::ldexp(double(random()), -32) - 1);
      if (!keeps(x, i) && i < dimension_v<M>) (i == 0 ? x.x : i == 1 ? x.y : x.z) += d;
    }
    set_point(m, v, x);
  }
}

double coordinate(const vec3& x, unsigned i) { return i == 0 ? x.x : i == 1 ? x.y : x.z; }
bool is_end(double x) { return std::abs(x) < 1e-12 || std::abs(x - 1) < 1e-12; }

/// The unit square or cube; verts are moved within its planes, edges and, where x is `kept`, within that plane.
template<class M>
M noisy_box(unsigned n, double noise, unsigned seed = 1, double kept = 0) {
  auto m = grid<M>(n);
  add_noise(m, distance(point(m, vert_id{0}), point(m, vert_id{1})), noise, seed, [&](const vec3& x, unsigned i) {
    return is_end(coordinate(x, i)) || (i == 0 && std::abs(x.x - kept) < 1e-12);
  });
  return m;
}

/// Each coordinate that is 0 or 1 remains, and with two or three of them in a square or cube the edge or corner.
template<class M>
void stays_a_box(const M& before, const M& m) {
  for (const auto v : verts(m)) {
    const vec3 a = point(before, v), b = point(m, v);
    for (unsigned i = 0; i < 3; ++i)
      if (is_end(coordinate(a, i))) CHECK(std::abs(coordinate(a, i) - coordinate(b, i)) < 1e-12);
  }
  CHECK(total_measure(m) == doctest::Approx(1).epsilon(1e-12));
}

/// The grids of these kinds.
template<class M> constexpr bool has_reflex_corners = std::is_same_v<M, polygonmesh> || std::is_same_v<M, polyhedralmesh>;

void is_no_worse(const points_smoothing& r) {
  CHECK(r.min_shape_after >= r.min_shape_before);
  CHECK(r.num_inverted_after <= r.num_inverted_before);
}

const auto none_fixed = [](const vert_id&) { return false; };
const auto no_edges = [](const edge_id&) { return false; };

template<class M>
std::size_t num_moved(const M& a, const M& b) {
  std::size_t n = 0;
  for (const auto v : verts(a)) n += !(point(a, v) == point(b, v));
  return n;
}

double distance_to_segment(const vec3& x, const vec3& a, const vec3& b) {
  const double t = std::clamp(dot(x - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  return norm(x - (a + t * (b - a)));
}

}  // namespace

TEST_CASE_TEMPLATE("smooth_points: a square and a cube keep their faces, edges and corners", M, CONCINO_KINDS) {
  for (const double noise : {0.15, 0.3}) {
    const auto before = noisy_box<M>(5, noise);
    auto fixed = before, m = before;
    const auto r = smooth_points(fixed), s = smooth_points(m, {.slides = true});
    is_no_worse(s);
    stays_a_box(before, m);
    if (!has_reflex_corners<M>) CHECK(s.num_inverted_after == 0);
    CHECK(s.min_shape_after >= r.min_shape_after);
    CHECK(num_moved(before, m) > num_moved(before, fixed));
    for (const auto v : verts(fixed))
      if (is_boundary(fixed, v)) CHECK(point(fixed, v) == point(before, v));
  }
}

TEST_CASE_TEMPLATE("smooth_points: regular shapes come back on the boundary too", M, quadmesh, trimesh, hexmesh, tetmesh) {
  auto m = noisy_box<M>(6, 0.35);
  const auto r = smooth_points(m, {.max_rounds = 200, .slides = true});
  const double best = [] { auto regular = grid<M>(6); return smooth_points(regular, {.max_rounds = 0}).min_shape_before; }();
  CHECK(r.min_shape_before < 0.75 * best);
  CHECK(r.min_shape_after > 0.95 * best);
}

TEST_CASE_TEMPLATE("smooth_points: inverted corners on the boundary are turned back", M, trimesh, quadmesh, tetmesh, hexmesh) {
  auto before = grid<M>(5);
  // a vert of the boundary is moved past the next one, within the edge y = z = 0
  for (const auto v : verts(before)) {
    const vec3 x = point(before, v);
    if (norm(x - vec3{0.2, 0, 0}) < 1e-9) set_point(before, v, vec3{0.45, 0.05, dimension_v<M> == 3 ? 0.05 : 0.0});
  }
  auto m = before;
  const auto r = smooth_points(m, {.feature_angle_deg = 180, .slides = true});
  is_no_worse(r);
  CHECK(r.num_inverted_before > 0);
}

TEST_CASE_TEMPLATE("smooth_points: the rims of a cylinder stay on their polygons", M, trimesh, quadmesh, polygonmesh, tetmesh, hexmesh, polyhedralmesh) {
  auto before = make_cylinder<M>({.cells = {24, 6}});
  std::mt19937 random(3);
  for (const auto v : verts(before)) {
    const vec3 x = point(before, v);
    if (std::abs(std::hypot(x.x, x.y) - 1) > 1e-9) continue;
    const double a = std::atan2(x.y, x.x) + 0.3 * (std::ldexp(double(random()), -32) - 0.5) * 6.28 / 24;
    set_point(before, v, vec3{std::cos(a), std::sin(a), x.z});
  }
  auto m = before;
  const auto r = smooth_points(m, {.slides = true});
  is_no_worse(r);
  CHECK(r.min_shape_after > 1.02 * r.min_shape_before);
  const auto surface = [&] {
    if constexpr (dimension_v<M> == 2) return before;
    else return boundary_surface(before);
  }();
  const auto tree = bounding_tree(surface);
  for (const double z : {0.0, 1.0}) {
    std::vector<vec3> polygon;
    for (const auto v : verts(before))
      if (const vec3 x = point(before, v); x.z == z && std::abs(std::hypot(x.x, x.y) - 1) < 1e-9) polygon.push_back(x);
    CHECK(polygon.size() == 24);
    std::sort(polygon.begin(), polygon.end(), [](const vec3& a, const vec3& b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
    std::size_t moved = 0;
    for (const auto v : verts(before)) {
      const vec3 x = point(before, v), y = point(m, v);
      if (x.z == z) CHECK(std::abs(y.z - z) < 1e-12);
      if (x.z != z || std::abs(std::hypot(x.x, x.y) - 1) > 1e-9) continue;
      double least = 1;
      for (std::size_t i = 0; i < polygon.size(); ++i)
        least = std::min(least, distance_to_segment(y, polygon[i], polygon[(i + 1) % polygon.size()]));
      CHECK(least < 1e-12);
      moved += norm(x - y) > 1e-3;
    }
    CHECK(moved > 12);
  }
  for (const auto v : verts(m))
    if (is_boundary(before, v) || dimension_v<M> == 2) CHECK(tree.closest(point(m, v)).distance < 1e-12);
}

TEST_CASE_TEMPLATE("smooth_points: verts of named edges stay or slide", M, trimesh, quadmesh, tetmesh, hexmesh) {
  // the line x = 1/2 in the plane z = 0
  const auto before = noisy_box<M>(6, 0.3, 2, 0.5);
  const auto is_on_line = [&](const vert_id& v) {
    return point(before, v).x == 0.5 && std::abs(point(before, v).z) < 1e-12;
  };
  const auto is_feature = [&](const edge_id& e) {
    const auto [a, b] = end_verts(before, e);
    return is_on_line(a) && is_on_line(b);
  };
  auto m = before, fixed = before;
  is_no_worse(smooth_points(fixed, {}, none_fixed, is_feature));
  is_no_worse(smooth_points(m, {.slides = true}, none_fixed, is_feature));
  stays_a_box(before, m);
  unsigned moved = 0, on_line = 0;
  for (const auto v : verts(m)) {
    if (!is_on_line(v)) continue;
    ++on_line;
    CHECK(point(fixed, v) == point(before, v));
    CHECK(std::abs(point(m, v).x - 0.5) < 1e-12);
    CHECK(std::abs(point(m, v).z) < 1e-12);
    const bool is_joint = is_end(point(before, v).y);  // with the boundary
    if (is_joint) CHECK(point(m, v) == point(before, v));
    else moved += !(point(m, v) == point(before, v));
  }
  CHECK(on_line == 7);
  CHECK(moved >= 4);
  // verts that the caller fixes are ends
  auto both = before;
  smooth_points(both, {.slides = true}, [](const vert_id& v) { return v.raw() % 3 == 0; }, is_feature);
  stays_a_box(before, both);
  for (const auto v : verts(both))
    if (v.raw() % 3 == 0) CHECK(point(both, v) == point(before, v));
}

TEST_CASE_TEMPLATE("smooth_points: what lies between labels is kept", M, CONCINO_KINDS) {
  const auto before = noisy_box<M>(4, 0.3, 4, 0.5);
  const auto label = [&](const poly_id& p) {
    vec3 sum;
    double n = 0;
    for (const auto v : adj_p2v(before, p)) sum += point(before, v), n += 1;
    return sum.x / n < 0.5 ? std::string("left") : std::string("right");
  };
  auto map = make_poly_map<int>(before, 0);
  for (const auto p : polys(before)) map[p] = label(p) == "left";
  auto m = before, by_map = before, fixed = before, without = before;
  is_no_worse(smooth_points(m, {.slides = true}, none_fixed, no_edges, label));
  is_no_worse(smooth_points(by_map, {.slides = true}, none_fixed, no_edges, map));
  is_no_worse(smooth_points(fixed, {}, none_fixed, no_edges, map));
  smooth_points(without, {.slides = true});
  CHECK(whole(m) == whole(by_map));
  stays_a_box(before, m);
  unsigned on_wall = 0, moved = 0, left = 0;
  for (const auto v : verts(m)) {
    if (point(before, v).x != 0.5) continue;
    ++on_wall;
    CHECK(point(fixed, v) == point(before, v));
    CHECK(std::abs(point(m, v).x - 0.5) < 1e-12);
    moved += norm(point(m, v) - point(before, v)) > 1e-4;
    left += std::abs(point(without, v).x - 0.5) > 1e-6;
  }
  CHECK(on_wall > 2);
  if (!has_reflex_corners<M>) CHECK(moved > 0);
  if (!has_reflex_corners<M>) CHECK(left > 0);
  double measure = 0;
  for (const auto p : polys(m))
    if (map[p]) measure += concino::measure(m, p);
  CHECK(measure == doctest::Approx(0.5).epsilon(1e-12));
}

TEST_CASE("smooth_points: joints of three walls stay, the line where they meet is kept") {
  const auto before = noisy_box<hexmesh>(4, 0.0);
  const auto label = [&](const poly_id& p) {
    vec3 sum;
    for (const auto v : adj_p2v(before, p)) sum += point(before, v) / 8;
    return sum.x < 0.5 ? 0 : sum.y < 0.5 ? 1 : 2;
  };
  auto start = before;
  add_noise(start, 0.25, 0.3, 7, [](const vec3& x, unsigned i) {
    return is_end(coordinate(x, i)) || (i < 2 && coordinate(x, i) == 0.5);
  });
  auto m = start;
  is_no_worse(smooth_points(m, {.slides = true}, none_fixed, no_edges, label));
  stays_a_box(start, m);
  for (const auto v : verts(m)) {
    const vec3 a = point(start, v), b = point(m, v);
    if (a.x == 0.5) CHECK(std::abs(b.x - 0.5) < 1e-12);
    if (a.y == 0.5 && a.x > 0.5 - 1e-9) CHECK(std::abs(b.y - 0.5) < 1e-12);
    if (a.x == 0.5 && a.y == 0.5 && is_end(a.z)) CHECK(b == a);
  }
}

TEST_CASE("smooth_points: a named line inside a volume is kept, and stays where it crosses a wall") {
  auto before = grid<hexmesh>(4);
  const auto is_on_line = [](const vec3& x) { return std::abs(x.y - 0.5) < 1e-12 && std::abs(x.z - 0.5) < 1e-12; };
  add_noise(before, 0.25, 0.3, 3, [&](const vec3& x, unsigned i) {
    return is_end(coordinate(x, i)) || (i == 0 && x.x == 0.5) || (i > 0 && is_on_line({0, x.y, x.z}));
  });
  const auto is_feature = [&](const edge_id& e) {
    const auto [a, b] = end_verts(before, e);
    return is_on_line(point(before, a)) && is_on_line(point(before, b));
  };
  const auto label = [&](const poly_id& p) {
    double sum = 0;
    for (const auto v : adj_p2v(before, p)) sum += point(before, v).x / 8;
    return sum < 0.5;
  };
  auto m = before, without = before;
  is_no_worse(smooth_points(without, {.slides = true}, none_fixed, is_feature));
  is_no_worse(smooth_points(m, {.slides = true}, none_fixed, is_feature, label));
  stays_a_box(before, m);
  unsigned on_line = 0, moved = 0;
  for (const auto v : verts(m)) {
    const vec3 x = point(before, v);
    if (!is_on_line(x)) continue;
    ++on_line;
    CHECK(is_on_line(point(m, v)));
    CHECK(is_on_line(point(without, v)));
    if (x.x == 0.5) CHECK(point(m, v) == x);
    moved += !(point(m, v) == x);
  }
  CHECK(on_line == 5);
  CHECK(moved == 2);
}

TEST_CASE("smooth_points: sheets that meet in one line, and closed lines") {
  // three sheets at the z axis
  std::vector<vec3> points;
  std::vector<std::vector<unsigned>> quads;
  const unsigned n = 5;
  for (unsigned k = 0; k <= n; ++k) points.push_back({0, 0, k + (k > 0 && k < n ? 0.3 * (k % 2) - 0.1 : 0.0)});
  for (unsigned sheet = 0; sheet < 3; ++sheet) {
    const double a = 2.0944 * sheet;
    const auto first = static_cast<unsigned>(points.size());
    for (unsigned k = 0; k <= n; ++k) points.push_back({std::cos(a), std::sin(a), double(k)});
    for (unsigned k = 0; k < n; ++k) quads.push_back({k, first + k, first + k + 1, k + 1});
  }
  const quadmesh before(points, quads);
  auto m = before;
  const auto r = smooth_points(m, {.slides = true});
  is_no_worse(r);
  CHECK(r.num_inverted_before == 0);
  CHECK(r.min_shape_after > r.min_shape_before + 0.01);
  for (unsigned k = 0; k <= n; ++k) {
    const vec3 x = point(m, vert_id{k});
    CHECK(std::max(std::abs(x.x), std::abs(x.y)) < 1e-12);
    if (k == 0 || k == n) CHECK(x == point(before, vert_id{k}));
  }

  // an open tube: both boundaries are closed lines without an end
  std::vector<vec3> ring;
  std::vector<std::vector<unsigned>> of_tube;
  for (unsigned k = 0; k < 48; ++k) {
    const double a = 6.283185307179586 * (k % 16 + 0.35 * ((k * 7) % 3)) / 16;
    ring.push_back({std::cos(a), std::sin(a), 0.4 * (k / 16)});
  }
  for (unsigned k = 0; k < 32; ++k) of_tube.push_back({k, k / 16 * 16 + (k + 1) % 16, k / 16 * 16 + (k + 1) % 16 + 16, k + 16});
  const quadmesh tube(ring, of_tube);
  auto smooth = tube;
  const auto s = smooth_points(smooth, {.max_rounds = 200, .slides = true});
  is_no_worse(s);
  CHECK(s.min_shape_after > 0.95);
  const auto tree = bounding_tree(tube);
  for (const auto v : verts(smooth)) {
    CHECK(tree.closest(point(smooth, v)).distance < 1e-12);
    if (v.raw() < 16) CHECK(std::abs(point(smooth, v).z) < 1e-12);
  }
}

TEST_CASE_TEMPLATE("smooth_points: sliding does not depend on storage, nor on a power of two", M, trimesh, polygonmesh, hexmesh, tetmesh) {
  const auto before = noisy_box<M>(4, 0.25);
  auto m = before;
  const smooth_points_options options{.max_rounds = 300, .slides = true};
  const auto r = smooth_points(m, options);
  for (const unsigned seed : {1u, 2u}) {
    auto other = permute(before, seed);
    const auto s = smooth_points(other.mesh, options);
    CHECK(s.min_shape_before == doctest::Approx(r.min_shape_before).epsilon(1e-9));
    CHECK(s.min_shape_after == doctest::Approx(r.min_shape_after).epsilon(0.02));
    CHECK(total_measure(other.mesh) == doctest::Approx(1).epsilon(1e-12));
  }
  for (const double scale : {0x1p-400, 0x1p400}) {
    auto other = before;
    for (const auto v : verts(other)) set_point(other, v, scale * point(other, v));
    smooth_points(other, options);
    for (const auto v : verts(m)) CHECK(distance(point(other, v) / scale, point(m, v)) < 1e-9);
  }
  auto again = before;
  smooth_points(again, options);
  CHECK(whole(again) == whole(m));
}

TEST_CASE("smooth_points: meshes on which hardly anything can slide") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const smooth_points_options slides{.slides = true};
  trimesh no_triangles;
  CHECK(smooth_points(no_triangles, slides).num_moves == 0);
  hexmesh no_hexes;
  CHECK(smooth_points(no_hexes, slides).num_moves == 0);
  trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}, {0, 2, 3}, {4, 0, 1}});
  CHECK(smooth_points(flat, slides).num_moves == 0);
  tetmesh point_only({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, {{0, 1, 2, 3}});
  CHECK(smooth_points(point_only, slides).num_inverted_before == 1);
  // two tets that share a vert, an edge: their verts are corners
  tetmesh at_vert({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}, {{0, 1, 2, 3}, {0, 5, 4, 6}});
  CHECK(smooth_points(at_vert, slides).num_moves == 0);
  tetmesh at_edge({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 2, 3, 1}, {0, 4, 5, 1}});
  CHECK(smooth_points(at_edge, slides).num_moves == 0);
  // the tip of a cone touches the middle of a straight boundary: both fans keep it
  quadmesh touched({{0, 0, 0}, {0.3, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {0, -1, -1}, {1, -1, -1}, {1, -1, 1}, {0, -1, 1}},
                   {{0, 1, 4, 3}, {1, 2, 5, 4}});
  trimesh with_cone({{0, 0, 0}, {0.3, 0, 0}, {2, 0, 0}, {1, 1, 0}, {0, -1, -1}, {1, -1, -1}, {1, -1, 1}, {0, -1, 1}},
                    {{0, 1, 3}, {1, 2, 3}, {1, 4, 5}, {1, 5, 6}, {1, 6, 7}, {1, 7, 4}});
  CHECK(smooth_points(touched, slides).num_moves > 0);
  smooth_points(with_cone, {.feature_angle_deg = 170, .slides = true});
  CHECK(point(with_cone, vert_id{1}) == vec3{0.3, 0, 0});
  // winding that contradicts itself
  auto turned = noisy_box<trimesh>(4, 0.2);
  std::vector<std::vector<unsigned>> triangles;
  std::vector<vec3> points;
  for (const auto v : verts(turned)) points.push_back(point(turned, v));
  for (const auto p : polys(turned)) {
    std::vector<unsigned> t;
    for (const auto v : adj_p2v(turned, p)) t.push_back(v.raw());
    if (p.raw() == 9) std::swap(t[0], t[1]);
    triangles.push_back(t);
  }
  trimesh contradictory(points, triangles);
  const auto before = contradictory;
  is_no_worse(smooth_points(contradictory, slides));
  for (const unsigned v : triangles[9]) CHECK(point(contradictory, vert_id{v}) == point(before, vert_id{v}));

  auto m = noisy_box<tetmesh>(3, 0.2);
  const auto was = whole(m);
  for (const double angle : {-1.0, nan}) CHECK_THROWS_AS(smooth_points(m, {.feature_angle_deg = angle, .slides = true}), invalid_argument);
  unsigned calls = 0;
  CHECK_THROWS_AS(smooth_points(m, {.slides = true, .progress = [&](double, const char*) { return ++calls < 3; }}), cancelled);
  CHECK(whole(m) == was);
  set_point(m, vert_id{5}, vec3{nan, 0, 0});
  CHECK_THROWS_WITH_AS(smooth_points(m, slides), doctest::Contains("vert 5"), invalid_mesh);
  // every edge is named: all verts are joints
  auto all = noisy_box<quadmesh>(4, 0.2);
  const auto all_before = all;
  smooth_points(all, slides, none_fixed, [](const edge_id&) { return true; });
  for (const auto v : verts(all)) CHECK(point(all, v) == point(all_before, v));
}

TEST_CASE("smooth_points: real meshes slide without getting worse") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  unsigned better = 0;
  for (const corpus_row& row : rows) {
    CAPTURE(row.name);
    std::visit(
        [&](auto m) {
          if (num_polys(m) > 6000 && !long_run()) return;
          auto fixed = m;
          const auto r = smooth_points(m, {.max_rounds = 10, .slides = true}), f = smooth_points(fixed, {.max_rounds = 10});
          CHECK(r.min_shape_after >= r.min_shape_before);
          CHECK(r.num_inverted_after <= r.num_inverted_before);
          better += r.min_shape_after > 1.02 * f.min_shape_after;
        },
        load_any(row.file.string()));
  }
  CHECK(better >= std::min<std::size_t>(3, rows.size() / 20));
}
