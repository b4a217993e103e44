// Defines heights.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/print/heights.hpp>

#include <cmath>
#include <limits>

namespace concino::detail {

CONCINO_INLINE std::vector<double> heights_between(double bottom, double top, double thickness) {
  if (!(thickness > 0 && thickness <= std::numeric_limits<double>::max()))
    core::throw_joined<invalid_argument>(
        {"heights: thickness is ", core::number_text(thickness), "; it must be finite and above 0"});
  if (!std::isfinite(bottom) || !std::isfinite(top))
    core::throw_joined<invalid_mesh>({"heights: a vert is not finite"});
  const double count = std::ceil((top - bottom) / thickness - 1e-9);
  if (!(count <= 1e8))
    core::throw_joined<invalid_argument>(
        {"heights: thickness ", core::number_text(thickness), " gives more than 10^8 layers"});
  std::vector<double> all;
  for (double k = 0; k < count; ++k) all.push_back(bottom + k * thickness);
  return all;
}

}  // namespace concino::detail
