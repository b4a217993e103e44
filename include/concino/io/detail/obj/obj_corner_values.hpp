// Texture coordinates and normals of the corners of OBJ files, which list the values and then name them at the corners.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/io/file_contents.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace concino::detail {

using texture_point = std::array<double, 2>;

/// The value of corners that have none in a file: not-a-number in all its parts.
template<class T>
T no_corner_value() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if constexpr (std::is_same_v<T, vec3>) return {nan, nan, nan};
  else return {nan, nan};
}
inline bool is_finite(const texture_point& t) { return std::isfinite(t[0]) && std::isfinite(t[1]); }
inline bool is_no_corner_value(const texture_point& t) { return std::isnan(t[0]) && std::isnan(t[1]); }
inline bool is_no_corner_value(const vec3& n) { return std::isnan(n.x) && std::isnan(n.y) && std::isnan(n.z); }

/// Collects values and the corners that have them, for a reader.
template<class T>
class corner_value_list {
  static constexpr std::uint32_t none = ~0u;
  std::vector<T> values_;
  std::vector<std::uint32_t> index_;  // of the value of each corner; those at the end may be missing

 public:
  std::size_t size() const { return values_.size(); }
  void reserve(std::size_t values, std::size_t corners) {
    values_.reserve(values);
    index_.reserve(corners);
  }
  void add(const T& x) { values_.push_back(x); }
  /// Sets the value of a corner, by its index. Corners come in order.
  void set(std::size_t corner, std::uint64_t i) {
    if (index_.size() < corner) index_.resize(corner, none);
    index_.push_back(static_cast<std::uint32_t>(i));
  }
  void clear() {
    values_.clear();
    index_.clear();
  }

  /// Adds the property of all corners to the contents, if one of them has a value. Returns the number of values that no
  /// corner has.
  std::size_t store(std::string_view property, std::size_t corners, file_contents& out) {
    std::vector<bool> used(values_.size());
    std::size_t num_used = 0;
    if (!index_.empty()) {
      T* const all = out.add_property<T>(element_kind::corner, property, corners);
      for (std::size_t c = 0; c < corners; ++c) {
        const std::uint32_t i = c < index_.size() ? index_[c] : none;
        all[c] = i == none ? no_corner_value<T>() : values_[i];
        if (i != none && !used[i]) used[i] = true, ++num_used;
      }
    }
    const std::size_t unused = values_.size() - num_used;
    *this = {};
    return unused;
  }
};

/// Numbers the distinct values of corners in the order of their first occurrence, for a writer. Values are equal if
/// their bytes are.
template<class T>
class distinct_corner_values {
  struct byte_hash {
    std::size_t operator()(const std::array<char, sizeof(T)>& x) const {
      return std::hash<std::string_view>()({x.data(), x.size()});
    }
  };
  std::vector<T> values_;
  std::unordered_map<std::array<char, sizeof(T)>, std::uint32_t, byte_hash> numbers_;  // by the bytes of a value

 public:
  const std::vector<T>& values() const { return values_; }
  std::uint32_t add(const T& x) {
    const auto [at, is_new] =
        numbers_.try_emplace(std::bit_cast<std::array<char, sizeof(T)>>(x), static_cast<std::uint32_t>(values_.size()));
    if (is_new) values_.push_back(x);
    return at->second;
  }
};

}  // namespace concino::detail
