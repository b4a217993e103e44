// The equations of a band; see band_equations.hpp.
#pragma once

#include <concino/fields/detail/heat/band_equations.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace concino::detail {

/// The pivots of an incomplete factorisation that keeps the diagonal of fill-in, and half of what is dropped off the
/// diagonal. Sets scale_.
CONCINO_INLINE void band_equations::find_pivots(const heat_rows& rows, std::size_t first, std::size_t end) {
  constexpr double kept = 0.5, min_pivot = 1e-3;  // of the diagonal entry
  const std::size_t size = end - first;
  std::vector<double>&right = product_, &size_right = along_;  // sums of the entries right of the diagonal, and of
                                                               // their absolute values
  right.assign(size, 0.0);
  size_right.assign(size, 0.0);
  scale_.resize(size);
  const auto for_each_entry = [&](std::size_t i, const auto& f) {
    for (auto k = static_cast<std::size_t>(rows.begin[first + i]);
         k < static_cast<std::size_t>(rows.begin[first + i + 1]); ++k)
      if (const auto c = static_cast<std::size_t>(rows.column[k]); c >= first) f(c - first, rows.entry[k]);
  };
  for (std::size_t i = 0; i < size; ++i)
    for_each_entry(i, [&](std::size_t c, double w) {
      right[c] += w;
      size_right[c] += std::abs(w);
    });
  for (std::size_t i = 0; i < size; ++i) {
    const double d = rows.diagonal[first + i];
    double pivot = d;
    for_each_entry(i, [&](std::size_t c, double w) { pivot -= w * (w + kept * (right[c] - w)) / scale_[c]; });
    scale_[i] = std::max(std::min(pivot, 2 * d), std::max(size_right[i], min_pivot * d));
  }
  for (double& s : scale_) s = 1 / std::sqrt(s);
}

CONCINO_INLINE void band_equations::assign(const heat_rows& rows, std::size_t first, std::size_t end) {
  find_pivots(rows, first, end);
  const std::size_t size = end - first;
  begin_.resize(size + 1);
  begin_[0] = 0;
  column_.clear();
  entry_.clear();
  diagonal_.resize(size);
  mass_.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    diagonal_[i] = rows.diagonal[first + i] * scale_[i] * scale_[i];
    mass_[i] = rows.mass[first + i] / rows.diagonal[first + i];
    for (auto k = static_cast<std::size_t>(rows.begin[first + i]);
         k < static_cast<std::size_t>(rows.begin[first + i + 1]); ++k) {
      const auto c = static_cast<std::size_t>(rows.column[k]);
      if (c < first || rows.entry[k] == 0) continue;
      column_.push_back(static_cast<int>(c - first));
      entry_.push_back(rows.entry[k] * scale_[c - first] * scale_[i]);
    }
    begin_[i + 1] = static_cast<int>(column_.size());
  }
}

/// y = (I - L)^-1 y.
CONCINO_INLINE void band_equations::substitute_forward(std::vector<double>& y) const {
  const int *const begin = begin_.data(), *const column = column_.data();
  const double* const entry = entry_.data();
  double* const to = y.data();
  for (std::size_t i = 0; i < y.size(); ++i) {
    double sum = to[i];
    for (int k = begin[i]; k < begin[i + 1]; ++k) sum += entry[k] * to[column[k]];
    to[i] = sum;
  }
}

/// y = (I - L^T)^-1 y.
CONCINO_INLINE void band_equations::substitute_back(std::vector<double>& y) const {
  const int *const begin = begin_.data(), *const column = column_.data();
  const double* const entry = entry_.data();
  double* const to = y.data();
  for (std::size_t i = y.size(); i-- > 0;) {
    const double here = to[i];
    for (int k = begin[i]; k < begin[i + 1]; ++k) to[column[k]] += entry[k] * here;
  }
}

/// Sets residual_ to that of x_. If `measures`, returns the largest residual of the accepted rows in units of what is
/// allowed, else 0.
CONCINO_INLINE double band_equations::find_residual(bool measures) {
  const std::size_t size = x_.size();
  std::vector<double>& sizes = along_;
  for (std::size_t i = 0; i < size; ++i) {
    const double on = diagonal_[i] * x_[i];
    residual_[i] = load_[i] - on;
    sizes[i] = std::abs(on) + std::abs(load_[i]);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const double here = x_[i];
    double sum = 0, size_sum = 0;
    for (auto k = static_cast<std::size_t>(begin_[i]); k < static_cast<std::size_t>(begin_[i + 1]); ++k) {
      const auto c = static_cast<std::size_t>(column_[k]);
      const double of_column = entry_[k] * x_[c], of_row = entry_[k] * here;
      sum += of_column;
      residual_[c] += of_row;
      if (!measures) continue;
      size_sum += std::abs(of_column);
      sizes[c] += std::abs(of_row);
    }
    residual_[i] += sum;
    sizes[i] += size_sum;
  }
  if (!measures) return 0;
  double largest = 0;
  for (std::size_t i = 0; i < num_accepted_; ++i) {
    const double wrong = std::abs(residual_[i]), allowed = tolerance_ * mass_[i] * sizes[i];
    if (!(wrong <= largest * allowed))
      largest = allowed > 0 ? wrong / allowed : std::numeric_limits<double>::infinity();
  }
  return largest;
}

