// Texture coordinates and normals of the corners of OBJ files, which list the values and then name them at the corners.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/io/file_contents.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>
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

  /// Adds the property of all corners to the contents, if one of them has a value. Returns the number of values that no corner has.
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

/// Numbers the distinct values of corners in the order of their first occurrence, for a writer. Values are equal if their bytes are.
template<class T>
class distinct_corner_values {
  std::vector<T> values_;
  std::vector<std::uint32_t> slots_;  // hash table with open addressing, at most half full: 0 or number + 1

  static std::uint64_t hash(const T& x) {
    std::uint64_t words[sizeof(T) / 8], h = 0;
    std::memcpy(words, &x, sizeof(T));
    for (std::uint64_t w : words) {
      h = (h ^ w) * 0x9e3779b97f4a7c15u;
      h ^= h >> 29;
    }
    return h ^ (h >> 32);
  }
  std::size_t slot_of(const T& x) const {
    std::size_t at = hash(x) & (slots_.size() - 1);
    while (slots_[at] != 0 && std::memcmp(&values_[slots_[at] - 1], &x, sizeof(T)) != 0) at = (at + 1) & (slots_.size() - 1);
    return at;
  }

 public:
  const std::vector<T>& values() const { return values_; }
  std::uint32_t add(const T& x) {
    if (2 * (values_.size() + 1) > slots_.size()) {
      slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), 0);
      for (std::uint32_t i = 0; i < values_.size(); ++i) slots_[slot_of(values_[i])] = i + 1;
    }
    std::uint32_t& slot = slots_[slot_of(x)];
    if (slot == 0) {
      values_.push_back(x);
      slot = static_cast<std::uint32_t>(values_.size());
    }
    return slot - 1;
  }
};

}  // namespace concino::detail
