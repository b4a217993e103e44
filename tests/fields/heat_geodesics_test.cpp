#include <concino/fields/heat_geodesics.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/edit/elements.hpp>
#include <concino/generate/icosphere.hpp>

#include <support/kinds.hpp>

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

struct deviation {
  double mean = 0, largest = 0, farthest = 0, mean_distance = 0;
};

template<class Map, class F>
deviation error_of(const Map& d, const F& exact) {
  deviation e;
  const auto& m = d.mesh();
  for (const auto v : verts(m)) {
    const double x = exact(to_vec3(point(m, v))), wrong = std::abs(d[v] - x), share = 1 / static_cast<double>(num_verts(m));
    e.mean += wrong * share;
    e.mean_distance += x * share;
    e.largest = std::max(e.largest, wrong);
    e.farthest = std::max(e.farthest, x);
  }
  return e;
}

template<class M>
vert_id nearest(const M& m, const vec3& x) {
  vert_id best{0};
  for (const auto v : verts(m))
    if (distance(point(m, v), x) < distance(point(m, best), x)) best = v;
  return best;
}

template<class Heat>
double error_from(const Heat& heat, vert_id s) {
  const vec3 from = point(heat.mesh(), s);
  const deviation e = error_of(heat.distance_from(s), [&](const vec3& x) { return distance(x, from); });
  return e.mean / e.farthest;
}

template<class M>
M square_or_cube(unsigned n) {
  return M(jittered(grid_arrays<M>(n), 0.1 / n, VolumeMesh<M>));
}

}  // namespace

TEST_CASE_TEMPLATE("heat_geodesics: straight lines on the square and in the cube, nearer when refined", M, CONCINO_ALL_KINDS) {
  const unsigned n = VolumeMesh<M> ? 3 : 10;
  const M coarse = square_or_cube<M>(n), fine = square_or_cube<M>(2 * n);
  const auto before = heat_geodesics(coarse), after = heat_geodesics(fine);
  for (const vec3& at : {vec3{0, 0, 0}, vec3{0.5, 0.5, VolumeMesh<M> ? 0.5 : 0}}) {
    const double e = error_from(before, nearest(coarse, at)), f = error_from(after, nearest(fine, at));
    CHECK(e < (VolumeMesh<M> ? 0.08 : 0.03));
    CHECK(f < 0.9 * e);
  }
  CHECK(after.time() == doctest::Approx(std::pow(1.5 * detail::mean_edge_length(fine), 2)));
}

TEST_CASE("heat_geodesics: arcs on the sphere, nearer when refined") {
  double before = 1;
  for (const unsigned k : {2u, 3u, 4u}) {
    const trimesh m = icosphere(k);
    const vec3 from = point(m, vert_id{5});
    const auto arc = [&](const vec3& x) { return std::atan2(norm(cross(x, from)), dot(x, from)); };
    const deviation e = error_of(heat_geodesics(m).distance_from(vert_id{5}), arc);
    CHECK(e.mean / e.farthest < 0.75 * before);
    before = e.mean / e.farthest;
  }
  CHECK(before < 0.002);
}

TEST_CASE_TEMPLATE("heat_geodesics: moving and scaling the mesh moves and scales the distances", M, CONCINO_ALL_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(3), 0.02, VolumeMesh<M>);
  const M m(arrays);
  const vert_id s{1};
  const auto d = heat_geodesics(m).distance_from(s);
  const auto changed = [&](double factor, const vec3& by) {
    auto a = arrays;
    for (vec3& x : a.points) x = factor * x + by;
    const M other(std::move(a));
    const auto e = heat_geodesics(other).distance_from(s);
    return std::vector<double>(e.values().begin(), e.values().end());
  };
  const auto large = changed(0x1p20, {}), small = changed(0x1p-20, {}), moved = changed(1e3, {5, -7, 3});
  for (const auto v : verts(m)) {
    const std::size_t i = index_of(m, v);
    CHECK(large[i] == 0x1p20 * d[v]);
    CHECK(small[i] == 0x1p-20 * d[v]);
    CHECK(moved[i] == doctest::Approx(1e3 * d[v]).epsilon(1e-9));
  }
}

