// The linear system that solvers are measured with.
#pragma once

#include <concino/operators/laplacian.hpp>

#include <Eigen/SparseCore>

namespace bench {

/// The lower triangle of minus the Laplacian, with one vert constrained.
template<class M, class... Discretisation>
Eigen::SparseMatrix<double> laplace_system(const M& m, const Discretisation&... discretisation) {
  Eigen::SparseMatrix<double> a = -concino::laplacian(m, discretisation...);
  a.coeffRef(0, 0) *= 2;
  return a.triangularView<Eigen::Lower>();
}

}  // namespace bench
