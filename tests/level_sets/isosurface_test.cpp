#include <concino/level_sets/isosurface.hpp>

#include <concino/convert/convert.hpp>
#include <concino/core/error.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/mesh/property.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/level_sets.hpp>
#include <support/random_meshes.hpp>
#include <support/threads.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class Q>
double total_area(const Q& q) {
  double sum = 0;
  for (const auto p : polys(q)) sum += area(q, p);
  return sum;
}

/// The corners of {u = value} in a tet, from the definition: its verts on the level set, and the crossings of its edges.
template<class U>
std::vector<vec3> cap_by_definition(const tetmesh& m, const U& u, double value, poly_id p) {
  std::vector<vec3> corners;
  for (const auto v : adj_p2v(m, p))
    if (u[v] == value) corners.push_back(point(m, v));
  for (const auto e : adj_p2e(m, p)) {
    const auto [a, b] = end_verts(m, e);
    const double x = u[a] - value, y = u[b] - value;
    if (x * y < 0) corners.push_back(point(m, a) + x / (x - y) * (point(m, b) - point(m, a)));
  }
  return corners;
}

/// The area of the convex hull of up to four points of a plane: four triangles cover it twice.
double hull_area(const std::vector<vec3>& x) {
  const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) { return norm(cross(x[b] - x[a], x[c] - x[a])) / 2; };
  if (x.size() < 3) return 0;
  return x.size() == 3 ? triangle(0, 1, 2) : (triangle(0, 1, 2) + triangle(0, 1, 3) + triangle(0, 2, 3) + triangle(1, 2, 3)) / 2;
}

/// The area of {u = value} from the definition: the caps of tets, and the faces on the level set between a tet with smaller values and one without.
template<class U>
double area_by_definition(const tetmesh& m, const U& u, double value) {
  double sum = 0;
  for (const auto p : polys(m)) {
    bool below = false, above = false;
    for (const auto v : adj_p2v(m, p)) below |= u[v] < value, above |= u[v] > value;
    if (below && above) sum += hull_area(cap_by_definition(m, u, value, p));
  }
  for (const auto f : faces(m)) {
    bool on_level = true;
    for (const auto v : adj_f2v(m, f)) on_level &= u[v] == value;
    std::size_t polys_here = 0, below = 0;
    for (const auto p : adj_f2p(m, f)) {
      ++polys_here;
      for (const auto v : adj_p2v(m, p)) below += u[v] < value;
    }
    if (on_level && polys_here == 2 && below == 1) sum += area(m, f);
  }
  return sum;
}

