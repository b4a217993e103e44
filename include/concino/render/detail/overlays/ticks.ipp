// Bodies of ticks.hpp: round numbers along an axis or a legend, and their texts.
#pragma once

#include <concino/render/detail/overlays/ticks.hpp>
#include <concino/render/detail/text/font.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace concino::detail {

inline int decimal_exponent(double x) {
  return x == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(x)) + 1e-9));
}

/// A number with `decimals` digits after the point, and a minus sign as long as the plus sign.
inline std::string fixed_text(double x, int decimals) {
  char buffer[400];
  char* const end =
      std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::fixed, std::max(0, decimals)).ptr;
  const std::string_view digits(buffer, static_cast<std::size_t>(end - buffer));
  const bool zero = digits.find_first_of("123456789") == std::string_view::npos;
  if (digits[0] != '-') return std::string(digits);
  std::string text = zero ? "" : "−";
  return text += digits.substr(1);
}

/// Without zeros at the end of a fraction.
inline std::string without_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.resize(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

inline std::string scientific_text(double x, int step_exponent) {
  if (x == 0) return "0";
  static constexpr const char* superscripts[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const int exponent = decimal_exponent(x), decimals = std::max(0, exponent - step_exponent);
  // The power of ten in two factors, as those below 1e-308 lose digits.
  std::string text =
      without_zeros(fixed_text(x / std::pow(10.0, exponent / 2) / std::pow(10.0, exponent - exponent / 2), decimals));
  if (text == "1") text = "10";
  else if (text == "−1") text = "−10";
  else text += "·10";
  if (exponent < 0) text += "⁻";
  for (const char c : std::to_string(std::abs(exponent))) text += superscripts[c - '0'];
  return text;
}

CONCINO_INLINE std::vector<tick> with_texts(const std::vector<double>& values, double step) {
  const int step_exponent = decimal_exponent(step);
  std::vector<tick> result, scientific;
  std::size_t length = 0, scientific_length = 0;
  const auto longest = [](std::size_t& n, const std::string& s) {
    n = std::max(n, characters_of(s.data(), s.size()).size());
  };
  for (const double x : values) {
    result.push_back({x, fixed_text(x, -step_exponent)});
    if (values.size() == 1) result[0].text = without_zeros(result[0].text);
    scientific.push_back({x, scientific_text(x, step_exponent)});
    longest(length, result.back().text);
    longest(scientific_length, scientific.back().text);
  }
  return length <= 6 || length <= scientific_length ? result : scientific;
}

/// The smallest of 1, 2, 5, 10 ... times a power of 10 that is at least x.
inline double round_step(double x) {
  const double power = std::pow(10.0, std::floor(std::log10(x)));
  for (const double m : {1.0, 2.0, 5.0})
    if (x <= m * power * (1 + 1e-9)) return m * power;
  return 10 * power;
}

/// The multiples of a step in [low, high], ends included where rounding would miss them.
inline std::vector<double> multiples(double low, double high, double step) {
  std::vector<double> values;
  const double first = std::ceil(low / step - 1e-6), last = std::floor(high / step + 1e-6);
  if (!(last - first < 1000)) return values;
  for (double k = first; k <= last; ++k) values.push_back(std::min(std::max(k * step, low), high));
  return values;
}

CONCINO_INLINE std::vector<tick> round_ticks(double low, double high, int count) {
  if (!std::isfinite(low) || !std::isfinite(high)) return {};
  const double part = high / count - low / count;  // the difference may overflow
  const double size = std::max(std::abs(low), std::abs(high));
  // Numbers that differ in their last digits only, and equal ones, are one tick, with six digits.
  if (!(part > size * 1e-12) || !std::isfinite(std::pow(10.0, decimal_exponent(part) + 1)) || part < 1e-300)
    return with_texts({low / 2 + high / 2},
                      size > 1e-300 ? std::pow(10.0, std::max(decimal_exponent(size) - 5, -300)) : 1);
  const double step = round_step(part), finer = round_step(0.4 * step);
  const std::vector<double> few = multiples(low, high, step), many = multiples(low, high, finer);
  const auto miss = [&](const std::vector<double>& values) {
    return std::abs(static_cast<double>(values.size()) - count);
  };
  return few.size() >= 2 && miss(few) <= miss(many) ? with_texts(few, step) : with_texts(many, finer);
}

CONCINO_INLINE std::vector<tick> round_ticks(const value_scale& scale, int count) {
  const double low = scale.low(), high = scale.high();
  const auto value_between = [&](double t) { return low * (1 - t) + high * t; };
  bool linear = true;
  for (const double t : {0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875})
    linear &= std::abs(scale(value_between(t)) - t) < 1e-6;
  if (linear || !(high > low)) return round_ticks(low, high, count);

  const auto value_at = [&](double position) {
    double a = 0, b = 1;
    for (int k = 0; k < 60; ++k) (scale(value_between((a + b) / 2)) < position ? a : b) = (a + b) / 2;
    return value_between((a + b) / 2);
  };
  std::vector<tick> ticks;
  for (int k = 0; k <= count; ++k) {
    // The roundest number between the values a fifth of a step before and behind
    const double part = 1.0 / count, at = k * part, a = value_at(std::max(0.0, at - part / 5)),
                 b = value_at(std::min(1.0, at + part / 5));
    if (!(b - a > 1e-12 * std::max(std::abs(a), std::abs(b)))) continue;
    const double power = std::pow(10.0, decimal_exponent(b - a));
    for (const double m : {10.0, 5.0, 2.0, 1.0}) {
      const std::vector<double> inside = multiples(a, b, m * power);
      if (inside.empty()) continue;
      ticks.push_back(with_texts({inside[inside.size() / 2]}, m * power)[0]);
      break;
    }
  }
  return ticks;
}

}  // namespace concino::detail
