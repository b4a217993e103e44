#include <concino/fields/harmonic_map.hpp>

#include <concino/edit/elements.hpp>
#include <concino/operators/laplacian.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using values = std::map<vert_id, double>;

/// A reference solution: K = A (M^-1 A)^(n-1) as a dense matrix, with rows of prescribed verts replaced by u = value, by full pivoting.
template<class M, class D>
Eigen::VectorXd dense_solution(const M& m, const values& given, const D& which, int exponent) {
  const Eigen::MatrixXd l = laplacian(m, which);
  Eigen::MatrixXd inverse_mass = Eigen::MatrixXd::Identity(l.rows(), l.rows());
  if constexpr (!std::same_as<D, uniform_t>)
    for (const auto v : verts(m)) {
      const auto i = static_cast<Eigen::Index>(index_of(m, v));
      inverse_mass(i, i) = 1 / vert_masses(m)[v];
    }
  Eigen::MatrixXd k = l;
  for (int i = 1; i < exponent; ++i) k = l * inverse_mass * k;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(l.rows());
  for (const auto& [v, x] : given) {
    const auto i = static_cast<Eigen::Index>(index_of(m, v));
    k.row(i).setZero();
    k(i, i) = 1;
    b[i] = x;
  }
  return k.fullPivLu().solve(b);
}

template<class M, class D>
double distance_to_dense(const M& m, const values& given, const D& which, int exponent) {
  const auto u = harmonic_map(m, given, which, {.exponent = exponent});
  const auto expected = dense_solution(m, given, which, exponent);
  double worst = 0;
  for (const auto v : verts(m)) worst = std::max(worst, std::abs(u[v] - expected[static_cast<Eigen::Index>(index_of(m, v))]));
  for (const auto& [v, x] : given) CHECK(u[v] == x);
  return worst;
}

template<class M>
bool on_boundary(const M& m, vert_id v) {
  for (std::size_t k = 0; k < (VolumeMesh<M> ? 3u : 2u); ++k)
    if (point(m, v)[k] == 0 || point(m, v)[k] == 1) return true;
  return false;
}

template<class M, class D, class F>
double largest_error(const M& m, const D& which, const F& f) {
  values given;
  for (const auto v : verts(m))
    if (on_boundary(m, v)) given[v] = f(to_vec3(point(m, v)));
  const auto u = harmonic_map(m, given, which);
  double worst = 0;
  for (const auto v : verts(m)) worst = std::max(worst, std::abs(u[v] - f(to_vec3(point(m, v)))));
  return worst;
}

template<class M> concept mappable = requires(const values& given) { harmonic_map(std::declval<M>(), given); };

}  // namespace

TEST_CASE_TEMPLATE("harmonic_map, uniform: equals a dense solution", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)}, c{3};
  CHECK(distance_to_dense(m, {{a, 0}, {b, 1}}, uniform, 1) < 1e-12);
  CHECK(distance_to_dense(m, {{a, -2}, {b, 5}, {c, 7.25}}, uniform, 1) < 1e-12);
  CHECK(distance_to_dense(m, {{c, 3}}, uniform, 1) < 1e-12);
  CHECK(distance_to_dense(m, {{a, -2}, {b, 5}, {c, 7.25}}, uniform, 2) < 1e-9);
  CHECK(distance_to_dense(m, {{a, -2}, {b, 5}, {c, 7.25}}, uniform, 3) < 1e-6);
}

TEST_CASE_TEMPLATE("harmonic_map, cotangent: equals a dense solution, for all exponents", M, trimesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(2), 0.05));
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)}, c{3};
  for (const int n : {1, 2, 3}) CHECK(distance_to_dense(m, {{a, -2}, {b, 5}, {c, 7.25}}, cotangent, n) < (n == 1 ? 1e-12 : n == 2 ? 1e-9 : 1e-6));
}

