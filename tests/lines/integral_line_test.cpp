#include <concino/lines/integral_line.hpp>

#include <concino/core/error.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/generate/grid.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/operators/gradient.hpp>
#include <concino/operators/rotated.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class M>
auto constant_field(const M& m, const vec3& g) {
  auto field = make_poly_map<vec3>(m);
  for (const auto p : polys(m)) field[p] = g;
  return field;
}

/// A vector at each poly, from its centroid.
template<class M, class F>
auto field_of(const M& m, const F& f) {
  auto field = make_poly_map<vec3>(m);
  for (const auto p : polys(m)) field[p] = f(centroid(m, p));
  return field;
}

/// Calls f(p) for each poly at a place.
template<class M, class F>
void for_each_poly_at(const M& m, const mesh_point<M>& x, const F& f) {
  const auto visit = [&](const auto& list) {
    for (const auto p : list) f(p);
  };
  if (const auto* v = std::get_if<vert_t<M>>(&x.element)) visit(adj_v2p(m, *v));
  else if (const auto* e = std::get_if<edge_point<M>>(&x.element)) visit(adj_e2p(m, e->edge));
  else if (const auto* p = std::get_if<poly_t<M>>(&x.element)) f(*p);
  else if constexpr (dimension_v<M> == 3) visit(adj_f2p(m, std::get<face_t<M>>(x.element)));
}
template<class M>
bool is_at(const M& m, const mesh_point<M>& x, const poly_t<M>& p) {
  bool found = false;
  for_each_poly_at(m, x, [&](const poly_t<M>& q) { found = found || p == q; });
  return found;
}

template<class M>
bool is_on_boundary(const M& m, const mesh_point<M>& x) {
  const auto is_open = [&](const auto& facet) {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto p : adj_facet2p(m, facet)) ++n;
    return n < 2;
  };
  if (const auto* v = std::get_if<vert_t<M>>(&x.element)) {
    for (const auto p : adj_v2p(m, *v))
      for (const auto facet : adj_p2facet(m, p))
        for (const auto w : adj_facet2v(m, facet))
          if (w == *v && is_open(facet)) return true;
    return false;
  }
  if (const auto* e = std::get_if<edge_point<M>>(&x.element)) {
    if constexpr (dimension_v<M> == 2) return is_open(e->edge);
    else {
      for (const auto f : adj_e2f(m, e->edge))
        if (is_open(f)) return true;
      return false;
    }
  }
  if constexpr (dimension_v<M> == 3)
    if (const auto* f = std::get_if<face_t<M>>(&x.element)) return is_open(*f);
  return false;
}

/// What is true of every line.
template<class M, class G>
void check_line(const M& m, const G& g, const field_line<M>& line) {
  const std::size_t n = line.points.size();
  REQUIRE(line.polys.size() == (line.stopped_by == line_end::closed ? n : n - 1));
  double length = 0;
  bool in_polys = true;
  for (std::size_t i = 0; i < line.polys.size(); ++i) {
    const std::size_t j = (i + 1) % n;
    in_polys = in_polys && is_at(m, line.points[i], line.polys[i]) && is_at(m, line.points[j], line.polys[i]);
    length += distance(line.points[i].position, line.points[j].position);
  }
  REQUIRE(in_polys);
  REQUIRE(line.length >= length * (1 - 1e-12));
  const mesh_point<M>& end = line.points.back();
  switch (line.stopped_by) {
    case line_end::boundary: REQUIRE(is_on_boundary(m, end)); break;
    case line_end::sink: REQUIRE(!is_on_boundary(m, end)); break;
    case line_end::zero: {
      bool some_zero = false;
      for_each_poly_at(m, end, [&](const poly_t<M>& p) { some_zero = some_zero || norm(g[p]) < 1e-9; });
      if constexpr (dimension_v<M> == 3) REQUIRE(some_zero);
      break;
    }
    case line_end::winds_to_cycle: REQUIRE(line.cycle.size() >= 2); break;
    case line_end::non_manifold:
    case line_end::max_length:
    case line_end::too_close: REQUIRE(false); break;
    case line_end::closed:
    case line_end::max_steps: break;
  }
}

