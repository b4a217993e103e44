#include <concino/fields/exact_geodesics.hpp>
#include <concino/fields/exact_paths.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/geometry/centroid.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Calls f for each poly that contains a point of the mesh.
template<class M, class F>
void for_each_poly_at(const M& m, const mesh_point<M>& x, const F& f) {
  if (const auto* v = std::get_if<vert_t<M>>(&x.element)) {
    for (const auto p : adj_v2p(m, *v)) f(p);
  } else if (const auto* e = std::get_if<edge_point<M>>(&x.element)) {
    for (const auto p : adj_e2p(m, e->edge)) f(p);
  } else {
    f(std::get<poly_t<M>>(x.element));
  }
}

template<class M>
bool are_in_one_poly(const M& m, const mesh_point<M>& a, const mesh_point<M>& b) {
  bool found = false;
  for_each_poly_at(m, a, [&](const auto& p) { for_each_poly_at(m, b, [&](const auto& q) { found = found || p == q; }); });
  return found;
}

/// Whether a point lies on its element, up to rounding errors at that scale.
template<class M>
bool lies_on_its_element(const M& m, const mesh_point<M>& x, double scale) {
  if (const auto* v = std::get_if<vert_t<M>>(&x.element)) return x.position == to_vec3(point(m, *v));
  const auto* e = std::get_if<edge_point<M>>(&x.element);
  if (!e) return true;
  vec3 end[2];
  std::size_t k = 0;
  for (const auto v : adj_e2v(m, e->edge)) end[k++] = to_vec3(point(m, v));
  return e->parameter > 0 && e->parameter < 1 && distance(x.position, end[0] + e->parameter * (end[1] - end[0])) <= 1e-15 * scale;
}

/// Checks that every path is on the surface, goes from a source to its target, and is as long as the distance.
template<class M>
void check_paths(const M& m, const exact_paths<M>& paths, double scale = 1) {
  for (const auto v : verts(m)) {
    const auto path = paths.path_to(v);
    const double d = paths.distances()[v];
    if (d == infinity) {
      CHECK(path.points.empty());
      CHECK(path.length == infinity);
      continue;
    }
    REQUIRE(!path.points.empty());
    CHECK(std::get<vert_t<M>>(path.points.back().element) == v);
    CHECK(std::abs(path.length - d) <= 1e-12 * d);
    double sum = 0;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
      CHECK(lies_on_its_element(m, path.points[i], scale));
      if (i == 0) continue;
      CHECK(are_in_one_poly(m, path.points[i - 1], path.points[i]));
      sum += distance(path.points[i - 1].position, path.points[i].position);
    }
    CHECK(std::abs(sum - d) <= 1e-12 * d);
  }
}

surface_arrays bumps(unsigned n, unsigned seed) {
  surface_arrays a = jittered(triangle_grid(n), 0.2 / n, false, seed);
  for (vec3& x : a.points) x.z = 0.3 * std::sin(7 * x.x) * std::cos(5 * x.y);
  return a;
}

surface_arrays spikes(unsigned n) {
  surface_arrays a = jittered(triangle_grid(n), 0.02, false);
  for (std::size_t i = 0; i < a.points.size(); ++i) a.points[i].z = i % 3 == 0 ? 0.4 : 0.0;
  return a;
}

}  // namespace

TEST_CASE("exact_paths: are paths of the right length on flat grids, on bumps and between spikes") {
  for (const surface_arrays& a : {triangle_grid(8), bumps(8, 1), bumps(8, 2), spikes(7)}) {
    const trimesh m(a);
    const auto exact = prepare_exact_geodesics(m);
    for (const unsigned s : {0u, 13u, 40u, 63u}) {
      const auto paths = exact.paths_from(vert_id{s});
      check_paths(m, paths);
      const auto d = exact.distance_from(vert_id{s});
      for (const auto v : verts(m)) CHECK(d[v] == paths.distances()[v]);
    }
  }
}

