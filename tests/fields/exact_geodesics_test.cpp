#include <concino/fields/exact_geodesics.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>
#include <concino/generate/icosphere.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A square of triangles whose interior verts were moved randomly.
surface_arrays uneven_square(unsigned n, unsigned seed = 1) {
  const surface_arrays even = triangle_grid(n);
  surface_arrays a = jittered(even, 0.25 / n, false, seed);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const vec3 x = even.points[i];
    if (x.x == 0 || x.x == 1 || x.y == 0 || x.y == 1) a.points[i] = x;
  }
  return a;
}

template<class Map, class F>
double largest_error(const Map& d, const F& exact) {
  double worst = 0;
  for (const auto v : verts(d.mesh())) {
    const double e = exact(to_vec3(point(d.mesh(), v)));
    worst = std::max(worst, e == d[v] ? 0 : std::abs(d[v] - e));  // infinities that are equal have no error
  }
  return worst;
}

auto line_from(const vec3& from) {
  return [=](const vec3& x) { return distance(x, from); };
}

/// The triangles, each divided into n x n. Equal points become one vert.
surface_arrays refined(const std::vector<std::array<vec3, 3>>& triangles, unsigned n) {
  surface_arrays r{{}, {}, {}, 3};
  std::map<std::array<long, 3>, unsigned> known;
  const auto vert = [&](const vec3& x) {
    const auto key = std::array{std::lround(x.x * 1e6), std::lround(x.y * 1e6), std::lround(x.z * 1e6)};
    const auto [it, added] = known.try_emplace(key, static_cast<unsigned>(r.points.size()));
    if (added) r.points.push_back(x);
    return vert_id{it->second};
  };
  for (const auto& [a, b, c] : triangles) {
    const auto at = [&, &o = a, &p = b, &q = c](unsigned i, unsigned j) { return vert(o + (i * (p - o) + j * (q - o)) / n); };
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; i + j < n; ++j) {
        for (const vert_id v : {at(i, j), at(i + 1, j), at(i, j + 1)}) r.verts.push_back(v);
        if (i + j + 2 <= n)
          for (const vert_id v : {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}) r.verts.push_back(v);
      }
  }
  return r;
}

}  // namespace

TEST_CASE("exact_geodesics: are straight lines in the plane, on any triangles, in any order of verts") {
  for (const surface_arrays& a : {triangle_grid(12), uneven_square(12), uneven_square(12, 2)}) {
    const trimesh m(a);
    const auto exact = prepare_exact_geodesics(m);
    for (const unsigned s : {0u, 6u, 84u, 100u, 168u})
      CHECK(largest_error(exact.distance_from(vert_id{s}), line_from(point(m, vert_id{s}))) < 1e-13);
    // not oriented: every third triangle is reversed
    surface_arrays turned = a;
    for (std::size_t i = 0; i < turned.verts.size(); i += 9) std::swap(turned.verts[i], turned.verts[i + 1]);
    const trimesh t(turned);
    CHECK(largest_error(prepare_exact_geodesics(t).distance_from(vert_id{84}), line_from(point(t, vert_id{84}))) < 1e-13);
  }
}

TEST_CASE("exact_geodesics: accept polygons that are triangles and archetypes, and are symmetric") {
  surface_arrays a = uneven_square(6);
  for (vec3& x : a.points) x.z = 0.3 * std::sin(7 * x.x) * std::cos(5 * x.y);
  const trimesh m(a);
  const polygonmesh p(with_offsets(a));
  const auto weak = only_embedded_mesh(m);
  const auto exact = prepare_exact_geodesics(m);
  for (const unsigned s : {0u, 17u, 24u}) {
    const auto d = exact.distance_from(vert_id{s});
    const auto e = prepare_exact_geodesics(p).distance_from(vert_id{s});
    const auto f = prepare_exact_geodesics(weak).distance_from(weak.vert(vert_id{s}));
    for (const auto v : verts(weak)) {
      CHECK(e[weak.base(v)] == d[weak.base(v)]);
      CHECK(f[v] == d[weak.base(v)]);
    }
    for (const auto v : verts(m)) {
      CHECK(exact.distance_from(v)[vert_id{s}] == doctest::Approx(d[v]).epsilon(1e-13));
      CHECK(d[v] >= distance(point(m, v), point(m, vert_id{s})) * (1 - 1e-15));
      for (const auto w : adj_v2v(m, v)) CHECK(d[w] <= d[v] + distance(point(m, v), point(m, w)) + 1e-15);
    }
  }
}

