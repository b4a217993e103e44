#include <concino/fields/poisson.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/fields/harmonic_map.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using values = std::vector<std::pair<vert_id, double>>;

template<class M>
std::size_t dimension_of() { return VolumeMesh<M> ? 3 : 2; }

template<class M>
bool on_boundary(const vec3& x) {
  for (std::size_t k = 0; k < dimension_of<M>(); ++k)
    if (x[k] < 1e-9 || x[k] > 1 - 1e-9) return true;
  return false;
}

/// A grid whose interior verts are moved.
template<class M>
M moved_grid(unsigned n, double amount) {
  auto a = grid_arrays<M>(n);
  const auto b = jittered(a, amount / n, VolumeMesh<M>);
  for (std::size_t i = 0; i < a.points.size(); ++i)
    if (!on_boundary<M>(a.points[i])) a.points[i] = b.points[i];
  return M(a);
}

template<class M, class F>
values on_boundary_of(const M& m, const F& f) {
  values given;
  for (const auto v : verts(m))
    if (on_boundary<M>(to_vec3(point(m, v)))) given.emplace_back(v, f(to_vec3(point(m, v))));
  return given;
}

constexpr double pi = 3.14159265358979323846;

/// The product of sin(pi x_k).
template<class M>
double wave(const vec3& x) {
  return std::sin(pi * x.x) * std::sin(pi * x.y) * (VolumeMesh<M> ? std::sin(pi * x.z) : 1);
}

/// The root of the sum of mass times the squared error.
template<class M>
double error_of_wave(const M& m) {
  auto f = make_vert_map<double>(m);
  for (const auto v : verts(m)) f[v] = static_cast<double>(dimension_of<M>()) * pi * pi * wave<M>(to_vec3(point(m, v)));
  const auto u = poisson(m, f, {.values = on_boundary_of(m, [](const vec3&) { return 0.0; })});
  const auto mass = vert_masses(m);
  double sum = 0;
  for (const auto v : verts(m)) {
    const double e = u[v] - wave<M>(to_vec3(point(m, v)));
    sum += mass[v] * e * e;
  }
  return std::sqrt(sum);
}

struct constant {
  double value;
  template<class V>
  double operator[](const V&) const { return value; }
};

}  // namespace

TEST_CASE_TEMPLATE("poisson: without a load equals the harmonic map; prescribed values are exact", M, CONCINO_KINDS) {
  const M m = moved_grid<M>(3, 0.1);
  const auto given = on_boundary_of(m, [](const vec3& x) { return 1 + x.x * x.y - 2 * x.z; });
  const auto u = poisson(m, constant{0}, {.values = given}), h = harmonic_map(m, given);
  for (const auto v : verts(m)) CHECK(u[v] == h[v]);
  for (const auto& [v, x] : given) CHECK(u[v] == x);
}

TEST_CASE_TEMPLATE("poisson: converges with second order, also on polys that are not boxes", M, CONCINO_KINDS) {
  const unsigned n = VolumeMesh<M> ? 4 : 6;
  const double coarse = error_of_wave(moved_grid<M>(n, 0.15)), fine = error_of_wave(moved_grid<M>(2 * n, 0.15));
  CHECK(std::log2(coarse / fine) > (TetMesh<M> ? 1.7 : 1.8));  // the order of tets approaches 2 more slowly
  CHECK(fine < (VolumeMesh<M> ? 0.04 : 0.02));
}

TEST_CASE_TEMPLATE("poisson: the total of a load of 1 is the measure of the mesh", M, CONCINO_KINDS) {
  const M m(jittered(grid_arrays<M>(3), 0.03, VolumeMesh<M>));
  const auto given = on_boundary_of(m, [](const vec3&) { return 0.0; });
  const auto u = poisson(m, constant{1}, {.values = {{vert_id{0}, 0.0}}});
  Eigen::VectorXd x(static_cast<Eigen::Index>(vert_index_bound(m)));
  for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = u[v];
  const Eigen::VectorXd load = laplacian(m) * x;
  CHECK(-(load.sum() - load[0]) == doctest::Approx(total_measure(m) - mass_matrix(m, {.lumped = false}).col(0).sum()).epsilon(1e-10));
}