TEST_CASE("exact_paths: accept polygons that are triangles and archetypes") {
  const surface_arrays a = bumps(5, 3);
  const trimesh m(a);
  const polygonmesh p(with_offsets(a));
  const auto weak = only_embedded_mesh(m);
  check_paths(p, prepare_exact_geodesics(p).paths_from(vert_id{7}));
  const auto paths = prepare_exact_geodesics(weak).paths_from(weak.vert(vert_id{7}));
  check_paths(weak, paths);
  const auto same = prepare_exact_geodesics(m).paths_from(vert_id{7});
  for (const auto v : verts(weak)) CHECK(paths.path_to(v).points.size() == same.path_to(weak.base(v)).points.size());
}

TEST_CASE("exact_paths: on a sphere are near great circles, with the same length in both directions") {
  const trimesh m = icosphere(3);
  const auto exact = prepare_exact_geodesics(m);
  check_paths(m, exact.paths_from(vert_id{5}));
  const auto there = exact.path_between(vert_id{5}, vert_id{100}), back = exact.path_between(vert_id{100}, vert_id{5});
  CHECK(there.length == doctest::Approx(back.length).epsilon(1e-13));
  const vec3 normal = cross(point(m, vert_id{5}), point(m, vert_id{100}));
  for (const auto& x : there.points) CHECK(std::abs(dot(x.position, normal)) < 0.03 * norm(normal));
}

TEST_CASE("exact_paths: work at edges with three triangles and verts with several fans") {
  // three rectangles that share the line x = y = 0
  surface_arrays book{{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}, {}, {}, 3};
  for (const vec3& out : {vec3{1, 0, 0}, vec3{-0.6, 0.8, 0}, vec3{0, -1, 0}})
    for (const double z : {0.0, 1.0, 2.0}) book.points.push_back(out + vec3{0, 0, z});
  for (unsigned page = 0; page < 3; ++page)
    for (unsigned k = 0; k < 2; ++k)
      for (const unsigned v : {k, 3 + 3 * page + k, 4 + 3 * page + k, k, 4 + 3 * page + k, k + 1}) book.verts.push_back(vert_id{v});
  const trimesh m(book);
  const auto exact = prepare_exact_geodesics(m);
  for (const auto v : verts(m)) check_paths(m, exact.paths_from(v));
  const auto path = exact.path_between(vert_id{3}, vert_id{8});
  CHECK(path.length == doctest::Approx(std::sqrt(8.0)));

  const trimesh two({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 0, -1}, {0, 1, -1}}, {{0, 1, 2}, {0, 3, 4}});
  const auto over = prepare_exact_geodesics(two).path_between(vert_id{1}, vert_id{4});
  REQUIRE(over.points.size() == 3);
  CHECK(std::get<vert_id>(over.points[1].element) == vert_id{0});
}

TEST_CASE("exact_paths: bend only at concave corners of the boundary and at saddles") {
  // an L of three unit squares
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}},
                  {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}});
  const auto path = prepare_exact_geodesics(m).path_between(vert_id{5}, vert_id{7});
  CHECK(path.length == doctest::Approx(2));
  REQUIRE(path.points.size() == 3);
  CHECK(std::get<vert_id>(path.points[1].element) == vert_id{4});
}