TEST_CASE("exact_geodesics: go around a hole along its edges and corners") {
  // a square with a square hole: a shortest path bends at no, one or two corners of the hole
  surface_arrays a = uneven_square(9);
  const surface_arrays even = triangle_grid(9);
  const auto is_hole = [](const vec3& x) { return x.x > 0.33 && x.x < 0.67 && x.y > 0.33 && x.y < 0.67; };
  surface_arrays r{even.points, {}, {}, 3};
  for (std::size_t i = 0; i < even.points.size(); ++i)
    if (!is_hole(even.points[i])) r.points[i] = a.points[i];
  for (std::size_t i = 0; i < even.points.size(); ++i)
    if (is_hole(even.points[i])) r.points[i] = even.points[i];
  for (std::size_t t = 0; t < a.verts.size(); t += 3) {
    vec3 mean;
    for (std::size_t k = 0; k < 3; ++k) mean += even.points[a.verts[t + k].raw()] / 3;
    if (is_hole(mean)) continue;
    for (std::size_t k = 0; k < 3; ++k) r.verts.push_back(a.verts[t + k]);
  }
  const double lo = 3.0 / 9, hi = 6.0 / 9;
  const std::array<vec3, 4> corner{vec3{lo, lo, 0}, vec3{hi, lo, 0}, vec3{hi, hi, 0}, vec3{lo, hi, 0}};
  const auto sees = [&](const vec3& p, const vec3& q) {  // clips the segment by the open square of the hole
    double t0 = 0, t1 = 1;
    for (const std::size_t k : {0u, 1u}) {
      const double d = q[k] - p[k];
      const double x0 = lo + 1e-12, x1 = hi - 1e-12;
      if (d == 0) {
        if (p[k] <= x0 || p[k] >= x1) return true;
      } else {
        t0 = std::max(t0, std::min((x0 - p[k]) / d, (x1 - p[k]) / d));
        t1 = std::min(t1, std::max((x0 - p[k]) / d, (x1 - p[k]) / d));
      }
    }
    return t0 >= t1;
  };
  const trimesh m(r);
  const auto exact = prepare_exact_geodesics(m);
  for (const unsigned s : {0u, 4u, 23u, 33u, 46u, 99u}) {
    const vec3 from = point(m, vert_id{s});
    const auto way = [&](const vec3& x) {
      if (sees(from, x)) return distance(from, x);
      double best = infinity;
      for (std::size_t i = 0; i < 4; ++i)
        for (const std::size_t j : {i, (i + 1) % 4, (i + 3) % 4})
          if (sees(from, corner[i]) && sees(corner[j], x))
            best = std::min(best, distance(from, corner[i]) + distance(corner[i], corner[j]) + distance(corner[j], x));
      return best;
    };
    const auto d = exact.distance_from(vert_id{s});
    for (const auto v : verts(m)) {
      std::size_t n = 0;
      for ([[maybe_unused]] const auto p : adj_v2p(m, v)) ++n;
      if (n == 0) CHECK(d[v] == infinity);
      else CHECK(d[v] == doctest::Approx(way(point(m, v))).epsilon(1e-12));
    }
  }
}

