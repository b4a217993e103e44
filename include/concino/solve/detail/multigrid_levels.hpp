// The hierarchy of matrices of multigrid, and its cycle.
#pragma once

#include <concino/solve/detail/aggregates.hpp>
#include <concino/solve/detail/bottom_solver.hpp>
#include <concino/solve/detail/incomplete_cholesky.hpp>
#include <concino/solve/detail/multigrid_cycle.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// Computes P^T A P for the lower triangle of A; the result is a lower triangle too, with sorted columns. With U the upper triangle of A and half of its
/// diagonal, P^T A P = T + T^T for T = P^T U P.
class coarse_matrix {
  std::size_t n_;  // coarse unknowns
  std::vector<std::size_t> end_;  // row c of T: entries [end_[c], end_[c + 1])
  std::vector<int> column_;
  std::vector<double> value_, bound_;  // bound_: a sum of non-negative terms of the diagonal, which it may not cancel

  /// Adds an entry to those from position `first`, or to the one of them with the same index, whose position is at[index].
  static void add(int index, double x, std::size_t first, std::vector<int>& at, std::vector<int>& indices, std::vector<double>& values) {
    int& position = at[static_cast<std::size_t>(index)];
    if (position < static_cast<int>(first)) {
      position = static_cast<int>(indices.size());
      indices.push_back(index);
      values.push_back(x);
    } else {
      values[static_cast<std::size_t>(position)] += x;
    }
  }

  void multiply(const Eigen::SparseMatrix<double>& a, const prolongation& p, const restriction& by_column) {
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr(), n = static_cast<int>(a.cols());
    const double* const x = a.valuePtr();
    std::vector<int> at(n_, -1);
    std::vector<int> fine_at(static_cast<std::size_t>(n), -1), fine;  // row c of P^T U
    std::vector<double> fine_value;
    for (std::size_t c = 0; c < n_; ++c) {
      for (auto m = static_cast<std::size_t>(by_column.begin[c]); m < static_cast<std::size_t>(by_column.begin[c + 1]); ++m) {
        const int i = by_column.row[m];
        const double w = static_cast<double>(by_column.weight[m]);
        bound_[c] += w * w * x[starts[i]];
        for (int k = starts[i]; k < starts[i + 1]; ++k) add(rows[k], k == starts[i] ? w * x[k] / 2 : w * x[k], 0, fine_at, fine, fine_value);
      }
      const std::size_t first = column_.size();
      for (std::size_t k = 0; k < fine.size(); ++k) {
        const auto j = static_cast<std::size_t>(fine[k]);
        fine_at[j] = -1;
        for (auto l = static_cast<std::size_t>(p.begin[j]); l < static_cast<std::size_t>(p.begin[j + 1]); ++l)
          add(p.column[l], fine_value[k] * static_cast<double>(p.weight[l]), first, at, column_, value_);
      }
      fine.clear();
      fine_value.clear();
      end_[c + 1] = column_.size();
    }
  }

 public:
  /// by_column: the same as p.
  coarse_matrix(const Eigen::SparseMatrix<double>& a, const prolongation& p, const restriction& by_column)
      : n_(static_cast<std::size_t>(p.columns)), end_(n_ + 1), bound_(n_) {
    multiply(a, p, by_column);
  }

