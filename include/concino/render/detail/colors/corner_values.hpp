// The polygons of a drawable that belong to each poly of its mesh, and their corners.
#pragma once

#include <concino/render/drawable.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// of[i] are the polygons of a drawable that belong to the poly with index i.
class polygons_of_polys {
  std::vector<std::uint32_t> first_, polygons_;

 public:
  polygons_of_polys(const drawable& d, std::size_t poly_index_bound)
      : first_(poly_index_bound + 1, 0), polygons_(d.polys.size()) {
    for (const std::uint32_t p : d.polys) ++first_[p + 1];
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < d.polys.size(); ++i) polygons_[next[d.polys[i]]++] = static_cast<std::uint32_t>(i);
  }
  std::span<const std::uint32_t> operator[](std::size_t poly) const {
    return {polygons_.data() + first_[poly], polygons_.data() + first_[poly + 1]};
  }
};

/// Calls found(c, i) for each corner c of a polygon whose vert is verts[i]. Fast if the corners have the order of
/// `verts`.
template<class F>
void for_each_corner(const drawable& d, std::uint32_t polygon, std::span<const std::uint32_t> verts, F&& found) {
  std::size_t at = 0;
  for (std::uint32_t c = d.offsets[polygon]; c < d.offsets[polygon + 1]; ++c) {
    const std::uint32_t vert = d.verts[d.corners[c]];
    std::size_t tried = 0;
    while (tried < verts.size() && verts[at] != vert) at = at + 1 < verts.size() ? at + 1 : 0, ++tried;
    if (tried < verts.size()) found(c, at);
  }
}

}  // namespace concino::detail