TEST_CASE_TEMPLATE("harmonic_map, uniform: obeys the strict maximum principle", M, CONCINO_ALL_KINDS) {
  std::mt19937 random(5);
  const M m(jittered(grid_arrays<M>(4), 0.05));
  for (int round = 0; round < 5; ++round) {
    values given;
    for (int i = 0; i < 6; ++i) given[vert_id{static_cast<unsigned>(random() % num_verts(m))}] = static_cast<double>(random() % 1000) - 500;
    const auto [low, high] = std::minmax_element(given.begin(), given.end(), [](auto& x, auto& y) { return x.second < y.second; });
    const auto u = harmonic_map(m, given, uniform);
    for (const auto v : verts(m)) {
      if (given.count(v)) {
        CHECK(u[v] == given[v]);
      } else {
        CHECK(u[v] >= low->second - 1e-10);
        CHECK(u[v] <= high->second + 1e-10);
        double mean = 0, n = 0;
        for (const auto w : adj_v2v(m, v)) {
          mean += u[w];
          n += 1;
        }
        CHECK(u[v] == doctest::Approx(mean / n).epsilon(1e-9).scale(500));
      }
    }
  }
}

TEST_CASE_TEMPLATE("harmonic_map, cotangent: reproduces linear functions on planar triangles and on tets", M, trimesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(5), 0));
  CHECK(largest_error(m, cotangent, [](const vec3& x) { return x.x; }) < 1e-13);
  auto arrays = grid_arrays<M>(5);
  const auto wild = jittered(arrays, 0.06, VolumeMesh<M>);
  for (const auto v : verts(m))
    if (!on_boundary(m, v)) arrays.points[v.raw()] = wild.points[v.raw()];
  const M moved(arrays);
  CHECK(largest_error(moved, cotangent, [](const vec3& x) { return 1 + x.x + 2 * x.y - x.z; }) < 1e-13);
}

TEST_CASE("harmonic_map, cotangent: is exact for harmonic quadratics on the regular grid") {
  const auto m = grid<trimesh>(8);
  CHECK(largest_error(m, cotangent, [](const vec3& x) { return x.x * x.x - x.y * x.y; }) < 1e-14);
  CHECK(largest_error(m, cotangent, [](const vec3& x) { return x.x * x.y; }) < 1e-14);
  const auto t = grid<tetmesh>(4);
  CHECK(largest_error(t, cotangent, [](const vec3& x) { return x.x * x.x + x.y * x.y - 2 * x.z * x.z; }) < 1e-14);
}

TEST_CASE("harmonic_map: exponent 2 reproduces cubics along a ring of verts") {
  // With uniform weights on a ring of n verts the Laplacian is the second difference. The biharmonic map with prescribed values at two verts on each
  // side of an interval is the cubic through them.
  const int n = 24;
  std::vector<vec3> x;
  std::vector<std::vector<int>> ring(1);
  for (int i = 0; i < n; ++i) {
    x.push_back({std::cos(2 * 3.14159265358979 * i / n), std::sin(2 * 3.14159265358979 * i / n), 0});
    ring[0].push_back(i);
  }
  const polygonmesh m(x, ring);
  const auto cubic = [](int i) { return 0.001 * i * i * i - 0.02 * i * i + 0.3 * i - 1; };
  values given;
  for (const int i : {0, 1, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23}) given[vert_id{i}] = cubic(i);
  const auto u = harmonic_map(m, given, uniform, {.exponent = 2});
  for (int i = 0; i < n; ++i) CHECK(u[vert_id{i}] == doctest::Approx(cubic(i)).epsilon(1e-11));
}

