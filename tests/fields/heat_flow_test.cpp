#include <concino/fields/heat_flow.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/fields/harmonic_map.hpp>

#include <support/kinds.hpp>
#include <support/values_at_verts.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr double pi = 3.14159265358979323846;

template<class M>
vert_map<M, double> wave(const M& m) {
  auto u = make_vert_map<double>(m);
  for (const auto v : verts(m)) u[v] = std::cos(pi * point(m, v)[0]);
  return u;
}

template<class Map>
Eigen::VectorXd vector_of(const Map& u) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(u.values().size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = u.values()[static_cast<std::size_t>(i)];
  return x;
}

}  // namespace

TEST_CASE_TEMPLATE("heat_flow: preserves the total heat, and its square decreases", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const auto u = random_values(m);
  for (const auto scheme : {heat_scheme::second_order, heat_scheme::backward_euler})
    for (const bool lumped : {false, true}) {
      const Eigen::SparseMatrix<double> mass = mass_matrix(m, {.lumped = lumped});
      const Eigen::VectorXd before = vector_of(u), after = vector_of(heat_flow(m, u, 0.02, {.steps = 3, .scheme = scheme, .lumped = lumped}));
      const Eigen::VectorXd heat_before = mass * before, heat_after = mass * after;
      CHECK(heat_after.sum() == doctest::Approx(heat_before.sum()).epsilon(1e-12).scale(1));
      CHECK(after.dot(heat_after) < 0.9 * before.dot(heat_before));
    }
  const auto w = heat_flow(m, u, 0.5, uniform);
  CHECK(vector_of(w).sum() == doctest::Approx(vector_of(u).sum()).epsilon(1e-12).scale(1));
}

TEST_CASE_TEMPLATE("heat_flow: cos(pi x) decays as exp(-pi^2 t), with second order in the size of the polys", M, CONCINO_KINDS) {
  const auto error = [](unsigned n) {
    const M m = grid<M>(n);
    const auto u = wave(m), w = heat_flow(m, u, 0.1, {.steps = 20});
    double squares = 0;
    for (const auto v : verts(m)) squares += std::pow(w[v] - std::exp(-0.1 * pi * pi) * u[v], 2);
    return std::sqrt(squares / static_cast<double>(num_verts(m)));
  };
  const unsigned n = VolumeMesh<M> ? 3 : 6;
  const double coarse = error(n), fine = error(2 * n);
  CHECK(fine < 0.02);
  CHECK(std::log2(coarse / fine) > (TetMesh<M> ? 1.5 : 1.75));  // the order of tets approaches 2 more slowly
}

TEST_CASE_TEMPLATE("heat_flow: has the order in time of the scheme", M, trimesh, hexmesh) {
  const M m = grid<M>(VolumeMesh<M> ? 3 : 6);
  const auto u = wave(m);
  for (const auto& [scheme, order] : {std::pair(heat_scheme::second_order, 2.0), std::pair(heat_scheme::backward_euler, 1.0)}) {
    const auto after = [&, scheme = scheme](int steps) { return heat_flow(m, u, 0.2, {.steps = steps, .scheme = scheme}); };
    const auto exact = heat_flow(m, u, 0.2, {.steps = 400});
    const double coarse = largest_difference(after(10), exact), fine = largest_difference(after(20), exact);
    CHECK(std::log2(coarse / fine) == doctest::Approx(order).epsilon(0.08));
  }
}

TEST_CASE("heat_flow: backward Euler with lumped masses and positive weights obeys the maximum principle") {
  const auto m = grid<trimesh>(6);
  auto u = make_vert_map<double>(m, 0.0);
  u[vert_id{24}] = 1;
  double before = 1;
  for (int i = 0; i < 5; ++i) {
    u = heat_flow(m, u, 1e-4, {.steps = 2, .scheme = heat_scheme::backward_euler, .lumped = true});
    const auto [low, high] = std::minmax_element(u.values().begin(), u.values().end());
    CHECK(*low >= 0);
    CHECK(*high < before);
    before = *high;
  }
}

TEST_CASE_TEMPLATE("heat_flow: long steps converge to the mean of each component, or to the harmonic map", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.03, VolumeMesh<M>));
  const auto u = random_values(m);
  const Eigen::SparseMatrix<double> mass = mass_matrix(m, {.lumped = false});
  const Eigen::VectorXd heat = mass * vector_of(u);
  const double mean = heat.sum() / total_measure(m);
  const auto w = heat_flow(m, u, 1e4, {.steps = 2});
  for (const auto v : verts(m)) CHECK(w[v] == doctest::Approx(mean).epsilon(1e-5).scale(1));
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)};
  const auto h = harmonic_map(m, {{a, u[a]}, {b, u[b]}}), x = heat_flow(m, u, 1e4, {.fixed = {a, b}, .steps = 2});
  for (const auto v : verts(m)) CHECK(x[v] == doctest::Approx(h[v]).epsilon(1e-5).scale(1));
  CHECK(x[a] == u[a]);
  CHECK(x[b] == u[b]);
  CHECK(largest_difference(heat_flow(m, u, 0), u) < 1e-12);
}

