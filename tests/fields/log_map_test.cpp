#include <concino/fields/log_map.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>
#include <concino/edit/garbage_collect.hpp>
#include <concino/fields/exact_geodesics.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/solve/multigrid.hpp>

#include <support/geodesic_errors.hpp>
#include <support/tangents.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The largest difference from polar coordinates on a mesh in the plane of x and y, of distances and of directions times distances.
template<class M>
double error_on_plane(const M& m, const log_map_result<M>& l, const vert_t<M>& source) {
  const vec3 x = first_edge(m, source), y{-x.y, x.x, 0}, from = point(m, source);
  double worst = 0;
  for (const auto v : verts(m)) {
    const vec3 to = point(m, v) - from;
    worst = std::max(worst, std::abs(l.distance[v] - norm(to)));
    worst = std::max(worst, std::hypot(l.distance[v] * l.direction[v].x - dot(to, x), l.distance[v] * l.direction[v].y - dot(to, y)));
  }
  return worst;
}

/// The mesh seen from below.
trimesh mirrored(const trimesh& m) {
  trimesh r = m;
  for (const vert_id v : verts(m)) set_point(r, v, vec3{point(m, v).x, -point(m, v).y, 0});
  return r;
}

}  // namespace

TEST_CASE_TEMPLATE("log_map: is polar coordinates on the plane", M, trimesh, polygonmesh) {
  const M m = square_or_cube<M>(12);
  const auto log = prepare_log_map(m);
  for (const vec3& at : {vec3{0, 0, 0}, vec3{0.5, 0.5, 0}, vec3{1, 0.4, 0}}) {
    const vert_id v = nearest(m, at);
    CHECK(error_on_plane(m, log.log_map_from(v), v) < 1e-10);
  }
}

TEST_CASE("log_map: is polar coordinates over polygons that are not convex") {
  const polygonmesh m = jigsaw(6);
  CHECK(error_on_plane(m, log_map(m, vert_id{3}), vert_id{3}) < 1e-8);
}

TEST_CASE("log_map: converges on the sphere") {
  double before = 1, turned_before = 1;
  for (const unsigned k : {2u, 3u, 4u}) {
    const trimesh m = icosphere(k);
    const vert_id source{5};
    const vec3 from = point(m, source);
    const auto l = log_map(m, source);
    const vec3 edge = first_edge(m, source);
    vec3 x = edge - dot(edge, from) * from;
    x = x / norm(x);
    const vec3 y = cross(from, x);
    double worst = 0, turned = 0;
    for (const vert_id v : verts(m)) {
      const vec3 to = point(m, v);
      const double arc = std::atan2(norm(cross(to, from)), dot(to, from));
      if (arc > 2.5 || arc == 0) continue;  // the paths to the opposite point have all directions
      worst = std::max(worst, std::abs(l.distance[v] - arc));
      turned = std::max(turned, std::hypot(l.direction[v].x - dot(to, x) / std::sin(arc), l.direction[v].y - dot(to, y) / std::sin(arc)));
    }
    CHECK(worst < 0.6 * before);
    CHECK(turned < turned_before);
    CHECK(turned < 0.01);
    before = worst;
    turned_before = turned;
  }
  CHECK(before < 0.06);
}

TEST_CASE("log_map: distances do not vanish where paths of all directions meet") {
  const trimesh m = icosphere(3);
  const vert_id source{0};
  const auto l = log_map(m, source);
  const vert_id opposite = nearest(m, -point(m, source));
  CHECK(l.distance[opposite] == doctest::Approx(std::numbers::pi).epsilon(0.06));
  const trimesh bumpy = bumpy_ball(3);
  const auto exact = exact_geodesics(bumpy, source);
  const auto of_bumpy = log_map(bumpy, source);
  unsigned next = 0;
  const auto exact_distances = [&](const vec3&) { return exact[vert_id{next++}]; };  // asked in the order of verts
  const deviation e = error_of(of_bumpy.distance, exact_distances);
  CHECK(e.mean < 0.03 * e.farthest);
  CHECK(e.largest < 0.12 * e.farthest);
}