TEST_CASE_TEMPLATE("harmonic_map: components are independent; isolated verts get the isolated or prescribed value", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(2);
  const auto half = static_cast<unsigned>((num_verts(m) - 1) / 2);
  const vert_id a{0}, b{half - 1}, c{half}, lonely{2 * half};
  const auto u = harmonic_map(m, {{a, 0}, {b, 1}, {c, 7}}, {.isolated_value = -3});
  CHECK(u[lonely] == -3);
  for (unsigned i = 0; i < half; ++i) CHECK(u[vert_id{half + i}] == doctest::Approx(7).epsilon(1e-12));
  static_assert(mappable<M&> && mappable<const M&> && !mappable<M>);
  CHECK(harmonic_map(m, {{a, 0}, {c, 7}, {lonely, 2}})[lonely] == 2);
  CHECK(harmonic_map(m, {{a, 0}, {c, 7}})[lonely] == 0);

  const std::string expected = "harmonic_map: the system is singular, because the component of vert " + std::to_string(half) + " (" + std::to_string(half) +
                               " verts) has no prescribed value; give one at any of its verts";
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{a, 0}, {b, 1}}), expected.c_str(), solver_error);
  CHECK_THROWS_AS(harmonic_map(m, values{}), solver_error);
  CHECK_THROWS_AS(harmonic_map(m, {{lonely, 1}}), solver_error);
}

TEST_CASE_TEMPLATE("harmonic_map: returns the prescribed values if there are no unknowns", M, CONCINO_ALL_KINDS) {
  const M none;
  CHECK(harmonic_map(none, values{}).values().empty());
  const M m = grid<M>(1);
  values all;
  for (const auto v : verts(m)) all[v] = v.raw();
  for (const int n : {1, 3}) {
    const auto u = harmonic_map(m, all, {.exponent = n});
    for (const auto v : verts(m)) CHECK(u[v] == v.raw());
  }
}

TEST_CASE("harmonic_map: accepts values in braces, maps and vectors, also equal duplicates") {
  const auto m = grid<quadmesh>(3);
  const vert_id a{0}, b{15};
  const auto u = harmonic_map(m, {{a, 0}, {b, 1}, {a, 0}});
  const auto by_map = harmonic_map(m, values{{a, 0}, {b, 1}});
  const auto by_vector = harmonic_map(m, std::vector<std::pair<vert_id, float>>{{b, 1.f}, {a, 0.f}});
  for (const auto v : verts(m)) {
    CHECK(u[v] == by_map[v]);
    CHECK(u[v] == by_vector[v]);
  }
}

TEST_CASE("harmonic_map: is accurate on a strip of 3 x 400 cells") {
  std::vector<vec3> x;
  std::vector<std::vector<int>> quads;
  const int n = 400;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < 4; ++j) x.push_back({i, j, 0});
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 3; ++j) quads.push_back({4 * i + j, 4 * i + 4 + j, 4 * i + 5 + j, 4 * i + 1 + j});
  const quadmesh m(x, quads);
  values given;
  for (int j = 0; j < 4; ++j) {
    given[vert_id{j}] = 0;
    given[vert_id{4 * n + j}] = 1;
  }
  const auto u = harmonic_map(m, given);
  for (const auto v : verts(m)) CHECK(u[v] == doctest::Approx(point(m, v)[0] / n).epsilon(1e-11));
}

TEST_CASE("harmonic_map: does not depend on the scale of the mesh, for any exponent") {
  auto arrays = jittered(triangle_grid(5), 0.04);
  const vert_id a{0}, b{35};
  for (const int n : {1, 2, 3}) {
    const trimesh m(arrays);
    const auto u = harmonic_map(m, {{a, 0}, {b, 1}}, cotangent, {.exponent = n});
    for (const double scale : {0x1p-200, 0x1p-20, 0x1p60}) {
      auto scaled = arrays;
      for (vec3& x : scaled.points) x *= scale;
      const trimesh s(scaled);
      if (n > 1 && scale < 0x1p-100) continue;  // areas to the power of 3 are out of the range of doubles
      const auto w = harmonic_map(s, {{a, 0}, {b, 1}}, cotangent, {.exponent = n});
      for (const auto v : verts(m)) CHECK(w[v] == doctest::Approx(u[v]).epsilon(1e-9));
    }
  }
}

