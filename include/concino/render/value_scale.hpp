// Scales that map values to positions in a colour map.
#pragma once

#include <concino/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace concino {

/// A non-decreasing, piecewise linear function from values to [0, 1]. Values beyond its ends map to 0 and 1.
class value_scale {
  std::vector<double> values_ = {0, 1}, positions_ = {0, 1};  // of the knots; values do not decrease, places go from 0
                                                              // to 1

  std::size_t step_of(double value) const {
    const auto i = static_cast<std::size_t>(std::upper_bound(values_.begin(), values_.end(), value) - values_.begin());
    return std::min(std::max<std::size_t>(i, 1), values_.size() - 1) - 1;
  }

 public:
  value_scale() = default;

  /// A linear scale from `low` to `high`.      Errors: invalid_argument unless both are finite and low <= high.
  static value_scale linear(double low, double high) {
    if (!std::isfinite(low) || !std::isfinite(high) || !(low <= high))
      throw invalid_argument("value_scale: low and high must be finite, low <= high");
    value_scale s;
    s.values_ = {low, high};
    return s;
  }

  /// A linear scale from the smallest to the largest finite value; from 0 to 1 if there is none.
  static value_scale linear(std::span<const double> values) { return equalized(values, 0); }

  /// A blend of the linear scale (share 0) and the scale by rank, in which equal parts of the map have equally many
  /// values (share 1). It shows the variation everywhere in a field that is steep in a few places and flat elsewhere,
  /// such as a potential of points.
  /// Errors: invalid_argument if share is not in [0, 1].      Cost: O(n log n).
  static value_scale equalized(std::span<const double> values, double share = 0.6) {
    if (!(share >= 0 && share <= 1)) throw invalid_argument("value_scale: share must be in [0, 1]");
    std::vector<double> sorted;
    for (const double x : values)
      if (std::isfinite(x)) sorted.push_back(x);
    if (sorted.empty()) return {};
    std::sort(sorted.begin(), sorted.end());
    value_scale s = linear(sorted.front(), sorted.back());
    const double range = sorted.back() / 2 - sorted.front() / 2;  // the difference of halves cannot overflow
    if (share == 0 || !(range > 0)) return s;
    constexpr std::size_t steps = 16;  // few knots, so that the slope varies little from band to band
    s.values_.clear();
    s.positions_.clear();
    const auto position_of = [&](double x, double rank) {
      return share * rank + (1 - share) * std::min(1.0, (x / 2 - sorted.front() / 2) / range);
    };
    for (std::size_t k = 0; k <= steps;) {
      const double x = sorted[(sorted.size() - 1) * k / steps];
      const std::size_t first = k;
      while (k <= steps && sorted[(sorted.size() - 1) * k / steps] == x) ++k;
      const std::size_t last = k - 1;  // equal values are one knot, at the middle of their ranks, or at an end of the
                                       // scale
      const double rank = first == 0 ? 0 : last == steps ? 1 : static_cast<double>(first + last) / (2.0 * steps);
      s.values_.push_back(x);
      s.positions_.push_back(position_of(x, rank));
    }
    return s;
  }

  /// The knots: values that do not decrease, and the position of each, from 0 to 1.
  std::span<const double> values() const { return values_; }
  std::span<const double> positions() const { return positions_; }

  double low() const { return values_.front(); }
  double high() const { return values_.back(); }

  double operator()(double value) const {
    const std::size_t i = step_of(value);
    const double a = values_[i], b = values_[i + 1];
    const double part = b > a ? std::min(1.0, std::max(0.0, (value / 2 - a / 2) / (b / 2 - a / 2))) : 0.5;
    return positions_[i] + part * (positions_[i + 1] - positions_[i]);
  }

  /// The derivative of the scale at a value; 0 outside its range, and if all values are equal.
  double slope(double value) const {
    const std::size_t i = step_of(value);
    const double a = values_[i], b = values_[i + 1];
    return b > a && value >= a && value <= b ? (positions_[i + 1] - positions_[i]) / (b - a) : 0;
  }
};

}  // namespace concino
