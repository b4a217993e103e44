#include <concino/fields/smooth.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/fields/harmonic_map.hpp>
#include <concino/generate/icosphere.hpp>

#include <support/kinds.hpp>
#include <support/values_at_verts.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("smooth: removes the amount times the Laplacian or its power", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const auto f = random_values(m);
  const Eigen::SparseMatrix<double> l = laplacian(m);
  const auto mass = vert_masses(m);
  for (const int n : {1, 2, 3}) {
    const auto u = smooth(m, f, 1e-3, {.exponent = n});
    Eigen::VectorXd x(l.cols());
    for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = u[v];
    for (int k = 0; k < n; ++k) {
      const Eigen::VectorXd y = l * x;
      for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = -y[static_cast<Eigen::Index>(index_of(m, v))] / mass[v];
    }
    for (const auto v : verts(m)) CHECK(f[v] - u[v] == doctest::Approx(1e-3 * x[static_cast<Eigen::Index>(index_of(m, v))]).epsilon(1e-8).scale(1));
  }
}

TEST_CASE_TEMPLATE("smooth: preserves constants and totals, and reduces differences", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const auto f = random_values(m), ones = make_vert_map<double>(m, 1.0);
  const auto mass = vert_masses(m);
  for (const int n : {1, 2}) {
    CHECK(largest_difference(smooth(m, ones, 0.1, {.exponent = n}), ones) < 1e-12);
    const auto u = smooth(m, f, 0.01, {.exponent = n});
    double before = 0, after = 0, squares_before = 0, squares_after = 0;
    for (const auto v : verts(m)) {
      before += mass[v] * f[v];
      after += mass[v] * u[v];
      squares_before += mass[v] * f[v] * f[v];
      squares_after += mass[v] * u[v] * u[v];
    }
    CHECK(after == doctest::Approx(before).epsilon(1e-11).scale(1));
    CHECK(squares_after < 0.9 * squares_before);
    const auto flat = smooth(m, f, 1e6, {.exponent = n});
    for (const auto v : verts(m)) CHECK(flat[v] == doctest::Approx(before / total_measure(m)).epsilon(1e-3).scale(1));
  }
  CHECK(largest_difference(smooth(m, f, 0), f) < 1e-15);
  const auto u = smooth(m, f, 3, uniform);
  const auto [low, high] = std::minmax_element(f.values().begin(), f.values().end());
  for (const auto v : verts(m)) CHECK((u[v] > *low && u[v] < *high));
}

TEST_CASE_TEMPLATE("smooth: solves u - a u'' = x with slope 0 at the boundary", M, CONCINO_KINDS) {
  const auto error = [](unsigned n) {
    const M m = grid<M>(n);
    auto f = make_vert_map<double>(m);
    for (const auto v : verts(m)) f[v] = point(m, v)[0];
    const double s = 0.3;
    const auto u = smooth(m, f, s * s);
    double worst = 0;
    for (const auto v : verts(m)) {
      const double x = f[v];
      worst = std::max(worst, std::abs(u[v] - (x - s * std::sinh((x - 0.5) / s) / std::cosh(0.5 / s))));
    }
    return worst;
  };
  const unsigned n = VolumeMesh<M> ? 2 : 4;
  const double coarse = error(n), fine = error(2 * n);
  CHECK(fine < (VolumeMesh<M> ? 0.06 : 0.02));
  CHECK(coarse > 1.7 * fine);
}

TEST_CASE_TEMPLATE("smooth: preserves linear functions with constrained boundary, and constrained values exactly", M, CONCINO_KINDS) {
  const M m = grid<M>(3);
  auto f = make_vert_map<double>(m);
  std::vector<vert_id> held;
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    f[v] = 1 + x.x - 2 * x.y + 3 * x.z;
    bool inside = true;
    for (std::size_t k = 0; k < dimension_v<M>; ++k) inside = inside && x[k] > 0 && x[k] < 1;
    if (!inside) held.push_back(v);
  }
  const auto u = smooth(m, f, 0.5, {.fixed = held});
  CHECK(largest_difference(u, f) < 1e-13);
  auto noisy = random_values(m);
  const auto w = smooth(m, noisy, 1e9, {.fixed = held});
  std::vector<std::pair<vert_id, double>> given;
  for (const auto v : held) {
    given.push_back({v, noisy[v]});
    CHECK(w[v] == noisy[v]);
  }
  CHECK(largest_difference(w, harmonic_map(m, given)) < 1e-8);
}

TEST_CASE("smooth: of points is implicit fairing: reduces noise on a sphere without drift") {
  trimesh m = icosphere(3);
  std::mt19937 random(3);
  for (const auto v : verts(m)) set_point(m, v, (1 + 0.05 * (static_cast<double>(random() % 2001) / 1000 - 1)) * to_vec3(point(m, v)));
  auto x = make_vert_map<vec3>(m);
  for (const auto v : verts(m)) x[v] = to_vec3(point(m, v));
  const auto roughness = [&](const vert_map<trimesh, vec3>& at) {
    double mean = 0, squares = 0;
    for (const auto v : verts(m)) mean += norm(at[v]) / static_cast<double>(num_verts(m));
    for (const auto v : verts(m)) squares += (norm(at[v]) - mean) * (norm(at[v]) - mean);
    return std::sqrt(squares / static_cast<double>(num_verts(m))) / mean;
  };
  const double before = roughness(x);
  CHECK(roughness(smooth(m, x, 0.03)) < 0.4 * before);
  CHECK(roughness(smooth(m, x, 0.0005, {.exponent = 2})) < 0.5 * before);
  const auto mass = vert_masses(m);
  const auto faired = smooth(m, x, 0.03);
  vec3 centre_before, centre_after;
  for (const auto v : verts(m)) {
    centre_before += mass[v] * x[v];
    centre_after += mass[v] * faired[v];
  }
  CHECK(norm(centre_after - centre_before) < 1e-11);
}

