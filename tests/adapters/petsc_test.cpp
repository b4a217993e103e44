#include <concino/adapters/petsc.hpp>

#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/heat_geodesics.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/kinds.hpp>
#include <support/meshes.hpp>
#include <support/solver_paths.hpp>
#include <support/systems.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

using namespace concino;
using namespace systems;

namespace {

/// An option of PETSc's database, while it exists.
class database_option {
  std::string name_;

 public:
  database_option(const char* name, const char* value) : name_(name) { PetscOptionsSetValue(nullptr, name, value); }
  database_option(const database_option&) = delete;
  database_option& operator=(const database_option&) = delete;
  ~database_option() { PetscOptionsClearValue(nullptr, name_.c_str()); }
};

const petsc_options both[] = {{.preconditioner = petsc_preconditioner::gamg}, {.preconditioner = petsc_preconditioner::boomeramg}};

}  // namespace

TEST_CASE("petsc: fulfils the laws of solvers with each preconditioner") {
  for (const petsc_preconditioner p : {petsc_preconditioner::gamg, petsc_preconditioner::boomeramg, petsc_preconditioner::mumps})
    for (const petsc_system s : {petsc_system::symmetric_definite, petsc_system::general}) {
      CAPTURE(static_cast<int>(p));
      CAPTURE(static_cast<int>(s));
      petsc solver({.system = s, .preconditioner = p});
      check_solver(solver, 30, 0x1p-10);
      check_scaling(solver);
    }
}

TEST_CASE("petsc: handles small, singular and indefinite systems, and isolated verts") {
  for (const petsc_options& options : both) solver_paths::check_all(solver_paths::any_solver::make<petsc>(options), solver_paths::indefinite::either);
  solver_paths::check_all(solver_paths::any_solver::make<petsc>(petsc_options{.preconditioner = petsc_preconditioner::mumps}), solver_paths::indefinite::either);
  solver_paths::any_solver general = solver_paths::any_solver::make<petsc>(petsc_options{.system = petsc_system::general, .preconditioner = petsc_preconditioner::mumps});
  solver_paths::check_matrices(general, solver_paths::indefinite::solved);
}

TEST_CASE_TEMPLATE("petsc: problems on all kinds of mesh equal those of ldlt", M, CONCINO_ALL_KINDS) {
  const M m = concino::testing::grid<M>(4);
  std::vector<std::pair<vert_id, double>> values;
  auto load = make_vert_map<double>(m, 1.0);
  for (const vert_id v : verts(m)) {
    const vec3 p = point(m, v);
    if (p.x == 0 || p.x == 1) values.emplace_back(v, p.x + p.y * p.y);
    load[v] = p.y;
  }
  const auto source = std::vector<std::pair<vert_id, double>>{{vert_id{0}, 0.0}};
  for (const petsc_options& options : both) {
    const auto check = [&](const auto& u, const auto& expected, double accuracy) {
      double worst = 0;
      for (const vert_id v : verts(m)) worst = std::max(worst, std::abs(u[v] - expected[v]));
      CHECK(worst < accuracy);
    };
    check(harmonic_map(m, values, {}, petsc(options)), harmonic_map(m, values, {}, ldlt()), 1e-10);
    check(poisson(m, load, {.values = {{vert_id{0}, 0.5}}}, petsc(options)), poisson(m, load, {.values = {{vert_id{0}, 0.5}}}, ldlt()), 1e-10);
    check(heat_flow(m, load, 0.01, {}, petsc(options)), heat_flow(m, load, 0.01, {}, ldlt()), 1e-10);
    check(heat_geodesics(m, source, {}, petsc(options)), heat_geodesics(m, source, {}, conjugate_gradients()), 1e-8);  // as of any iteration
    const auto prepared = prepare_harmonic_map(m, std::vector<vert_id>{vert_id{0}, vert_id{1}}, {}, petsc(options));
    check(prepared.with_values(std::vector<std::pair<vert_id, double>>{{vert_id{0}, 1.0}, {vert_id{1}, 2.0}}),
          harmonic_map(m, std::vector<std::pair<vert_id, double>>{{vert_id{0}, 1.0}, {vert_id{1}, 2.0}}, {}, ldlt()), 1e-10);
  }
  const auto d = heat_geodesics(m, source, {}, petsc({.preconditioner = petsc_preconditioner::mumps})), expected = heat_geodesics(m, source, {}, ldlt());
  for (const vert_id v : verts(m)) CHECK(std::abs(d[v] - expected[v]) < 1e-9);
}

