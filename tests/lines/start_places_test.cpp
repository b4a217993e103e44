#include <concino/lines/field_at_verts.hpp>
#include <concino/lines/integral_line.hpp>
#include <concino/lines/trace_geodesic.hpp>

#include <concino/generate/grid.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/geometry/bounding_tree.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
M jittered(std::uint64_t seed) {
  M m = make_grid<M>({.cells = {3, 3, 3}});
  jitter(m, 0.2, {.seed = seed});
  return m;
}

/// Where a straight line from x leaves the unit square or cube.
template<class M>
vec3 expected_end(const vec3& x, const vec3& d) {
  double t = 1e9;
  for (std::size_t k = 0; k < dimension_v<M>; ++k)
    if (d[k] != 0) t = std::min(t, ((d[k] > 0 ? 1 : 0) - x[k]) / d[k]);
  return x + std::max(t, 0.0) * d;
}

/// The corners of each poly, and places on its edges and faces.
template<class M>
std::vector<mesh_point<M>> places_on_borders(const M& m) {
  std::vector<mesh_point<M>> places;
  for (const auto p : polys(m)) {
    for (const auto v : adj_p2v(m, p)) places.push_back({p, point(m, v)});
    for (const auto e : adj_p2e(m, p)) {
      const auto [a, b] = end_verts(m, e);
      places.push_back({p, 0.5 * (point(m, a) + point(m, b))});
    }
    for (const auto facet : adj_p2facet(m, p)) {
      std::vector<vec3> x;
      for (const auto v : adj_facet2v(m, facet)) x.push_back(point(m, v));
      if (x.size() <= 3) places.push_back({p, 0.6 * x[0] + 0.3 * x[1] + 0.1 * x.back()});
    }
  }
  return places;
}

/// The number of places from which a straight line leads elsewhere.
template<class M, class F>
std::size_t wrong_ends(const M& m, unsigned seed, const F& end_of_line) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-1, 1);
  std::size_t wrong = 0;
  for (const auto& x : places_on_borders(m)) {
    const vec3 d(any(random), any(random), dimension_v<M> == 3 ? any(random) : 0.0);
    wrong += !(distance(end_of_line(x, d), expected_end<M>(x.position, d)) < 1e-9);
  }
  return wrong;
}

}  // namespace

TEST_CASE_TEMPLATE("integral_line: is straight from places of a poly on its border", M, CONCINO_KINDS) {
  for (const unsigned seed : {1u, 2u}) {
    const M m = jittered<M>(seed);
    auto g = make_poly_map<vec3>(m);
    CHECK(wrong_ends(m, seed, [&](const mesh_point<M>& x, const vec3& d) {
      for (const auto p : polys(m)) g[p] = d;
      return integral_line(m, g, x).points.back().position;
    }) == 0);
  }
}

TEST_CASE_TEMPLATE("integral_line: of fields at verts, is straight from places of a poly on its border", M, trimesh, quadmesh, tetmesh, hexmesh) {
  const M m = jittered<M>(3);
  auto h = make_vert_map<vec3>(m);
  std::size_t n = 0;
  CHECK(wrong_ends(m, 3, [&](const mesh_point<M>& x, const vec3& d) {
    if (n++ % 8 != 0) return expected_end<M>(x.position, d);
    for (const auto v : verts(m)) h[v] = d;
    return integral_line(m, field_at_verts(h), x).points.back().position;
  }) == 0);
}

TEST_CASE_TEMPLATE("trace_geodesic: is straight from places of a poly on its border", M, CONCINO_SURFACE_KINDS) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const M m = jittered<M>(seed);
    const auto trace = prepare_trace_geodesic(m);
    CHECK(wrong_ends(m, seed, [&](const mesh_point<M>& x, const vec3& d) { return trace.trace_from(x, d, 10).points.back().position; }) == 0);
    // the frame of a poly has x along its first edge
    CHECK(wrong_ends(m, seed, [&](const mesh_point<M>& x, const vec3& d) {
      const auto p = std::get<poly_t<M>>(x.element);
      const auto all = adj_p2v(m, p);
      auto it = all.begin();
      const vec3 a = point(m, *it), b = point(m, *++it), along = (b - a) / distance(a, b);
      return trace.trace_from(x, tangent_vector{dot(d, along), along.x * d.y - along.y * d.x}, 10).points.back().position;
    }) == 0);
  }
}

TEST_CASE("trace_geodesic: a direction in the frame of a poly leads over a sharp edge") {
  // two triangles that fold back by 150 degrees at the edge from 0 to 1
  const trimesh m({{0, 0, 0}, {0, 1, 0}, {1, 0.5, 0}, {0.8660254037844386, 0.5, 0.5}}, {{0, 1, 2}, {1, 0, 3}});
  const auto first = trace_geodesic(m, mesh_point<trimesh>{poly_id{0}, {0, 0.5, 0}}, tangent_vector{0, -1}, 0.25);  // y leads into poly 0
  CHECK(first.stopped_by == line_end::max_length);
  CHECK(distance(first.points.back().position, {0.25 * 0.8660254037844386, 0.5, 0.125}) < 1e-12);
}

TEST_CASE_TEMPLATE("integral_line: along an axis from each place, also located", M, CONCINO_KINDS) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    M m = make_grid<M>({.cells = {3, 3, 3}});
    jitter(m, 0.15, {.seed = seed});
    const auto tree = bounding_tree(m);
    std::size_t wrong = 0;
    for (std::size_t axis = 0; axis < dimension_v<M>; ++axis)
      for (const double sense : {1.0, -1.0}) {
        vec3 d;
        d[axis] = sense;
        const auto g = make_poly_map<vec3>(m, d);
        for (const auto v : verts(m)) {
          const vec3 x = point(m, v), end = expected_end<M>(x, d);
          wrong += !(distance(integral_line(m, g, v).points.back().position, end) < 1e-9);
          wrong += !(distance(integral_line(m, g, mesh_point<M>{*tree.locate(x), x}).points.back().position, end) < 1e-9);
        }
      }
    CHECK(wrong == 0);
  }
}

TEST_CASE_TEMPLATE("integral_line: from places on and near faces that are not planar", M, CONCINO_VOLUME_KINDS) {
  const M m = jittered<M>(5);
  const auto tree = bounding_tree(m);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  auto g = make_poly_map<vec3>(m);
  std::size_t wrong = 0, n = 0;
  const auto follow = [&](const mesh_point<M>& x) {
    const vec3 d(any(random), any(random), any(random));
    for (const auto p : polys(m)) g[p] = d;
    const auto line = integral_line(m, g, x);
    const vec3 from = line.points.front().position;  // in the shell between the triangles and the face as it is for locate, the start is moved to the triangles
    wrong += !(distance(from, x.position) < 0.1 && distance(line.points.back().position, expected_end<M>(from, d)) < 1e-9);
    ++n;
  };
  for (const auto f : faces(m)) {
    std::vector<vec3> x;
    for (const auto v : adj_f2v(m, f)) x.push_back(point(m, v));
    if (x.size() < 4) continue;
    for (const std::size_t k : {0u, 1u}) {
      const vec3 middle = 0.5 * (x[k] + x[k + 2]);
      follow({f, middle});
      for (const auto p : adj_f2p(m, f)) follow({p, middle});
    }
  }
  for (int i = 0; i < 200; ++i) {
    const vec3 x(0.5 + 0.5 * any(random), 0.5 + 0.5 * any(random), 0.5 + 0.5 * any(random));
    follow({*tree.locate(x), x});
  }
  CHECK(wrong == 0);
  CHECK(n >= 200);
}