template<class Points>
std::vector<vec3> positions(const Points& points) {
  std::vector<vec3> all;
  for (const auto& x : points) all.push_back(x.position);
  return all;
}

template<class M>
bool same(const field_line<M>& a, const field_line<M>& b) {
  return positions(a.points) == positions(b.points) && a.polys == b.polys && a.length == b.length && a.stopped_by == b.stopped_by && positions(a.cycle) == positions(b.cycle);
}

}  // namespace

TEST_CASE_TEMPLATE("integral_line: a constant field gives straight lines through every kind of mesh", M, CONCINO_ALL_KINDS) {
  M m = make_grid<M>({.cells = {5, 4, 3}});
  if constexpr (dimension_v<M> == 3) jitter(m, 0.2);  // faces that are not planar
  const vec3 g = dimension_v<M> == 2 ? vec3(0.7, 0.31, 0) : vec3(0.7, 0.31, 0.23);
  const auto field = constant_field(m, g);
  for (const auto p : polys(m)) {
    const auto line = integral_line(m, field, p, {.both_ways = true});
    check_line(m, field, line);
    CHECK(line.stopped_by == line_end::boundary);
    CHECK(line.began_by == line_end::boundary);
    const vec3 x0 = line.points.front().position, direction = g / norm(g);
    double last = -1;
    for (const vec3& x : positions(line.points)) {
      const double t = dot(x - x0, direction);
      CHECK(norm(x - x0 - t * direction) < 1e-12);
      CHECK(t >= last - 1e-12);
      last = t;
    }
    CHECK(line.length == doctest::Approx(last).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("integral_line: along edges, diagonals and faces", M, CONCINO_ALL_KINDS) {
  if constexpr (std::same_as<M, polygonmesh>) return;  // hexagons have no such lines
  else {
    const M m = make_grid<M>({.cells = {3, 3, 3}});
    const auto origin = *verts(m).begin();
    REQUIRE(to_vec3(point(m, origin)) == vec3());
    std::vector<vec3> directions = {{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    if (dimension_v<M> == 3) directions.insert(directions.end(), {{0, 0, 1}, {1, 1, 1}, {0, 1, 1}, {1, 0, 2}, {1, 2, 1}});
    for (const vec3& g : directions) {
      const auto field = constant_field(m, g);
      const auto line = integral_line(m, field, origin);
      check_line(m, field, line);
      CHECK(line.stopped_by == line_end::boundary);
      CHECK(distance(line.points.back().position, g / std::max({g.x, g.y, g.z})) < 1e-12);
      CHECK(line.length == doctest::Approx(norm(line.points.back().position)).epsilon(1e-12));
    }
  }
}

TEST_CASE_TEMPLATE("integral_line: random fields, 10,000 lines, each stops for a true reason", M, CONCINO_ALL_KINDS) {
  const M m = [] {
    if constexpr (dimension_v<M> == 2) return make_torus<M>({});
    else return make_grid<M>({.cells = {3, 3, 3}});
  }();
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1, 1);
  std::uniform_int_distribution<int> few(-1, 1);
  std::vector<poly_t<M>> all_polys;
  std::vector<vert_t<M>> all_verts;
  for (const auto p : polys(m)) all_polys.push_back(p);
  for (const auto v : verts(m)) all_verts.push_back(v);
  std::size_t stopped_early = 0, total = 0;
  const int num_fields = long_run() ? 1000 : 42, num_starts = long_run() ? 167 : 40;  // of each of the six kinds
  for (int f = 0; f < num_fields; ++f) {
    auto g = make_poly_map<vec3>(m);
    for (const auto p : all_polys) g[p] = f % 2 ? vec3(any(random), any(random), any(random)) : vec3(few(random), few(random), few(random));
    for (int s = 0; s < num_starts; ++s) {
      const auto line = s % 2 ? integral_line(m, g, all_polys[random() % all_polys.size()], {.max_steps = 600, .backward = s % 3 == 0})
                              : integral_line(m, g, all_verts[random() % all_verts.size()], {.max_steps = 600});
      check_line(m, g, line);
      stopped_early += line.stopped_by == line_end::max_steps;
      ++total;
    }
  }
  CHECK(total == static_cast<std::size_t>(num_fields * num_starts));
  CHECK(stopped_early <= (dimension_v<M> == 2 ? 0 : total / 50));  // in volumes, a line that comes ever closer to a cycle is not recognised
}

TEST_CASE("integral_line: the level lines of a function on triangles close") {
  const auto m = make_grid<trimesh>({.cells = {12, 12}, .min = {-1, -1, 0}, .max = {1, 1, 0}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = dot(to_vec3(point(m, v)), to_vec3(point(m, v)));
  const auto g = rotated(m, gradient(m, u));
  std::size_t closed = 0;
  for (const auto p : polys(m)) {
    if (norm(centroid(m, p)) > 0.8 || norm(centroid(m, p)) < 0.2) continue;
    const auto line = integral_line(m, g, p);
    check_line(m, g, line);
    CHECK(line.stopped_by == line_end::closed);
    CHECK(line.length == doctest::Approx(2 * std::numbers::pi * norm(line.points[0].position)).epsilon(0.05));
    ++closed;
    const auto short_line = integral_line(m, g, p, {.max_length = 0.9 * line.length}), long_line = integral_line(m, g, p, {.max_length = 5 * line.length});
    CHECK(short_line.stopped_by == line_end::max_length);
    CHECK(short_line.length == 0.9 * line.length);
    CHECK(same(long_line, line));
  }
  CHECK(closed > 50);
}

TEST_CASE_TEMPLATE("integral_line: on other polygons they return close to their start", M, quadmesh, polygonmesh) {
  double off[2];
  for (const unsigned n : {16u, 32u}) {
    const M m = make_grid<M>({.cells = {n, n}, .min = {-1, -1, 0}, .max = {1, 1, 0}});
    auto u = make_vert_map<double>(m);
    for (const auto v : verts(m)) u[v] = dot(to_vec3(point(m, v)), to_vec3(point(m, v)));
    const auto g = rotated(m, gradient(m, u));
    double& worst = off[n == 32];
    worst = 0;
    for (const auto p : polys(m)) {
      const double r = norm(centroid(m, p));
      if (r > 0.7 || r < 0.5) continue;
      const auto line = integral_line(m, g, p, {.max_length = 6 * r});
      for (const vec3& x : positions(line.points)) worst = std::max(worst, std::abs(norm(x) - r));
    }
  }
  CHECK(off[0] < 4.0 / 16);
  CHECK(off[1] < 0.75 * off[0]);
}

TEST_CASE_TEMPLATE("integral_line: gradients of harmonic maps lead to the maximum or the boundary", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {5, 5, 5}});
  vert_t<M> low = *verts(m).begin(), high = low;
  for (const auto v : verts(m)) {
    if (distance(to_vec3(point(m, v)), {0.4, 0.4, 0.4}) < distance(to_vec3(point(m, low)), {0.4, 0.4, 0.4})) low = v;
    if (distance(to_vec3(point(m, v)), {0.8, 0.6, 0.6}) < distance(to_vec3(point(m, high)), {0.8, 0.6, 0.6})) high = v;
  }
  const auto u = harmonic_map(m, {{low, 0.0}, {high, 1.0}});
  const auto g = gradient(m, u);
  for (const auto& line : integral_lines(m, g, polys(m))) {
    check_line(m, g, line);
    if constexpr (TriMesh<M> || TetMesh<M>) {
      const bool at_maximum = line.stopped_by == line_end::sink && std::get_if<vert_t<M>>(&line.points.back().element) && std::get<vert_t<M>>(line.points.back().element) == high;
      CHECK((at_maximum || line.stopped_by == line_end::boundary));
    } else {
      CHECK(line.stopped_by != line_end::max_steps);
    }
  }
}

TEST_CASE("integral_line: cycles, spirals, saddles and fields against each other") {
  const auto m = make_grid<quadmesh>({.cells = {4, 4}, .min = {-2, -2, 0}, .max = {2, 2, 0}});
  const auto start = [&](double x, double y) {
    for (const auto p : polys(m))
      if (distance(centroid(m, p), {x, y, 0}) < 1e-9) return p;
    return *polys(m).begin();
  };
  const auto quadrant = [](const vec3& x) { return vec3{x.y > 0 ? -1 : 1, x.x > 0 ? 1 : -1, 0}; };  // round the origin, counter-clockwise
  SUBCASE("0.9 per quadrant into a vert") {
    // crossing a quadrant at 45 degrees keeps the distance; a part towards the vert makes it shorter by the same factor each time
    const double t = (1 - 0.9) / (1 + 0.9);
    const auto g = field_of(m, [&](const vec3& x) { return quadrant(x) - t * vec3{x.x > 0 ? 1 : -1, x.y > 0 ? 1 : -1, 0}; });
    const auto line = integral_line(m, g, start(0.5, 0.5));
    CHECK(line.stopped_by == line_end::sink);
    CHECK(line.points.back().position == vec3());
    CHECK(std::holds_alternative<vert_id>(line.points.back().element));
    // from (a, 0) to (0, 0.9 a): sqrt(1.81) a, and the sum of a geometric series
    const double a = distance(line.points[1].position, {}), first = distance(line.points[0].position, line.points[1].position);
    CHECK(line.length == doctest::Approx(first + std::sqrt(1.81) * a / (1 - 0.9)).epsilon(1e-12));
    const auto cut = integral_line(m, g, start(0.5, 0.5), {.max_length = 0.99 * line.length});
    CHECK(cut.stopped_by == line_end::max_length);
  }
  SUBCASE("out of the spiral, backwards") {
    const auto g = field_of(m, [&](const vec3& x) { return quadrant(x) + 0.05 * vec3{x.x > 0 ? 1 : -1, x.y > 0 ? 1 : -1, 0}; });
    CHECK(integral_line(m, g, start(0.5, 0.5)).stopped_by == line_end::boundary);
    CHECK(integral_line(m, g, start(0.5, 0.5), {.backward = true}).stopped_by == line_end::sink);
  }
  SUBCASE("once round is closed") {
    const auto g = field_of(m, quadrant);
    const auto line = integral_line(m, g, start(0.5, 0.5));
    CHECK(line.stopped_by == line_end::closed);
    CHECK(line.length == doctest::Approx(4 * std::sqrt(2.0)).epsilon(1e-12));
    CHECK(integral_line(m, g, start(0.5, 0.5), {.both_ways = true}).length == line.length);
  }
  SUBCASE("a cycle that attracts") {
    const auto g = field_of(m, [](const vec3& x) { return vec3{-x.y, x.x, 0} + 0.4 * (1.6 - norm(x)) * x; });
    const auto line = integral_line(m, g, start(1.5, 0.5));
    CHECK((line.stopped_by == line_end::winds_to_cycle || line.stopped_by == line_end::closed));
    CHECK(line.cycle.size() >= 4);
    for (const auto& x : line.cycle) CHECK(std::holds_alternative<edge_point<quadmesh>>(x.element));
    double turn = 0;
    for (std::size_t i = 0; i < line.cycle.size(); ++i) {
      const vec3 &a = line.cycle[i].position, &b = line.cycle[(i + 1) % line.cycle.size()].position;
      turn += std::atan2(a.x * b.y - a.y * b.x, dot(a, b));
    }
    CHECK(turn == doctest::Approx(2 * std::numbers::pi));
  }
  SUBCASE("two fields against each other lead along their edge") {
    const auto g = field_of(m, [](const vec3& x) { return vec3{x.x > 0 ? -1 : 1, x.x > 0 ? 0.5 : 0.2, 0}; });
    const auto line = integral_line(m, g, start(-0.5, -1.5));
    CHECK(line.stopped_by == line_end::boundary);
    CHECK(line.points.back().position == vec3(0, 2, 0));
    CHECK(line.points[1].position == vec3(0, -1.4, 0));
  }
  SUBCASE("exactly against each other") {
    const auto g = field_of(m, [](const vec3& x) { return vec3{x.x > 0 ? -1 : 1, 0, 0}; });
    const auto line = integral_line(m, g, start(-0.5, -1.5));
    CHECK(line.stopped_by == line_end::sink);
    CHECK(line.points.back().position == vec3(0, -1.5, 0));
  }
  SUBCASE("a saddle") {
    const auto g = field_of(m, [](const vec3& x) { return vec3{x.x, -x.y, 0}; });
    const auto line = integral_line(m, g, start(-0.5, 1.5));
    CHECK(line.stopped_by == line_end::boundary);
    CHECK(line.points.back().position.x == -2);
    const auto from_saddle = integral_line(m, g, vert_id{12});
    REQUIRE(from_saddle.points[0].position == vec3());
    CHECK(from_saddle.stopped_by == line_end::boundary);
    CHECK(from_saddle.points.back().position == vec3(-2, 0, 0));  // equally fast to both sides: the first by x
  }
  SUBCASE("no field") {
    const auto none = constant_field(m, {});
    CHECK(integral_line(m, none, vert_id{12}).stopped_by == line_end::zero);
    CHECK(integral_line(m, none, poly_id{0}).stopped_by == line_end::zero);
    CHECK(integral_line(m, none, poly_id{0}).points.size() == 1);
    const auto half = field_of(m, [](const vec3& x) { return vec3{x.x < 0 ? 1 : 0, 0, 0}; });
    const auto line = integral_line(m, half, start(-0.5, 0.5));
    CHECK(line.stopped_by == line_end::zero);
    CHECK(line.points.back().position == vec3(0, 0.5, 0));
    CHECK(integral_line(m, constant_field(m, {0, 0, 1}), poly_id{0}).stopped_by == line_end::zero);
  }
}

TEST_CASE("integral_line: on a flat torus a rational slope closes, and an irrational one runs to max_steps") {
  // squares folded onto each other, so that all lie in the plane
  constexpr unsigned n = 4;
  const auto place = [](unsigned i) { return i % n <= n / 2 ? i % n : n - i % n; };
  surface_arrays arrays;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) arrays.points.push_back({place(i), place(j), 0});
  arrays.arity = 4;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      for (const auto& [di, dj] : {std::pair(0u, 0u), std::pair(1u, 0u), std::pair(1u, 1u), std::pair(0u, 1u)}) arrays.verts.push_back(vert_id((i + di) % n * n + (j + dj) % n));
    }
  const quadmesh m(arrays);
  const auto slope = [&](double y) {
    return [&m, y](poly_id start) {
      auto g = make_poly_map<vec3>(m);
      for (unsigned i = 0; i < n; ++i)
        for (unsigned j = 0; j < n; ++j) g[poly_id(i * n + j)] = {i < n / 2 ? 1 : -1, j < n / 2 ? y : -y, 0};
      return integral_line(m, g, start);
    };
  };
  const auto flat = slope(0)(poly_id{5}), half = slope(0.5)(poly_id{5}), third = slope(3)(poly_id{5}), irrational = slope(std::numbers::sqrt2)(poly_id{5});
  CHECK(flat.stopped_by == line_end::closed);
  CHECK(flat.length == 4);
  CHECK(half.stopped_by == line_end::closed);
  CHECK(half.length == doctest::Approx(4 * std::sqrt(5.0)).epsilon(1e-14));
  CHECK(third.stopped_by == line_end::closed);
  CHECK(third.length == doctest::Approx(4 * std::sqrt(10.0)).epsilon(1e-14));
  CHECK(irrational.stopped_by == line_end::max_steps);
  CHECK(irrational.polys.size() == 16 * 16 + 1000);
}

TEST_CASE_TEMPLATE("integral_lines: as each line alone, from verts, polys and points, for any number of threads", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {3, 3, 3}});
  const auto g = field_of(m, [](const vec3& x) { return vec3{0.5 - x.y, x.x - 0.5, 0.1}; });
  std::vector<mesh_point<M>> starts;
  for (const auto v : verts(m)) starts.push_back({v, {}});
  for (const auto e : edges(m)) starts.push_back({edge_point<M>{e, 0.25}, {}});
  if constexpr (dimension_v<M> == 3)
    for (const auto f : faces(m)) {
      std::vector<vec3> x;
      for (const auto v : adj_f2v(m, f)) x.push_back(to_vec3(point(m, v)));
      starts.push_back({f, 0.5 * x[0] + 0.3 * x[1] + 0.2 * x[2]});
    }
  const auto lines = integral_lines(m, g, starts);
  REQUIRE(lines.size() == starts.size());
  for (std::size_t i = 0; i < starts.size(); i += 7) {
    check_line(m, g, lines[i]);
    CHECK(same(lines[i], integral_line(m, g, starts[i])));
  }
  for (const int threads : {1, 3}) {
    const with_num_threads limit(threads);
    const auto again = integral_lines(m, g, starts);
    for (std::size_t i = 0; i < starts.size(); ++i) CHECK(same(lines[i], again[i]));
  }
}