TEST_CASE("exact_paths: accept several sources with initial distances, anywhere, and components without one") {
  const trimesh m = two_grids<trimesh>(5);
  const auto exact = prepare_exact_geodesics(m);
  check_paths(m, exact.paths_from({vert_id{0}, vert_id{33}}));
  const auto later = exact.paths_from({{vert_id{0}, 0.5}, {vert_id{20}, 0.125}});
  for (const auto v : verts(m)) {
    const auto path = later.path_to(v);
    if (path.points.empty()) continue;
    const vert_id source = std::get<vert_id>(path.points.front().element);
    CHECK((source == vert_id{0} || source == vert_id{20}));
    CHECK(path.length + (source == vert_id{0} ? 0.5 : 0.125) == doctest::Approx(later.distances()[v]).epsilon(1e-12));
  }
  const trimesh b(bumps(6, 4));
  const auto on_bumps = prepare_exact_geodesics(b);
  for (const auto& part : {vec3{0.2, 0.5, 0.3}, vec3{0, 0.5, 0.5}, vec3{1, 0, 0}}) {
    vec3 x;
    std::size_t k = 0;
    for (const auto v : adj_p2v(b, poly_id{25})) x += part[k++] * point(b, v);
    const auto paths = on_bumps.paths_from(poly_id{25}, x);
    check_paths(b, paths);
    CHECK(distance(paths.path_to(vert_id{0}).points.front().position, x) < 1e-14);
  }
}

TEST_CASE("exact_paths: a single path equals that of a full query, and scales with the mesh") {
  const surface_arrays a = bumps(7, 5);
  const trimesh m(a);
  const auto exact = prepare_exact_geodesics(m);
  const auto all = exact.paths_from(vert_id{3});
  for (const unsigned t : {3u, 4u, 31u, 60u}) {
    const auto one = exact.path_between(vert_id{3}, vert_id{t}), same = all.path_to(vert_id{t});
    CHECK(one.length == same.length);
    CHECK(one.points.size() == same.points.size());
  }
  CHECK(exact.path_between(vert_id{3}, vert_id{3}).points.size() == 1);
  CHECK(exact.path_between(vert_id{3}, vert_id{3}).length == 0);
  for (const int power : {500, -500, 1000, -900}) {
    auto b = a;
    for (vec3& x : b.points) x *= std::ldexp(1.0, power);
    const trimesh scaled(b);
    const auto path = prepare_exact_geodesics(scaled).path_between(vert_id{3}, vert_id{60}), same = all.path_to(vert_id{60});
    CHECK(path.length == std::ldexp(same.length, power));
    CHECK(path.points.size() == same.points.size());
  }
}

TEST_CASE("exact_paths: throw errors, work with gaps in the indices, and copies are independent") {
  const auto m = grid<trimesh>(2);
  const auto exact = prepare_exact_geodesics(m);
  CHECK_THROWS_WITH_AS(exact.path_between(vert_id{0}, vert_id{9}), "exact_geodesics: the target is not a vert of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(exact.paths_from(vert_id{0}).path_to(vert_id{9}), "exact_paths: the target is not a vert of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_AS(exact.paths_from(std::vector<vert_id>()), invalid_argument);
  CHECK_THROWS_AS(exact.path_between(vert_id{9}, vert_id{0}), invalid_mesh);

  trimesh gaps(bumps(4, 6));
  remove_vert(gaps, vert_id{6});
  const auto paths = [&] { return prepare_exact_geodesics(gaps).paths_from(vert_id{24}); }();
  check_paths(gaps, paths);
}

TEST_CASE("exact_geodesics: a single query can be one call") {
  const trimesh m(bumps(4, 7));
  const auto exact = prepare_exact_geodesics(m);
  const auto a = exact_geodesics(m, vert_id{3}), b = exact_geodesics(m, {vert_id{3}, vert_id{9}});
  const auto c = exact_geodesics(m, {{vert_id{3}, 0.5}, {vert_id{9}, 0.0}}), d = exact_geodesics(m, poly_id{2}, centroid(m, poly_id{2}));
  for (const auto v : verts(m)) {
    CHECK(a[v] == exact.distance_from(vert_id{3})[v]);
    CHECK(b[v] == exact.distance_from({vert_id{3}, vert_id{9}})[v]);
    CHECK(c[v] == exact.distance_from({{vert_id{3}, 0.5}, {vert_id{9}, 0.0}})[v]);
    CHECK(d[v] == exact.distance_from(poly_id{2}, centroid(m, poly_id{2}))[v]);
  }
}
