// Every solver passes the checks of special problems.
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/bicgstab.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/llt.hpp>
#include <concino/solve/lu.hpp>
#include <concino/solve/qr.hpp>

#include <support/solver_paths.hpp>

using namespace solver_paths;

TEST_CASE("solver paths: ldlt") { check_all(any_solver::make<ldlt>(), indefinite::solved); }
TEST_CASE("solver paths: llt") { check_all(any_solver::make<llt>(), indefinite::refused); }
TEST_CASE("solver paths: lu") { check_all(any_solver::make<lu>(), indefinite::solved); }
TEST_CASE("solver paths: qr") { check_all(any_solver::make<qr>(), indefinite::solved); }
TEST_CASE("solver paths: conjugate_gradients") { check_all(any_solver::make<conjugate_gradients>(), indefinite::either); }
TEST_CASE("solver paths: bicgstab") { check_all(any_solver::make<bicgstab>(), indefinite::either); }
TEST_CASE("solver paths: auto_solver by factorisation") { check_all(any_solver::make<auto_solver>(), indefinite::solved); }
TEST_CASE("solver paths: auto_solver by iteration") {  // a triangle is still factorised
  check_all(any_solver::make<auto_solver>(auto_solver_options{.max_factor_entries = 10}), indefinite::either);
}
