// Estimates the error of conjugate gradients in the energy norm, from the gains of the iterations.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace concino::detail {

/// Each iteration of conjugate gradients reduces the square of the error in the energy norm by a known amount, its
/// gain. So the squared error is the sum of all gains to come.
/// Source: Hestenes, Stiefel 1952, theorem 6:1; Golub, Meurant 1997.
class energy_gains {
  std::vector<double> gain_;  // since the last start
  double all_ = 0, since_start_ = 0;  // all_: the square of the energy norm of the solution found so far

  std::size_t window() const { return std::min<std::size_t>(4 + gain_.size() / 24, 64); }
  double sum_of_last(std::size_t number, std::size_t skipped) const {
    double sum = 0;
    for (std::size_t i = gain_.size() - skipped - number; i < gain_.size() - skipped; ++i) sum += gain_[i];
    return sum;
  }

 public:
  void start() {
    gain_.clear();
    since_start_ = 0;
  }
  void add(double gain) {
    gain_.push_back(gain);
    since_start_ += gain;
    all_ += gain;
  }
  bool has_any() const { return !gain_.empty(); }
  double all() const { return all_; }

  /// Whether the gain of the last iteration was rounding errors only.
  bool is_exhausted() const { return !(gain_.back() > 1e-30 * since_start_); }

  /// An estimate of the square of the remaining error. If the last two windows of iterations gained G and g < G,
  /// further gains form a geometric series. +inf if there is no estimate.
  double left() const {
    const std::size_t n = window();
    if (gain_.size() < 2 * n) return std::numeric_limits<double>::infinity();
    const double last = sum_of_last(n, 0), fall = sum_of_last(n, n) - last;
    return fall > 0 ? last * std::max(last / fall, 1e-4) : std::numeric_limits<double>::infinity();
  }

  /// The gain of the last iterations, at least one: a lower bound of the square of the error before them.
  double recent() const { return is_exhausted() ? gain_.back() : sum_of_last(std::min(gain_.size(), window()), 0); }
};

}  // namespace concino::detail
