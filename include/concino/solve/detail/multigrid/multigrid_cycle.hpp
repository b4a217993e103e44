// The steps of a cycle of multigrid on one level: smoothing, residuals, and transfer to and from the next level. A
// template argument says for how many right-hand sides at once; the entries of a row are then next to each other. The
// results are those of one right-hand side after another, but the matrix is read only once.
#pragma once

#include <concino/solve/detail/multigrid/aggregates.hpp>

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

/// Gauss-Seidel from 0, last to first row. inverse: of the diagonal. r: the residual afterwards.
template<int W>
void pre_smooth(const lower_entries& m, const double* inverse, const double* b, double* x, double* r) {
  for (int c = m.n - 1; c >= 0; --c) {  // x_c = (b - L^T x)_c / d_c for the x known so far; r = -L x
    double xc[W], *const at = row_of<W>(x, c), *const residual = row_of<W>(r, c);
    for (int l = 0; l < W; ++l) xc[l] = row_of<W>(b, c)[l];
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      const double* const from = row_of<W>(x, m.rows[k]);
      for (int l = 0; l < W; ++l) xc[l] -= a * from[l];
    }
    for (int l = 0; l < W; ++l) {
      at[l] = xc[l] *= inverse[c];
      residual[l] = 0;
    }
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      double* const to = row_of<W>(r, m.rows[k]);
      for (int l = 0; l < W; ++l) to[l] -= a * xc[l];
    }
  }
}

/// Gauss-Seidel from x, first to last row. Afterwards A x = y + L^T x.
template<int W>
void post_smooth(const lower_entries& m, const double* inverse, const double* b, double* x, double* y) {
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(m.n) * W; ++i) y[i] = 0;
  for (int c = 0; c < m.n; ++c) {  // y is L x from row c, and b - L^T x, with the x before, above it
    double sum[W], xc[W], *const at = row_of<W>(x, c), *const lower_product = row_of<W>(y, c);
    for (int l = 0; l < W; ++l) sum[l] = row_of<W>(b, c)[l];
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      const double* const from = row_of<W>(x, m.rows[k]);
      for (int l = 0; l < W; ++l) sum[l] -= a * from[l];
    }
    for (int l = 0; l < W; ++l) {
      at[l] = xc[l] = (sum[l] - lower_product[l]) * inverse[c];
      lower_product[l] = sum[l];
    }
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      double* const to = row_of<W>(y, m.rows[k]);
      for (int l = 0; l < W; ++l) to[l] += a * xc[l];
    }
  }
}

/// y += L^T x, the rest of A x after post_smooth.
template<int W>
void add_upper_product(const lower_entries& m, const double* x, double* y) {
  for (int c = 0; c < m.n; ++c) {
    double sum[W] = {}, *const to = row_of<W>(y, c);
    for (int k = m.starts[c] + 1; k < m.starts[c + 1]; ++k) {
      const double a = m.a[k];
      const double* const from = row_of<W>(x, m.rows[k]);
      for (int l = 0; l < W; ++l) sum[l] += a * from[l];
    }
    for (int l = 0; l < W; ++l) to[l] += sum[l];
  }
}

/// coarse = P^T r.
template<int W>
void restrict_to(const restriction& p, const double* r, double* coarse) {
  for (int c = 0; c < p.size(); ++c) {
    double sum[W] = {};
    for (int k = p.begin[static_cast<std::size_t>(c)]; k < p.begin[static_cast<std::size_t>(c) + 1]; ++k) {
      const double* const from = row_of<W>(r, p.row[static_cast<std::size_t>(k)]);
      const auto weight = static_cast<double>(p.weight[static_cast<std::size_t>(k)]);
      for (int l = 0; l < W; ++l) sum[l] += weight * from[l];
    }
    for (int l = 0; l < W; ++l) row_of<W>(coarse, c)[l] = sum[l];
  }
}

/// x += P coarse.
template<int W>
void add_interpolated(const restriction& p, const double* coarse, double* x) {
  for (int c = 0; c < p.size(); ++c) {
    double value[W];
    for (int l = 0; l < W; ++l) value[l] = row_of<W>(coarse, c)[l];
    for (int k = p.begin[static_cast<std::size_t>(c)]; k < p.begin[static_cast<std::size_t>(c) + 1]; ++k) {
      double* const to = row_of<W>(x, p.row[static_cast<std::size_t>(k)]);
      const auto weight = static_cast<double>(p.weight[static_cast<std::size_t>(k)]);
      for (int l = 0; l < W; ++l) to[l] += weight * value[l];
    }
  }
}

}  // namespace concino::detail