TEST_CASE_TEMPLATE("integral_line: a copy with all elements in reversed order has the same lines", M, trimesh, polygonmesh, tetmesh, hexmesh) {
  M m = make_grid<M>({.cells = {5, 5, 5}});
  jitter(m, 0.2);
  std::vector<vec3> points;
  std::vector<std::vector<unsigned>> corners;
  const unsigned n = static_cast<unsigned>(num_verts(m)), k = static_cast<unsigned>(num_polys(m));
  for (unsigned i = 0; i < n; ++i) points.push_back(point(m, vert_id{n - 1 - i}));
  for (unsigned i = 0; i < k; ++i) {
    corners.emplace_back();
    for (const auto v : adj_p2v(m, poly_id{k - 1 - i})) corners.back().push_back(n - 1 - v.raw());
    if constexpr (dimension_v<M> == 2) std::rotate(corners.back().begin(), corners.back().begin() + 1, corners.back().end());
  }
  const M copy(points, corners);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1, 1);
  auto g = make_poly_map<vec3>(m), h = make_poly_map<vec3>(copy);
  for (unsigned i = 0; i < k; ++i) g[poly_id{i}] = h[poly_id{k - 1 - i}] = vec3(1, 0.3, 0.2) + 0.5 * vec3(any(random), any(random), any(random));
  std::size_t compared = 0;
  for (unsigned i = 0; i < k; ++i) {
    const auto a = integral_line(m, g, poly_id{i}), b = integral_line(copy, h, poly_id{k - 1 - i});
    bool meets_vert = false;
    for (const auto& x : a.points) meets_vert = meets_vert || std::holds_alternative<vert_id>(x.element);
    if (meets_vert) continue;
    ++compared;
    REQUIRE(a.points.size() == b.points.size());
    CHECK(a.stopped_by == b.stopped_by);
    for (std::size_t j = 0; j < a.points.size(); ++j) CHECK(distance(a.points[j].position, b.points[j].position) < 1e-9);
    for (std::size_t j = 0; j < a.polys.size(); ++j) CHECK(a.polys[j].raw() == k - 1 - b.polys[j].raw());
  }
  CHECK(compared > k / 8);
}