TEST_CASE("harmonic_map: works at edges with three polys and verts with two fans") {
  const trimesh m({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {0.5, 0, 1}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {1, 5, 6}});
  const auto check = [&](const auto& which) {
    CHECK(distance_to_dense(m, {{vert_id{0}, 0}, {vert_id{5}, 1}}, which, 1) < 1e-13);
    CHECK(distance_to_dense(m, {{vert_id{0}, 0}, {vert_id{5}, 1}}, which, 2) < 1e-10);
  };
  check(uniform);
  check(cotangent);
}

TEST_CASE_TEMPLATE("harmonic_map, virtual elements: equals a dense solution, for all exponents", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)}, c{3};
  for (const int n : {1, 2, 3})
    CHECK(distance_to_dense(m, {{a, -2}, {b, 5}, {c, 7.25}}, virtual_elements, n) < (n == 1 ? 1e-12 : n == 2 ? 1e-9 : 1e-6));
}

TEST_CASE_TEMPLATE("harmonic_map, virtual elements: reproduces linear functions, whatever the polys", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.03, VolumeMesh<M>));
  values given;
  const auto f = [](const vec3& x) { return 1 + x.x + 2 * x.y - x.z; };
  for (const auto v : verts(m)) {
    bool inside = true;
    for (std::size_t k = 0; k < (VolumeMesh<M> ? 3u : 2u); ++k) inside = inside && point(m, v)[k] > 0.1 && point(m, v)[k] < 0.9;
    if (!inside) given[v] = f(to_vec3(point(m, v)));
  }
  REQUIRE(given.size() < num_verts(m));
  const auto u = harmonic_map(m, given);
  for (const auto v : verts(m)) CHECK(std::abs(u[v] - f(to_vec3(point(m, v)))) < 1e-13);
}

TEST_CASE_TEMPLATE("harmonic_map<vec3>: equals the map of numbers by component, with one factorisation", M, CONCINO_ALL_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)};
  const auto to_space = harmonic_map<vec3>(m, {{a, {0, 1, 2}}, {b, {3, -1, 5}}}, {.exponent = 2});
  const values parts[3] = {{{a, 0}, {b, 3}}, {{a, 1}, {b, -1}}, {{a, 2}, {b, 5}}};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto u = harmonic_map(m, parts[k], {.exponent = 2});
    for (const auto v : verts(m)) CHECK(to_space[v][k] == u[v]);
  }
  CHECK_THROWS_AS(harmonic_map<vec3>(m, {{a, {0, 1, 2}}, {a, {0, 1, 3}}}), invalid_argument);
  CHECK_THROWS_AS(harmonic_map<vec3>(m, {{a, {0, 1, INFINITY}}}), invalid_argument);
  CHECK_THROWS_AS(harmonic_map<vec3>(m, {{a, {0, INFINITY, 1}}}), invalid_argument);
  const M two = two_grids<M>(1);
  const vert_id second{static_cast<unsigned>(num_verts(two) / 2)}, alone{static_cast<unsigned>(num_verts(two) - 1)};
  const auto with_lonely = harmonic_map<vec3>(two, {{a, {0, 0, 0}}, {second, {1, 1, 1}}}, {.isolated_value = 4});
  CHECK(with_lonely[alone] == vec3{4, 4, 4});
}

