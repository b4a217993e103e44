// Several processes solve together. Every test also passes on one.
#include <concino/adapters/petsc.hpp>

#include <concino/solve/ldlt.hpp>

#include <support/systems.hpp>

#include <cmath>
#include <cstddef>

using namespace concino;
using namespace systems;

namespace {

int number_of_processes() {
  int n = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &n);
  return n;
}

bool is_last_process() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank == number_of_processes() - 1;
}

}  // namespace

TEST_CASE("petsc: processes that solve together get the solution of one") {
  for (const petsc_preconditioner p : {petsc_preconditioner::gamg, petsc_preconditioner::boomeramg, petsc_preconditioner::mumps})
    for (const petsc_system s : {petsc_system::symmetric_definite, petsc_system::general}) {
      petsc solver({.system = s, .preconditioner = p, .communicator = MPI_COMM_WORLD});
      check_solver(solver, 20, 0x1p-10);  // matrices with fewer rows than processes, too
      ldlt alone;
      const sparse a = grid(40, 0.01);
      const Eigen::VectorXd b = random_vector(1600);
      solver.factorize(a);
      alone.factorize(a);
      const Eigen::VectorXd x = alone.solve(b);
      CHECK(distance(solver.solve(b), x) < 1e-10 * x.cwiseAbs().maxCoeff());
    }
}

TEST_CASE("petsc: a session knows the number of processes") {
  int argc = 0;
  char** argv = nullptr;
  CHECK(petsc_session(argc, argv).num_processes() == static_cast<std::size_t>(number_of_processes()));
}

TEST_CASE("petsc: what one process finds wrong is an error on all") {
  petsc solver({.communicator = MPI_COMM_WORLD});
  sparse a = grid(20);
  if (is_last_process()) a.coeffRef(7, 7) = std::nan("");
  CHECK_THROWS_WITH_AS(solver.factorize(a), doctest::Contains("not finite, in row 7, column 7"), solver_error);
  solver.factorize(grid(20));
  Eigen::VectorXd b = random_vector(400);
  if (is_last_process()) b[3] = HUGE_VAL;
  CHECK_THROWS_WITH_AS(solver.solve(b), doctest::Contains("entry 3 of the right-hand side is not finite"), solver_error);
  if (number_of_processes() > 1)
    CHECK_THROWS_WITH_AS(solver.factorize(grid(is_last_process() ? 20 : 10)), doctest::Contains("have different sizes"), solver_error);
  solver.factorize(grid(20));
  CHECK(distance(grid(20) * solver.solve(random_vector(400)), random_vector(400)) < 1e-9);
}