  /// P^T A P. A diagonal entry that is only rounding errors belongs to the kernel of A, and is replaced by a positive number; has_kernel: then set.
  Eigen::SparseMatrix<double> lower(bool& has_kernel) const {
    std::vector<int> next(n_ + 2), row(column_.size()), rows, at(n_, -1);  // column j of the upper triangle: entries (i, j) and (j, i) of T for i <= j
    std::vector<double> sorted(column_.size()), values;
    const auto for_each_entry = [&](auto visit) {
      for (std::size_t c = 0; c < n_; ++c)
        for (std::size_t k = end_[c]; k < end_[c + 1]; ++k) {
          const auto other = static_cast<std::size_t>(column_[k]);
          visit(std::min(c, other), std::max(c, other), c == other ? 2 * value_[k] : value_[k]);
        }
    };
    for_each_entry([&](std::size_t, std::size_t j, double) { ++next[j + 2]; });
    for (std::size_t i = 2; i < next.size(); ++i) next[i] += next[i - 1];
    for_each_entry([&](std::size_t i, std::size_t j, double x) {
      const auto to = static_cast<std::size_t>(next[j + 1]++);
      row[to] = static_cast<int>(i);
      sorted[to] = x;
    });
    Eigen::SparseMatrix<double> upper(static_cast<Eigen::Index>(n_), static_cast<Eigen::Index>(n_));
    rows.reserve(row.size() / 2 + n_);
    values.reserve(row.size() / 2 + n_);
    for (std::size_t c = 0; c < n_; ++c) {
      const std::size_t first = rows.size();
      for (auto k = static_cast<std::size_t>(next[c]); k < static_cast<std::size_t>(next[c + 1]); ++k) add(row[k], sorted[k], first, at, rows, values);
      upper.outerIndexPtr()[c + 1] = static_cast<int>(rows.size());
    }
    upper.resizeNonZeros(static_cast<Eigen::Index>(rows.size()));
    std::copy(rows.begin(), rows.end(), upper.innerIndexPtr());
    std::copy(values.begin(), values.end(), upper.valuePtr());
    Eigen::SparseMatrix<double> r = sorted_transpose(upper);
    for (std::size_t c = 0; c < n_; ++c) {
      double& d = r.valuePtr()[r.outerIndexPtr()[c]];
      if (d > 1e-13 * bound_[c]) continue;
      d = bound_[c];
      has_kernel = true;
    }
    return r;
  }
};

/// The matrices of multigrid, from the finest to one with few unknowns, and the interpolations between them.
class multigrid_levels {
  struct level {
    Eigen::SparseMatrix<double> a;  // lower triangle
    std::vector<double> inverse;    // of its diagonal
    restriction to_next;            // its transpose interpolates from the next level
    bool visits_next_twice = false;
  };
  std::vector<level> levels_;
  bottom_solver bottom_;
  bool has_bottom_ = false, has_kernel_ = false;
  double entries_per_cycle_ = 0;

 public:
  static constexpr Eigen::Index max_bottom = 256;

  /// Vectors of each level.
  struct workspace {
    std::vector<Eigen::VectorXd> b, x, y, e;
  };

  const Eigen::SparseMatrix<double>& finest() const { return levels_.front().a; }
  std::size_t size() const { return levels_.size(); }
  /// Whether a vector was met whose product with the matrix is only rounding errors, or the matrix is not definite.
  bool has_kernel() const { return has_kernel_; }
  /// The entries of the matrices of a cycle, once for each visit.
  double entries_per_cycle() const { return entries_per_cycle_; }

  /// a: a lower triangle with a positive diagonal and sorted columns; moved from.
  void build(Eigen::SparseMatrix<double>& a) {
    levels_.clear();
    levels_.reserve(32);  // Eigen's matrices are copied where a vector grows
    has_kernel_ = false;
    levels_.emplace_back().a.swap(a);
    while (levels_.back().a.cols() > max_bottom && add_level()) {}
    has_bottom_ = levels_.back().a.cols() <= max_bottom && bottom_.factorize(levels_.back().a, has_kernel_);
    for (level& l : levels_) {
      const auto n = static_cast<std::size_t>(l.a.cols());
      l.inverse.resize(n);
      for (std::size_t i = 0; i < n; ++i) l.inverse[i] = 1 / l.a.valuePtr()[l.a.outerIndexPtr()[i]];
    }
    choose_visits();
  }

  /// width: the number of right-hand sides at once.
  workspace make_workspace(Eigen::Index width = 1) const {
    workspace w;
    for (auto* const v : {&w.b, &w.x, &w.y, &w.e}) v->resize(levels_.size());
    for (std::size_t i = 1; i < levels_.size(); ++i) {
      const Eigen::Index n = levels_[i].a.cols() * width;
      for (auto* const v : {&w.b, &w.x, &w.y, &w.e}) (*v)[i].resize(n);
    }
    if (levels_.size() == 1 && has_bottom_) w.e[0].resize(levels_[0].a.cols() * width);
    return w;
  }