TEST_CASE("exact_geodesics: match the unfolded surface of a cube, from a corner and a face centre") {
  std::vector<std::array<vec3, 3>> halves;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double at : {0.0, 1.0}) {
      const auto place = [&](double u, double v) {
        vec3 x;
        x[axis] = at;
        x[(axis + 1) % 3] = u;
        x[(axis + 2) % 3] = v;
        return x;
      };
      halves.push_back({place(0, 0), place(1, 0), place(1, 1)});
      halves.push_back({place(0, 0), place(1, 1), place(0, 1)});
    }
  const trimesh m(refined(halves, 6));
  const auto exact = prepare_exact_geodesics(m);
  const auto vert_at = [&](const vec3& x) {
    vert_id best{0};
    for (const auto v : verts(m))
      if (distance(point(m, v), x) < distance(point(m, best), x)) best = v;
    return best;
  };
  const auto d = exact.distance_from(vert_at({0, 0, 0}));
  CHECK(largest_error(d, [](const vec3& x) {
          double best = infinity;
          for (std::size_t k = 0; k < 3; ++k) {
            const double u = x[(k + 1) % 3], v = x[(k + 2) % 3];
            if (x[k] == 0) best = std::min(best, std::hypot(u, v));
            if (x[k] == 1) best = std::min({best, std::hypot(1 + u, v), std::hypot(1 + v, u)});
          }
          return best;
        }) < 1e-12);
  CHECK(d[vert_at({1, 1, 1})] == doctest::Approx(std::sqrt(5.0)).epsilon(1e-13));
  const vert_id below = vert_at({0.5, 0.5, 0});
  CHECK(point(m, below) == vec3{0.5, 0.5, 0});
  const auto e = exact.distance_from(below);
  CHECK(largest_error(e, [](const vec3& x) {
          if (x.z == 0) return std::hypot(x.x - 0.5, x.y - 0.5);
          double best = infinity;
          for (const bool swap : {false, true})  // over the face at u = 0 or u = 1 directly, or over it and an adjacent face
            for (const bool mirror : {false, true}) {
              double u = swap ? x.y : x.x;
              const double v = swap ? x.x : x.y;
              if (mirror) u = 1 - u;
              if (u == 0) best = std::min(best, std::hypot(0.5 + x.z, v - 0.5));
              if (x.z == 1) best = std::min({best, std::hypot(1.5 + u, v - 0.5), std::hypot(1.5 + v, 1.5 - u), std::hypot(2.5 - v, 1.5 - u)});
              if (v == 0) best = std::min(best, std::hypot(0.5 + x.z, u - 0.5));
              if (v == 0 || v == 1) best = std::min(best, std::hypot(0.5 + u, 0.5 + x.z));
            }
          return best;
        }) < 1e-12);
}

TEST_CASE("exact_geodesics: match the unfolded regular tetrahedron") {
  const std::array<vec3, 4> x{vec3{1, 1, 1}, vec3{1, -1, -1}, vec3{-1, 1, -1}, vec3{-1, -1, 1}};
  const double side = std::sqrt(8.0);
  const trimesh m(refined({{x[0], x[1], x[2]}, {x[1], x[3], x[2]}, {x[0], x[3], x[1]}, {x[0], x[2], x[3]}}, 5));
  const auto d = prepare_exact_geodesics(m).distance_from(vert_id{0});
  REQUIRE(point(m, vert_id{0}) == x[0]);
  const vec3 e1{1, 0, 0}, e2{0.5, std::sqrt(0.75), 0};
  CHECK(largest_error(d, [&](const vec3& p) {
          std::array<double, 4> part;  // barycentric coordinates
          for (std::size_t k = 0; k < 4; ++k) part[k] = (1 + dot(p, x[k])) / 4;
          vec3 y;  // unfolded into the plane: copies of corner 0 are at even points of the lattice, of 1 at e1 more, of 2 at e2, of 3 at e1 + e2
          const bool without_0 = std::abs(part[0]) < 1e-9, without_3 = std::abs(part[3]) < 1e-9, without_2 = std::abs(part[2]) < 1e-9;
          if (without_3) y = part[1] * e1 + part[2] * e2;
          else if (without_0) y = part[1] * e1 + part[2] * e2 + part[3] * (e1 + e2);
          else if (without_2) y = part[1] * e1 + part[0] * (2.0 * e1) + part[3] * (e1 + e2);
          else y = part[2] * e2 + part[3] * (e1 + e2) + part[0] * (2.0 * e2);
          double best = infinity;
          for (int i = -4; i <= 4; i += 2)
            for (int j = -4; j <= 4; j += 2) best = std::min(best, distance(y, i * e1 + j * e2));
          return side * best;
        }) < 1e-12);
}

