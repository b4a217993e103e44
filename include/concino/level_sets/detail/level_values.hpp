// The values of level sets that a caller gives: one number or several.
#pragma once

#include <concino/core/compiled.hpp>

#include <concepts>
#include <type_traits>
#include <vector>

namespace concino {

namespace requirement {

/// One value or several.
template<class V>
concept is_value_list = std::is_arithmetic_v<V> || requires(const V& values) {
  { *values.begin() } -> std::convertible_to<double>;
  values.end();
};

}  // namespace requirement

namespace detail {

/// The values in ascending order, each once.
/// Errors: invalid_argument if one is NaN.
std::vector<double> sort_levels(std::vector<double> levels, const char* caller);

template<class V>
std::vector<double> sorted_levels(const V& values, const char* caller) {
  std::vector<double> all;
  if constexpr (std::is_arithmetic_v<V>) {
    all.push_back(static_cast<double>(values));
  } else {
    for (const auto& x : values) all.push_back(static_cast<double>(x));
  }
  return sort_levels(std::move(all), caller);
}

}  // namespace detail

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/level_values.ipp>
#endif