  /// x = M b for a symmetric positive definite M that approximates the inverse of the matrix of this level. For W vectors at once; the W entries of a row are
  /// next to each other. y: as many numbers; see smooth_last for what they are afterwards.
  template<int W>
  void cycle(std::size_t at, const double* b, double* x, double* y, workspace& w) const {
    const level& l = levels_[at];
    const lower_entries a(l.a);
    const bool is_last = at + 1 == levels_.size();
    if (is_last && has_bottom_) {
      bottom_.solve<W>(b, x, w.e[at].data());
      return;
    }
    smooth_first<W>(a, l.inverse.data(), b, x, y);
    if (!is_last) {
      double *const coarse_b = w.b[at + 1].data(), *const coarse_x = w.x[at + 1].data(), *const coarse_y = w.y[at + 1].data();
      restrict_to<W>(l.to_next, y, coarse_b);
      cycle<W>(at + 1, coarse_b, coarse_x, coarse_y, w);
      if (l.visits_next_twice) {
        double* const more = w.e[at + 1].data();
        add_upper_product<W>(lower_entries(levels_[at + 1].a), coarse_x, coarse_y);
        for (Eigen::Index i = 0; i < w.b[at + 1].size(); ++i) coarse_b[i] -= coarse_y[i];
        cycle<W>(at + 1, coarse_b, more, coarse_y, w);
        for (Eigen::Index i = 0; i < w.b[at + 1].size(); ++i) coarse_x[i] += more[i];
      }
      add_interpolated<W>(l.to_next, coarse_x, x);
    }
    smooth_last<W>(a, l.inverse.data(), b, x, y);
  }

  /// x = M b for one vector, and y = A x unless there is one level only. Returns whether it has set y.
  bool apply(const double* b, double* x, double* y, workspace& w) const {
    cycle<1>(0, b, x, y, w);
    if (levels_.size() == 1 && has_bottom_) return false;
    add_upper_product<1>(lower_entries(finest()), x, y);
    return true;
  }

 private:
  /// Returns false if there is nothing to aggregate. The interpolation is smoothed unless it or the coarse matrix would be large.
  bool add_level() {
    aggregates groups(levels_.back().a);
    if (groups.size() == 0) return false;
    const Eigen::Index entries = levels_.back().a.nonZeros();
    prolongation p = groups.smoothed(static_cast<std::size_t>(entries));
    groups.forget_strong_entries();
    Eigen::SparseMatrix<double> coarse;
    restriction by_column(p);
    if (p.columns > 0) coarse_matrix(levels_.back().a, p, by_column).lower(has_kernel_).swap(coarse);
    if (p.columns == 0 || coarse.nonZeros() > entries / 4 * 3) {
      p = groups.piecewise_constant();
      by_column = restriction(p);
      coarse_matrix(levels_.back().a, p, by_column).lower(has_kernel_).swap(coarse);
    }
    levels_.back().to_next = std::move(by_column);
    levels_.emplace_back().a.swap(coarse);
    return true;
  }

  /// A W-cycle needs hardly more iterations on large meshes than on small ones. Cycles are V-shaped where a W would cost too much, and on the finest level,
  /// where it would take twice the time to save one iteration in ten.
  void choose_visits() {
    double cost = 0;  // of a cycle that begins on the next level, in entries of matrices
    for (std::size_t i = levels_.size(); i-- > 0;) {
      const auto entries = static_cast<double>(levels_[i].a.nonZeros());
      levels_[i].visits_next_twice = i > 0 && i + 2 < levels_.size() && cost <= entries;
      cost = entries + (levels_[i].visits_next_twice ? 2 : 1) * cost;
    }
    entries_per_cycle_ = cost;
  }
};

}  // namespace concino::detail