TEST_CASE("petsc: the iterations hardly depend on the number of unknowns, and the residual is measured") {
  for (const auto& [p, most] : {std::pair{petsc_preconditioner::gamg, 25}, std::pair{petsc_preconditioner::boomeramg, 12}}) {
    petsc solver({.preconditioner = p, .tolerance = 1e-10});
    int before = 0;
    for (const int n : {30, 90}) {
      const sparse a = grid(n, 0.01);
      const Eigen::VectorXd b = random_vector(n * n);
      solver.factorize(a);
      const Eigen::VectorXd x = solver.solve(b);
      CHECK(solver.residual() <= 1e-10);
      CHECK(std::abs(solver.residual() - (b - a * x).norm() / b.norm()) < 1e-15);
      CHECK(solver.iterations() <= most);
      if (before > 0) CHECK(solver.iterations() <= 1.5 * before);
      before = solver.iterations();
    }
  }
  petsc exact({.preconditioner = petsc_preconditioner::mumps});
  exact.factorize(grid(30, 0.01));
  exact.solve(random_vector(900));
  CHECK(exact.iterations() <= 2);
}

TEST_CASE("petsc: a missed tolerance is an error, or by option a flag") {
  petsc few({.max_iterations = 2}), flagged({.max_iterations = 2, .accept_missed_tolerance = true});
  const sparse a = grid(30, 0.001);
  const Eigen::VectorXd b = random_vector(900);
  few.factorize(a);
  flagged.factorize(a);
  CHECK_THROWS_WITH_AS(few.solve(b), doctest::Contains("petsc: not converged after 2 iterations: the residual is "), solver_error);
  CHECK_THROWS_WITH_AS(few.solve(b), doctest::Contains("allow more iterations or a larger tolerance"), solver_error);
  const Eigen::VectorXd x = flagged.solve(b);
  CHECK_FALSE(flagged.has_converged());
  CHECK(flagged.iterations() == 2);
  CHECK(std::abs(flagged.residual() - (b - a * x).norm() / b.norm()) < 1e-15);
}