/// The polys, sorted, as cycles of points that begin with the smallest one.
std::vector<std::vector<std::array<double, 3>>> cycles_of(const polygonmesh& q) {
  std::vector<std::vector<std::array<double, 3>>> all;
  for (const auto p : polys(q)) {
    auto& cycle = all.emplace_back();
    for (const auto v : adj_p2v(q, p)) cycle.push_back({point(q, v).x, point(q, v).y, point(q, v).z});
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

template<class F>
std::string message_of(const F& f) {
  try {
    f();
  } catch (const error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE_TEMPLATE("isosurface: closed up to the boundary, manifold and oriented, whatever the values are", M, CONCINO_VOLUME_KINDS) {
  std::mt19937 random(1);
  std::size_t found = 0;
  for (int i = 0; i < (long_run() ? 1000 : 150); ++i) {
    const M m = mesh_to_cut<M>(random);
    const auto u = random_values(m, random, i % 3 != 0);
    INFO("mesh " << i);
    const auto s = isosurface(m, u, 1.0);
    check_level_surface(m, s);
    found += num_polys(s.mesh);
  }
  CHECK(found > 500);
}

TEST_CASE_TEMPLATE("isosurface: in random cells that are not manifold or not oriented consistently, each edge has two polys at most", M, CONCINO_VOLUME_KINDS) {
  std::mt19937 random(5);
  std::size_t cut = 0;
  for (unsigned i = 0; i < num_random_meshes(); ++i) {
    const M m = random_mesh<M>(random);
    INFO("mesh " << i);
    try {
      const auto s = isosurface(m, random_values(m, random, i % 2 == 0), 1.0);
      std::size_t wrong = 0;
      for (const auto e : edges(s.mesh)) wrong += num_elements(adj_e2p(s.mesh, e)) > 2;
      CHECK(wrong == 0);
      ++cut;
    } catch (const unsupported&) {
      continue;  // a cell whose faces do not form a sphere
    }
  }
  CHECK(cut > num_random_meshes() / 4);
}

TEST_CASE("isosurface: in tets it is what it is in the same cells as polyhedra, also where they are not manifold or not oriented consistently") {
  std::mt19937 random(6);
  std::size_t found = 0;
  for (unsigned i = 0; i < num_random_meshes() + 300; ++i) {
    const tetmesh m = i < num_random_meshes() ? random_mesh<tetmesh>(random) : mesh_to_cut<tetmesh>(random);
    const auto u = random_values(m, random, i % 3 != 0);
    const auto n = convert<polyhedralmesh>(m);
    auto w = make_vert_map<double>(n);
    std::vector<vert_id> all;
    for (const auto v : verts(m)) all.push_back(v);
    std::size_t k = 0;
    for (const auto v : verts(n)) w[v] = u[all[k++]];
    INFO("mesh " << i);
    const auto s = isosurface(m, u, 1.0);
    const auto expected = isosurface(n, w, 1.0);
    CHECK(num_verts(s.mesh) == num_verts(expected.mesh));
    CHECK(num_edges(s.mesh) == num_edges(expected.mesh));
    CHECK(cycles_of(s.mesh) == cycles_of(expected.mesh));
    found += num_polys(s.mesh);
  }
  CHECK(found > 1000);
}

TEST_CASE("isosurface: the area in tets is that of the caps of each tet") {
  std::mt19937 random(2);
  for (int i = 0; i < 100; ++i) {
    auto m = make_grid<tetmesh>({.cells = {3, 3, 2}});
    jitter(m, 0.2, {.seed = random()});
    const auto u = random_values(m, random, i % 2 == 0);
    const auto s = isosurface(m, u, 1.0);
    CHECK(total_area(s.mesh) == doctest::Approx(area_by_definition(m, u, 1.0)).epsilon(1e-12));
    for (const auto p : polys(s.mesh)) {
      const auto cap = cap_by_definition(m, u, 1.0, s.poly_of(p));
      if (num_elements(adj_p2v(s.mesh, p)) == cap.size()) CHECK(area(s.mesh, p) == doctest::Approx(hull_area(cap)).epsilon(1e-12));
    }
  }
}

TEST_CASE_TEMPLATE("isosurface: of a linear function it is a plane, seen counter-clockwise from larger values", M, CONCINO_VOLUME_KINDS) {
  const vec3 direction{0.2, 0.3, 0.5};
  const M m = make_grid<M>({.cells = {4, 5, 3}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = dot(direction, point(m, v));
  const auto s = isosurface(m, u, {0.6, 0.3});
  CHECK(s.values.size() == num_polys(s.mesh));
  for (const auto p : polys(s.mesh)) {
    CHECK(dot(area_vector(s.mesh, p), direction) > 0);
    for (const auto v : adj_p2v(s.mesh, p)) {
      CHECK(std::abs(dot(direction, point(s.mesh, v)) - s.value_of(p)) <= 1e-12);
      CHECK(norm(s.place_of(v).position - point(s.mesh, v)) == 0);
    }
  }
  CHECK(s.value_of(*polys(s.mesh).begin()) == 0.3);  // ascending
}

TEST_CASE_TEMPLATE("isosurface: the area of a sphere is of order 2", M, CONCINO_VOLUME_KINDS) {
  const auto area_error = [](std::uint32_t n) {
    const M m = [&] {
      if constexpr (std::same_as<M, polyhedralmesh>) {
        const auto tets = make_grid<tetmesh>({.cells = {n, n, n}});
        return agglomerate(tets, random_labels(tets, 4));
      } else {
        return make_grid<M>({.cells = {n, n, n}});
      }
    }();
    const vec3 centre{0.5, 0.5, 0.5};
    auto u = make_vert_map<double>(m);
    for (const auto v : verts(m)) u[v] = dot(point(m, v) - centre, point(m, v) - centre);
    const auto s = isosurface<trimesh>(m, u, 0.16);
    check_level_surface(m, s);
    return std::abs(total_area(s.mesh) - 4 * 3.14159265358979324 * 0.16);
  };
  const double coarse = area_error(5), fine = area_error(15);
  CHECK(coarse < 0.25);
  CHECK(fine < coarse / 5);
}

TEST_CASE("isosurface: two cubes under two cubes, with one vert below that lies inside the patch between two cells") {
  // Each layer of 2 x 2 cubes is one cell, so that they share four faces. The vert in the middle of these is alone on its side: two caps coincide.
  const auto m = merged_cubes(2, 2, 2, {0, 0, 0, 0, 1, 1, 1, 1});
  auto u = make_vert_map<double>(m, 1.0);
  for (const auto v : verts(m))
    if (norm(point(m, v) - vec3{1, 1, 1}) < 0.1) u[v] = 0;
  const auto s = isosurface(m, u, 0.5);
  check_level_surface(m, s);
  CHECK(num_polys(s.mesh) == 0);

  // Two cells below and two above, across: the vert touches all four, and its caps form a closed surface.
  const auto crossed = merged_cubes(2, 2, 2, {0, 0, 1, 1, 2, 3, 2, 3});
  auto w = make_vert_map<double>(crossed, 1.0);
  for (const auto v : verts(crossed))
    if (norm(point(crossed, v) - vec3{1, 1, 1}) < 0.1) w[v] = 0;
  const auto t = isosurface(crossed, w, 0.5);
  check_level_surface(crossed, t);
  CHECK(num_polys(t.mesh) == 4);
}

TEST_CASE("isosurface: an L-shaped cell of which only the verts at the reflex edge are below") {
  const auto m = merged_cubes(2, 2, 1, {0, 0, 0, 1});
  auto u = make_vert_map<double>(m, 1.0);
  for (const auto v : verts(m))
    if (std::abs(point(m, v).x - 1) + std::abs(point(m, v).y - 1) < 0.1) u[v] = 0;
  const auto s = isosurface(m, u, 0.5);
  check_level_surface(m, s);
  CHECK(num_polys(s.mesh) > 0);
}

TEST_CASE("isosurface: values and properties, and triangles on request") {
  auto m = make_grid<hexmesh>({.cells = {4, 4, 4}});
  const auto height = vert_property<double>(m, "height");
  const auto number = poly_property<int>(m, "number");
  int i = 0;
  for (const auto v : verts(m)) height[v] = point(m, v).x + point(m, v).z;
  for (const auto p : polys(m)) number[p] = i++;
  const auto s = isosurface(m, height, {0.7, 1.3});
  const auto heights = find_vert_property<double>(s.mesh, "height");
  const auto numbers = find_poly_property<int>(s.mesh, "number");
  REQUIRE(heights);
  REQUIRE(numbers);
  for (const auto p : polys(s.mesh)) {
    CHECK(numbers[p] == number[s.poly_of(p)]);
    for (const auto v : adj_p2v(s.mesh, p)) CHECK(heights[v] == doctest::Approx(s.value_of(p)).epsilon(1e-14));
  }
  const auto t = isosurface<trimesh>(m, height, {0.7, 1.3});
  CHECK(num_verts(t.mesh) == num_verts(s.mesh));
  CHECK(num_polys(t.mesh) > num_polys(s.mesh));
  CHECK(total_area(t.mesh) == doctest::Approx(total_area(s.mesh)).epsilon(1e-12));
}

namespace {

/// The number of polys of the level set, which is the same, to the bit, with 1, 2 and 3 threads.
template<class M, class U>
std::size_t compare_threads(const M& m, const U& u, double level) {
  const auto with = [&](int threads) {
    const with_num_threads fixed(threads);
    return isosurface(m, u, level);
  };
  const auto one = with(1);
  CHECK(one.values == std::vector<double>(num_polys(one.mesh), level));
  for (const auto v : verts(one.mesh)) REQUIRE(norm(point(one.mesh, v) - one.place_of(v).position) == 0);
  for (const int threads : {2, 3}) {
    const auto more = with(threads);
    REQUIRE(num_verts(one.mesh) == num_verts(more.mesh));
    REQUIRE(num_polys(one.mesh) == num_polys(more.mesh));
    REQUIRE(one.places.size() == more.places.size());
    bool equal = one.polys == more.polys && one.values == more.values;
    for (const auto v : verts(one.mesh)) {
      const auto &a = one.place_of(v), &b = more.place_of(v);
      equal = equal && a.element.index() == b.element.index() && norm(a.position - b.position) == 0 && norm(point(one.mesh, v) - point(more.mesh, v)) == 0;
      if (const auto* x = std::get_if<edge_point<M>>(&a.element)) equal = equal && x->edge == std::get<edge_point<M>>(b.element).edge;
    }
    for (const auto p : polys(one.mesh)) {
      auto other = adj_p2v(more.mesh, p).begin();
      for (const auto v : adj_p2v(one.mesh, p)) equal = equal && v == *other++;
    }
    CHECK(equal);
  }
  return num_polys(one.mesh);
}

}  // namespace

TEST_CASE("isosurface: the same for any number of threads") {
  auto m = make_grid<hexmesh>({.cells = {12, 12, 12}});
  jitter(m, 0.2);
  std::mt19937 random(3);
  for (const bool whole_numbers : {false, true}) compare_threads(m, random_values(m, random, whole_numbers), 1.0);
}

TEST_CASE_TEMPLATE("isosurface: of several values, the surfaces of each value alone, one after another", To, polygonmesh, trimesh) {
  const auto m = make_grid<hexmesh>({.cells = {8, 8, 8}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = norm(point(m, v) - vec3(0.47, 0.52, 0.49));
  const std::vector<double> levels{0.21, 0.33, 0.44};
  const auto all = isosurface<To>(m, u, levels);
  std::size_t vert = 0, poly = 0;
  for (const double level : levels) {
    const auto one = isosurface<To>(m, u, {level});
    for (const auto p : polys(one.mesh)) {
      const poly_id same{poly + p.raw()};
      CHECK(all.value_of(same) == level);
      CHECK(all.poly_of(same) == one.poly_of(p));
      auto other = adj_p2v(all.mesh, same).begin();
      for (const auto v : adj_p2v(one.mesh, p)) CHECK((*other++).raw() == vert + v.raw());
    }
    for (const auto v : verts(one.mesh)) {
      const vert_id same{vert + v.raw()};
      CHECK(norm(point(all.mesh, same) - point(one.mesh, v)) == 0);
      CHECK(norm(all.place_of(same).position - point(one.mesh, v)) == 0);
    }
    vert += num_verts(one.mesh), poly += num_polys(one.mesh);
  }
  CHECK(poly > 300);
  CHECK(num_verts(all.mesh) == vert);
  CHECK(num_polys(all.mesh) == poly);
}

TEST_CASE("isosurface: where nothing is crossed there is no surface, and infinite values are limits") {
  const auto m = make_grid<hexmesh>({.cells = {2, 2, 2}});
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v).z;
  for (const double value : {-1.0, 0.0, 1.0, 2.0, std::numeric_limits<double>::infinity()}) CHECK(num_polys(isosurface(m, u, value).mesh) == 0);
  CHECK(total_area(isosurface(m, u, 0.5).mesh) == doctest::Approx(1));
  const tetmesh none;
  CHECK(num_polys(isosurface(none, make_vert_map<double>(none), 0.0).mesh) == 0);
  for (const auto v : verts(m)) u[v] = point(m, v).z < 0.25 ? -std::numeric_limits<double>::infinity() : 1e300;
  const auto s = isosurface(m, u, 0.0);
  for (const auto v : verts(s.mesh)) CHECK(point(s.mesh, v).z == 0.5);
}

TEST_CASE("isosurface: errors name the vert, the map, and a cell whose surface is no sphere") {
  const auto m = make_grid<hexmesh>({.cells = {2, 2, 2}});
  const auto larger = make_grid<hexmesh>({.cells = {3, 2, 2}});
  auto u = make_vert_map<double>(m, 0.0);
  CHECK_THROWS_AS((void)isosurface(larger, u, 1.0), invalid_argument);
  CHECK_THROWS_AS((void)isosurface(m, u, std::nan("")), invalid_argument);
  u[vert_id(7)] = std::nan("");
  CHECK(message_of([&] { (void)isosurface(m, u, 1.0); }).find("vert 7") != std::string::npos);

  // A ring of eight cubes around one that is a cell of its own.
  const auto ring = merged_cubes(3, 3, 1, {0, 0, 0, 0, 1, 0, 0, 0, 0});
  auto w = make_vert_map<double>(ring);
  for (const auto v : verts(ring)) w[v] = point(ring, v).x;
  CHECK_THROWS_AS((void)isosurface(ring, w, 0.5), unsupported);
  CHECK(message_of([&] { (void)isosurface(ring, w, 0.5); }).find("poly 0") != std::string::npos);
  CHECK(num_polys(isosurface(ring, w, -1.0).mesh) == 0);  // not cut
}

TEST_CASE("isosurface: a face of three polys does not hide that another face is on the boundary") {
  // The cell in the middle of the lower layer has six neighbours through five faces. Its lowest face is on the boundary, and not planar.
  const auto grid = make_grid<hexmesh>({.cells = {3, 3, 2}});
  cell_arrays arrays{{}, {}, 8};
  for (const auto v : verts(grid)) arrays.points.push_back(point(grid, v));
  for (const auto p : polys(grid))
    for (const auto v : adj_p2v(grid, p)) arrays.verts.push_back(v);
  const std::size_t above = 8 * (9 + 4);
  for (std::size_t k = 0; k < 8; ++k) {
    const vert_id v = arrays.verts[above + k];
    if (arrays.points[v.raw()].z < 0.75) {
      arrays.verts.push_back(v);
    } else {
      arrays.verts.push_back(vert_id(static_cast<std::uint32_t>(arrays.points.size())));
      arrays.points.push_back(arrays.points[v.raw()] + vec3{0.05, 0.1, 0.4});
    }
  }
  for (vec3& x : arrays.points)
    if (norm(x - vec3{1.0 / 3, 1.0 / 3, 0}) < 0.01) x.z = 0.1;
  const hexmesh m(std::move(arrays));
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = point(m, v).z < 0.3 ? point(m, v).x : 1;
  const auto s = isosurface(m, u, 0.45);
  CHECK(num_verts(s.mesh) == 16);
  CHECK(total_area(s.mesh) == doctest::Approx(0.504022).epsilon(1e-6));
}