TEST_CASE_TEMPLATE("heat_geodesics: an archetype of the mesh has the same distances", M, CONCINO_ALL_KINDS) {
  const M m = square_or_cube<M>(2);
  const auto weak = only_embedded_mesh(m);
  const auto d = heat_geodesics(m).distance_from(vert_id{0});
  const auto e = heat_geodesics(weak).distance_from(weak.vert(vert_id{0}));
  for (const auto v : verts(weak)) CHECK(e[v] == doctest::Approx(d[weak.base(v)]).epsilon(1e-9));
}

TEST_CASE_TEMPLATE("heat_geodesics: several sources, components and verts of no poly", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(3);
  const vert_id alone{static_cast<unsigned>(num_verts(m) - 1)}, a{0}, b = nearest(m, {1, 1, VolumeMesh<M> ? 1 : 0}), c = nearest(m, {2, 0, 0});
  const auto heat = heat_geodesics(m);
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

  // a source that another one overtakes is none
  const auto late = heat.distance_from({{a, 0.25}, {b, 40.0}});
  CHECK(late[a] == 0.25);
  for (const auto v : verts(m))
    if (da[v] < infinity) CHECK(late[v] == doctest::Approx(da[v] + 0.25));
  CHECK(heat.distance_from(std::vector<std::pair<vert_id, double>>{{a, -1.0}})[a] == -1);
}