TEST_CASE_TEMPLATE("prepare_heat_flow: equals heat_flow to the bit, in steps and by component", M, polygonmesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(2), 0.03, VolumeMesh<M>));
  const vert_id a{0};
  const auto u = random_values(m), w = wave(m);
  const auto flow = prepare_heat_flow(m, 0.1, {.fixed = {a}, .steps = 3});
  CHECK(flow.time() == 0.1);
  CHECK(&flow.mesh() == &m);
  CHECK(largest_difference(flow.advance(u), heat_flow(m, u, 0.1, {.fixed = {a}, .steps = 3})) == 0);
  const auto free = prepare_heat_flow(m, 0.1);
  CHECK(largest_difference(free.advance(w), heat_flow(m, w, 0.1)) == 0);
  CHECK(largest_difference(free.advance(free.advance(w)), heat_flow(m, w, 0.2, {.steps = 20})) < 1e-15);
  auto both = make_vert_map<vec3>(m);
  for (const auto v : verts(m)) both[v] = {u[v], w[v], 1};
  const auto x = free.advance(both);
  const auto first = free.advance(u), second = free.advance(w);
  for (const auto v : verts(m)) {
    CHECK(x[v].x == first[v]);
    CHECK(x[v].y == second[v]);
    CHECK(x[v].z == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("heat_flow: runs on archetypes", M, trimesh, polyhedralmesh) {
  const M m = grid<M>(2);
  const auto u = wave(m);
  const auto weak = only_embedded_mesh(m);
  auto on_weak = make_vert_map<double>(weak);
  for (const auto v : verts(weak)) on_weak[v] = u[weak.base(v)];
  const auto w = heat_flow(m, u, 0.1, {.fixed = {vert_id{0}}}), x = heat_flow(m, u, 0.1, uniform);
  const auto same = heat_flow(weak, on_weak, 0.1, {.fixed = {weak.vert(vert_id{0})}});
  for (const auto v : verts(weak)) CHECK(same[v] == doctest::Approx(w[weak.base(v)]).epsilon(1e-12).scale(1));
  const auto graph = only_primal_graph(m);
  auto on_graph = make_vert_map<double>(graph);
  for (const auto v : verts(graph)) on_graph[v] = u[graph.base(v)];
  const auto y = heat_flow(graph, on_graph, 0.1, uniform);
  for (const auto v : verts(graph)) CHECK(y[v] == doctest::Approx(x[graph.base(v)]).epsilon(1e-12).scale(1));
}

TEST_CASE_TEMPLATE("heat_flow: scaling the mesh by a power of two and time by its square changes nothing", M, trimesh, polyhedralmesh) {
  auto arrays = jittered(grid_arrays<M>(2), 0.03, VolumeMesh<M>);
  const M m(arrays);
  const auto u = random_values(m), w = heat_flow(m, u, 0.03);
  for (const int power : {20, -20}) {
    auto scaled = arrays;
    for (vec3& x : scaled.points) x *= std::ldexp(1.0, power);
    const M s(scaled);
    CHECK(largest_difference(heat_flow(s, u, std::ldexp(0.03, 2 * power)), w) == 0);
  }
}

TEST_CASE_TEMPLATE("heat_flow: isolated verts keep their values and are counted", M, quadmesh, hexmesh) {
  const M m = two_grids<M>(1);
  const vert_id alone{static_cast<unsigned>(num_verts(m) - 1)};
  auto u = make_vert_map<double>(m, 1.0);
  u[alone] = NAN;
  const auto check = [&](const auto& which) {
    const auto flow = prepare_heat_flow(m, 0.1, which);
    CHECK(flow.num_isolated() == 1);
    const auto x = flow.advance(u);
    CHECK(std::isnan(x[alone]));
    for (const auto v : verts(m)) CHECK((v == alone || std::abs(x[v] - 1) < 1e-12));
  };
  check(virtual_elements);
  check(uniform);
  u[alone] = -7;
  CHECK(heat_flow(m, u, 1)[alone] == -7);
  const M none;
  CHECK(heat_flow(none, make_vert_map<double>(none), 1).values().empty());
}

TEST_CASE("heat_flow: throws on invalid arguments, and reports progress") {
  const auto m = grid<trimesh>(2);
  auto u = make_vert_map<double>(m, 1.0);
  CHECK_THROWS_WITH_AS(heat_flow(m, u, -1), "heat_flow: time is -1; it must be finite and 0 or more", invalid_argument);
  CHECK_THROWS_AS(heat_flow(m, u, INFINITY), invalid_argument);
  CHECK_THROWS_AS(heat_flow(m, u, NAN), invalid_argument);
  CHECK_THROWS_WITH_AS(heat_flow(m, u, 1, {.steps = 0}), "heat_flow: steps is 0; it must be 1 or more", invalid_argument);
  CHECK_THROWS_WITH_AS(heat_flow(m, u, 1, {.fixed = {vert_id{9}}}), doctest::Contains("not a vert of the mesh"), invalid_mesh);
  const polygonmesh quads({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS(heat_flow(quads, make_vert_map<double>(quads), 1, cotangent), unsupported);
  const trimesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}});
  CHECK_THROWS_AS(heat_flow(flat, make_vert_map<double>(flat), 1), invalid_mesh);
  u[vert_id{4}] = NAN;
  CHECK_THROWS_WITH_AS(heat_flow(m, u, 1), "heat_flow: the value at vert 4 is not finite", invalid_argument);
  u[vert_id{4}] = 1;
  int calls = 0;
  double last = 0;
  heat_flow(m, u, 1, {.progress = [&](double x, const char*) { return last = x, ++calls > 0; }});
  CHECK(last == 1);
  CHECK(calls > 10);
  CHECK_THROWS_AS(heat_flow(m, u, 1, {.progress = [&](double, const char*) { return false; }}), cancelled);
  const auto flow = prepare_heat_flow(m, 1, {.progress = [](double, const char*) { return true; }});
  CHECK_THROWS_AS(flow.advance(u, [](double x, const char*) { return x < 0.5; }), cancelled);
  CHECK(flow.advance(u)[vert_id{0}] == doctest::Approx(1));
}
