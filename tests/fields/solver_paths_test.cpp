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

TEST_CASE("ldlt: passes the checks of special problems") { check_all(any_solver::make<ldlt>(), indefinite::solved); }
TEST_CASE("llt: passes the checks of special problems") { check_all(any_solver::make<llt>(), indefinite::refused); }
TEST_CASE("lu: passes the checks of special problems") { check_all(any_solver::make<lu>(), indefinite::solved); }
TEST_CASE("qr: passes the checks of special problems") { check_all(any_solver::make<qr>(), indefinite::solved); }
TEST_CASE("conjugate_gradients: passes the checks of special problems") { check_all(any_solver::make<conjugate_gradients>(), indefinite::either); }
TEST_CASE("bicgstab: passes the checks of special problems") { check_all(any_solver::make<bicgstab>(), indefinite::either); }
TEST_CASE("auto_solver: by factorisation passes the checks of special problems") { check_all(any_solver::make<auto_solver>(), indefinite::solved); }
TEST_CASE("auto_solver: by iteration passes the checks of special problems") {  // a triangle is still factorised
  check_all(any_solver::make<auto_solver>(auto_solver_options{.max_factor_entries = 10}), indefinite::either);
}
