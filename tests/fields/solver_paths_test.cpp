// Every solver handles small, singular and indefinite systems, and isolated verts.
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/bicgstab.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/llt.hpp>
#include <concino/solve/lu.hpp>
#include <concino/solve/multigrid.hpp>
#include <concino/solve/qr.hpp>

#include <support/solver_paths.hpp>

using namespace solver_paths;

TEST_CASE("ldlt: handles small, singular and indefinite systems, and isolated verts") { check_all(any_solver::make<ldlt>(), indefinite::solved); }
TEST_CASE("llt: handles small, singular and indefinite systems, and isolated verts") { check_all(any_solver::make<llt>(), indefinite::refused); }
TEST_CASE("lu: handles small, singular and indefinite systems, and isolated verts") { check_all(any_solver::make<lu>(), indefinite::solved); }
TEST_CASE("qr: handles small, singular and indefinite systems, and isolated verts") { check_all(any_solver::make<qr>(), indefinite::solved); }
TEST_CASE("conjugate_gradients: handles small, singular and indefinite systems, and isolated verts") { check_all(any_solver::make<conjugate_gradients>(), indefinite::either); }
TEST_CASE("bicgstab: handles small, singular and indefinite systems, and isolated verts") { check_all(any_solver::make<bicgstab>(), indefinite::either); }
TEST_CASE("multigrid: handles small, singular and indefinite systems, and isolated verts") { check_all(any_solver::make<multigrid>(), indefinite::either); }
TEST_CASE("auto_solver: by factorisation handles small, singular and indefinite systems, and isolated verts") { check_all(any_solver::make<auto_solver>(), indefinite::solved); }
TEST_CASE("auto_solver: by iteration handles small, singular and indefinite systems, and isolated verts") {  // a triangle is still factorised
  check_all(any_solver::make<auto_solver>(auto_solver_options{.max_factor_entries = 10}), indefinite::either);
}
