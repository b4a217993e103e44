// Harmonic maps and Poisson's equation prepared once and solved many times.
#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/fields/smooth.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using values = std::map<vert_id, double>;

struct constant {
  double value;
  template<class V>
  double operator[](const V&) const { return value; }
};

/// A solver that counts the factorisations of all of its copies.
struct counting : ldlt {
  int* factorised;
  explicit counting(int& n) : factorised(&n) {}
  const counting& options() const { return *this; }
  counting(const counting& other) : ldlt(), factorised(other.factorised) {}
  void factorize(const Eigen::SparseMatrix<double>& a) {
    ++*factorised;
    ldlt::factorize(a);
  }
};

template<class U, class W>
bool same_bits(const U& u, const W& w) {
  for (const auto v : verts(u.mesh()))
    if (!(u[v] == w[v])) return false;
  return true;
}

template<class M> concept preparable = requires { prepare_harmonic_map(std::declval<M>(), {vert_id{0}}); };

}  // namespace

TEST_CASE_TEMPLATE("prepare_harmonic_map: equals harmonic_map to the bit, with one factorisation", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)}, c{3};
  int factorised = 0;
  for (const int n : {1, 2}) {
    const harmonic_map_options options{.exponent = n};
    factorised = 0;
    const auto h = prepare_harmonic_map(m, {a, b, c, a}, options, counting(factorised));
    const auto copy = h;
    CHECK(&h.mesh() == &m);
    CHECK(h.num_isolated() == 0);
    for (const double x : {-3.0, 0.25, 7.0}) {
      const values given{{a, 0}, {b, x}, {c, 1}};
      CHECK(same_bits(copy.with_values({{a, 0.0}, {b, x}, {c, 1.0}}), harmonic_map(m, given, options)));
    }
    const values by_map{{a, 1}, {b, 2}, {c, 3}};
    CHECK(same_bits(h.with_values(by_map), harmonic_map(m, by_map, options)));
    const std::vector<std::pair<vert_id, vec3>> to_space{{a, {0, 1, 2}}, {b, {5, 4, 3}}, {c, {1, 1, 1}}};
    CHECK(same_bits(h.template with_values<vec3>(to_space), harmonic_map<vec3>(m, to_space, options)));
    CHECK(factorised == 1);
  }
  const std::vector<vert_id> all{a, b, c};
  CHECK(same_bits(prepare_harmonic_map(m, all).with_values({{a, 1}, {b, 2}, {c, 3}}), harmonic_map(m, {{a, 1}, {b, 2}, {c, 3}})));
  static_assert(preparable<const M&> && !preparable<M>);
}

TEST_CASE_TEMPLATE("prepare_poisson: equals poisson, with one factorisation", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(2), 0.05, VolumeMesh<M>));
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) - 1)};
  facet_t<M> outer{};
  if constexpr (SurfaceMesh<M>) {
    for (const auto e : edges(m)) {
      int n = 0;
      for ([[maybe_unused]] const auto p : adj_e2p(m, e)) ++n;
      if (n == 1) outer = e;
    }
  } else {
    for (const auto e : faces(m)) {
      int n = 0;
      for ([[maybe_unused]] const auto p : adj_f2p(m, e)) ++n;
      if (n == 1) outer = e;
    }
  }
  int factorised = 0;
  const auto p = prepare_poisson(m, {a, b}, {}, counting(factorised));
  CHECK(same_bits(p.solve(constant{1}, {.values = {{a, 0.0}, {b, 1.0}}}), poisson(m, constant{1}, {.values = {{a, 0.0}, {b, 1.0}}})));
  CHECK(same_bits(p.solve(constant{-2}, {.values = {{a, 5}, {b, 1}}}), poisson(m, constant{-2}, {.values = {{a, 5}, {b, 1}}})));
  CHECK(same_bits(p.solve(constant{1}, {.values = {{a, 0}, {b, 1}}, .fluxes = {{outer, 3}}}), poisson(m, constant{1}, {.values = {{a, 0}, {b, 1}}, .fluxes = {{outer, 3}}})));
  const auto f = make_vert_map<vec3>(m, vec3{1, 2, 3});
  CHECK(same_bits(p.solve(f, {.values = {{a, {0, 0, 0}}, {b, {1, 2, 3}}}}), poisson(m, f, {.values = {{a, {0, 0, 0}}, {b, {1, 2, 3}}}})));
  CHECK(factorised == 1);
  CHECK(&p.mesh() == &m);
}

