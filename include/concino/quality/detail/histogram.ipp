// Bodies of histogram.hpp: histograms of quality metrics, and how many polys a solver may not like.
#pragma once

#include <concino/quality/histogram.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE quality_histogram histogram_of(metric what, const std::vector<shaped_value>& values,
                                              const histogram_options& options) {
  if (options.bins == 0) core::throw_joined<invalid_argument>({"histogram: bins must be 1 or more"});
  if (std::isinf(options.low) || std::isinf(options.high) || options.low > options.high)
    core::throw_joined<invalid_argument>(
        {"histogram: low and high must be finite, or NaN for those of the values, and low not greater than high"});
  quality_histogram h;
  h.counts.assign(options.bins, 0);
  h.min_value = no_limit, h.max_value = -no_limit;
  const bool larger = larger_is_worse(what);
  value_range acceptable[num_poly_shapes];
  for (std::size_t i = 0; i < num_poly_shapes; ++i)
    if (const metric_row* const row = find_row(what, static_cast<poly_shape>(i)))
      acceptable[i] = row->limits.acceptable;
  std::size_t num_finite = 0;
  for (const shaped_value& x : values) {
    if (!is_acceptable_in(acceptable[static_cast<unsigned>(x.shape)], larger, x.value)) ++h.unacceptable;
    if (!std::isfinite(x.value)) continue;
    h.min_value = std::min(h.min_value, x.value), h.max_value = std::max(h.max_value, x.value);
    h.mean += (x.value - h.mean) / static_cast<double>(++num_finite);
  }
  if (num_finite == 0) h.min_value = h.max_value = 0;
  h.low = std::isnan(options.low) ? h.min_value : options.low;
  h.high = std::isnan(options.high) ? std::max(h.max_value, h.low) : options.high;
  if (std::isnan(options.low)) h.low = std::min(h.low, h.high);
  const double bins = static_cast<double>(options.bins);
  for (const shaped_value& x : values) {
    if (std::isnan(x.value)) ++h.undefined;
    else if (x.value < h.low) ++h.below;
    else if (x.value > h.high) ++h.above;
    else
      ++h.counts[h.high > h.low ? std::min(options.bins - 1,
                                           static_cast<std::size_t>(bins * ((x.value - h.low) / (h.high - h.low))))
                                : 0];
  }
  return h;
}

}  // namespace concino::detail