TEST_CASE_TEMPLATE("poisson: the equation holds at every vert without prescribed value", M, CONCINO_KINDS) {
  const M m = moved_grid<M>(2, 0.1);
  const vert_id held{static_cast<unsigned>(num_verts(m) - 1)};
  auto f = make_vert_map<double>(m);
  Eigen::VectorXd load(static_cast<Eigen::Index>(vert_index_bound(m))), x(load.size());
  for (const auto v : verts(m)) load[static_cast<Eigen::Index>(index_of(m, v))] = f[v] = 1 + 0.5 * static_cast<double>(index_of(m, v));
  const auto u = poisson(m, f, {.values = {{held, 3.0}}});
  for (const auto v : verts(m)) x[static_cast<Eigen::Index>(index_of(m, v))] = u[v];
  Eigen::VectorXd rest = laplacian(m) * x;
  rest += mass_matrix(m, {.lumped = false}) * load;
  rest[static_cast<Eigen::Index>(held.raw())] = 0;
  CHECK(rest.cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("poisson: has_mass finds the verts with a non-zero mass") {
  Eigen::SparseMatrix<double> mass(4, 4);  // columns that are empty, with mass only, without mass, and whose first entry is 0
  mass.insert(1, 1) = 0.5;
  mass.insert(2, 2) = 0;
  mass.insert(1, 3) = 0;
  mass.insert(3, 3) = 0.25;
  mass.makeCompressed();
  for (std::size_t i = 0; i < 4; ++i) CHECK(concino::detail::has_mass(mass, i) == (i % 2 == 1));
}

TEST_CASE("poisson: reports progress") {
  const auto m = grid<quadmesh>(2);
  double first = -1, last = -1;
  const auto told = [&](double fraction, const char*) {
    CHECK((fraction >= 0 && fraction <= 1));
    if (first < 0) first = fraction;
    last = fraction;
    return true;
  };
  poisson(m, constant{1}, {.values = {{vert_id{0}, 0.0}}, .progress = told});
  CHECK(first == 0);
  CHECK(last == 1);
}

TEST_CASE_TEMPLATE("poisson: runs on any embedded mesh", M, CONCINO_KINDS) {
  const M m = moved_grid<M>(2, 0.1);
  const auto stripped = only_embedded_mesh(m);
  const auto u = poisson(m, constant{1}, {.values = {{vert_id{0}, 0.5}}});
  const auto same = poisson(stripped, constant{1}, {.values = {{stripped.vert(vert_id{0}), 0.5}}});
  for (const auto v : verts(stripped)) CHECK(same[v] == doctest::Approx(u[stripped.base(v)]).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("poisson: handles isolated verts and throws on missing or invalid values and loads", M, CONCINO_KINDS) {
  const M m = two_grids<M>(2);
  const vert_id a{0}, b{static_cast<unsigned>(num_verts(m) / 2)}, lonely{static_cast<unsigned>(num_verts(m) - 1)};
  auto f = make_vert_map<double>(m, 1.0);
  f[lonely] = NAN;  // the load of a vert without polys is not used
  CHECK(poisson(m, f, {.values = {{a, 0}, {b, 1}}, .isolated_value = -3})[lonely] == -3);
  CHECK(poisson(m, f, {.values = {{a, 0}, {b, 1}}})[lonely] == 0);
  CHECK_THROWS_WITH_AS(poisson(m, f, {.values = {{a, 0.0}}}), doctest::Contains("poisson: the system is singular, because the component of vert "), solver_error);
  f[a] = INFINITY;
  CHECK_THROWS_WITH_AS(poisson(m, f, {.values = {{a, 0}, {b, 1}}}), "poisson: the load f at vert 0 is not finite", invalid_argument);
  f[a] = 0;
  CHECK_THROWS_AS(poisson(m, f, {.values = {{a, NAN}, {b, 1}}}), invalid_argument);
  CHECK_THROWS_AS(poisson(m, f, {.values = {{vert_id{static_cast<unsigned>(num_verts(m))}, 0.0}}}), invalid_mesh);
  CHECK_THROWS_AS(poisson(m, f, {.values = {{a, 0}, {b, 1}}, .progress = [](double, const char*) { return false; }}), cancelled);
  M none;
  CHECK(poisson(none, constant{1}).values().empty());
}

TEST_CASE_TEMPLATE("poisson: the error names polys without a measure", M, CONCINO_KINDS) {
  auto arrays = grid_arrays<M>(1);
  for (vec3& x : arrays.points) x.y = x.z = 0;
  const M m(arrays);
  CHECK_THROWS_WITH_AS(poisson(m, constant{1}, {.values = {{vert_id{0}, 0.0}}}), doctest::Contains("poly 0"), invalid_mesh);
}