TEST_CASE("exact_geodesics: go around a cone or over its tip") {
  for (const int wedges : {3, 4, 5, 6, 8, 10}) {
    const double turn = 2 * std::numbers::pi / wedges;
    // boundary verts are at distance 1 from the tip and from the next; if there are more than 6 triangles, their heights alternate
    const double wide = wedges <= 6 ? 1 / (2 * std::sin(turn / 2)) : std::sqrt(3 / (4 * std::cos(turn / 2) * std::cos(turn / 2)));
    const double high = std::sqrt(std::max(0.0, 1 - wide * wide));
    const auto rim = [&](int k) {
      k %= wedges;
      return vec3{wide * std::cos(k * turn), wide * std::sin(k * turn), wedges > 6 && k % 2 ? -high : high};
    };
    std::vector<std::array<vec3, 3>> triangles;
    for (int k = 0; k < wedges; ++k) triangles.push_back({vec3{}, rim(k), rim(k + 1)});
    const trimesh m(refined(triangles, 5));
    const auto polar = [&](const vec3& p) {  // the distance from the tip, and the angle around it
      if (norm(p) < 1e-9) return std::pair{0.0, 0.0};
      const double around = std::atan2(p.y, p.x);
      const int k = static_cast<int>(std::floor(around / turn + 1e-9)) + (around < -1e-9 ? wedges : 0);
      const double angle = std::atan2(norm(cross(rim(k), p)), dot(rim(k), p));
      return std::pair{norm(p), k * std::numbers::pi / 3 + angle};
    };
    const double whole = wedges * std::numbers::pi / 3;
    const auto exact = prepare_exact_geodesics(m);
    for (const unsigned s : {0u, 1u, 7u, 13u, 20u}) {
      const auto [r, at] = polar(point(m, vert_id{s}));
      CHECK(largest_error(exact.distance_from(vert_id{s}), [&, r = r, at = at](const vec3& p) {
              const auto [q, there] = polar(p);
              const double between = std::min(std::abs(at - there), whole - std::abs(at - there));
              if (between >= std::numbers::pi) return r + q;
              return std::hypot(r - q * std::cos(between), q * std::sin(between));
            }) < 1e-12);
    }
  }
}

TEST_CASE("exact_geodesics: on the sphere are shorter than arcs, and converge to them") {
  double before = 1;
  for (const unsigned k : {1u, 2u, 3u, 4u}) {
    const trimesh m = icosphere(k);
    const vec3 from = point(m, vert_id{5});
    const auto d = prepare_exact_geodesics(m).distance_from(vert_id{5});
    const auto arc = [&](const vec3& x) { return std::atan2(norm(cross(x, from)), dot(x, from)); };
    for (const auto v : verts(m)) CHECK(d[v] <= arc(point(m, v)) + 1e-15);
    const double e = largest_error(d, arc);
    CHECK(e < 0.3 * before);
    before = e;
  }
  CHECK(before < 0.0025);
}

TEST_CASE("exact_geodesics: return the nearest of several sources with initial distances, by component") {
  const trimesh m = two_grids<trimesh>(6);
  const auto exact = prepare_exact_geodesics(m);
  const vert_id a{0}, b{20}, c{33}, other{60}, alone{static_cast<unsigned>(num_verts(m) - 1)};
  const auto da = exact.distance_from(a), db = exact.distance_from(b), dc = exact.distance_from(c);
  const auto several = exact.distance_from({a, b, c});
  const auto later = exact.distance_from({{a, 0.5}, {b, 0.25}, {c, -0.125}});
  for (const auto v : verts(m)) {
    if (point(m, v)[0] > 1.5) {
      CHECK(several[v] == infinity);
      CHECK(later[v] == infinity);
      continue;
    }
    CHECK(several[v] == doctest::Approx(std::min({da[v], db[v], dc[v]})).epsilon(1e-13));
    CHECK(later[v] == doctest::Approx(std::min({da[v] + 0.5, db[v] + 0.25, dc[v] - 0.125})).epsilon(1e-13));
  }
  const auto both = exact.distance_from(std::vector<vert_id>{a, other, alone});
  for (const auto v : verts(m)) CHECK(both[v] < infinity);
  CHECK(both[alone] == 0);
  CHECK(exact.distance_from({{a, 7.0}, {a, 3.0}})[a] == 3);
  const auto copy = exact;
  CHECK(copy.distance_from(b)[a] == db[a]);
}