TEST_CASE("integral_line: errors") {
  const auto m = make_grid<trimesh>({.cells = {3, 3}});
  auto g = constant_field(m, {1, 0, 0});
  CHECK_THROWS_WITH_AS(integral_line(m, g, vert_id{99}), "integral_line: the start, vert 99, is no vert of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(integral_line(m, g, poly_id{99}), "integral_line: the start, poly 99, is no poly of the mesh; take it from polys(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(integral_line(m, g, vert_id{0}, {.max_length = 0}), "integral_line: max_length must be above 0; leave it out to follow lines to their end",
                       invalid_argument);
  CHECK_THROWS_WITH_AS(integral_line(m, g, mesh_point<trimesh>{edge_point<trimesh>{edge_id{0}, 1.5}, {}}),
                       "integral_line: the start is on an edge, but its parameter is not in [0, 1]", invalid_argument);
  CHECK_THROWS_WITH_AS(integral_line(m, g, mesh_point<trimesh>{poly_id{0}, {std::nan(""), 0, 0}}), "integral_line: the position of the start is not finite",
                       invalid_argument);
  CHECK_THROWS_WITH_AS(integral_line(m, g, mesh_point<trimesh>{poly_id{0}, {0.5, 0.5, 0.5}}),
                       doctest::Contains("integral_line: the position of the start is not in poly 0, but "), invalid_argument);
  CHECK_THROWS_AS(integral_lines(m, g, polys(m), {.progress = [](double, const char*) { return false; }}), cancelled);
  g[poly_id{5}] = {0, std::nan(""), 0};
  CHECK_THROWS_WITH_AS(integral_line(m, g, vert_id{0}), "integral_line: the vector at poly 5 is not finite; give each poly a finite vector", invalid_argument);
  g[poly_id{5}] = {0, std::numeric_limits<double>::infinity(), 0};
  CHECK_THROWS_WITH_AS(integral_lines(m, g, polys(m)), "integral_lines: the vector at poly 5 is not finite; give each poly a finite vector", invalid_argument);
}

TEST_CASE("integral_line: what is degenerate, not manifold or not finite") {
  // three triangles at one edge, a triangle without area, and a vert of no poly
  trimesh m(std::vector<vec3>{{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {-0.5, 0.5, 0}, {5, 5, 5}},
            std::vector<std::vector<unsigned>>{{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 5, 2}});
  auto g = constant_field(m, {1, 0.1, 0});
  const auto into_edge = integral_line(m, g, poly_id{0});
  CHECK(into_edge.stopped_by == line_end::non_manifold);
  CHECK(into_edge.points.back().position.x == 0);
  CHECK(integral_line(m, g, vert_id{6}).stopped_by == line_end::boundary);
  CHECK(integral_line(m, g, vert_id{6}).points.size() == 1);
  CHECK(integral_line(m, g, poly_id{0}, {.backward = true}).stopped_by != line_end::max_steps);
  CHECK(integral_line(m, g, poly_id{3}).stopped_by == line_end::zero);
  set_point(m, vert_id{1}, vec3(0, std::nan(""), 0));
  CHECK_THROWS_WITH_AS(integral_line(m, g, vert_id{0}), "integral_line: poly 0 has points that are not finite", invalid_mesh);
  auto cells = make_grid<tetmesh>({.cells = {2, 2, 2}});
  const auto h = constant_field(cells, {1, 0.1, 0.2});
  set_point(cells, vert_id{26}, vec3(0, 0, std::numeric_limits<double>::infinity()));
  CHECK_THROWS_AS(integral_lines(cells, h, verts(cells)), invalid_mesh);
  for (const auto v : verts(cells)) set_point(cells, v, vec3(v.raw(), 0, 0));  // all cells are flat
  for (const auto& line : integral_lines(cells, h, verts(cells))) CHECK(line.points.size() < 100);
  for (const auto v : verts(cells)) set_point(cells, v, vec3());
  for (const auto& line : integral_lines(cells, h, polys(cells))) CHECK(line.points.size() < 100);
}

TEST_CASE("integral_line: the length of vectors does not matter") {
  const auto m = make_grid<hexmesh>({.cells = {3, 3, 3}});
  const auto g = field_of(m, [](const vec3& x) { return vec3{0.5 - x.y, x.x - 0.5, 0.1}; });
  for (const double scale : {0x1p-900, 0x1p900}) {
    auto scaled = make_poly_map<vec3>(m);
    for (const auto p : polys(m)) scaled[p] = scale * g[p];
    for (const auto p : polys(m)) CHECK(same(integral_line(m, g, p), integral_line(m, scaled, p)));
  }
}
