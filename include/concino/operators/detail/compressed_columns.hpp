// Sparse matrices filled directly in compressed columns: entries are counted, the counts are summed to offsets, then
// each entry is written to its position.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace concino::detail {

inline constexpr std::size_t largest_sparse_index = static_cast<std::size_t>(std::numeric_limits<int>::max());

[[noreturn, gnu::noinline, gnu::cold]] inline void throw_too_large(const char* caller, const char* what) {
  core::throw_joined<unsupported>(
      {caller, ": the matrix would have more ", what, " than its 32-bit indices can count; split the mesh"});
}

/// A matrix with empty columns. The caller then counts the entries of column c in outerIndexPtr()[c + 1].
/// Errors: unsupported if the number of rows or columns exceeds the index type.
inline Eigen::SparseMatrix<double> empty_columns(const char* caller, std::size_t rows, std::size_t columns) {
  if (rows >= largest_sparse_index) throw_too_large(caller, "rows");
  if (columns >= largest_sparse_index) throw_too_large(caller, "columns");
  return {static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns)};
}

/// Allocates `each` entries per counted entry. Afterwards column c begins at outerIndexPtr()[c].
/// Errors: unsupported if the number of entries exceeds the index type.
inline void make_room(const char* caller, Eigen::SparseMatrix<double>& a, int each = 1) {
  int* const begin = a.outerIndexPtr();
  std::int64_t sum = 0;
  for (Eigen::Index c = 0; c < a.cols(); ++c) {
    sum += std::int64_t{each} * begin[c + 1];
    if (sum > std::numeric_limits<int>::max()) throw_too_large(caller, "entries");
    begin[c + 1] = static_cast<int>(sum);
  }
  a.resizeNonZeros(sum);
}

}  // namespace concino::detail