TEST_CASE("exact_geodesics: sources may be in triangles, on edges and at verts") {
  const trimesh m(uneven_square(6));
  const auto exact = prepare_exact_geodesics(m);
  for (const unsigned p : {0u, 13u, 40u, 71u})
    for (const auto& part : {vec3{0.2, 0.5, 0.3}, vec3{0, 0.5, 0.5}, vec3{0.25, 0, 0.75}, vec3{0.75, 0.25, 0}, vec3{1, 0, 0}, vec3{0, 0, 1}}) {
      vec3 x;
      std::size_t k = 0;
      for (const auto v : adj_p2v(m, poly_id{p})) x += part[k++] * point(m, v);
      CHECK(largest_error(exact.distance_from(poly_id{p}, x), line_from(x)) < 1e-13);
      CHECK(largest_error(exact.distance_from(poly_id{p}, x + vec3{0, 0, 1e-8}), line_from(x)) < 1e-13);  // the source is the nearest point of the triangle
    }
  // from a point near a vert, distances differ from those of the vert at most by the distance between the two
  const trimesh ball = icosphere(3);
  const auto around = prepare_exact_geodesics(ball);
  const vert_id v{9};
  const auto from_vert = around.distance_from(v);
  for (const auto p : adj_v2p(ball, v)) {
    vec3 mean;
    for (const auto w : adj_p2v(ball, p)) mean += point(ball, w) / 3;
    const auto d = around.distance_from(p, mean);
    const double off = distance(mean, point(ball, v));
    CHECK(d[v] == doctest::Approx(off).epsilon(1e-12));
    for (const auto w : verts(ball)) CHECK(std::abs(d[w] - from_vert[w]) <= off + 1e-14);
    for (const auto w : adj_p2v(ball, p)) {  // the distances at the corners of the triangle are lengths of segments
      CHECK(d[w] == doctest::Approx(distance(mean, point(ball, w))).epsilon(1e-12));
    }
  }
}

TEST_CASE("exact_geodesics: work at edges with three triangles and verts with several fans") {
  // half-planes that share the line x = 0, each with a unit square; a shortest path is straight after unfolding two of them
  std::vector<std::array<vec3, 3>> triangles;
  const std::array<vec3, 3> out{vec3{1, 0, 0}, vec3{-0.6, 0.8, 0}, vec3{0, -1, 0}};
  const vec3 up{0, 0, 1};
  for (const vec3& w : out) {
    triangles.push_back({vec3{}, w, w + up});
    triangles.push_back({vec3{}, w + up, up});
  }
  const trimesh book(refined(triangles, 5));
  const auto page = [&](const vec3& x) {
    for (std::size_t k = 0; k < 3; ++k)
      if (norm(cross(x - vec3{0, 0, x.z}, out[k])) < 1e-9 && dot(x, out[k]) > -1e-9) return k;
    return std::size_t{3};
  };
  const auto exact = prepare_exact_geodesics(book);
  for (const unsigned s : {0u, 1u, 3u, 9u, 14u, 30u}) {
    const vec3 from = point(book, vert_id{s});
    const double r = std::hypot(from.x, from.y);
    CHECK(largest_error(exact.distance_from(vert_id{s}), [&](const vec3& x) {
            const double q = std::hypot(x.x, x.y);
            return std::hypot(page(x) == page(from) ? r - q : r + q, x.z - from.z);
          }) < 1e-13);
  }

  const trimesh two({{0, 0, 0}, {1, 0, 1}, {0, 1, 1}, {1, 0, -1}, {0, 1, -1}}, {{0, 1, 2}, {0, 3, 4}});
  const auto d = prepare_exact_geodesics(two).distance_from(vert_id{1});
  CHECK(d[vert_id{0}] == doctest::Approx(std::sqrt(2.0)));
  CHECK(d[vert_id{4}] == doctest::Approx(std::sqrt(8.0)));
}

