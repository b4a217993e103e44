// The range of normalized values; see normalized.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/number_text.hpp>
#include <concino/fields/normalized.hpp>

namespace concino::detail {

CONCINO_INLINE void check_range(const normalize_options& options) {
  for (const double end : {options.low, options.high})
    if (!std::isfinite(end))
      core::throw_joined<invalid_argument>(
          {"normalized: the range ends at ", core::number_text(end), "; its ends must be finite"});
}

}  // namespace concino::detail
