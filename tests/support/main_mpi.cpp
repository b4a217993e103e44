// The main of the test programs in which MPI and PETSc run, from its beginning to its end.
#define DOCTEST_CONFIG_IMPLEMENT
#include <concino/adapters/petsc_session.hpp>

#include <doctest/doctest.h>

int main(int argc, char** argv) {
  int no_arguments = 1;  // those of doctest are not PETSc's
  concino::petsc_session session(no_arguments, argv);
  return doctest::Context(argc, argv).run();
}