TEST_CASE_TEMPLATE("heat_geodesics: from a point in a poly", M, CONCINO_ALL_KINDS) {
  const M m = grid<M>(VolumeMesh<M> ? 4 : 8);
  const auto heat = heat_geodesics(m);
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

TEST_CASE("heat_geodesics: long strips, graded grids and short times, where heat underflows") {
  surface_arrays a{{}, {}, {}, 3};
  const unsigned length = 3000;
  for (unsigned i = 0; i <= length; ++i)
    for (unsigned j = 0; j <= 1; ++j) a.points.push_back({double(i), double(j), 0});
  for (unsigned i = 0; i < length; ++i)
    for (const unsigned v : {0u, 2u, 3u, 0u, 3u, 1u}) a.verts.push_back(vert_id{2 * i + v});
  const trimesh strip(a);
  CHECK(heat_geodesics(strip).distance_from(vert_id{0})[vert_id{2 * length}] == doctest::Approx(length).epsilon(1e-3));
  CHECK(heat_geodesics(strip, {.time = 0.01}).distance_from(vert_id{0})[vert_id{2 * length}] == doctest::Approx(length).epsilon(1e-3));
  CHECK(heat_geodesics(strip, {.boundary = heat_boundary::cold}).distance_from(vert_id{0})[vert_id{2 * length}] > 0.5 * length);
  const auto sudden = heat_geodesics(strip, {.time = 1e-300}).distance_from(vert_id{0});  // no heat at all: ways along edges
  CHECK(sudden[vert_id{2 * length}] == doctest::Approx(length).epsilon(0.1));

  for (const double power : {2.0, 3.0}) {
    auto arrays = triangle_grid(25);
    for (vec3& x : arrays.points) x = {std::pow(x.x, power), std::pow(x.y, power), 0};
    const trimesh m(arrays);
    const auto heat = heat_geodesics(m);
    const deviation e = error_of(heat.distance_from(vert_id{0}), [](const vec3& x) { return norm(x); });
    CHECK(e.mean <= 0.03 * e.mean_distance);
  }
}

TEST_CASE("heat_geodesics: very long and thin hexahedra, whose Laplacian makes heat negative") {
  auto arrays = hex_grid(10);
  for (vec3& x : arrays.points) x = {std::pow(x.x, 3), std::pow(x.y, 3), std::pow(x.z, 3)};
  const hexmesh m(arrays);
  CHECK(error_from(heat_geodesics(m), vert_id{0}) < 0.1);
  const hexmesh wide = grid<hexmesh>(1);
  CHECK(detail::lower_positive_stiffness(wide).coeff(1, 0) == doctest::Approx(-0.25));  // a quarter of the face between two verts, over the edge
}

TEST_CASE("heat_geodesics: options") {
  const auto m = square_or_cube<trimesh>(16);
  const auto quads = square_or_cube<quadmesh>(16);
  const vert_id middle = nearest(m, {0.5, 0.5, 0});
  const double averaged = error_from(heat_geodesics(m), middle);
  CHECK(averaged < error_from(heat_geodesics(m, {.boundary = heat_boundary::natural}), middle));
  CHECK(averaged < error_from(heat_geodesics(m, {.boundary = heat_boundary::cold}), middle));
  CHECK(error_from(heat_geodesics(m, {.boundary = heat_boundary::cold}), vert_id{0}) < 0.12);
  CHECK(error_from(heat_geodesics(m, {.weights = weights::uniform}), middle) < 0.1);
  CHECK(error_from(heat_geodesics(quads, {.weights = weights::virtual_refinement}), middle) < 0.02);
  CHECK(error_from(heat_geodesics(m, {.weights = weights::cotangent}), middle) == doctest::Approx(averaged));
  CHECK(heat_geodesics(m, {.time = 0.01}).time() == 0.01);

  struct counting : ldlt {
    int* factorised = nullptr;
    explicit counting(int* n) : factorised(n) {}
    counting(const counting& c) : ldlt(), factorised(c.factorised) {}
    void factorize(const Eigen::SparseMatrix<double>& a) {
      ++*factorised;
      ldlt::factorize(a);
    }
  };
  int n = 0;
  const auto ball = icosphere(1);
  const auto heat = heat_geodesics(ball, {}, counting(&n));
  CHECK(n == 2);
  heat.distance_from(vert_id{0});
  heat.distance_from(vert_id{7});
  CHECK(n == 2);
  const auto shared = heat;
  CHECK(shared.distance_from(vert_id{3})[vert_id{3}] == 0);
}

TEST_CASE("heat_geodesics: errors") {
  const auto m = grid<quadmesh>(2);
  const auto heat = heat_geodesics(m);
  CHECK_THROWS_WITH_AS(heat.distance_from(vert_id{9}), "heat_geodesics: a source is no vert of the mesh; take it from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(heat.distance_from(std::vector<vert_id>()), "heat_geodesics: there is no source; give at least one vert", invalid_argument);
  CHECK_THROWS_WITH_AS(heat.distance_from({{vert_id{1}, std::nan("")}}), "heat_geodesics: the initial distance at vert 1 is not finite",
                       invalid_argument);
  CHECK_THROWS_AS(heat.distance_from(poly_id{4}, {0, 0, 0}), invalid_mesh);
  CHECK_THROWS_AS(heat.distance_from(poly_id{0}, {0, 0, infinity}), invalid_argument);
  CHECK_THROWS_WITH_AS(heat_geodesics(m, {.time = -1}), "heat_geodesics: time is -1; it must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_AS(heat_geodesics(m, {.time = infinity}), invalid_argument);
  CHECK_THROWS_AS(heat_geodesics(m, {.weights = weights::cotangent}), unsupported);
  CHECK_THROWS_AS(heat_geodesics(m, {.progress = [](double, const char*) { return false; }}), cancelled);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK_THROWS_WITH_AS(heat_geodesics(flat), doctest::Contains("heat_geodesics: poly 0 has no area"), invalid_mesh);
  const trimesh endless({{0, 0, 0}, {1, 0, 0}, {0, infinity, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(heat_geodesics(endless), invalid_mesh);
}

TEST_CASE_TEMPLATE("heat_geodesics: elements removed and not renumbered, and no elements at all", M, CONCINO_ALL_KINDS) {
  M m(jittered(grid_arrays<M>(4), 0.02, VolumeMesh<M>));
  remove_vert(m, vert_id{static_cast<unsigned>(num_verts(m) / 2)});
  const auto d = heat_geodesics(m).distance_from(vert_id{0});
  for (const auto v : verts(m)) CHECK(d[v] >= distance(point(m, v), point(m, vert_id{0})) * 0.7);
  const M empty;
  CHECK_THROWS_AS(heat_geodesics(empty).distance_from(vert_id{0}), invalid_mesh);
}
