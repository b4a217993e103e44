// The polygons of a surface that is repaired, as lists of numbers of verts, and what they were before.
#pragma once

#include <concino/core/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

struct surface_lists {
  static constexpr std::uint32_t none = ~0u;

  std::vector<vec3> points;
  std::vector<std::uint32_t> offsets{0}, verts;  // poly p has verts[offsets[p]] .. verts[offsets[p + 1] - 1]
  std::vector<std::uint32_t> poly_origin;        // by poly: its number before; none: it is new
  std::vector<std::uint32_t> vert_origin;        // by vert: the first vert before of its cluster; none: it is new
  std::vector<std::uint8_t> is_turned;           // by poly: it is wound the other way than before
  std::vector<std::uint32_t> cluster;            // by vert before: the first one of its cluster
  std::vector<std::vector<std::uint32_t>> of_new_verts;  // of each new vert, in their order: verts before around it

  std::size_t num_polys() const { return offsets.size() - 1; }
  std::span<std::uint32_t> poly(std::size_t p) { return {verts.data() + offsets[p], verts.data() + offsets[p + 1]}; }
  std::span<const std::uint32_t> poly(std::size_t p) const {
    return {verts.data() + offsets[p], verts.data() + offsets[p + 1]};
  }
  void add_poly(std::span<const std::uint32_t> list, std::uint32_t origin, std::uint8_t turned = 0) {
    verts.insert(verts.end(), list.begin(), list.end());
    offsets.push_back(static_cast<std::uint32_t>(verts.size()));
    poly_origin.push_back(origin);
    is_turned.push_back(turned);
  }
  std::uint32_t add_vert(const vec3& x, std::uint32_t origin) {
    points.push_back(x);
    vert_origin.push_back(origin);
    return static_cast<std::uint32_t>(points.size() - 1);
  }
  /// Removes the polys that are marked.
  void remove(const std::vector<std::uint8_t>& marked) {
    std::size_t kept = 0, end = 0;
    for (std::size_t p = 0, from = 0; p < marked.size(); ++p) {
      const std::size_t to = offsets[p + 1];
      if (!marked[p]) {
        while (from < to) verts[end++] = verts[from++];
        offsets[kept + 1] = static_cast<std::uint32_t>(end);
        poly_origin[kept] = poly_origin[p];
        is_turned[kept++] = is_turned[p];
      }
      from = to;
    }
    offsets.resize(kept + 1), verts.resize(end), poly_origin.resize(kept), is_turned.resize(kept);
  }
};

}  // namespace concino::detail
