// Bodies of property_values.hpp: the values of named properties as numbers or texts.
#pragma once

#include <concino/render/detail/page/property_values.hpp>

#include <array>
#include <cstdint>
#include <utility>

namespace concino::detail {

/// Takes the values of a column of Ts, or of arrays of N of them.
template<class T, std::size_t N>
bool take_numbers(inspected_values& to, const column& from) {
  if (from.type() != typeid(T) && from.type() != typeid(std::array<T, N>)) return false;
  if (from.type() == typeid(T) && N > 1) return false;
  to.width = N;
  const T* const first = static_cast<const T*>(from.data());
  to.numbers.resize(from.size() * N);
  for (std::size_t i = 0; i < to.numbers.size(); ++i) to.numbers[i] = static_cast<double>(first[i]);
  return true;
}

template<class T>
bool take_numbers_or_arrays(inspected_values& to, const column& from) {
  return take_numbers<T, 1>(to, from) || take_numbers<T, 2>(to, from) || take_numbers<T, 3>(to, from) ||
         take_numbers<T, 4>(to, from) || take_numbers<T, 9>(to, from);
}

template<class... T>
bool take_any_numbers(inspected_values& to, const column& from) {
  return (take_numbers_or_arrays<T>(to, from) || ...);
}

/// Returns false if the values are of another type.
inline bool take_values_of_column(inspected_values& to, const column& from) {
  if (from.type() == typeid(vec3)) {
    to.width = 3;
    const vec3* const first = static_cast<const vec3*>(from.data());
    for (std::size_t i = 0; i < from.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) to.numbers.push_back(first[i][k]);
    return true;
  }
  if (from.type() == typeid(std::string)) {
    const std::string* const first = static_cast<const std::string*>(from.data());
    to.texts.assign(first, first + from.size());
    return true;
  }
  return take_any_numbers<double, float, int, bool, std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, unsigned,
                          long, unsigned long, long long, unsigned long long>(to, from);
}

/// The values with some numbers, in their order.
inline inspected_values chosen_values(const inspected_values& from, std::span<const std::size_t> numbers) {
  inspected_values to{from.name, from.at, from.width, {}, {}};
  for (const std::size_t i : numbers) {
    if (!from.texts.empty()) to.texts.push_back(from.texts[i]);
    else
      for (std::size_t k = 0; k < from.width; ++k) to.numbers.push_back(from.numbers[i * from.width + k]);
  }
  return to;
}

CONCINO_INLINE bool has_corner_properties(const property_set& all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all.kind(i) == element_kind::corner) return true;
  return false;
}

CONCINO_INLINE void add_properties(std::vector<inspected_values>& to, const property_set& all,
                                   std::span<const std::size_t> corners) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    inspected_values values{all.info(i).name, all.kind(i), 1, {}, {}};
    if (!take_values_of_column(values, *all.values(i))) continue;
    to.push_back(values.at == element_kind::corner ? chosen_values(values, corners) : std::move(values));
  }
}

}  // namespace concino::detail
