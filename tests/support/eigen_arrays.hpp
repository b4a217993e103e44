// Constructs Eigen matrices and vectors from numbers.
#pragma once

#include <support/input_arrays.hpp>

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <vector>

namespace concino::testing {

template<class Matrix>
Matrix rows(const std::vector<double>& values, int width) {
  Matrix m(static_cast<Eigen::Index>(values.size()) / width, width);
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (int k = 0; k < width; ++k) m(i, k) = static_cast<typename Matrix::Scalar>(values[static_cast<std::size_t>(i * width + k)]);
  return m;
}
template<class V, class Arrays>
V points_of(const Arrays& a) { return rows<V>(coordinates<double>(a.points), 3); }
template<class F, class Arrays>
F polys_of(const Arrays& a, int arity) { return rows<F>(raws<double>(a.verts), arity); }
template<class I, int Options = Eigen::ColMajor>
auto vector_of(const std::vector<std::uint32_t>& x) {
  Eigen::Matrix<I, Options == Eigen::RowMajor ? 1 : Eigen::Dynamic, Options == Eigen::RowMajor ? Eigen::Dynamic : 1, Options> v(static_cast<Eigen::Index>(x.size()));
  for (std::size_t i = 0; i < x.size(); ++i) v(static_cast<Eigen::Index>(i)) = static_cast<I>(x[i]);
  return v;
}

/// A user's class derived from a matrix.
struct cloud : Eigen::MatrixXd {
  using Eigen::MatrixXd::MatrixXd;
  std::string name;
};

}  // namespace concino::testing