TEST_CASE("log_map: distances are those in the unfolded plane, also across a notch") {
  auto m = make_grid<trimesh>({.cells = {12, 12}, .max = {3, 3, 0}});
  std::vector<poly_id> notch;
  for (const poly_id p : polys(m))
    if (const vec3 c = centroid(m, p); c.x > 1 && c.x < 2 && c.y > 1) notch.push_back(p);
  for (const poly_id p : notch) remove_poly(m, p);
  garbage_collect(m);
  const vert_id source = nearest(m, vec3{2, 3, 0}), end = nearest(m, vec3{1, 3, 0});
  const auto l = log_map(m, source);
  double worst = 0;
  for (const vert_id v : verts(m))
    if (num_elements(adj_v2p(m, v)) > 0) worst = std::max(worst, std::abs(l.distance[v] - distance(point(m, v), point(m, source))));
  CHECK(worst < 1e-9);
  CHECK(l.distance[end] == doctest::Approx(1).epsilon(1e-9));
  CHECK(exact_geodesics(m, source)[end] == doctest::Approx(5).epsilon(1e-9));  // round the notch
}

TEST_CASE("log_map: does not depend on the orientation of polys, and scales with the mesh") {
  trimesh m = square_or_cube<trimesh>(6);
  const auto before = log_map(m, vert_id{8});
  auto turned = jittered(grid_arrays<trimesh>(6), 0.1 / 6, false);
  for (std::size_t t = 2; 3 * t < turned.verts.size(); t += 3) std::swap(turned.verts[3 * t], turned.verts[3 * t + 1]);
  const trimesh mixed(turned);
  const auto after = log_map(mixed, vert_id{8});
  for (const vert_id v : verts(m)) CHECK(after.distance[v] == doctest::Approx(before.distance[v]).epsilon(1e-9));
  CHECK(std::min(error_on_plane(mixed, after, vert_id{8}), error_on_plane(mirrored(mixed), after, vert_id{8})) < 1e-9);
  for (const int power : {-300, 300}) {
    trimesh far = m;
    for (const vert_id v : verts(far)) set_point(far, v, std::ldexp(1.0, power) * point(m, v));
    const auto l = log_map(far, vert_id{8});
    for (const vert_id v : verts(m)) {
      CHECK(l.distance[v] == std::ldexp(before.distance[v], power));
      CHECK(l.direction[v] == before.direction[v]);
    }
  }
}

