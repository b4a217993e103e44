// Assembly of matrices over verts, poly by poly, directly in compressed columns: without triplets, and with each poly
// computed once.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/parallel.hpp>
#include <concino/operators/detail/poly_operator.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace concino::detail {

/// Builds the sparsity pattern of a lower triangle, column by column.
class pattern_builder {
  std::vector<int> rows_, seen_in_;
  std::vector<std::size_t> begin_, end_;
  int column_ = 0;

 public:
  /// Errors: unsupported if 32-bit indices cannot count the rows.
  explicit pattern_builder(std::size_t size);

  /// Begins column i with its diagonal. Each column at most once, in any order.
  void begin_column(std::size_t i);
  void add(std::size_t row) {
    const int r = static_cast<int>(row);
    if (r > column_ && seen_in_[row] != column_) add_new(r);
  }
  void end_column();

  /// Result: a matrix of zeros.      Errors: unsupported if 32-bit indices cannot count the entries.
  void finish(Eigen::SparseMatrix<double>& a) const;

 private:
  void add_new(int row);
};

/// The sparsity pattern of the lower triangle: the pairs of verts of one poly, and the diagonal of every vert.
template<AnyMesh M>
void make_lower_pattern(const M& m, Eigen::SparseMatrix<double>& a) {
  pattern_builder pattern(vert_index_bound(m));
  for (const vert_t<M> v : verts(m)) {
    pattern.begin_column(index_of(m, v));
    for (const poly_t<M> p : adj_v2p(m, v))
      for (const vert_t<M> w : adj_p2v(m, p)) pattern.add(index_of(m, w));
    pattern.end_column();
  }
  pattern.finish(a);
}

/// Adds a poly's matrix, the lower triangle row by row, to the columns of its verts, which have these indices.
void add_local(const std::vector<int>& index, const double* entries, Eigen::SparseMatrix<double>& a);

template<class M>
void add_local(const M& m, const local_matrix<vert_t<M>>& local, std::vector<int>& index,
               Eigen::SparseMatrix<double>& a) {
  index.resize(local.size());
  for (std::size_t i = 0; i < index.size(); ++i) index[i] = static_cast<int>(index_of(m, local.verts[i]));
  add_local(index, local.entries.data(), a);
}

/// The lower triangle of the sum of the local matrices of all polys. They are computed in parallel and added in the
/// order of polys(m), so the bits do not depend on the number of threads.
/// Errors: unsupported if 32-bit indices do not suffice; those of the element, for the first poly that has one.
template<AnyMesh M>
Eigen::SparseMatrix<double> assemble_elements(const M& m, make_poly_operator<M> make_element) {
  constexpr std::size_t blocks = 16, block = 64;
  Eigen::SparseMatrix<double> a;
  make_lower_pattern(m, a);
  std::unique_ptr<poly_operator<M>> element[blocks];
  for (auto& e : element) e = make_element();
  std::vector<local_matrix<vert_t<M>>> local(blocks * block);
  std::vector<poly_t<M>> batch;
  batch.reserve(blocks * block);
  std::vector<int> index;
  const auto add_batch = [&] {
    parallel_for((batch.size() + block - 1) / block,
                 [&](std::size_t b) {
                   for (std::size_t i = b * block; i < std::min(batch.size(), (b + 1) * block); ++i)
                     (*element[b])(batch[i], local[i]);
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

/// Both triangles of `sign` times the matrix with this lower triangle. Each diagonal entry becomes minus the sum of the
/// other entries of its column, so constants are in the kernel as well as rounding allows.
Eigen::SparseMatrix<double> with_constants_in_kernel(const Eigen::SparseMatrix<double>& lower, double sign);

template<AnyMesh M>
Eigen::SparseMatrix<double> assemble_stiffness(const M& m, make_poly_operator<M> make_element, double sign) {
  return with_constants_in_kernel(assemble_elements(m, make_element), sign);
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/operators/detail/element_assembly.ipp>
#endif
