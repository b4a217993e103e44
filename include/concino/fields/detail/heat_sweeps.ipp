// Sweeps over heat systems; see heat_sweeps.hpp.
#pragma once

#include <concino/fields/detail/heat_sweeps.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace concino::detail {

namespace heat_sweep_values {

/// 2^e for e <= 0; 0 where 1 would not change by it.
inline double power_of_two(int e) { return e < -1000 ? 0.0 : std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52); }

constexpr double log2 = 0.69314718055994530942;

}  // namespace heat_sweep_values

CONCINO_INLINE heat_sweeps::heat_sweeps(const Eigen::SparseMatrix<double>& lower, std::span<const double> load, std::span<const double> log_guess)
    : order_(log_guess.size()), heat_(log_guess.size()) {
  for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<int>(i);
  const auto guess = [&](int i) { return log_guess[static_cast<std::size_t>(i)]; };
  std::stable_sort(order_.begin(), order_.end(), [&](int i, int j) { return guess(i) > guess(j); });
  permute(lower, load);
  for (std::size_t i = 0; i < heat_.size(); ++i) {
    const double bits = guess(order_[i]) / heat_sweep_values::log2, whole = std::floor(bits);
    if (std::abs(bits) < 1e9) heat_[i] = {std::exp2(bits - whole) / 2, static_cast<int>(whole) + 1};
  }
}

/// Copies both triangles in the order of the visits.
CONCINO_INLINE void heat_sweeps::permute(const Eigen::SparseMatrix<double>& lower, std::span<const double> load) {
  const std::size_t size = order_.size();
  std::vector<int> rank(size);
  for (std::size_t i = 0; i < size; ++i) rank[static_cast<std::size_t>(order_[i])] = static_cast<int>(i);
  begin_.assign(size + 1, 0);
  mass_.assign(size, 0.0);
  diagonal_.resize(size);
  load_.resize(size);
  const auto for_each_entry = [&](const auto& f) {
    for (std::size_t c = 0; c < size; ++c)
      for (int k = lower.outerIndexPtr()[c]; k < lower.outerIndexPtr()[c + 1]; ++k)
        f(rank[static_cast<std::size_t>(lower.innerIndexPtr()[k])], rank[c], lower.valuePtr()[k]);
  };
  for_each_entry([&](int r, int c, double) {
    if (r == c) return;
    ++begin_[static_cast<std::size_t>(r) + 1];
    ++begin_[static_cast<std::size_t>(c) + 1];
  });
  for (std::size_t i = 0; i < size; ++i) {
    begin_[i + 1] += begin_[i];
    load_[i] = load[static_cast<std::size_t>(order_[i])];
  }
  column_.resize(static_cast<std::size_t>(begin_.back()));
  entry_.resize(column_.size());
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  const auto put = [&](int r, int c, double x) {
    const auto at = static_cast<std::size_t>(next[static_cast<std::size_t>(r)]++);
    column_[at] = c;
    entry_[at] = -x;
  };
  for_each_entry([&](int r, int c, double x) {
    mass_[static_cast<std::size_t>(r)] += x;
    if (r == c) {
      diagonal_[static_cast<std::size_t>(r)] = x;
      return;
    }
    mass_[static_cast<std::size_t>(c)] += x;
    put(r, c, x);
    put(c, r, x);
  });
  for (std::size_t i = 0; i < size; ++i) mass_[i] = std::max(mass_[i], min_mass * diagonal_[i]);
}

