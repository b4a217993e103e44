// The steps of a cycle of multigrid on one level: smoothing, residuals, and transfer to and from the next level. A template argument says for how many
// right-hand sides at once; the entries of a row are then next to each other. All are computed as if they were alone, but the matrix is read only once.
#pragma once

#include <concino/solve/detail/aggregates.hpp>

#include <Eigen/SparseCore>

#include <cstddef>

namespace concino::detail {

/// A symmetric matrix as its lower triangle; columns are sorted, so each begins with its diagonal entry.
struct lower_entries {
  int n;
  const int *starts, *rows;
  const double* a;

  explicit lower_entries(const Eigen::SparseMatrix<double>& m)
      : n(static_cast<int>(m.cols())), starts(m.outerIndexPtr()), rows(m.innerIndexPtr()), a(m.valuePtr()) {}
};

/// The entries of one row of W vectors.
template<int W>
inline double* row_of(double* x, int i) { return x + static_cast<std::ptrdiff_t>(i) * W; }
template<int W>
inline const double* row_of(const double* x, int i) { return x + static_cast<std::ptrdiff_t>(i) * W; }

/// Gauss-Seidel from 0, first to last row.
template<int W>
void smooth_first(const lower_entries& m, const double* b, double* x) {
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(m.n) * W; ++i) x[i] = b[i];
  for (int c = 0; c < m.n; ++c) {
    const double diagonal = m.a[m.starts[c]];
    double xc[W], *const at = row_of<W>(x, c);
    for (int l = 0; l < W; ++l) xc[l] = at[l] /= diagonal;
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      double* const to = row_of<W>(x, m.rows[k]);
      for (int l = 0; l < W; ++l) to[l] -= a * xc[l];
    }
  }
}

/// Gauss-Seidel from x, last to first row.
template<int W>
void smooth_last(const lower_entries& m, const double* b, double* x) {
  for (int c = m.n - 1; c >= 0; --c) {  // x = b - L x; entries below c are done
    double xc[W], *const at = row_of<W>(x, c);
    for (int l = 0; l < W; ++l) {
      xc[l] = at[l];
      at[l] = row_of<W>(b, c)[l];
    }
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      double* const to = row_of<W>(x, m.rows[k]);
      for (int l = 0; l < W; ++l) to[l] -= a * xc[l];
    }
  }
  for (int c = m.n - 1; c >= 0; --c) {
    double xc[W], *const at = row_of<W>(x, c);
    for (int l = 0; l < W; ++l) xc[l] = at[l];
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      const double* const from = row_of<W>(x, m.rows[k]);
      for (int l = 0; l < W; ++l) xc[l] -= a * from[l];
    }
    const double diagonal = m.a[m.starts[c]];
    for (int l = 0; l < W; ++l) at[l] = xc[l] / diagonal;
  }
}

/// Restricts the residual after smooth_first, which is -L^T x.
template<int W>
void restrict_residual(const lower_entries& m, const prolongation& p, const double* x, double* coarse) {
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(p.columns) * W; ++i) coarse[i] = 0;
  for (int c = 0; c < m.n; ++c) {
    double r[W] = {};
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      const double* const from = row_of<W>(x, m.rows[k]);
      for (int l = 0; l < W; ++l) r[l] -= a * from[l];
    }
    for (auto k = static_cast<std::size_t>(p.begin[static_cast<std::size_t>(c)]); k < static_cast<std::size_t>(p.begin[static_cast<std::size_t>(c) + 1]); ++k) {
      double* const to = row_of<W>(coarse, p.column[k]);
      const auto weight = static_cast<double>(p.weight[k]);
      for (int l = 0; l < W; ++l) to[l] += weight * r[l];
    }
  }
}

template<int W>
void add_interpolated(const prolongation& p, const double* coarse, double* x, int n) {
  for (int i = 0; i < n; ++i) {
    double sum[W] = {}, *const to = row_of<W>(x, i);
    for (auto k = static_cast<std::size_t>(p.begin[static_cast<std::size_t>(i)]); k < static_cast<std::size_t>(p.begin[static_cast<std::size_t>(i) + 1]); ++k) {
      const double* const from = row_of<W>(coarse, p.column[k]);
      const auto weight = static_cast<double>(p.weight[k]);
      for (int l = 0; l < W; ++l) sum[l] += weight * from[l];
    }
    for (int l = 0; l < W; ++l) to[l] += sum[l];
  }
}

/// r = b - A x.
template<int W>
void subtract_product(const lower_entries& m, const double* x, const double* b, double* r) {
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(m.n) * W; ++i) r[i] = b[i];
  for (int c = 0; c < m.n; ++c) {
    double xc[W], sum[W], *const at = row_of<W>(r, c);
    const double diagonal = m.a[m.starts[c]];
    for (int l = 0; l < W; ++l) xc[l] = row_of<W>(x, c)[l];
    for (int l = 0; l < W; ++l) sum[l] = diagonal * xc[l];
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      double* const to = row_of<W>(r, m.rows[k]);
      const double* const from = row_of<W>(x, m.rows[k]);
      for (int l = 0; l < W; ++l) to[l] -= a * xc[l];
      for (int l = 0; l < W; ++l) sum[l] += a * from[l];
    }
    for (int l = 0; l < W; ++l) at[l] -= sum[l];
  }
}

}  // namespace concino::detail
