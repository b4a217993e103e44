#include <concino/level_sets/clip.hpp>

#include <concino/core/error.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/level_sets/isolines.hpp>
#include <concino/level_sets/isosurface.hpp>
#include <concino/mesh/property.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/level_sets.hpp>
#include <support/random_meshes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

/// The vector area of the surface of a poly of a volume, which is 0 if it is closed.
template<class M>
double openness(const M& m, poly_t<M> p) {
  vec3 sum;
  for (const auto f : adj_p2f(m, p)) sum += face_is_outward(m, p, f) ? area_vector(m, f) : -area_vector(m, f);
  return norm(sum);
}

/// The area of the level set, or its length, as isosurface or isolines find it.
template<class M, class U>
double level_measure(const M& m, const U& u, double value) {
  double sum = 0;
  if constexpr (dimension_v<M> == 3) {
    const auto s = isosurface(m, u, value);
    for (const auto p : polys(s.mesh)) sum += area(s.mesh, p);
  } else {
    for (const auto& line : isolines(m, u, value)) sum += length_of(line);
  }
  return sum;
}

template<class C>
double cut_measure(const C& c) {
  double sum = 0;
  if constexpr (dimension_v<decltype(c.mesh)> == 3) {
    for (const auto f : c.cut_faces) sum += area(c.mesh, f);
  } else {
    for (const auto e : c.cut_edges) sum += edge_length(c.mesh, e);
  }
  return sum;
}

template<class C>
double measure_above(const C& c) {
  double sum = 0;
  for (const auto p : polys(c.mesh))
    if (c.above[index_of(c.mesh, p)]) sum += measure(c.mesh, p);
  return sum;
}

/// Checks that no poly of the result has verts on both sides, except those that were moved.
template<class C>
void check_sides(const C& c, double value) {
  const auto q = find_vert_property<double>(c.mesh, "value");
  REQUIRE(q);
  std::size_t wrong = 0;
  for (const auto p : polys(c.mesh))
    for (const auto v : adj_p2v(c.mesh, p)) wrong += c.above[index_of(c.mesh, p)] ? q[v] < value - 1e-12 : q[v] > value + 1e-12;
  if (c.report.moved_verts.empty()) CHECK(wrong == 0);
}

}  // namespace

TEST_CASE_TEMPLATE("split: the parts are closed, sum to the whole, and meet in the level set", M, CONCINO_KINDS) {
  std::mt19937 random(1);
  std::size_t cut = 0;
  for (int i = 0; i < (long_run() ? 1000 : 50); ++i) {
    M m = mesh_to_cut<M>(random);
    const auto u = random_values(m, random, i % 3 != 0);
    const auto value = vert_property<double>(m, "value");
    for (const auto v : verts(m)) value[v] = u[v];
    INFO("mesh " << i);
    const double whole = total_measure(m);
    const auto s = split(m, u, 1.0);
    const auto c = clip(m, u, 1.0);
    CHECK(std::abs(total_measure(s.mesh) - whole) <= 1e-12 * whole);
    CHECK(std::abs(total_measure(c.mesh) - measure_above(s)) <= 1e-12 * whole);
    CHECK(cut_measure(s) == doctest::Approx(level_measure(m, u, 1.0)).epsilon(1e-9));
    CHECK(s.from.polys.size() == num_polys(s.mesh));
    check_sides(s, 1.0);
    if constexpr (dimension_v<M> == 3) {
      for (const auto p : polys(s.mesh)) CHECK(openness(s.mesh, p) <= 1e-12);
    }
    if (i < 10) CHECK(check_laws(s.mesh).empty());
    cut += s.report.cut_polys;
  }
  CHECK(cut > 100);
}

TEST_CASE_TEMPLATE("split: random meshes that are not manifold are cut to meshes, with the same measure", M, CONCINO_KINDS) {
  std::mt19937 random(6);
  std::size_t cut = 0;
  for (unsigned i = 0; i < num_random_meshes() / 2; ++i) {
    const M m = random_mesh<M>(random);
    INFO("mesh " << i);
    try {
      const auto s = split(m, random_values(m, random, i % 2 == 0), 1.0);
      cut += s.report.cut_polys > 0;
      CHECK(s.from.polys.size() == num_polys(s.mesh));
      if constexpr (std::same_as<M, tetmesh>) {  // other faces are not planar, and two cells may use one in the same direction
        double size = 0;
        for (const auto p : polys(m)) size += std::abs(measure(m, p));
        CHECK(std::abs(total_measure(s.mesh) - total_measure(m)) <= 1e-12 * size);
      }
    } catch (const unsupported&) {
      continue;  // a cell whose faces do not form a sphere
    }
  }
  CHECK(cut > num_random_meshes() / 8);
}

TEST_CASE_TEMPLATE("clip: of a linear function it has the measure of the part of the box, and passes validate", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {5, 4, 3}});
  const auto c = clip(m, plane{{2, 0, 0}, 0.6});  // x >= 0.3
  CHECK(total_measure(c.mesh) == doctest::Approx(0.7).epsilon(1e-13));
  CHECK(cut_measure(c) == doctest::Approx(1).epsilon(1e-13));
  const auto report = validate(c.mesh);
  for (const auto& d : report) CHECK_MESSAGE(false, d.what);
  CHECK(report.facts.manifold);
  CHECK(c.report.concave_polys == 0);
  CHECK(c.report.inverted_parts == 0);
  for (const auto above : c.above) CHECK(above == 1);
}

