// Finds parts of meshes, such as edges and faces, that have the same verts.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

namespace concino::detail {

/// Parts by their verts, at most 8. Each part may be added several times, by one number.
class verts_of_parts {
  struct part {
    std::array<std::uint32_t, 8> verts;  // sorted; unused ones are ~0
    std::uint32_t number;
  };
  std::vector<part> all_;

 public:
  /// Returns whether its verts are all different.
  bool add(const std::uint32_t* verts, std::size_t n, std::uint32_t number) {
    part& x = all_.emplace_back();
    x.verts.fill(~0u), x.number = number;
    std::copy_n(verts, n, x.verts.begin());
    std::sort(x.verts.begin(), x.verts.end());
    const auto last = x.verts.begin() + static_cast<std::ptrdiff_t>(n);
    return std::adjacent_find(x.verts.begin(), last) == last;
  }
  /// Whether two parts have the same verts.
  bool has_two_on_same_verts() {
    std::sort(all_.begin(), all_.end(),
              [](const part& a, const part& b) { return std::tie(a.verts, a.number) < std::tie(b.verts, b.number); });
    for (std::size_t i = 1; i < all_.size(); ++i)
      if (all_[i - 1].verts == all_[i].verts && all_[i - 1].number != all_[i].number) return true;
    return false;
  }
};

}  // namespace concino::detail