/// Returns false if the row and its load are 0.
CONCINO_INLINE bool heat_sweeps::sum_row(std::size_t row, row_sums& sums) const {
  using heat_sweep_values::power_of_two;
  const auto begin = static_cast<std::size_t>(begin_[row]), end = static_cast<std::size_t>(begin_[row + 1]);
  int largest = std::max(heat_[row].exponent, load_[row] > 0 ? 0 : zero);
  for (std::size_t k = begin; k < end; ++k) largest = std::max(largest, heat_[static_cast<std::size_t>(column_[k])].exponent);
  if (largest == zero) return false;
  const double load = load_[row] * power_of_two(std::min(-largest, 0));
  sums = {largest, load, 0, load, 0, heat_[row].mantissa * power_of_two(heat_[row].exponent - largest)};
  for (std::size_t k = begin; k < end; ++k) {
    const auto c = static_cast<std::size_t>(column_[k]);
    const double x = entry_[k] * heat_[c].mantissa * power_of_two(heat_[c].exponent - largest);
    (c < row ? sums.before : sums.after) += x;
    (c < row ? sums.size_before : sums.size_after) += std::abs(x);
  }
  return true;
}

/// The load and the absolute contributions of the verts before this one, from their values at the beginning of the sweep.
CONCINO_INLINE heat_sweeps::value heat_sweeps::size_before(std::size_t row) const {
  using heat_sweep_values::power_of_two;
  const auto begin = static_cast<std::size_t>(begin_[row]), end = static_cast<std::size_t>(begin_[row + 1]);
  value r{0, load_[row] > 0 ? 0 : zero};
  for (std::size_t k = begin; k < end; ++k)
    if (const auto c = static_cast<std::size_t>(column_[k]); c < row) r.exponent = std::max(r.exponent, last_[c].exponent);
  if (r.exponent == zero) return r;
  r.mantissa = load_[row] * power_of_two(std::min(-r.exponent, 0));
  for (std::size_t k = begin; k < end; ++k)
    if (const auto c = static_cast<std::size_t>(column_[k]); c < row) r.mantissa += std::abs(entry_[k] * last_[c].mantissa) * power_of_two(last_[c].exponent - r.exponent);
  return r;
}

/// Sets a value to x 2^exponent.
CONCINO_INLINE void heat_sweeps::set(std::size_t row, double x, int exponent) {
  int e = 0;
  const double mantissa = std::frexp(x, &e);
  heat_[row] = mantissa == 0 ? value{} : value{mantissa, exponent + e};
}

/// The verts after this one are expected to change by the same factor as those before in their mean.
CONCINO_INLINE void heat_sweeps::sweep_outwards() {
  last_ = heat_;
  row_sums s;
  for (std::size_t i = 0; i < heat_.size(); ++i) {
    if (!sum_row(i, s)) continue;
    const value before = size_before(i);
    double factor = 1;
    if (s.size_before > 0 && before.mantissa > 0) factor = std::ldexp(s.size_before / before.mantissa, std::clamp(s.exponent - before.exponent, -1100, 1000));
    set(i, (s.before + factor * s.after) / diagonal_[i], s.exponent);
  }
}

CONCINO_INLINE double heat_sweeps::sweep_back() {
  double largest = 0;
  row_sums s;
  for (std::size_t i = heat_.size(); i-- > 0;) {
    if (!sum_row(i, s)) continue;
    const double d = diagonal_[i], sum = s.before + s.after, change = std::abs(sum - d * s.old) / (mass_[i] * ((s.size_before + s.size_after) / d + std::abs(s.old)));
    if (change > largest) largest = change;
    set(i, sum / d, s.exponent);
  }
  return largest;
}

CONCINO_INLINE bool heat_sweeps::run(double tolerance, int max_sweeps) {
  for (num_sweeps_ = 0; num_sweeps_ < max_sweeps;) {
    sweep_outwards();
    const double change = sweep_back();
    ++num_sweeps_;
    if (change <= tolerance) return true;
    if (num_sweeps_ >= 60 && change > 0.5) return false;
  }
  return false;
}

CONCINO_INLINE std::vector<double> heat_sweeps::log_heat() const {
  std::vector<double> r(order_.size(), -std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < order_.size(); ++i)
    if (const value& v = heat_[i]; v.mantissa > 0) r[static_cast<std::size_t>(order_[i])] = std::log(v.mantissa) + v.exponent * heat_sweep_values::log2;
  return r;
}

}  // namespace concino::detail