TEST_CASE("harmonic_map: throws if an argument is invalid") {
  const auto m = grid<trimesh>(2);
  const vert_id a{0}, b{8};
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{a, 0.0}, {vert_id{9}, 1.0}}),
                       "harmonic_map: a value is given at something that is not a vert of the mesh; take verts from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{a, 0.0}, {b, 1.0}, {a, 0.5}}), "harmonic_map: two values are given at vert 0, 0 and 0.5; keep one", invalid_argument);
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{b, std::nan("")}}), "harmonic_map: the value given at vert 8 is not finite", invalid_argument);
  CHECK_THROWS_AS(harmonic_map(m, {{b, INFINITY}}), invalid_argument);
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{b, 1.0}}, {.exponent = 0}), "harmonic_map: exponent is 0; it must be 1 or more", invalid_argument);
  const polygonmesh quads({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS(harmonic_map(quads, {{a, 1.0}}, cotangent), unsupported);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(harmonic_map(flat, {{a, 1.0}}, cotangent), invalid_mesh);
  CHECK_THROWS_WITH_AS(harmonic_map(flat, {{a, 1.0}}), doctest::Contains("virtual elements: poly 0"), invalid_mesh);
  const quadmesh pressed({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_WITH_AS(harmonic_map(pressed, {{a, 1.0}}), doctest::Contains("virtual elements: poly 0 has no area"), invalid_mesh);
  CHECK(harmonic_map(flat, {{a, 1.0}}, uniform)[vert_id{2}] == doctest::Approx(1));
}

TEST_CASE("harmonic_map: reports progress and can be cancelled") {
  const auto m = grid<trimesh>(4);
  double last = 0;
  int calls = 0;
  const auto u = harmonic_map(m, {{vert_id{0}, 0.0}, {vert_id{24}, 1.0}}, {.progress = [&](double fraction, const char*) {
                                CHECK(fraction >= last);
                                last = fraction;
                                return ++calls > 0;
                              }});
  CHECK(last == 1);
  CHECK(u[vert_id{24}] == 1);
  CHECK_THROWS_AS(harmonic_map(m, {{vert_id{0}, 0.0}}, {.progress = [](double, const char*) { return false; }}), cancelled);
}

TEST_CASE_TEMPLATE("harmonic_map: the value of isolated verts does not change others, for all exponents", M, CONCINO_ALL_KINDS) {
  const M m = grid<M>(2);
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)}, c{3};
  for (const int n : {1, 2, 3, 4}) {
    const auto u = harmonic_map(m, {{a, 0}, {b, 1}, {c, 2}}, {.exponent = n});
    const auto w = harmonic_map(m, {{a, 0}, {b, 1}, {c, 2}}, {.exponent = n, .isolated_value = -300});
    for (const auto v : verts(m)) CHECK(u[v] == w[v]);
  }
  CHECK(distance_to_dense(grid<M>(1), {{a, -2}, {vert_id{1}, 5}}, uniform, 4) < 1e-6);
  CHECK(distance_to_dense(m, {{b, 1}, {c, 2}}, uniform, 2) < 1e-9);  // the component without vert 0
}

TEST_CASE_TEMPLATE("harmonic_map, laplacian, masses: work with gaps in the indices", M, CONCINO_ALL_KINDS) {
  M m(jittered(grid_arrays<M>(4), 0.02));
  const vert_id gone{static_cast<unsigned>(num_verts(m) / 2)};
  remove_vert(m, gone);
  const auto l = laplacian(m, uniform);
  CHECK(static_cast<std::size_t>(l.rows()) == vert_index_bound(m));
  CHECK(l.col(static_cast<Eigen::Index>(gone.raw())).nonZeros() == 0);
  CHECK((l * Eigen::VectorXd::Ones(l.rows())).cwiseAbs().maxCoeff() < 1e-12);
  CHECK(mass_matrix(m).coeff(static_cast<Eigen::Index>(gone.raw()), static_cast<Eigen::Index>(gone.raw())) == 0);
  const vert_id a{0}, b{static_cast<unsigned>(vert_index_bound(m) - 1)};
  const auto u = harmonic_map(m, {{a, 0}, {b, 1}}, uniform);
  for (const auto v : verts(m)) {
    double mean = 0, n = 0;
    for (const auto w : adj_v2v(m, v)) {
      mean += u[w];
      n += 1;
    }
    if (n == 0) CHECK(u[v] == 0);
    else if (v != a && v != b) CHECK(u[v] == doctest::Approx(mean / n).epsilon(1e-11));
  }
  const auto squared = harmonic_map(m, {{a, 0}, {b, 1}}, {.exponent = 2});
  CHECK(squared[b] == 1);
  CHECK_THROWS_AS(harmonic_map(m, {{gone, 1}}), invalid_mesh);
}
