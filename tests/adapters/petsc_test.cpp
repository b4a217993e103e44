#include <concino/adapters/petsc.hpp>

#include <concino/fields/harmonic_map.hpp>
#include <concino/fields/heat_flow.hpp>
#include <concino/fields/heat_geodesics.hpp>
#include <concino/fields/poisson.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/kinds.hpp>
#include <support/meshes.hpp>
#include <support/solver_paths.hpp>
#include <support/systems.hpp>

#include <cmath>
#include <cstddef>
#include <string>
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
