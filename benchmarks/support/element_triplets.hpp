// The standard Laplacian as most programs assemble it: Eigen sums the matrices of the polys from one list of triplets.
#pragma once

#include <concino/operators/laplacian.hpp>

#include <vector>

namespace bench {

template<class M>
Eigen::SparseMatrix<double> standard_laplacian_by_triplets(const M& m) {
  concino::detail::virtual_stiffness<M> element(m);
  concino::local_matrix<concino::vert_t<M>> local;
  std::vector<Eigen::Triplet<double>> t;
  for (const auto p : concino::polys(m)) {
    element(p, local);
    for (std::size_t i = 0; i < local.size(); ++i)
      for (std::size_t j = 0; j < local.size(); ++j)
        t.emplace_back(static_cast<int>(concino::index_of(m, local.verts[i])), static_cast<int>(concino::index_of(m, local.verts[j])), -local.at(std::max(i, j), std::min(i, j)));
  }
  const auto n = static_cast<Eigen::Index>(concino::vert_index_bound(m));
  Eigen::SparseMatrix<double> a(n, n);
  a.setFromTriplets(t.begin(), t.end());
  return a;
}

}  // namespace bench
