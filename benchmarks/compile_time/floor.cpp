// Factorises a matrix with Eigen's sparse Cholesky and does nothing else: the floor of the compile time.
#include <Eigen/SparseCholesky>

int main() {
  Eigen::SparseMatrix<double> a(2, 2);
  a.insert(0, 0) = 2;
  a.insert(1, 0) = 1;
  a.insert(1, 1) = 2;
  a.makeCompressed();
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factors(a);
  const Eigen::VectorXd x = factors.solve(Eigen::VectorXd::Ones(2));
  return x.size() == 2 && x[0] > 0 ? 0 : 1;
}
