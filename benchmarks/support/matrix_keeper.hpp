// A solver that stores the matrices that it is asked to factorise, so that their factorisations can be timed alone.
#pragma once

#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCore>

#include <vector>

namespace bench {

struct matrix_keeper {
  std::vector<Eigen::SparseMatrix<double>>* kept;
  concino::ldlt inner;

  explicit matrix_keeper(std::vector<Eigen::SparseMatrix<double>>* where) : kept(where) {}
  matrix_keeper(const matrix_keeper& k) : kept(k.kept) {}
  void factorize(const Eigen::SparseMatrix<double>& a) {
    kept->push_back(a);
    inner.factorize(a);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return inner.solve(b); }
};

}  // namespace bench
