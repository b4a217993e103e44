// Checks that any solver must pass: fields with a small and a large component, all verts prescribed or none, a vert without edges, and
// matrices that are singular, indefinite or contain NaN.
#pragma once

#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_geodesics.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/mesh/trimesh.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "support/meshes.hpp"
#include "support/systems.hpp"

namespace solver_paths {

using namespace concino;

/// A type-erased solver, so that problems are compiled once.
class any_solver {
  struct base {
    virtual ~base() = default;
    virtual void factorize(const systems::sparse& a) = 0;
    virtual Eigen::VectorXd solve(const Eigen::VectorXd& b) const = 0;
    virtual bool is_iterative() const = 0;
  };
  template<class Solver>
  struct of final : base {
    Solver solver;
    explicit of(const auto&... options) : solver(options...) {}
    void factorize(const systems::sparse& a) override { solver.factorize(a); }
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const override { return solver.solve(b); }
    bool is_iterative() const override { return core::is_iterative(solver); }
  };
  using maker = std::function<std::unique_ptr<base>()>;
  maker make_;
  std::unique_ptr<base> solver_;

 public:
  static constexpr bool reads_both_triangles = true;
  explicit any_solver(maker make) : make_(std::move(make)), solver_(make_()) {}
  template<class Solver>
  static any_solver make(const auto&... options) {
    return any_solver([options...] { return std::make_unique<of<Solver>>(options...); });
  }
  const maker& options() const { return make_; }
  void factorize(const systems::sparse& a) { solver_->factorize(a); }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return solver_->solve(b); }
  bool is_iterative() const { return solver_->is_iterative(); }
};

/// How a solver treats an indefinite matrix.
enum class indefinite { solved, refused, either };

/// A triangle, verts 0 to 2; a vert without edges, 3; a unit square of 12 x 12 pairs of triangles, verts 4 to 172.
inline trimesh two_components_and_a_vert() {
  surface_arrays a = testing::triangle_grid(12), r;
  r.arity = 3;
  r.points = {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {9, 9, 9}};
  r.verts = {vert_id{0}, vert_id{1}, vert_id{2}};
  for (const vec3& p : a.points) r.points.push_back(p);
  for (const vert_id v : a.verts) r.verts.push_back(vert_id{v.raw() + 4});
  return trimesh(r);
}

using values = std::vector<std::pair<vert_id, double>>;

/// f(point) at the verts around the square.
template<class F>
values around_square(const trimesh& m, F f) {
  values r;
  for (const vert_id v : verts(m)) {
    const vec3 p = point(m, v);
    if (p.x <= 1 && (p.x == 0 || p.x == 1 || p.y == 0 || p.y == 1)) r.emplace_back(v, f(p));
  }
  return r;
}

