// Means and deviations; see value_statistics.hpp.
#pragma once

#include <concino/fields/detail/values/value_statistics.hpp>

#include <cmath>

namespace concino::detail {

/// Differences to the first finite value are summed, so that large constants lose no digits; they are halved, so that
/// they do not overflow.
CONCINO_INLINE value_statistics statistics_of_values(const std::vector<double>& values,
                                                     const std::vector<double>& weights) {
  value_statistics s;
  double total = 0, first = 0, sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      ++s.not_finite;
      continue;
    }
    if (!s.has_values) s.min_at = s.max_at = i, first = values[i];
    s.has_values = true;
    if (values[i] < values[s.min_at]) s.min_at = i;
    if (values[i] > values[s.max_at]) s.max_at = i;
    total += weights[i];
  }
  if (!s.has_values) return s;
  const bool is_weighted = total > 0 && std::isfinite(total);
  const double count = static_cast<double>(values.size() - s.not_finite);
  const auto share = [&](std::size_t i) { return is_weighted ? weights[i] / total : 1 / count; };
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::isfinite(values[i])) sum += share(i) * (values[i] / 2 - first / 2);
  s.mean = first + 2 * sum;
  const double range = values[s.max_at] / 2 - values[s.min_at] / 2;
  double squares = 0;
  for (std::size_t i = 0; i < values.size() && range > 0; ++i) {
    if (!std::isfinite(values[i])) continue;
    const double scaled = (values[i] / 2 - s.mean / 2) / range;  // squares of values may overflow or underflow
    squares += share(i) * scaled * scaled;
  }
  s.deviation = 2 * range * std::sqrt(squares);
  s.integral = is_weighted ? total * s.mean : 0;
  return s;
}

}  // namespace concino::detail
