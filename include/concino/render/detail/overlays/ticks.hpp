// Round numbers along an axis or a legend, and their texts.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/value_scale.hpp>

#include <string>
#include <vector>

namespace concino::detail {

/// A number of an axis: the place of the tick and its text.
struct tick {
  double value;
  std::string text;
};

/// Multiples of 1, 2 or 5 times a power of 10 in [low, high], about `count` of them, at least one unless the numbers
/// are not finite.
std::vector<tick> round_ticks(double low, double high, int count);

/// Round numbers at about equal distances of a scale. For a linear scale they are those of round_ticks.
std::vector<tick> round_ticks(const value_scale& scale, int count);

/// Texts of numbers, with as many digits as tell multiples of `step` apart: all as 0.003, or all as 3·10⁻³ if
/// that is shorter and the others long.
std::vector<tick> with_texts(const std::vector<double>& values, double step);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/overlays/ticks.ipp>
#endif
