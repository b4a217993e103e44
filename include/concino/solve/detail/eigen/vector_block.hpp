// Many vectors side by side, and what block methods for eigenpairs do with them. The entries of one row are next to
// each other, so that a sparse matrix is read once for eight vectors, and a basis is replaced by combinations of its
// vectors in place.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/solve/detail/multigrid/multigrid_cycle.hpp>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// The number of vectors for which a sparse matrix is read once.
inline constexpr int panel_width = 8;

inline Eigen::Index num_panels(Eigen::Index columns) { return (columns + panel_width - 1) / panel_width; }

/// Columns from..from + columns of a block with `stride` numbers per row. Panels are whole: columns up to a multiple of
/// eight after the first may be read and written too.
struct column_range {
  double* data;
  Eigen::Index stride, columns;

  double* row(Eigen::Index i) const { return data + i * stride; }
};

/// Rows of vectors. Sums over rows are added up in the same order for any number of threads.
class vector_block {
  Eigen::Index rows_ = 0, stride_ = 0;
  std::vector<double> x_;

 public:
  using row_major = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using view = Eigen::Map<row_major, 0, Eigen::OuterStride<>>;

  vector_block() = default;
  vector_block(Eigen::Index rows, Eigen::Index columns)
      : rows_(rows), stride_(num_panels(columns) * panel_width + panel_width),
        x_(static_cast<std::size_t>(rows_ * stride_)) {}

  Eigen::Index rows() const { return rows_; }
  column_range columns(Eigen::Index from, Eigen::Index number) { return {x_.data() + from, stride_, number}; }
};

inline vector_block::view rows_between(const column_range& x, Eigen::Index first, Eigen::Index last) {
  return {x.row(first), last - first, x.columns, Eigen::OuterStride<>(x.stride)};
}

/// The rows in at most 64 parts, which do not depend on the number of threads.
struct row_blocks {
  Eigen::Index rows, size;

  explicit row_blocks(Eigen::Index n) : rows(n), size(std::max<Eigen::Index>(1024, (n + 63) / 64)) {}
  std::size_t number() const { return static_cast<std::size_t>((rows + size - 1) / size); }

  /// Calls f(part, first row, end of rows).
  template<class F>
  void for_each(const F& f) const {
    parallel_for(number(), [&](std::size_t k) {
      const auto first = static_cast<Eigen::Index>(k) * size;
      f(k, first, std::min(rows, first + size));
    }, 1);
  }

  /// The sum over all parts of f(part, first row, end of rows), a matrix of this size.
  template<class F>
  Eigen::MatrixXd sum(Eigen::Index height, Eigen::Index width, const F& f) const {
    std::vector<Eigen::MatrixXd> parts(number());
    for_each([&](std::size_t k, Eigen::Index first, Eigen::Index last) { parts[k] = f(first, last); });
    Eigen::MatrixXd r = Eigen::MatrixXd::Zero(height, width);
    for (const Eigen::MatrixXd& p : parts) r += p;
    return r;
  }
};

/// x^T y, of n rows.
inline Eigen::MatrixXd gram_matrix(Eigen::Index n, const column_range& x, const column_range& y) {
  return row_blocks(n).sum(x.columns, y.columns, [&](Eigen::Index first, Eigen::Index last) -> Eigen::MatrixXd {
    return rows_between(x, first, last).transpose() * rows_between(y, first, last);
  });
}

/// Replaces the first columns of x by x c. If there are vectors v, by x c - v d.
inline void combine(Eigen::Index n, const column_range& x, const Eigen::MatrixXd& c,
                    const column_range& v = {nullptr, 0, 0}, const Eigen::MatrixXd& d = {}) {
  row_blocks(n).for_each([&](std::size_t, Eigen::Index first, Eigen::Index last) {
    constexpr Eigen::Index at_once = 256;
    vector_block::row_major sum(at_once, c.cols());
    for (Eigen::Index i = first; i < last; i += at_once) {
      const Eigen::Index end = std::min(last, i + at_once);
      auto part = sum.topRows(end - i);
      part.noalias() = rows_between(x, i, end) * c;
      if (v.columns > 0) part.noalias() -= rows_between(v, i, end) * d;
      rows_between({x.data, x.stride, c.cols()}, i, end) = part;
    }
  });
}

/// y = A x for eight vectors.
inline void multiply_panel(const lower_entries& m, const column_range& x, const column_range& y) {
  constexpr int width = panel_width;
  for (int c = 0; c < m.n; ++c) {
    double* const at = y.row(c);
    for (int l = 0; l < width; ++l) at[l] = 0;
  }
  for (int c = 0; c < m.n; ++c) {
    double xc[width], sum[width];
    const double diagonal = m.a[m.starts[c]], *const xr = x.row(c);
    for (int l = 0; l < width; ++l) xc[l] = xr[l];
    for (int l = 0; l < width; ++l) sum[l] = diagonal * xc[l];
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      double* const to = y.row(m.rows[k]);
      const double* const from = x.row(m.rows[k]);
      for (int l = 0; l < width; ++l) to[l] += a * xc[l];
      for (int l = 0; l < width; ++l) sum[l] += a * from[l];
    }
    double* const at = y.row(c);
    for (int l = 0; l < width; ++l) at[l] += sum[l];
  }
}

/// y = A x. A: a lower triangle; each column is sorted and begins with its diagonal entry.
inline void multiply_columns(const Eigen::SparseMatrix<double>& a, const column_range& x, const column_range& y) {
  const lower_entries m(a);
  if (a.nonZeros() == a.cols()) {
    row_blocks(a.cols()).for_each([&](std::size_t, Eigen::Index first, Eigen::Index last) {
      for (Eigen::Index i = first; i < last; ++i)
        for (Eigen::Index j = 0; j < x.columns; ++j) y.row(i)[j] = m.a[i] * x.row(i)[j];
    });
    return;
  }
  parallel_for(static_cast<std::size_t>(num_panels(x.columns)), [&](std::size_t panel) {
    const auto at = static_cast<Eigen::Index>(panel) * panel_width;
    multiply_panel(m, {x.data + at, x.stride, panel_width}, {y.data + at, y.stride, panel_width});
  }, 1);
}

}  // namespace concino::detail
