// Measures a harmonic map by ldlt against Eigen's factorisation alone.
#include <concino/solve/ldlt.hpp>

#include "support/harmonic.hpp"

#include <Eigen/SparseCholesky>

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    bench::compare_harmonic<concino::ldlt>(p, "", [](const Eigen::SparseMatrix<double>& a) {
      return std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(a);
    });
  });
}
