// Matrices over verts put together poly by poly, straight into compressed columns: no list of triplets, each poly computed once.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/product.hpp>
#include <concino/operators/detail/poly_operator.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace concino::detail {

/// Which entries of the lower triangle there are: the pairs of verts of one poly, and the diagonal of every vert.
template<AnyMesh M>
Eigen::SparseMatrix<double> lower_pattern(const M& m) {
  const auto size = vert_index_bound(m);
  if (size >= static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw unsupported("assembly: the matrix would have more rows than its 32-bit indices can count");
  std::vector<int> rows, seen_in(size, -1);
  rows.reserve(4 * size);
  std::vector<std::size_t> begin(size, 0), end(size, 0);
  for (const vert_t<M> v : verts(m)) {
    const auto i = index_of(m, v);
    const int c = static_cast<int>(i);
    begin[i] = rows.size();
    rows.push_back(c);
    for (const poly_t<M> p : adj_v2p(m, v))
      for (const vert_t<M> w : adj_p2v(m, p)) {
        const int r = static_cast<int>(index_of(m, w));
        if (r <= c || seen_in[static_cast<std::size_t>(r)] == c) continue;
        seen_in[static_cast<std::size_t>(r)] = c;
        rows.push_back(r);
      }
    std::sort(rows.begin() + static_cast<std::ptrdiff_t>(begin[i]), rows.end());
    end[i] = rows.size();
  }
  if (rows.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    throw unsupported("assembly: the matrix would have more entries than its 32-bit indices can count");
  Eigen::SparseMatrix<double> a(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  a.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
  int at = 0;
  for (std::size_t i = 0; i < size; ++i) {  // verts may come in any order
    std::copy(rows.begin() + static_cast<std::ptrdiff_t>(begin[i]), rows.begin() + static_cast<std::ptrdiff_t>(end[i]), a.innerIndexPtr() + at);
    at += static_cast<int>(end[i] - begin[i]);
    a.outerIndexPtr()[i + 1] = at;
  }
  std::fill_n(a.valuePtr(), at, 0.0);
  return a;
}

/// Adds a poly's matrix to those columns.
template<class M>
void add_local(const M& m, const local_matrix<vert_t<M>>& local, std::vector<int>& index, Eigen::SparseMatrix<double>& a) {
  const std::size_t n = local.size();
  index.resize(n);
  for (std::size_t i = 0; i < n; ++i) index[i] = static_cast<int>(index_of(m, local.verts[i]));
  const int *const begin = a.outerIndexPtr(), *const rows = a.innerIndexPtr();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const int row = std::max(index[i], index[j]), column = std::min(index[i], index[j]);
      const int* const at = std::lower_bound(rows + begin[column], rows + begin[column + 1], row);
      a.valuePtr()[at - rows] += local.at(i, j);
    }
}

/// The sum of the local matrices of all polys, lower triangle. They are computed in parallel and added in the order of polys(m), so the
/// bits do not depend on the number of threads.
/// Errors: unsupported where 32-bit indices do not suffice; those of the element, for the first poly that has one.
template<AnyMesh M>
Eigen::SparseMatrix<double> assemble_elements(const M& m, make_poly_operator<M> make_element) {
  constexpr std::size_t blocks = 16, block = 64;
  Eigen::SparseMatrix<double> a = lower_pattern(m);
  std::unique_ptr<poly_operator<M>> element[blocks];
  for (auto& e : element) e = make_element();
  std::vector<local_matrix<vert_t<M>>> local(blocks * block);
  std::vector<poly_t<M>> batch;
  batch.reserve(blocks * block);
  std::vector<int> index;
  const auto add_batch = [&] {
    parallel_for(
        (batch.size() + block - 1) / block,
        [&](std::size_t b) {
          for (std::size_t i = b * block; i < std::min(batch.size(), (b + 1) * block); ++i) (*element[b])(batch[i], local[i]);
        },
        1);
    for (std::size_t i = 0; i < batch.size(); ++i) add_local(m, local[i], index, a);
    batch.clear();
  };
  for (const poly_t<M> p : polys(m)) {
    batch.push_back(p);
    if (batch.size() == blocks * block) add_batch();
  }
  add_batch();
  return a;
}

/// The same with both triangles, and on the diagonal minus the sum of what stands beside it: constants are in the kernel as well as rounding allows.
template<AnyMesh M>
Eigen::SparseMatrix<double> assemble_stiffness(const M& m, make_poly_operator<M> make_element, double sign) {
  Eigen::SparseMatrix<double> a = with_both_triangles(assemble_elements(m, make_element));
  for (int c = 0; c < a.cols(); ++c) {
    double sum = 0;
    int diagonal = -1;
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k) {
      if (a.innerIndexPtr()[k] == c) diagonal = k;
      else sum += a.valuePtr()[k] *= sign;
    }
    if (diagonal >= 0) a.valuePtr()[diagonal] = 0 - sum;
  }
  return a;
}

}  // namespace concino::detail
