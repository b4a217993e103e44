#include <concino/fields/heat_geodesics.hpp>

#include <concino/geometry/centroid.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/geodesic_errors.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE_TEMPLATE("heat_geodesics: accept several sources, components and isolated verts", M, CONCINO_KINDS) {
  const M m = two_grids<M>(3);
  const vert_id alone{static_cast<unsigned>(num_verts(m) - 1)}, a{0}, b = nearest(m, {1, 1, VolumeMesh<M> ? 1 : 0}), c = nearest(m, {2, 0, 0});
  const auto heat = prepare_heat_geodesics(m, {.clamp = true});
  const auto d = heat.distance_from({a, b});
  CHECK(d[a] == 0);
  CHECK(d[b] == 0);
  CHECK(d[c] == infinity);
  CHECK(d[alone] == infinity);
  for (const auto v : verts(m)) CHECK((d[v] == infinity) == (point(m, v)[0] > 1.5));
  const auto each = heat.distance_from(std::vector<vert_id>{a, c, alone});
  const auto da = heat.distance_from(a);
  for (const auto v : verts(m)) {
    if (point(m, v)[0] > 1.5) continue;
    CHECK(each[v] == doctest::Approx(da[v]));
    CHECK(d[v] <= da[v] + 0.2);
    CHECK(d[v] >= 0);
  }
  CHECK(each[c] == 0);
  CHECK(each[alone] == 0);
  CHECK(each[nearest(m, {3, 0, 0})] == doctest::Approx(1).epsilon(0.3));

  // a source has no effect if another one is nearer even there
  const auto late = heat.distance_from({{a, 0.25}, {b, 40.0}});
  CHECK(late[a] == 0.25);
  for (const auto v : verts(m))
    if (da[v] < infinity) CHECK(late[v] == doctest::Approx(da[v] + 0.25));
  CHECK(heat.distance_from(std::vector<std::pair<vert_id, double>>{{a, -1.0}})[a] == -1);
}

TEST_CASE_TEMPLATE("heat_geodesics: one call equals a prepared query, from any sources", M, CONCINO_KINDS) {
  const M m = square_or_cube<M>(2);
  const vert_id a{0}, b{5};
  const poly_id p{1};
  const vec3 x = centroid(m, p);
  const heat_geodesics_options options{.time = 0.3};
  const auto heat = prepare_heat_geodesics(m, options);
  const auto same = [](const auto& d, const auto& e) { return std::equal(d.values().begin(), d.values().end(), e.values().begin()); };
  CHECK(same(heat_geodesics(m, a, options), heat.distance_from(a)));
  CHECK(same(heat_geodesics(m, {a, b}, options), heat.distance_from({a, b})));
  CHECK(same(heat_geodesics(m, std::vector<vert_id>{a, b}, {.time = 0.3}, ldlt()), heat.distance_from({a, b})));
  CHECK(same(heat_geodesics(m, {{a, 0.5}, {b, 0.25}}, options), heat.distance_from({{a, 0.5}, {b, 0.25}})));
  CHECK(same(heat_geodesics(m, p, x, options), heat.distance_from(p, x)));
  CHECK(same(heat_geodesics(m, a), prepare_heat_geodesics(m).distance_from(a)));
}

TEST_CASE_TEMPLATE("heat_geodesics: a source may be a point in a poly", M, CONCINO_KINDS) {
  const M m = grid<M>(VolumeMesh<M> ? 4 : 8);
  const auto heat = prepare_heat_geodesics(m, {.clamp = true});
  const poly_id p{static_cast<unsigned>(num_polys(m) / 2 + 1)};
  vec3 x;
  double n = 0;
  for (const auto v : adj_p2v(m, p)) {
    x += point(m, v);
    n += 1;
  }
  x = x / n;
  const deviation e = error_of(heat.distance_from(p, x), [&](const vec3& y) { return distance(x, y); });
  CHECK(e.mean / e.farthest < (VolumeMesh<M> ? 0.1 : 0.05));
}

TEST_CASE_TEMPLATE("heat_geodesics: a source at a vert or an edge is the same as a place of each of its polys", M, CONCINO_KINDS) {
  const M m = square_or_cube<M>(3);
  const auto heat = prepare_heat_geodesics(m, {.clamp = true});
  const poly_id p{static_cast<unsigned>(num_polys(m) / 2)};
  const vert_id v = *adj_p2v(m, p).begin();
  const edge_id e = *adj_p2e(m, p).begin();
  const auto [a, b] = end_verts(m, e);
  const vec3 x = 0.7 * point(m, a) + 0.3 * point(m, b);
  const auto from_vert = heat.distance_from(v), from_edge = heat.distance_from(p, x);
  const auto largest_difference = [&](const auto& one, const auto& two) {
    double largest = 0;
    for (const auto w : verts(m)) largest = std::max(largest, std::abs(one[w] - two[w]));
    return largest;
  };
  for (const auto q : adj_v2p(m, v)) CHECK(largest_difference(heat.distance_from(q, point(m, v)), from_vert) == 0);
  for (const auto q : adj_e2p(m, e)) CHECK(largest_difference(heat.distance_from(q, x), from_edge) < 1e-12);
}

TEST_CASE_TEMPLATE("heat_geodesics: are between straight lines and edge paths", M, CONCINO_KINDS) {
  M m(jittered(grid_arrays<M>(VolumeMesh<M> ? 3 : 8), 0.03, VolumeMesh<M>));
  for (const auto v : verts(m)) set_point(m, v, vec3{point(m, v).x, 0.1 * point(m, v).y, point(m, v).z + 0.3 * std::sin(3 * point(m, v).x)});
  const std::vector<std::pair<vert_id, double>> sources{{vert_id{0}, 0.1}, {vert_id{7}, -0.2}, {vert_id{20}, 0.3}, {vert_id{11}, 0.0}};
  const auto d = heat_geodesics(m, sources, {.clamp = true});
  const auto low = [&](const auto v) {
    double least = infinity;
    for (const auto& [s, before] : sources) least = std::min(least, before + distance(point(m, v), point(m, s)));
    return least;
  };
  auto along = make_vert_map<double>(m, infinity);  // shortest edge paths by the Bellman-Ford algorithm
  for (const auto& [s, before] : sources) along[s] = std::min(along[s], before);
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto v : verts(m))
      for (const auto w : adj_v2v(m, v))
        if (const double on = along[v] + distance(point(m, v), point(m, w)); on < along[w]) {
          along[w] = on;
          changed = true;
        }
  }
  for (const auto v : verts(m)) {
    CHECK(d[v] >= low(v) - 1e-14);
    CHECK(d[v] <= along[v] + 1e-14);
  }
}