TEST_CASE("petsc: matrices that do not suit the system are errors with the reason") {
  petsc solver, general({.system = petsc_system::general});
  CHECK_THROWS_WITH_AS(solver.factorize(grid(4).triangularView<Eigen::Lower>()), doctest::Contains("not symmetric: row and column 0 differ"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(grid(4, 0.5, 0.1)), doctest::Contains("set system to petsc_system::general"), solver_error);
  CHECK_THROWS_WITH_AS(solver.factorize(from(3, 3, {{0, 0, 1.0}, {1, 1, -2.0}, {2, 2, 1.0}})),
                       "petsc: the matrix is not positive definite: the diagonal entry of row 1 is -2", solver_error);
  CHECK_THROWS_WITH_AS(general.factorize(from(3, 3, {{0, 0, 1.0}, {1, 0, 0.0}, {2, 2, 1.0}})), "petsc: the matrix is singular: row 1 is 0", solver_error);
  std::string said;
  try {
    solver.factorize(from(2, 2, {{0, 0, 1.0}, {0, 1, 2.0}, {1, 0, 2.0}, {1, 1, 1.0}}));  // indefinite, with a positive diagonal
    const Eigen::VectorXd x = solver.solve(Eigen::Vector2d(1, -1));
    CHECK(distance(x, Eigen::Vector2d(-1, 1)) < 1e-12);
  } catch (const solver_error& e) {
    said = e.what();
    CHECK(said.find("definite") != std::string::npos);
  }
}

TEST_CASE("petsc: solves unsymmetric systems") {
  for (const petsc_preconditioner p : {petsc_preconditioner::gamg, petsc_preconditioner::boomeramg, petsc_preconditioner::mumps}) {
    petsc solver({.system = petsc_system::general, .preconditioner = p});
    const sparse a = grid(20, 0.2, 0.4);
    solver.factorize(a);
    const Eigen::VectorXd x = random_vector(400);
    CHECK(distance(solver.solve(a * x), x) < 1e-9);
    CHECK(solver.residual() <= 1e-12);
  }
}

TEST_CASE("petsc: own defaults of multigrid yield to the database, and leave it as it was") {
  const sparse a = grid(30, 0.01);
  const Eigen::VectorXd b = random_vector(900);
  const auto iterations = [&](petsc_preconditioner p) {
    petsc solver({.prefix = "own_", .preconditioner = p});
    solver.factorize(a);
    solver.solve(b);
    return solver.iterations();
  };
  for (const auto& [preconditioner, option, value] :
       {std::tuple{petsc_preconditioner::gamg, "-own_pc_gamg_aggressive_coarsening", "1"}, std::tuple{petsc_preconditioner::boomeramg, "-own_pc_hypre_boomeramg_P_max", "1"}}) {
    const int by_default = iterations(preconditioner);
    PetscBool is_given = PETSC_TRUE;
    REQUIRE(PetscOptionsHasName(nullptr, nullptr, option, &is_given) == 0);
    CHECK_FALSE(is_given);
    REQUIRE(PetscOptionsSetValue(nullptr, option, value) == 0);
    CHECK(iterations(preconditioner) > by_default);
    REQUIRE(PetscOptionsHasName(nullptr, nullptr, option, &is_given) == 0);
    CHECK(is_given);
    REQUIRE(PetscOptionsClearValue(nullptr, option) == 0);
  }
}

TEST_CASE("petsc: options of the database override those of the solver, by prefix") {
  const sparse a = grid(30, 0.01);
  const Eigen::VectorXd b = random_vector(900);
  const auto iterations = [&](const petsc_options& options) {
    petsc solver(options);
    solver.factorize(a);
    solver.solve(b);
    return solver.iterations();
  };
  const int by_gamg = iterations({}), by_hypre = iterations({.preconditioner = petsc_preconditioner::boomeramg});
  CHECK(by_hypre < by_gamg);
  {
    const database_option type("-poisson_pc_type", "hypre");
    CHECK(iterations({.prefix = "poisson_"}) == by_hypre);
    CHECK(iterations({}) == by_gamg);
    CHECK(iterations({.prefix = "other_"}) == by_gamg);
  }
  const database_option tolerance("-poisson_ksp_rtol", "1e-3");
  petsc loose({.prefix = "poisson_"});
  loose.factorize(a);
  loose.solve(b);
  CHECK(loose.residual() <= 1e-3);
  CHECK(loose.residual() > 1e-8);
}

TEST_CASE("petsc: misspelt and unused options of the database are errors, or listed") {
  const database_option misspelt("-poisson_ksp_rtoll", "1e-3"), of_another("-other_pc_typ", "lu");
  petsc strict({.prefix = "poisson_"}), tolerant({.prefix = "poisson_", .accept_unused_options = true}), without;
  CHECK_THROWS_WITH_AS(strict.factorize(grid(5)), doctest::Contains("the option -poisson_ksp_rtoll is misspelt"), invalid_argument);
  CHECK_THROWS_WITH_AS(strict.solve(random_vector(25)), doctest::Contains("solve without a factorised matrix"), solver_error);
  tolerant.factorize(grid(5));
  CHECK(tolerant.unused_options() == std::vector<std::string>{"poisson_ksp_rtoll"});
  without.factorize(grid(5));
  const database_option bad_value("-third_pc_type", "no_such_preconditioner"), plain("-pc_gamg_thresold", "0.1");
  petsc third({.prefix = "third_"});
  CHECK_THROWS_WITH_AS(third.factorize(grid(5)), doctest::Contains("petsc: setting its options failed: "), solver_error);
  CHECK_THROWS_WITH_AS(without.factorize(grid(5)), doctest::Contains("-pc_gamg_thresold is misspelt"), invalid_argument);
}

TEST_CASE("petsc: options out of range are errors") {
  for (const double tolerance : {0.0, 1.0, -1.0, std::nan("")})
    CHECK_THROWS_WITH_AS(petsc({.tolerance = tolerance}), doctest::Contains("it must be in (0, 1)"), invalid_argument);
  CHECK_THROWS_WITH_AS(petsc({.max_iterations = -1}), "petsc: max_iterations is negative", invalid_argument);
  CHECK_THROWS_WITH_AS(petsc({.prefix = "poisson"}), doctest::Contains("must begin without - and end in _"), invalid_argument);
  CHECK_THROWS_AS(petsc({.prefix = "-poisson_"}), invalid_argument);
}

TEST_CASE("petsc: takes vectors of the near-null space") {
  const int n = 24;
  const sparse a = grid(n, 1e-6);
  const Eigen::VectorXd b = random_vector(n * n), ones = Eigen::VectorXd::Ones(n * n);
  Eigen::VectorXd slope(n * n);
  for (int i = 0; i < n * n; ++i) slope[i] = i % n;
  petsc plain, constants({.near_null_space = {ones}}), linear({.near_null_space = {ones, slope}});
  for (petsc* solver : {&plain, &constants, &linear}) {
    solver->factorize(a);
    CHECK(distance(solver->solve(a * b), b) < 1e-5);  // condition 1e7
  }
  CHECK(constants.iterations() <= plain.iterations() + 1);
  petsc dependent({.near_null_space = {ones, 3 * ones}}), zero({.near_null_space = {0 * ones}}), longer({.near_null_space = {Eigen::VectorXd::Ones(3)}});
  CHECK_THROWS_WITH_AS(dependent.factorize(a), doctest::Contains("vector 1 of near_null_space is not finite, 0, or depends"), invalid_argument);
  CHECK_THROWS_WITH_AS(zero.factorize(a), doctest::Contains("vector 0 of near_null_space"), invalid_argument);
  CHECK_THROWS_WITH_AS(longer.factorize(a), "petsc: a vector of near_null_space has 3 entries, the matrix 576 rows", invalid_argument);
}