TEST_CASE_TEMPLATE("prepared problems: isolated verts are counted", M, polygonmesh, tetmesh) {
  const M m = two_grids<M>(1);
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) / 2)}, alone{static_cast<unsigned>(num_verts(m) - 1)};
  const auto h = prepare_harmonic_map(m, {a, b}, {.isolated_value = -3});
  CHECK(h.num_isolated() == 1);
  CHECK(h.with_values({{a, 0}, {b, 1}})[alone] == -3);
  CHECK(h.template with_values<vec3>({{a, {0, 0, 0}}, {b, {1, 1, 1}}})[alone] == vec3{-3, -3, -3});
  const auto all = prepare_harmonic_map(m, {a, b, alone});
  CHECK(all.num_isolated() == 0);
  CHECK(all.with_values({{a, 0}, {b, 1}, {alone, 7}})[alone] == 7);
  const auto p = prepare_poisson(m, {a, b});
  CHECK(p.num_isolated() == 1);
  CHECK(std::isnan(p.solve(constant{1}, {.values = {{a, 0}, {b, 1}}, .isolated_value = NAN})[alone]));
}

TEST_CASE_TEMPLATE("prepared problems: run on archetypes", M, trimesh, polyhedralmesh) {
  const M m = grid<M>(2);
  const vert_id a{0}, b{3};
  const auto graph = only_primal_graph(m);
  const auto u = prepare_harmonic_map(m, {a, b}, uniform).with_values({{a, 0.0}, {b, 1.0}});
  const auto h = prepare_harmonic_map(graph, {graph.vert(a), graph.vert(b)}, uniform).with_values({{graph.vert(a), 0.0}, {graph.vert(b), 1.0}});
  for (const auto v : verts(graph)) CHECK(h[v] == doctest::Approx(u[graph.base(v)]).epsilon(1e-12));
  const auto weak = only_embedded_mesh(m);
  const auto w = poisson(m, constant{1}, {.values = {{a, 0.0}}});
  const auto p = prepare_poisson(weak, {weak.vert(a)}).solve(constant{1}, {.values = {{weak.vert(a), 0.0}}});
  for (const auto v : verts(weak)) CHECK(p[v] == doctest::Approx(w[weak.base(v)]).epsilon(1e-12));
}

TEST_CASE("prepared problems: work without unknowns and on empty meshes") {
  const trimesh none;
  const auto h = prepare_harmonic_map(none, {});
  CHECK(h.with_values(values{}).values().empty());
  CHECK(prepare_poisson(none, {}).solve(constant{1}).values().empty());
  const auto m = grid<trimesh>(1);
  const std::vector<vert_id> all(verts(m).begin(), verts(m).end());
  int factorised = 0;
  const auto p = prepare_poisson(m, all, {}, counting(factorised));
  CHECK(p.solve(constant{1}, {.values = {{all[0], 0}, {all[1], 1}, {all[2], 2}, {all[3], 3}}})[all[2]] == 2);
  CHECK(factorised == 0);
}

TEST_CASE("prepared problems: report progress") {
  const auto m = grid<quadmesh>(2);
  double first = -1, last = -1;
  const auto told = [&](double fraction, const char*) {
    CHECK((fraction >= 0 && fraction <= 1));
    if (first < 0) first = fraction;
    last = fraction;
    return true;
  };
  prepare_harmonic_map(m, {vert_id{0}}, {.progress = told});
  CHECK(first == 0);
  CHECK(last == 1);
  first = last = -1;
  prepare_poisson(m, {vert_id{0}}, {.progress = told});
  CHECK(first == 0);
  CHECK(last == 1);
}

