// Assembles a stiffness matrix from the local matrices of polys in the simplest way, for tests of local matrices.
#pragma once

#include <concino/geometry/measure.hpp>
#include <concino/operators/discretisation.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::testing {

/// The stiffness matrix: the sum over all polys, with vert_index_bound(m) rows and columns.
template<class Element, class M>
Eigen::MatrixXd stiffness(const M& m) {
  const auto n = static_cast<Eigen::Index>(vert_index_bound(m));
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  Element element(m);
  local_matrix<vert_t<M>> local;
  for (const auto p : polys(m)) {
    element(p, local);
    for (std::size_t i = 0; i < local.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const auto a = static_cast<Eigen::Index>(index_of(m, local.verts[i])), b = static_cast<Eigen::Index>(index_of(m, local.verts[j]));
        sum(a, b) += local.at(i, j);
        if (a != b) sum(b, a) += local.at(i, j);
      }
  }
  return sum;
}

/// The verts strictly inside the unit square or cube, in a mesh whose points were moved by less than 0.05.
template<class M>
std::vector<vert_t<M>> verts_in_unit_box(const M& m) {
  std::vector<vert_t<M>> r;
  for (const auto v : verts(m)) {
    const vec3 x = to_vec3(point(m, v));
    bool inside = true;
    for (std::size_t k = 0; k < static_cast<std::size_t>(dimension_v<M>); ++k) inside = inside && x[k] > 0.05 && x[k] < 0.95;
    if (inside) r.push_back(v);
  }
  return r;
}

/// The largest entry of K x at interior verts, where x are the coordinates.
template<class M>
double residual_of_coordinates(const M& m, const Eigen::MatrixXd& k) {
  Eigen::MatrixXd x = Eigen::MatrixXd::Zero(k.rows(), dimension_v<M>);
  for (const auto v : verts(m))
    for (int c = 0; c < dimension_v<M>; ++c) x(static_cast<Eigen::Index>(index_of(m, v)), c) = to_vec3(point(m, v))[static_cast<std::size_t>(c)];
  const Eigen::MatrixXd kx = k * x;
  double largest = 0;
  for (const auto v : verts_in_unit_box(m)) largest = std::max(largest, kx.row(static_cast<Eigen::Index>(index_of(m, v))).cwiseAbs().maxCoeff());
  return largest;
}

/// The eigenvalues in ascending order.
inline std::vector<double> spectrum(const Eigen::MatrixXd& k) {
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly).eigenvalues();
  return {values.data(), values.data() + values.size()};
}

}  // namespace concino::testing
