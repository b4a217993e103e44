// Means and deviations of numbers with weights.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <vector>

namespace concino::detail {

struct value_statistics {
  std::size_t not_finite = 0, min_at = 0, max_at = 0;  // places in the list, meaningless if no value is finite
  double mean = 0, deviation = 0, integral = 0;
  bool has_values = false;
};

/// Of the finite values; weights are 0 or more, and equal ones are used where their sum is 0 or not finite.
value_statistics statistics_of_values(const std::vector<double>& values, const std::vector<double>& weights);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/values/value_statistics.ipp>
#endif