TEST_CASE("exact_geodesics: scaling the mesh scales the distances to the last bit, however large or small") {
  surface_arrays a = uneven_square(7);
  for (vec3& x : a.points) x.z = 0.4 * std::sin(9 * x.x + 4 * x.y);
  const trimesh m(a);
  const auto d = prepare_exact_geodesics(m).distance_from(vert_id{11});
  for (const int power : {20, -20, 900, -900}) {
    auto b = a;
    for (vec3& x : b.points) x *= std::ldexp(1.0, power);
    const trimesh scaled(b);
    const auto e = prepare_exact_geodesics(scaled).distance_from(vert_id{11});
    for (const auto v : verts(m)) CHECK(e[v] == std::ldexp(d[v], power));
  }
  auto moved = a;
  for (vec3& x : moved.points) x = 1e3 * vec3{x.y, x.z, x.x} + vec3{500, 7, -3};
  const trimesh other(moved);
  const auto e = prepare_exact_geodesics(other).distance_from(vert_id{11});
  for (const auto v : verts(m)) CHECK(e[v] == doctest::Approx(1e3 * d[v]).epsilon(1e-12));
}

TEST_CASE("exact_geodesics: are right on long and thin triangles") {
  for (const double power : {2.0, 3.0}) {
    auto a = triangle_grid(15);
    for (vec3& x : a.points) x = {std::pow(x.x, power), std::pow(x.y, power), 0};
    const trimesh m(a);
    for (const unsigned s : {0u, 100u, 255u})
      CHECK(largest_error(prepare_exact_geodesics(m).distance_from(vert_id{s}), line_from(point(m, vert_id{s}))) < 1e-12);
  }
}

TEST_CASE("exact_geodesics: throw if an argument or the mesh is invalid") {
  const auto quads = grid<quadmesh>(2);
  CHECK_THROWS_WITH_AS(prepare_exact_geodesics(quads),
                       "exact_geodesics: poly 0 has 4 verts; all polys must be triangles: triangulate it, or use heat_geodesics", unsupported);
  const auto m = grid<trimesh>(2);
  const auto exact = prepare_exact_geodesics(m);
  CHECK_THROWS_WITH_AS(exact.distance_from(vert_id{9}), "exact_geodesics: a source is not a vert of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(exact.distance_from(std::vector<vert_id>()), "exact_geodesics: there is no source; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(exact.distance_from({{vert_id{1}, std::nan("")}}), "exact_geodesics: the initial distance at vert 1 is not finite",
                       invalid_argument);
  CHECK_THROWS_AS(exact.distance_from(poly_id{8}, {0, 0, 0}), invalid_mesh);
  CHECK_THROWS_AS(exact.distance_from(poly_id{0}, {0, 0, infinity}), invalid_argument);
  CHECK_THROWS_WITH_AS(exact.distance_from(poly_id{0}, {0, 0, 3}),
                       doctest::Contains("exact_geodesics: the position of the source is not in poly 0, but "), invalid_argument);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, {{0, 1, 3}, {0, 1, 2}});
  CHECK_THROWS_WITH_AS(prepare_exact_geodesics(flat),
                       "exact_geodesics: poly 1 has no area, or points that are not finite; remove it or move its verts", invalid_mesh);
  for (const double bad : {infinity, std::nan("")}) {
    const trimesh endless({{0, 0, 0}, {1, 0, 0}, {0, bad, 0}}, {{0, 1, 2}});
    CHECK_THROWS_AS(prepare_exact_geodesics(endless), invalid_mesh);
  }
}

TEST_CASE("exact_geodesics: work with gaps in the indices and on empty meshes") {
  trimesh m(uneven_square(4));
  remove_vert(m, vert_id{4});
  const auto d = prepare_exact_geodesics(m).distance_from(vert_id{24});
  for (const auto v : verts(m)) CHECK(d[v] == doctest::Approx(distance(point(m, v), point(m, vert_id{24}))).epsilon(1e-12));
  const trimesh empty;
  CHECK_THROWS_AS(prepare_exact_geodesics(empty).distance_from(vert_id{0}), invalid_mesh);
}
