// A harmonic map by CHOLMOD's supernodal factorisation, beside that factorisation alone. How fast that is depends on the BLAS it runs on.
#include "../support/harmonic.hpp"

#include <concino/adapters/cholmod.hpp>

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    bench::compare_harmonic<concino::cholmod>(p, ".cholmod", [](const Eigen::SparseMatrix<double>& a) {
      auto factors = std::make_unique<Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>>>();
      factors->compute(a);
      return factors;
    });
  });
}
