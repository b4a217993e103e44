// The values of level sets that a caller gives; see level_values.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/level_sets/detail/level_values.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE std::vector<double> sort_levels(std::vector<double> levels, const char* caller) {
  for (const double x : levels)
    if (std::isnan(x)) core::throw_joined<invalid_argument>({caller, ": the value of a level set is not a number (NaN)"});
  std::sort(levels.begin(), levels.end());
  levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  return levels;
}

}  // namespace concino::detail