TEST_CASE_TEMPLATE("clip: elements that are not cut keep their verts and their order", M, CONCINO_KINDS) {
  const M m = make_grid<M>({.cells = {4, 4, 4}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v).x;
  const auto c = clip(m, u, 0.6);
  std::size_t last = 0, kept = 0;
  bool ascending = true, same = true;
  for (const auto p : polys(c.mesh)) {
    const auto origins = c.from.polys[index_of(c.mesh, p)];
    REQUIRE(origins.size() == 1);
    const poly_t<M> before((*origins.begin()).index);
    bool whole = true;
    for (const auto v : adj_p2v(m, before)) whole = whole && u[v] >= 0.6;
    if (!whole) break;
    ascending = ascending && (kept == 0 || before.raw() > last);
    last = before.raw();
    ++kept;
    std::vector<vec3> points_before, points_after;
    for (const auto v : adj_p2v(m, before)) points_before.push_back(point(m, v));
    for (const auto v : adj_p2v(c.mesh, p)) points_after.push_back(point(c.mesh, v));
    same = same && std::is_permutation(points_before.begin(), points_before.end(), points_after.begin(), points_after.end());
  }
  CHECK(kept > 0);
  CHECK(ascending);
  CHECK(same);
}

TEST_CASE_TEMPLATE("clip: properties are interpolated at verts and inherited by parts", M, CONCINO_KINDS) {
  M m = make_grid<M>({.cells = {3, 3, 3}});
  const auto linear = vert_property<double>(m, "linear");
  const auto number = poly_property<int>(m, "number");
  for (const auto v : verts(m)) linear[v] = point(m, v).x + 2 * point(m, v).y;
  for (const auto p : polys(m)) number[p] = static_cast<int>(p.raw());
  const auto s = split(m, linear, 1.1);
  const auto values = find_vert_property<double>(s.mesh, "linear");
  const auto numbers = find_poly_property<int>(s.mesh, "number");
  REQUIRE(values);
  REQUIRE(numbers);
  for (const auto v : verts(s.mesh)) CHECK(std::abs(values[v] - point(s.mesh, v).x - 2 * point(s.mesh, v).y) <= 1e-14);
  for (const auto p : polys(s.mesh)) CHECK(numbers[p] == static_cast<int>((*s.from.polys[p.raw()].begin()).index));
  const auto without = split(m, linear, 1.1, {.properties = false});
  CHECK(!find_vert_property<double>(without.mesh, "linear"));
}

TEST_CASE("clip: a bowl is cut by a plane into a ring") {
  // 3 x 3 x 2 cubes without the upper one in the middle: a cell that is not convex. The plane through the upper layer leaves a ring.
  std::vector<std::size_t> labels(18, 0);
  labels[9 + 4] = 1;
  auto m = merged_cubes(3, 3, 2, labels);
  const auto s = split(m, plane{{0, 0, 1}, 1.5});
  CHECK(total_measure(s.mesh) == doctest::Approx(18).epsilon(1e-13));
  CHECK(measure_above(s) == doctest::Approx(4.5).epsilon(1e-13));
  CHECK(s.report.cut_polys == 2);
  CHECK(s.report.concave_polys == 1);
  for (const auto p : polys(s.mesh)) CHECK(openness(s.mesh, p) <= 1e-12);
  const auto message = [&] {
    try {
      (void)clip(m, plane{{0, 0, 1}, 1.5}, {.convex_only = true});
    } catch (const unsupported& e) {
      return std::string(e.what());
    }
    return std::string();
  }();
  CHECK(message.find("poly 0") != std::string::npos);
}

TEST_CASE("clip: a vert inside a patch between two cells moves to the other side and is reported") {
  const auto m = merged_cubes(2, 2, 2, {0, 0, 0, 0, 1, 1, 1, 1});
  auto u = make_vert_map<double>(m, 1.0);
  for (const auto v : verts(m))
    if (norm(point(m, v) - vec3{1, 1, 1}) < 0.1) u[v] = 0;
  const auto s = split(m, u, 0.5);
  CHECK(s.report.moved_verts.size() == 1);
  CHECK(s.cut_faces.empty());
  CHECK(num_polys(s.mesh) == 2);
  CHECK(total_measure(s.mesh) == doctest::Approx(8).epsilon(1e-13));
}

TEST_CASE("clip: all or nothing where the value is out of range") {
  const auto m = make_grid<hexmesh>({.cells = {2, 2, 2}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v).z;
  CHECK(num_polys(clip(m, u, -1.0).mesh) == 8);
  CHECK(num_verts(clip(m, u, -1.0).mesh) == 27);
  CHECK(num_polys(clip(m, u, 2.0).mesh) == 0);
  CHECK(num_verts(clip(m, u, 2.0).mesh) == 0);
  CHECK(num_polys(split(m, u, 0.5).mesh) == 8);  // along faces of the mesh
  CHECK(split(m, u, 0.5).cut_faces.size() == 4);
  const polygonmesh none;
  CHECK(num_polys(clip(none, make_vert_map<double>(none), 0.0).mesh) == 0);
}

TEST_CASE("clip: errors, and progress that cancels") {
  const auto m = make_grid<tetmesh>({.cells = {2, 2, 2}});
  auto u = make_vert_map<double>(m, 0.0);
  CHECK_THROWS_AS((void)clip(m, plane{{0, 0, 0}, 1}), invalid_argument);
  CHECK_THROWS_AS((void)clip(m, plane{{0, 0, std::nan("")}, 1}), invalid_argument);
  CHECK_THROWS_AS((void)clip(m, u, std::nan("")), invalid_argument);
  const auto larger = make_grid<tetmesh>({.cells = {3, 2, 2}});
  CHECK_THROWS_AS((void)split(larger, u, 1.0), invalid_argument);
  CHECK_THROWS_AS((void)clip(m, u, 1.0, {.progress = [](double, const char*) { return false; }}), cancelled);
  u[vert_id(3)] = std::nan("");
  CHECK_THROWS_AS((void)clip(m, u, 1.0), invalid_argument);
}