TEST_CASE_TEMPLATE("prepare_smooth: equals smooth to the bit, by component", M, polygonmesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(2), 0.03, VolumeMesh<M>));
  const vert_id a{0};
  const auto u = random_values(m);
  const auto s = prepare_smooth(m, 0.1, {.fixed = {a}, .exponent = 2}), copy = s;
  CHECK(&s.mesh() == &m);
  CHECK(largest_difference(copy.apply(u), smooth(m, u, 0.1, {.fixed = {a}, .exponent = 2})) == 0);
  auto parts = make_vert_map<vec3>(m);
  for (const auto v : verts(m)) parts[v] = {u[v], 2 * u[v], 1};
  const auto free = prepare_smooth(m, 0.1);
  const auto x = free.apply(parts);
  const auto y = free.apply(u);
  CHECK(largest_difference(y, smooth(m, u, 0.1)) == 0);
  for (const auto v : verts(m)) {
    CHECK(x[v].x == y[v]);
    CHECK(x[v].y == 2 * y[v]);
    CHECK(x[v].z == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("smooth: runs on archetypes", M, trimesh, polyhedralmesh) {
  const M m = grid<M>(2);
  const auto f = random_values(m);
  const auto weak = only_embedded_mesh(m);
  auto on_weak = make_vert_map<double>(weak);
  for (const auto v : verts(weak)) on_weak[v] = f[weak.base(v)];
  const auto u = smooth(m, f, 0.1, {.fixed = {vert_id{0}}}), w = smooth(m, f, 0.1, uniform, {.exponent = 2});
  const auto same = smooth(weak, on_weak, 0.1, {.fixed = {weak.vert(vert_id{0})}});
  for (const auto v : verts(weak)) CHECK(same[v] == doctest::Approx(u[weak.base(v)]).epsilon(1e-12).scale(1));
  const auto graph = only_primal_graph(m);
  auto on_graph = make_vert_map<double>(graph);
  for (const auto v : verts(graph)) on_graph[v] = f[graph.base(v)];
  const auto x = smooth(graph, on_graph, 0.1, uniform, {.exponent = 2});
  for (const auto v : verts(graph)) CHECK(x[v] == doctest::Approx(w[graph.base(v)]).epsilon(1e-12).scale(1));
}

TEST_CASE_TEMPLATE("smooth: scaling the mesh by a power of two, and the amount with it, changes nothing", M, quadmesh, tetmesh) {
  auto arrays = jittered(grid_arrays<M>(2), 0.03, VolumeMesh<M>);
  const M m(arrays);
  const auto f = random_values(m);
  for (const int n : {1, 2})
    for (const int power : {20, -20}) {
      auto scaled = arrays;
      for (vec3& x : scaled.points) x *= std::ldexp(1.0, power);
      const M s(scaled);
      CHECK(largest_difference(smooth(s, f, std::ldexp(0.03, 2 * n * power), {.exponent = n}), smooth(m, f, 0.03, {.exponent = n})) == 0);
    }
}

TEST_CASE_TEMPLATE("smooth: isolated verts keep their values and are counted", M, quadmesh, hexmesh) {
  const M m = two_grids<M>(1);
  const vert_id alone{static_cast<unsigned>(num_verts(m) - 1)};
  auto f = make_vert_map<double>(m, 1.0);
  f[alone] = NAN;
  for (const int n : {1, 2}) {
    const auto s = prepare_smooth(m, 0.1, {.exponent = n});
    CHECK(s.num_isolated() == 1);
    CHECK(std::isnan(s.apply(f)[alone]));
    CHECK(s.apply(f)[vert_id{0}] == doctest::Approx(1));
  }
  CHECK_THROWS_AS(smooth(m, f, 0.1, {.fixed = {alone}}), invalid_argument);
  f[alone] = 3;
  CHECK(prepare_smooth(m, 0.1, {.fixed = {alone}}).num_isolated() == 0);
  CHECK(smooth(m, f, 0.1)[alone] == 3);
  const M none;
  CHECK(smooth(none, make_vert_map<double>(none), 1).values().empty());
}

TEST_CASE("smooth: throws on invalid arguments, and reports progress") {
  const auto m = grid<trimesh>(2);
  auto f = make_vert_map<double>(m, 1.0);
  CHECK_THROWS_WITH_AS(smooth(m, f, -1), "smooth: amount is -1; it must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_AS(smooth(m, f, INFINITY), invalid_argument);
  CHECK_THROWS_AS(smooth(m, f, NAN), invalid_argument);
  CHECK_THROWS_WITH_AS(smooth(m, f, 1, {.exponent = 0}), "smooth: exponent is 0; it must be 1 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(smooth(m, f, 1, {.fixed = {vert_id{9}}}), doctest::Contains("not a vert of the mesh"), invalid_mesh);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(smooth(flat, make_vert_map<double>(flat), 1), invalid_mesh);
  f[vert_id{4}] = INFINITY;
  CHECK_THROWS_WITH_AS(smooth(m, f, 1), "smooth: the value at vert 4 is not finite", invalid_argument);
  f[vert_id{4}] = 1;
  double last = 0;
  smooth(m, f, 1, {.progress = [&](double x, const char*) { return last = x, true; }});
  CHECK(last == 1);
  CHECK_THROWS_AS(smooth(m, f, 1, {.progress = [&](double x, const char*) { return x == 0; }}), cancelled);
  CHECK_THROWS_AS(prepare_smooth(m, 1, {.progress = [&](double, const char*) { return false; }}), cancelled);
}
