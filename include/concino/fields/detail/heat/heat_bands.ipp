// Heat in bands; see heat_bands.hpp.
#pragma once

#include <concino/fields/detail/heat/heat_bands.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace concino::detail {

/// Sorts by one byte of the numbers after the other, which takes less than half of the time of comparisons.
CONCINO_INLINE std::vector<int> heat_bands::order_by_guess(std::span<const double> log_guess) {
  struct numbered {
    std::uint64_t key;  // increases as the guess decreases
    int vert;
  };
  constexpr int num_digits = 8, base = 256;
  const std::size_t size = log_guess.size();
  std::vector<numbered> from(size), to(size);
  std::vector<std::size_t> counts(num_digits * base);
  for (std::size_t i = 0; i < size; ++i) {
    const auto bits = std::bit_cast<std::uint64_t>(log_guess[i] + 0.0);  // 0.0: makes a positive zero of a negative one
    const std::uint64_t key = bits >> 63 ? bits : ~(bits | std::uint64_t{1} << 63);
    from[i] = {key, static_cast<int>(i)};
    for (std::size_t d = 0; d < num_digits; ++d) ++counts[d * base + (key >> (8 * d)) % base];
  }
  for (std::size_t d = 0; d < num_digits; ++d) {
    std::size_t next[base], sum = 0;
    for (std::size_t k = 0; k < base; ++k) {
      next[k] = sum;
      sum += counts[d * base + k];
    }
    for (const numbered& x : from) to[next[(x.key >> (8 * d)) % base]++] = x;
    std::swap(from, to);
  }
  std::vector<int> order(size);
  for (std::size_t i = 0; i < size; ++i) order[i] = from[i].vert;
  return order;
}

CONCINO_INLINE heat_bands::heat_bands(const Eigen::SparseMatrix<double>& lower, std::span<const double> load,
                                      std::span<const double> log_guess, std::span<const int> order)
    : order_(order), rows_(lower, order), guess_(order.size()), load_(order.size()), heat_(order.size()),
      exponent_(order.size(), no_heat) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    guess_[i] = log_guess[static_cast<std::size_t>(order[i])];
    load_[i] = load[static_cast<std::size_t>(order[i])];
  }
}

/// Sets band_load_ to the load of the verts [first, end) and what they get from those before, times 2^-e. Returns e,
/// which brings the largest near 1.
CONCINO_INLINE int heat_bands::find_load(std::size_t first, std::size_t end) {
  const auto for_each_before = [&](std::size_t i, const auto& f) {
    for (auto k = static_cast<std::size_t>(rows_.begin[i]); k < static_cast<std::size_t>(rows_.begin[i + 1]); ++k)
      if (const auto c = static_cast<std::size_t>(rows_.column[k]); c < first)
        if (const double x = rows_.entry[k] * heat_[c]; x != 0) f(x, exponent_[c]);
  };
  int largest = no_heat;
  for (std::size_t i = first; i < end; ++i) {
    if (load_[i] > 0) largest = std::max(largest, std::ilogb(load_[i]));
    for_each_before(i, [&](double x, int exponent) { largest = std::max(largest, exponent + std::ilogb(x)); });
  }
  band_load_.assign(end - first, 0.0);
  if (largest == no_heat) return largest;
  for (std::size_t i = first; i < end; ++i) {
    double& sum = band_load_[i - first];
    sum = std::ldexp(load_[i], -largest);
    for_each_before(i, [&](double x, int exponent) { sum += std::ldexp(x, exponent - largest); });
  }
  return largest;
}

CONCINO_INLINE bool heat_bands::run(double tolerance, fallback_solver fallback) {
  const auto is_known = [](double guess) { return guess > -std::numeric_limits<double>::infinity(); };
  const auto last =
      static_cast<std::size_t>(std::partition_point(guess_.begin(), guess_.end(), is_known) - guess_.begin());
  band_equations equations;
  bool is_solved = true;
  // solved: verts before have an approximation
  for (std::size_t first = 0, solved = 0, next = 0; first < last; first = next) {
    const auto first_below = [&](double guess) {
      return static_cast<std::size_t>(std::partition_point(guess_.begin() + static_cast<std::ptrdiff_t>(first),
                                                           guess_.begin() + static_cast<std::ptrdiff_t>(last),
                                                           [&](double x) { return x >= guess; }) -
                                      guess_.begin());
    };
    const std::size_t end = first_below(guess_[first] - (width + overlap));
    next = end == last ? last : first_below(guess_[first] - width);
    const int exponent = find_load(first, end);
    if (exponent == no_heat) continue;
    band_heat_.assign(end - first, 0.0);
    for (std::size_t i = first; i < solved; ++i) band_heat_[i - first] = std::ldexp(heat_[i], exponent_[i] - exponent);
    equations.assign(rows_, first, end);
    is_solved &= equations.solve(band_load_, band_heat_, next - first, tolerance,
                                 [&](const auto& lower, const auto& load, auto& x) {
                                   return fallback && fallback(order_.subspan(first, end - first), lower, load, x);
                                 });
    iterations_ += static_cast<double>(equations.num_iterations()) * static_cast<double>(end - first);
    for (std::size_t i = first; i < end; ++i) {
      heat_[i] = band_heat_[i - first];
      exponent_[i] = exponent;
    }
    solved = end;
  }
  return is_solved;
}

CONCINO_INLINE std::vector<double> heat_bands::log_heat() const {
  std::vector<double> r(order_.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < order_.size(); ++i)
    if (heat_[i] > 0)
      r[static_cast<std::size_t>(order_[i])] = std::log(heat_[i]) + exponent_[i] * 0.69314718055994530942;
  return r;
}

}  // namespace concino::detail
