#include <concino/lines/trace_geodesic.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/fields/log_map.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/geometry/centroid.hpp>

#include <support/geodesic_errors.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = std::numbers::pi;

/// The surface of the cube [0, 1]^3, oriented outward.
polygonmesh cube() {
  return polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                     {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
}

/// A prism of n quads about the z-axis, of rings of radius 1, cut into triangles.
trimesh prism(unsigned n, unsigned rings) {
  surface_arrays a{{}, {}, {}, 3};
  for (unsigned j = 0; j <= rings; ++j)
    for (unsigned i = 0; i < n; ++i) a.points.push_back({std::cos(2 * pi * i / n), std::sin(2 * pi * i / n), j});
  for (unsigned j = 0; j < rings; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const unsigned p = j * n + i, q = j * n + (i + 1) % n;
      for (const unsigned v : {p, q, q + n, p, q + n, p + n}) a.verts.push_back(vert_id{v});
    }
  return trimesh(a);
}

template<class M>
double sum_of_pieces(const traced_geodesic<M>& t) {
  double sum = 0;
  for (std::size_t i = 1; i < t.points.size(); ++i) sum += distance(t.points[i - 1].position, t.points[i].position);
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("trace_geodesic: is straight on the plane", M, trimesh, polygonmesh) {
  const M m = square_or_cube<M>(8);
  const auto trace = prepare_trace_geodesic(m);
  const auto log = prepare_log_map(m);
  const vert_id source = nearest(m, {0.4, 0.6, 0});
  const auto l = log.log_map_from(source);
  for (const vert_id v : verts(m)) {
    if (v == source) continue;
    const vec3 to = point(m, v) - point(m, source);
    const auto by_space = trace.trace_from(source, to, norm(to));
    const auto by_frame = trace.trace_from(source, l.direction[v], l.distance[v]);
    CHECK(distance(by_space.points.back().position, point(m, v)) < 1e-12);
    CHECK(distance(by_frame.points.back().position, point(m, v)) < 1e-9);
    CHECK(norm(by_space.direction - to / norm(to)) < 1e-12);
    CHECK(sum_of_pieces(by_space) == doctest::Approx(norm(to)).epsilon(1e-12));
    for (std::size_t i = 1; i + 1 < by_space.points.size(); ++i) CHECK(norm(cross(by_space.points[i].position - point(m, source), to)) < 1e-12);
  }
}

TEST_CASE("trace_geodesic: is straight on the unrolled cube") {
  const polygonmesh m = cube();
  const auto trace = prepare_trace_geodesic(m);
  // From the face y = 0 over x = 1, y = 1 and x = 0 back: unrolled, x runs from 0 to 4 and z stays.
  const vec3 from{0.3, 0, 0.2}, d{4, 0, 0.5};
  const auto t = trace.trace_from(mesh_point<polygonmesh>{poly_id{2}, from}, d, norm(d));
  CHECK(distance(t.points.back().position, {0.3, 0, 0.7}) < 1e-12);
  CHECK(t.stopped_by == line_end::max_length);
  CHECK(norm(t.direction - d / norm(d)) < 1e-12);
  CHECK(sum_of_pieces(t) == doctest::Approx(norm(d)).epsilon(1e-13));
  CHECK(trace_geodesic(m, poly_id{2}, from, {4, 0, 0.5}, norm(d)).points.back().position == t.points.back().position);
  // The frame of the face has x along its first edge, which is that of the x-axis, and y along z.
  const auto same = trace.trace_from(mesh_point<polygonmesh>{poly_id{2}, from}, tangent_vector{4, 0.5}, norm(d));
  CHECK(distance(same.points.back().position, {0.3, 0, 0.7}) < 1e-12);
  // Up over the edge to z = 1: unrolled, z above 1 is y.
  const auto over = trace.trace_from(mesh_point<polygonmesh>{poly_id{2}, from}, vec3{0.2, 0, 1}, std::hypot(0.2, 1));
  CHECK(distance(over.points.back().position, {0.5, 0.2, 1}) < 1e-12);
  // Into the corner (1, 0, 1), where three right angles meet: equal angles on both sides lead along the diagonal of the opposite sector.
  const auto corner = trace.trace_from(mesh_point<polygonmesh>{poly_id{2}, {0.5, 0, 0.5}}, vec3{1, 0, 1}, std::sqrt(0.5) + 0.4);
  CHECK(distance(corner.points.back().position, {1, 0.4, 1}) < 1e-12);
  CHECK(std::holds_alternative<vert_id>(corner.points[corner.points.size() - 2].element));
}

TEST_CASE("trace_geodesic: is straight on the unrolled cylinder and cone") {
  const unsigned n = 12;
  const trimesh m = prism(n, 5);
  const double side = 2 * std::sin(pi / n);
  const vert_id start{0};
  for (const double slope : {0.0, 0.1, 0.25, 0.9, 20.0}) {
    const vec3 along = (point(m, vert_id{1}) - point(m, start)) / side, d = along + vec3{0, 0, slope};
    // Around as far as the boundary is not reached. It starts at a vert of the boundary.
    const double around = std::min(4.9 / std::max(slope, 1e-9), 30.0);
    const auto t = trace_geodesic(m, start, d, around * std::hypot(1, slope));
    CHECK(t.stopped_by == line_end::max_length);
    const auto column = static_cast<unsigned>(around / side);
    const vec3 a = point(m, vert_id{column % n}), b = point(m, vert_id{(column + 1) % n});
    const vec3 end = a + (around / side - column) * (b - a) + vec3{0, 0, slope * around};
    CHECK(distance(t.points.back().position, end) < 1e-12);
  }
  const auto up = trace_geodesic(m, start, vec3{0, 0, 1}, 100);
  CHECK(up.stopped_by == line_end::boundary);
  CHECK(up.length == doctest::Approx(5));
  CHECK(up.points.size() == 6);

  // A cone of k triangles with the angle a at its apex is unrolled as a part of a disk.
  const unsigned k = 7;
  const double a = 0.6, radius = 2;
  surface_arrays cone{{{0, 0, 0}}, {}, {}, 3};
  const double wide = radius * std::sin(a / 2) / std::sin(pi / k), high = std::sqrt(radius * radius - wide * wide);
  for (unsigned i = 0; i < k; ++i) cone.points.push_back({wide * std::cos(2 * pi * i / k), wide * std::sin(2 * pi * i / k), -high});
  for (unsigned i = 0; i < k; ++i)
    for (const unsigned v : {0u, 1 + i, 1 + (i + 1) % k}) cone.verts.push_back(vert_id{v});
  const trimesh c(cone);
  // From a point at distance 1 of the apex on the first edge, at a right angle to it: at the angle b the distance is 1 / cos(b).
  const vec3 edge = point(c, vert_id{1}) / radius, beside = point(c, vert_id{2}) / radius - std::cos(a) * edge;
  edge_id first{0};
  for (const edge_id e : adj_v2e(c, vert_id{0}))
    for (const vert_id v : adj_e2v(c, e))
      if (v == vert_id{1}) first = e;
  for (const double b : {0.3, 0.7, 0.95}) {
    const auto t = trace_geodesic(c, mesh_point<trimesh>{edge_point<trimesh>{first, 0.5}, {}}, beside, std::tan(b));
    const auto sector = static_cast<unsigned>(b / a);
    const vec3 p = point(c, vert_id{1 + sector}) / radius, q = point(c, vert_id{1 + (sector + 1) % k}) / radius;
    const double within = b - a * sector;
    const vec3 end = (std::sin(a - within) * p + std::sin(within) * q) / (std::sin(a) * std::cos(b));
    CHECK(distance(t.points.back().position, end) < 1e-12);
  }
  // All edges at the apex lead down, but some directions are nearer to this one than others.
  const auto down = trace_geodesic(c, vert_id{0}, vec3{0.1, 0, 1}, 0.5);
  CHECK(down.length == 0.5);
  CHECK(down.direction.x > 0.1);
  CHECK_THROWS_AS(trace_geodesic(c, vert_id{0}, vec3{0, 0, 1}, 0.5), invalid_argument);
  // Through the apex, half of its angle on each side.
  const auto through = trace_geodesic(c, vert_id{1}, vec3{0, 0, 0} - point(c, vert_id{1}), radius + 1);
  const vec3 opposite = 0.5 * (point(c, vert_id{4}) + point(c, vert_id{5}));
  CHECK(distance(through.points.back().position, opposite / norm(opposite)) < 1e-12);
}

TEST_CASE("trace_geodesic: follows great circles of the sphere") {
  double before = 1;
  for (const unsigned k : {2u, 3u, 4u}) {
    const trimesh m = icosphere(k);
    const auto trace = prepare_trace_geodesic(m);
    double worst = 0;
    for (const unsigned s : {0u, 7u, 30u}) {
      const vec3 from = point(m, vert_id{s});
      for (int i = 0; i < 8; ++i) {
        const auto t = trace.trace_from(vert_id{s}, tangent_vector{std::cos(0.3 + i), std::sin(0.3 + i)}, 1.5);
        const vec3 start = t.points[1].position - from, axis = cross(from, start), n = axis / norm(axis);
        for (const auto& x : t.points) worst = std::max(worst, std::abs(dot(n, x.position)));
      }
    }
    CHECK(worst < 0.7 * before);
    before = worst;
  }
  CHECK(before < 0.025);
}

TEST_CASE("trace_geodesic: says why it ends, and goes back the way it came") {
  const trimesh m = icosphere(2);
  const auto trace = prepare_trace_geodesic(m);
  const vec3 from = 0.9 * centroid(m, poly_id{3}) + 0.1 * point(m, *adj_p2v(m, poly_id{3}).begin());
  const auto there = trace.trace_from(mesh_point<trimesh>{poly_id{3}, from}, tangent_vector{0.3, 0.7}, 40);
  CHECK(there.length == 40);
  const auto back = trace.trace_from(there.points.back(), -1 * there.direction, 40);
  CHECK(distance(back.points.back().position, there.points.front().position) < 1e-9);
  const auto few = trace.trace_from(vert_id{0}, tangent_vector{1, 2}, 40, {.max_steps = 5});
  CHECK(few.stopped_by == line_end::max_steps);
  CHECK(few.points.size() == 6);
  const auto none = trace.trace_from(vert_id{0}, tangent_vector{1, 2}, 0);
  CHECK(none.points.size() == 1);

  const trimesh square = grid<trimesh>(2);
  CHECK(trace_geodesic(square, vert_id{0}, tangent_vector{std::cos(-0.1), std::sin(-0.1)}, 1).stopped_by == line_end::boundary);
  for (const vec3& d : {vec3{-1, 0, 0}, vec3{-1, -1, 0}, vec3{1, -0.1, 0}}) {
    const auto out = trace_geodesic(square, vert_id{0}, d, 1);
    CHECK(out.stopped_by == line_end::boundary);
    CHECK(out.length == 0);
  }
  const trimesh book({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  const auto spine = trace_geodesic(book, mesh_point<trimesh>{poly_id{0}, {0.3, 0, 0.3}}, vec3{-1, 0, 0}, 5);
  CHECK(spine.stopped_by == line_end::non_manifold);
  CHECK(spine.length == doctest::Approx(0.3));
}

TEST_CASE_TEMPLATE("trace_geodesic: goes on along a straight boundary to its end", M, CONCINO_SURFACE_KINDS) {
  M m = make_grid<M>({.cells = {5, 5}});
  const M regular = m;
  jitter(m, 0.2, {.seed = 7, .keep_boundary = false});
  for (const auto v : verts(m)) {  // verts of the boundary at any places along it
    vec3 x = point(m, v);
    for (const std::size_t k : {0u, 1u, 2u})
      if (const double before = point(regular, v)[k]; before == 0 || before == 1) x[k] = before;
    set_point(m, v, x);
  }
  const auto trace = prepare_trace_geodesic(m);
  std::size_t n = 0;
  const auto check = [&](const mesh_point<M>& start, const vec3& d) {
    const vec3 end(d.x > 0 ? 1 : d.x < 0 ? 0 : start.position.x, d.y > 0 ? 1 : d.y < 0 ? 0 : start.position.y, 0);
    const auto t = trace.trace_from(start, d, 5);
    CHECK(t.stopped_by == line_end::boundary);
    CHECK(distance(t.points.back().position, end) < 1e-12);
    CHECK(t.length == doctest::Approx(distance(start.position, end)));
    ++n;
  };
  for (const auto e : edges(m)) {
    if (!is_boundary(m, e)) continue;
    const auto [a, b] = end_verts(m, e);
    const vec3 along = point(m, b) - point(m, a), d(std::round(along.x * 1e3), std::round(along.y * 1e3), 0), x = 0.7 * point(m, a) + 0.3 * point(m, b);
    for (const double sense : {1.0, -1.0}) {
      check({edge_point<M>{e, 0.3}, x}, sense * d);
      check({*adj_e2p(m, e).begin(), x}, sense * d);
      check({a, point(m, a)}, sense * d);
    }
  }
  CHECK(n >= 120);
}

TEST_CASE("trace_geodesic: goes on straight over a corner of the boundary that the surface lies around") {
  // an L of three unit squares, with the inner corner (1, 1) at vert 4
  const polygonmesh m({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}}, {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}});
  for (const bool mirrored : {false, true}) {
    const auto turned = [&](const vec3& x) { return mirrored ? vec3(x.y, x.x, 0) : x; };
    const auto along = trace_geodesic(m, vert_id{mirrored ? 5u : 7u}, turned({0, -1, 0}), 5);  // down its boundary, on between two squares
    CHECK(along.stopped_by == line_end::boundary);
    CHECK(distance(along.points.back().position, turned({1, 0, 0})) < 1e-12);
    const mesh_point<polygonmesh> above{poly_id{mirrored ? 1u : 2u}, turned({0.75, 1.5, 0})};
    const auto beside = trace_geodesic(m, above, turned({0.25, -0.5, 0}), 5);  // touches the corner
    CHECK(distance(beside.points.back().position, turned({1.5, 0, 0})) < 1e-12);
  }
  const auto into = trace_geodesic(m, vert_id{0}, vec3(1, 1, 0), 5);
  CHECK(into.stopped_by == line_end::boundary);
  CHECK(distance(into.points.back().position, {1, 1, 0}) < 1e-12);
}

TEST_CASE("trace_geodesic: work on an archetype") {
  const polygonmesh m = cube();
  const auto weak = only_embedded_mesh(m);
  const auto t = trace_geodesic(m, vert_id{2}, {-1, -0.3, 0.2}, 3);
  const auto of_weak = trace_geodesic(weak, weak.vert(vert_id{2}), {-1, -0.3, 0.2}, 3);
  REQUIRE(t.points.size() == of_weak.points.size());
  for (std::size_t i = 0; i < t.points.size(); ++i) CHECK(distance(t.points[i].position, of_weak.points[i].position) < 1e-12);
}

TEST_CASE("trace_geodesic: throw if an argument or the mesh is invalid") {
  const trimesh m = grid<trimesh>(2);
  const auto trace = prepare_trace_geodesic(m);
  const tangent_vector x{1, 0};
  CHECK_THROWS_WITH_AS(trace.trace_from(vert_id{9}, x, 1), "trace_geodesic: the start, vert 9, is no vert of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(trace.trace_from(vert_id{0}, x, -1), "trace_geodesic: the length is -1; it has to be finite and not negative", invalid_argument);
  CHECK_THROWS_WITH_AS(trace.trace_from(vert_id{0}, tangent_vector{0, 0}, 1), "trace_geodesic: the direction is 0 or not finite", invalid_argument);
  CHECK_THROWS_AS(trace.trace_from(vert_id{0}, {std::nan(""), 0, 0}, 1), invalid_argument);
  CHECK_THROWS_WITH_AS(trace.trace_from(vert_id{4}, {0, 0, 1}, 1), doctest::Contains("the direction at vert 4 is perpendicular to the surface"), invalid_argument);
  CHECK_THROWS_WITH_AS(trace.trace_from(vert_id{0}, x, 1, {.max_steps = 0}), "trace_geodesic: max_steps is 0; it has to be at least 1", invalid_argument);
  const auto at = [&](auto element, const vec3& position) { return mesh_point<trimesh>{element, position}; };
  CHECK_THROWS_AS(trace.trace_from(at(poly_id{8}, {}), x, 1), invalid_mesh);
  CHECK_THROWS_WITH_AS(trace.trace_from(at(poly_id{0}, {0, 0, std::nan("")}), x, 1), "trace_geodesic: the position of the start is not finite", invalid_argument);
  CHECK_THROWS_WITH_AS(trace.trace_from(at(poly_id{0}, {0.1, 0.1, 1}), x, 1),
                       doctest::Contains("the position of the start is not in poly 0, but "), invalid_argument);
  CHECK_THROWS_WITH_AS(trace.trace_from(at(poly_id{0}, {0.3, 0.1, 0}), {0, 0, 1}, 1),
                       "trace_geodesic: the direction is perpendicular to the surface; choose another", invalid_argument);
  CHECK_THROWS_AS(trace.trace_from(at(edge_point<trimesh>{edge_id{99}, 0.5}, {}), x, 1), invalid_mesh);
  CHECK_THROWS_WITH_AS(trace.trace_from(at(edge_point<trimesh>{edge_id{0}, 2}, {}), x, 1),
                       doctest::Contains("its parameter is not in [0, 1]"), invalid_argument);
  const trimesh two_fans({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  CHECK_THROWS_WITH_AS(trace_geodesic(two_fans, vert_id{0}, x, 1), doctest::Contains("the polys at vert 0 are not one fan"), unsupported);
  CHECK(trace_geodesic(two_fans, vert_id{0}, {1, 1, 0}, 0.5).stopped_by == line_end::max_length);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 3}, {0, 1, 2}});
  CHECK_THROWS_AS(prepare_trace_geodesic(flat), invalid_mesh);
  const trimesh empty;
  CHECK_THROWS_AS(trace_geodesic(empty, vert_id{0}, x, 1), invalid_mesh);
}