/// One iteration. square: that of the preconditioned residual. Returns its next value; negative if the iteration broke
/// down.
CONCINO_INLINE double band_equations::iterate_once(double square) {
  const std::size_t size = x_.size();
  along_ = direction_;
  substitute_back(along_);
  for (std::size_t i = 0; i < size; ++i) product_[i] = direction_[i] - (2 - diagonal_[i]) * along_[i];
  substitute_forward(product_);
  double energy = 0;
  for (std::size_t i = 0; i < size; ++i) {
    product_[i] += along_[i];
    energy += direction_[i] * product_[i];
  }
  if (!(energy > 0)) return -1;
  const double step = square / energy;
  double next = 0;
  for (std::size_t i = 0; i < size; ++i) {
    change_[i] += step * direction_[i];
    residual_[i] -= step * product_[i];
    next += residual_[i] * residual_[i];
  }
  const double turn = next / square;
  for (std::size_t i = 0; i < size; ++i) direction_[i] = residual_[i] + turn * direction_[i];
  return next;
}

/// Conjugate gradients from x_. Returns false if the tolerance is missed, or, with may_stop_early, as soon as that is
/// to be expected.
CONCINO_INLINE bool band_equations::iterate(int max_iterations, bool may_stop_early) {
  find_residual(false);
  substitute_forward(residual_);
  direction_ = residual_;
  start_ = x_;
  change_.assign(x_.size(), 0.0);
  double square = 0;
  for (const double r : residual_) square += r * r;
  const double first = square;
  for (int n = 1, check = 5; square > 0 && n <= max_iterations; ++n) {
    square = iterate_once(square);
    ++num_iterations_;
    if (n < check && n < max_iterations && square > 0) continue;
    x_ = change_;
    substitute_back(x_);
    for (std::size_t i = 0; i < x_.size(); ++i) x_[i] += start_[i];
    std::swap(residual_, product_);  // keeps the preconditioned one
    const double wrong = find_residual(true);
    std::swap(residual_, product_);
    if (wrong <= 1) return true;
    const double speed = std::log(first / square) / (2 * n),
                 left = speed > 0 ? std::log(wrong) / speed : max_iterations;
    if (may_stop_early && n >= 15 && n + 0.6 * left > max_iterations) return false;
    check = n + static_cast<int>(std::clamp(0.6 * left, 1.0, 10.0));
  }
  return find_residual(true) <= 1;
}

CONCINO_INLINE bool band_equations::solve(std::span<const double> load, std::span<double> x, std::size_t num_accepted,
                                          double tolerance, fallback_solver fallback) {
  constexpr int usual = 100, max_iterations = 3000;
  const std::size_t size = scale_.size();
  num_accepted_ = num_accepted;
  tolerance_ = tolerance;
  num_iterations_ = 0;
  for (std::vector<double>* const v : {&x_, &load_, &residual_, &product_, &along_}) v->resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    load_[i] = load[i] * scale_[i];
    x_[i] = x[i] / scale_[i];
  }
  bool is_solved = iterate(usual, true);
  if (!is_solved) {
    find_residual(false);
    Eigen::VectorXd lacking(static_cast<Eigen::Index>(size)), correction(lacking.size());
    for (std::size_t i = 0; i < size; ++i) lacking[static_cast<Eigen::Index>(i)] = residual_[i] / scale_[i];
    if (fallback && fallback(lower(), lacking, correction))
      for (std::size_t i = 0; i < size; ++i) x_[i] += correction[static_cast<Eigen::Index>(i)] / scale_[i];
    is_solved = find_residual(true) <= 1 || iterate(max_iterations, false);
  }
  for (std::size_t i = 0; i < size; ++i) x[i] = x_[i] * scale_[i];
  return is_solved;
}

CONCINO_INLINE Eigen::SparseMatrix<double> band_equations::lower() const {
  const auto size = static_cast<Eigen::Index>(scale_.size());
  Eigen::SparseMatrix<double> r(size, size);
  r.resizeNonZeros(size + static_cast<Eigen::Index>(column_.size()));
  int* const begin = r.outerIndexPtr();
  std::vector<int> next(scale_.size() + 1);
  for (const int c : column_) ++next[static_cast<std::size_t>(c) + 1];
  for (std::size_t i = 0; i < scale_.size(); ++i) next[i + 1] += next[i] + 1;  // 1: the diagonal entry
  std::copy(next.begin(), next.end(), begin);
  const auto put = [&](std::size_t row, std::size_t column, double x) {
    const int at = next[column]++;
    r.innerIndexPtr()[at] = static_cast<int>(row);
    r.valuePtr()[at] = x / (scale_[row] * scale_[column]);
  };
  for (std::size_t i = 0; i < scale_.size(); ++i) {
    put(i, i, diagonal_[i]);
    for (auto k = static_cast<std::size_t>(begin_[i]); k < static_cast<std::size_t>(begin_[i + 1]); ++k)
      put(i, static_cast<std::size_t>(column_[k]), -entry_[k]);
  }
  return r;
}

}  // namespace concino::detail
