// A harmonic map by CHOLMOD's supernodal factorisation, beside that factorisation alone. How fast that is depends on the BLAS it runs on.
#include "../support/harmonic.hpp"

#include <Eigen/CholmodSupport>

namespace {

using sparse = Eigen::SparseMatrix<double>;

class supernodal {
  Eigen::CholmodSupernodalLLT<sparse> factors_;

 public:
  void factorize(const sparse& a) {
    factors_.compute(a);
    if (factors_.info() != Eigen::Success) throw concino::solver_error("cholmod: the matrix is not positive definite");
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return factors_.solve(b); }
};

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    bench::compare_harmonic<supernodal>(p, ".cholmod", [](const sparse& a) {
      auto factors = std::make_unique<Eigen::CholmodSupernodalLLT<sparse>>();
      factors->compute(a);
      return factors;
    });
  });
}
