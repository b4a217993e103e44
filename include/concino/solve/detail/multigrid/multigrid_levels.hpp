// The hierarchy of matrices of multigrid, and its cycle.
#pragma once

#include <concino/solve/detail/multigrid/aggregates.hpp>
#include <concino/solve/detail/multigrid/bottom_solver.hpp>
#include <concino/solve/detail/multigrid/cancelling_rows.hpp>
#include <concino/solve/detail/multigrid/coarse_matrix.hpp>
#include <concino/solve/detail/multigrid/multigrid_cycle.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

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
  bool has_bottom_ = false, has_kernel_ = false, smooths_whole_rows_ = false;

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

  /// a: a lower triangle with a positive diagonal and sorted columns; moved from.
  void build(Eigen::SparseMatrix<double>& a) {
    levels_.clear();
    levels_.reserve(32);  // Eigen's matrices are copied where a vector grows
    has_kernel_ = false;
    levels_.emplace_back().a.swap(a);
    smooths_whole_rows_ = cancelling_rows::pay_for(finest());
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

  /// x = M b for a symmetric positive definite M that approximates the inverse of the matrix of this level. For W
  /// vectors at once; the W entries of a row are next to each other. y: as many numbers; see post_smooth for what they
  /// are afterwards.
  template<int W>
  void cycle(std::size_t at, const double* b, double* x, double* y, workspace& w) const {
    const level& l = levels_[at];
    const lower_entries a(l.a);
    const bool is_last = at + 1 == levels_.size();
    if (is_last && has_bottom_) {
      bottom_.solve<W>(b, x, w.e[at].data());
      return;
    }
    pre_smooth<W>(a, l.inverse.data(), b, x, y);
    if (!is_last) {
      double *const coarse_b = w.b[at + 1].data(), *const coarse_x = w.x[at + 1].data(),
                    *const coarse_y = w.y[at + 1].data();
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
    post_smooth<W>(a, l.inverse.data(), b, x, y);
  }

  /// x = M b for one vector, and y = A x unless there is one level only. Returns whether it has set y.
  bool apply(const double* b, double* x, double* y, workspace& w) const {
    cycle<1>(0, b, x, y, w);
    if (levels_.size() == 1 && has_bottom_) return false;
    add_upper_product<1>(lower_entries(finest()), x, y);
    return true;
  }

 private:
  /// Returns false if there is nothing to aggregate. The interpolation is smoothed unless it or the coarse matrix would
  /// be large.
  bool add_level() {
    const Eigen::Index entries = levels_.back().a.nonZeros();
    aggregates groups(levels_.back().a);
    if (groups.size() == 0) return false;
    if (smooths_whole_rows_ && add_level_below(smoothed_by_whole_rows(groups), entries / 4 * 3)) return true;
    smooths_whole_rows_ = false;
    const prolongation p = groups.smoothed(static_cast<std::size_t>(entries));
    groups.forget_strong_entries();
    if (!add_level_below(p, entries / 4 * 3))
      add_level_below(groups.piecewise_constant(), std::numeric_limits<Eigen::Index>::max());
    return true;
  }

  prolongation smoothed_by_whole_rows(const aggregates& groups) const {
    const Eigen::SparseMatrix<double>& a = levels_.back().a;
    const cancelling_rows rows(a);
    const auto most = static_cast<std::size_t>(a.nonZeros());
    return rows.smooth(groups.smoothed(most, [&](std::size_t i) { return rows.contains(i); }), most);
  }

  /// Returns false if the interpolation is empty, or the coarse matrix would have more entries.
  bool add_level_below(const prolongation& p, Eigen::Index max_entries) {
    if (p.columns == 0) return false;
    bool has_kernel = has_kernel_;
    Eigen::SparseMatrix<double> coarse = coarse_matrix(levels_.back().a, p, has_kernel);
    if (coarse.nonZeros() > max_entries) return false;
    has_kernel_ = has_kernel;
    levels_.back().to_next = restriction(p);
    levels_.emplace_back().a.swap(coarse);
    return true;
  }

  /// A W-cycle needs hardly more iterations on large meshes than on small ones. Cycles are V-shaped where a W would
  /// cost too much, and on the finest level, where it would take twice the time to save one iteration in ten.
  void choose_visits() {
    double cost = 0;  // of a cycle that begins on the next level, in entries of matrices
    for (std::size_t i = levels_.size(); i-- > 0;) {
      const auto entries = static_cast<double>(levels_[i].a.nonZeros());
      levels_[i].visits_next_twice = i > 0 && i + 2 < levels_.size() && cost <= entries;
      cost = entries + (levels_[i].visits_next_twice ? 2 : 1) * cost;
    }
  }
};

}  // namespace concino::detail