TEST_CASE("prepared problems: throw if an argument is invalid") {
  const auto m = grid<quadmesh>(2);
  const vert_id a{0}, b{8}, c{4}, none{9};
  const auto h = prepare_harmonic_map(m, {a, b});
  CHECK_THROWS_WITH_AS(h.with_values({{a, 0.0}}), doctest::Contains("harmonic_map: no value is given at vert 8, which was named when the"),
                       invalid_argument);
  CHECK_THROWS_WITH_AS(h.with_values({{a, 0.0}, {b, 1.0}, {c, 2.0}}),
                       doctest::Contains("harmonic_map: a value is given at vert 4, which is not among those that were named"), invalid_argument);
  CHECK_THROWS_AS(h.with_values({{a, 0.0}, {b, 1.0}, {none, 2.0}}), invalid_mesh);
  CHECK_THROWS_WITH_AS(h.with_values({{a, 0.0}, {a, 0.0}, {a, 0.0}}), doctest::Contains("no value is given at vert 8"), invalid_argument);
  CHECK_THROWS_WITH_AS(h.with_values<vec3>({{a, {0, 0, 0}}}), doctest::Contains("no value is given at vert 8"), invalid_argument);
  CHECK_THROWS_AS(h.with_values({{a, 0.0}, {b, NAN}}), invalid_argument);
  CHECK_THROWS_AS(h.with_values({{a, 0.0}, {b, 1.0}, {b, 2.0}}), invalid_argument);
  CHECK(h.with_values({{a, 1.0}, {b, 1.0}, {b, 1.0}})[c] == doctest::Approx(1));  // it works after the errors
  CHECK_THROWS_WITH_AS(prepare_harmonic_map(m, {none}),
                       "harmonic_map: a value is to be prescribed at something that is not a vert of the mesh; take verts from verts(m)", invalid_mesh);
  CHECK_THROWS_AS(prepare_harmonic_map(m, {a}, {.exponent = 0}), invalid_argument);
  CHECK_THROWS_AS(prepare_harmonic_map(m, {}), solver_error);
  CHECK_THROWS_AS(prepare_poisson(m, {}), solver_error);
  CHECK_THROWS_AS(prepare_poisson(m, {none}), invalid_mesh);
  const auto p = prepare_poisson(m, {a});
  CHECK_THROWS_WITH_AS(p.solve(constant{INFINITY}, {.values = {{a, 0.0}}}), "poisson: the load f at vert 0 is not finite", invalid_argument);
  CHECK_THROWS_AS(p.solve(constant{1}, {.values = {{b, 0.0}}}), invalid_argument);
  CHECK_THROWS_AS(prepare_harmonic_map(m, {a}, {.progress = [](double, const char*) { return false; }}), cancelled);
  CHECK_THROWS_AS(prepare_poisson(m, {a}, {.progress = [](double x, const char*) { return x == 0; }}), cancelled);
}

TEST_CASE_TEMPLATE("prepared problems: fields may be functions of points", M, polygonmesh, tetmesh) {
  const M m(jittered(grid_arrays<M>(2), 0.02, VolumeMesh<M>));
  const vert_id a{0};
  const auto number = [](const vec3& x) { return std::sin(x.x) + x.y; };
  const auto vector = [](const vec3& x) { return vec3{x.y, 1, x.x * x.z}; };
  auto numbers = make_vert_map<double>(m);
  auto vectors = make_vert_map<vec3>(m);
  for (const auto v : verts(m)) {
    numbers[v] = number(point(m, v));
    vectors[v] = vector(point(m, v));
  }
  const auto same = [&](const auto& u, const auto& w) {
    for (const auto v : verts(m)) CHECK(u[v] == w[v]);
  };
  same(poisson(m, number, {.values = {{a, 0.0}}}), poisson(m, numbers, {.values = {{a, 0.0}}}));
  same(poisson(m, vector, {.values = {{a, vec3()}}}), poisson(m, vectors, {.values = {{a, vec3()}}}));
  same(poisson(m, number, virtual_elements, {.values = {{a, 0.0}}}), poisson(m, numbers, {.values = {{a, 0.0}}}));
  const auto p = prepare_poisson(m, {a});
  same(p.solve(number, {.values = {{a, 1.0}}}), p.solve(numbers, {.values = {{a, 1.0}}}));
  same(heat_flow(m, number, 0.1), heat_flow(m, numbers, 0.1));
  same(prepare_heat_flow(m, 0.1).advance(vector), prepare_heat_flow(m, 0.1).advance(vectors));
  same(smooth(m, number, 0.1), smooth(m, numbers, 0.1));
  same(smooth(m, vector, 0.1, uniform), smooth(m, vectors, 0.1, uniform));
  same(prepare_smooth(m, 0.1).apply(number), prepare_smooth(m, 0.1).apply(numbers));
  const auto no_number = [](const vec3&) { return std::nan(""); };
  CHECK_THROWS_WITH_AS(poisson(m, no_number, {.values = {{a, 0.0}}}), doctest::Contains("the load f at vert 0 is not finite"), invalid_argument);
  const auto nothing = [](const vec3&) {};
  const auto of_vert = [](vert_id) { return 1.0; };
  static_assert(requirement::is_given_field<decltype(number), M> && !requirement::is_given_field<decltype(nothing), M> && !requirement::is_given_field<decltype(of_vert), M>);
}