TEST_CASE("log_map: is exact where heat underflows, and around a band with one side") {
  surface_arrays a{{}, {}, {}, 3};
  const unsigned length = 3000;
  for (unsigned i = 0; i <= length; ++i)
    for (unsigned j = 0; j <= 1; ++j) a.points.push_back({i, j, 0});
  for (unsigned i = 0; i < length; ++i)
    for (const unsigned v : {0u, 2u, 3u, 0u, 3u, 1u}) a.verts.push_back(vert_id{2 * i + v});
  const trimesh strip(a);
  CHECK(error_on_plane(strip, log_map(strip, vert_id{0}), vert_id{0}) < 1e-8 * length);
  CHECK(error_on_plane(strip, log_map(strip, vert_id{0}, {.time = 0.05}), vert_id{0}) < 1e-8 * length);

  // A band that is joined upside down, and the same cut open far from the source: the path crosses the joint in one of them.
  const int n = 200;
  const auto band = [&](int first, int last, bool is_joined) {
    surface_arrays b{{}, {}, {}, 3};
    for (int i = first; i <= last - is_joined; ++i)
      for (const double side : {-0.5, 0.5}) {
        const double angle = 2 * std::numbers::pi / n * i, radius = 40 + side * std::cos(angle / 2);
        b.points.push_back({radius * std::cos(angle), radius * std::sin(angle), side * std::sin(angle / 2)});
      }
    for (int i = 0; i < last - first; ++i)
      for (const int v : {0, 2, 3, 0, 3, 1}) {
        const int k = 2 * i + v;
        b.verts.push_back(vert_id{static_cast<unsigned>(!is_joined || k < 2 * n ? k : k == 2 * n ? 1 : 0)});
      }
    return trimesh(b);
  };
  const trimesh joined = band(0, n, true), open = band(n / 2, n / 2 + n, false);
  const auto l = log_map(joined, vert_id{2 * (n - 10)}), of_open = log_map(open, vert_id{2 * (n / 2 - 10)});
  CHECK(first_edge(joined, vert_id{2 * (n - 10)}) == first_edge(open, vert_id{2 * (n / 2 - 10)}));
  for (const unsigned i : {5u, 20u, 30u}) {
    const vert_id v{2 * i + 1}, w{n + 2 * i};
    CHECK(distance(point(joined, v), point(open, w)) < 1e-12);
    CHECK(l.distance[v] == doctest::Approx(of_open.distance[w]).epsilon(1e-4));  // diagonals at the joint are different
    CHECK(norm(l.direction[v] - of_open.direction[w]) < 1e-3);
  }
}

TEST_CASE("log_map: work on an archetype, with gaps in the indices and on several components") {
  polygonmesh m(two_grids_arrays<polygonmesh>(3));
  remove_poly(m, poly_id{0});
  const auto weak = only_embedded_mesh(m);
  const auto l = log_map(m, vert_id{6});
  const auto of_weak = log_map(weak, weak.vert(vert_id{6}));
  std::size_t unreached = 0;
  for (const auto v : verts(weak)) {
    const vert_id w = weak.base(v);
    CHECK((of_weak.distance[v] == l.distance[w] || of_weak.distance[v] == doctest::Approx(l.distance[w])));
    CHECK(norm(of_weak.direction[v] - l.direction[w]) < 1e-9);
    if (l.distance[w] != std::numeric_limits<double>::infinity()) continue;
    ++unreached;
    CHECK(l.direction[w] == tangent_vector());
  }
  CHECK(2 * unreached > num_verts(m));
}

TEST_CASE("log_map: throw if an argument or the mesh is invalid") {
  const trimesh m = grid<trimesh>(2);
  CHECK_THROWS_WITH_AS(log_map(m, vert_id{9}), "log_map: a source is not a vert of the mesh; take it from verts(m)", invalid_mesh);
  const trimesh empty;
  CHECK_THROWS_AS(log_map(empty, vert_id{0}), invalid_mesh);
  CHECK_THROWS_WITH_AS(prepare_log_map(m, {.time = -1}), "log_map: time is -1; it has to be finite and not negative, 0 for the default", invalid_argument);
  CHECK_THROWS_WITH_AS(log_map(m, vert_id{0}, {.time = 1e-300}), doctest::Contains("log_map: the time is so short that heat vanishes"), invalid_argument);
  CHECK_THROWS_WITH_AS(prepare_log_map(m, {}, multigrid()), doctest::Contains("log_map: the solver is iterative"), unsupported);
  const trimesh two_fans({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  CHECK_THROWS_WITH_AS(log_map(two_fans, vert_id{1}), doctest::Contains("log_map: the polys at vert 0 are not one fan"), unsupported);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 3}, {0, 1, 2}});
  CHECK_THROWS_WITH_AS(log_map(flat, vert_id{0}), "log_map: poly 1 has no area, or points that are not finite; remove it or move its verts", invalid_mesh);
  const trimesh endless({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(log_map(endless, vert_id{0}), invalid_mesh);
  CHECK_THROWS_AS(prepare_log_map(m, {.progress = [](double, auto) { return false; }}), cancelled);
}