/// Checks problems on a mesh with known solutions.
inline void check_problems(any_solver& solver) {
  const trimesh m = two_components_and_a_vert();
  const auto linear = [](const vec3& p) { return 3 * p.x - p.y; };
  const auto square = [](const vec3& p) { return p.x * p.x / 2; };
  values given = around_square(m, linear), curved = around_square(m, square), all, one;
  for (const vert_id v : verts(m)) all.emplace_back(v, 0.5 * v.raw());
  auto load = make_vert_map<double>(m, -1.0), none = make_vert_map<double>(m, 0.0);
  for (unsigned i = 0; i < 3; ++i) load[vert_id{i}] = 0;

  // values only on the large component: the error names the small one; then the reverse; then no values at all
  const auto small = doctest::Contains("component of vert 0 (3 verts) has no prescribed value");
  const auto large = doctest::Contains("component of vert 4 (169 verts) has no prescribed value");
  CHECK_THROWS_WITH_AS(harmonic_map(m, given, {}, solver), small, solver_error);
  CHECK_THROWS_WITH_AS(poisson(m, load, {.values = curved}, solver), small, solver_error);
  CHECK_THROWS_WITH_AS(harmonic_map(m, values{{vert_id{1}, 1.0}}, {}, solver), large, solver_error);
  CHECK_THROWS_WITH_AS(poisson(m, load, {.values = {{vert_id{1}, 1.0}}}, solver), large, solver_error);
  CHECK_THROWS_AS(harmonic_map(m, values{}, {}, solver), solver_error);
  CHECK_THROWS_AS(poisson(m, load, {}, solver), solver_error);

  // values on both components, and on the vert without edges
  given.emplace_back(vert_id{2}, 5.0);
  curved.emplace_back(vert_id{2}, 5.0);
  const auto check = [&](const auto& u, const auto& expected, double isolated) {
    double worst = 0;
    for (const vert_id v : verts(m)) {
      if (v.raw() > 3) worst = std::max(worst, std::abs(u[v] - expected(point(m, v))));
      if (v.raw() < 3) worst = std::max(worst, std::abs(u[v] - 5));
    }
    CHECK(worst < 1e-9);
    CHECK(u[vert_id{3}] == isolated);
  };
  check(harmonic_map(m, given, {.isolated_value = -7}, solver), linear, -7);
  check(poisson(m, load, {.values = curved, .isolated_value = -8}, solver), square, -8);
  given.emplace_back(vert_id{3}, 4.5);
  check(harmonic_map(m, given, {}, solver), linear, 4.5);

  // all verts prescribed: nothing to solve
  const auto u = harmonic_map(m, all, {}, solver), w = poisson(m, none, {.values = all}, solver);
  for (const auto& [v, x] : all) CHECK((u[v] == x && w[v] == x));
}

inline void check_distances(any_solver& solver) {
  const trimesh m = two_components_and_a_vert();
  const auto d = heat_geodesics(m, vert_id{4}, {.clamp = true}, solver);
  double worst = 0;
  for (const vert_id v : verts(m)) {
    if (v.raw() < 4) CHECK(d[v] == std::numeric_limits<double>::infinity());
    else worst = std::max(worst, std::abs(d[v] - distance(point(m, v), point(m, vert_id{4}))));
  }
  CHECK(worst < 0.1);
}

/// Checks that a matrix that cannot be solved causes an error in factorize or in solve, and that the solver is usable afterwards.
inline void check_matrices(any_solver& solver, indefinite what) {
  using namespace systems;
  const auto solve = [&](const sparse& a, const Eigen::VectorXd& b) {
    solver.factorize(a);
    return Eigen::VectorXd(solver.solve(b));
  };
  for (const int n : {2, 14}) {
    CHECK_THROWS_AS(solve(grid(n, 0), random_vector(n * n)), solver_error);
    sparse gap = grid(n);  // row 2 is 0
    gap.prune([](Eigen::Index row, Eigen::Index column, double) { return row != 2 && column != 2; });
    CHECK_THROWS_WITH_AS(solve(gap, Eigen::VectorXd::Ones(n * n)), doctest::Contains(" 2"), solver_error);
    for (const double bad : {std::nan(""), HUGE_VAL}) {
      sparse a = grid(n);
      a.coeffRef(2, 0) = bad;
      a.coeffRef(n * n - 1, 2) = bad;
      CHECK_THROWS_WITH_AS(solver.factorize(a), doctest::Contains("not finite, in row "), solver_error);
      Eigen::VectorXd b = random_vector(n * n);
      b[3] = bad;
      CHECK_THROWS_WITH_AS(solve(grid(n), b), doctest::Contains("entry 3 of the right-hand side is not finite"), solver_error);
    }
    const sparse a = grid(n, -0.3);
    const Eigen::VectorXd x = random_vector(n * n), b = a * x;
    bool solved = false;
    try {
      const Eigen::VectorXd y = solve(a, b);
      solved = true;
      CHECK(distance(a * y, b) < 1e-5);  // if it does not throw, the solution is right
    } catch (const solver_error&) {
    }
    if (what != indefinite::either) CHECK(solved == (what == indefinite::solved));
    CHECK(distance(solve(grid(n), grid(n) * x), x) < 1e-9);
  }
}

inline void check_all(any_solver solver, indefinite what) {
  check_problems(solver);
  check_matrices(solver, what);
  check_problems(solver);  // again, after errors
  check_distances(solver);
}

}  // namespace solver_paths
