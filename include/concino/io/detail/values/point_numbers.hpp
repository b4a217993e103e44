// Numbers points in the order in which they occur first; equal points have one number.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/core/hash_bytes.hpp>
#include <concino/core/vec3.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

class point_numbers {
  static constexpr std::uint32_t free_slot = ~0u;
  std::vector<vec3>& points_;
  std::vector<std::uint32_t> table_ = std::vector<std::uint32_t>(64, free_slot);  // of numbers, by their hashes; the
                                                                                  // size is a power of two

  /// -0 and 0 are equal, so they have the same hash.
  static std::uint64_t hash(const vec3& p) {
    std::uint64_t h = 0;
    for (const double x : {p.x, p.y, p.z}) h = core::scrambled(h ^ std::bit_cast<std::uint64_t>(x + 0.0));
    return h;
  }
  /// Where the point is, or can be put.
  std::size_t slot_of(const vec3& p) const {
    std::size_t at = hash(p) & (table_.size() - 1);
    while (table_[at] != free_slot && !(points_[table_[at]] == p)) at = (at + 1) & (table_.size() - 1);
    return at;
  }
  void grow() {
    table_.assign(2 * table_.size(), free_slot);
    for (std::uint32_t i = 0; i < points_.size(); ++i) table_[slot_of(points_[i])] = i;
  }

 public:
  /// The points that were numbered are appended to `points`, which are none at first.
  explicit point_numbers(std::vector<vec3>& points) : points_(points) {}

  /// Needs: finite coordinates, and less than 2^32 - 1 different points.
  vert_id operator()(const vec3& p) {
    if (2 * points_.size() >= table_.size()) grow();
    const std::size_t at = slot_of(p);
    if (table_[at] == free_slot) {
      table_[at] = static_cast<std::uint32_t>(points_.size());
      points_.push_back(p);
    }
    return vert_id{table_[at]};
  }
};

}  // namespace concino::detail
