// Recognises in which order the corners of a hex are listed, from its points.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/local_points.hpp>
#include <concino/mesh/corner_orders.hpp>

namespace concino::detail {

/// Whether the corners of hexes are listed in another order than the standard one: in the other order all corner angles
/// have the right orientation, in the standard order some do not.
class hex_order_checks {
  core::local_points local_;

  bool turns_right(const std::uint8_t* permutation) const {
    constexpr std::uint8_t next[8][3] = {{1, 3, 4}, {2, 0, 5}, {3, 1, 6}, {0, 2, 7},
                                         {7, 5, 0}, {4, 6, 1}, {5, 7, 2}, {6, 4, 3}};
    const auto at = [&](unsigned k) -> const vec3& { return local_.points[permutation[k]]; };
    for (unsigned k = 0; k < 8; ++k)
      if (!(dot(at(next[k][0]) - at(k), cross(at(next[k][1]) - at(k), at(next[k][2]) - at(k))) > local_.zero_volume(8)))
        return false;
    return true;
  }

 public:
  /// The order in which p seems to be listed; standard if it fits, or if no order fits.
  template<class M>
  hex_order operator()(const M& m, const poly_t<M>& p) {
    local_.points.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) local_.points.push_back(to_vec3(point(m, v)));
    if (local_.points.size() == 8 && local_.fit() && !turns_right(permutation_of(hex_order::standard)))
      for (const hex_order order : {hex_order::lexicographic, hex_order::mirrored, hex_order::mirrored_lexicographic})
        if (turns_right(permutation_of(order))) return order;
    return hex_order::standard;
  }
};

inline bool is_lexicographic(hex_order order) {
  return order == hex_order::lexicographic || order == hex_order::mirrored_lexicographic;
}

/// The name of an order, and how to read it.
inline const char* hex_order_remedy(hex_order order) {
  return order == hex_order::lexicographic
             ? "lexicographic order: read the lists with hex_order::lexicographic"
             : "mirrored lexicographic order: read the lists with hex_order::mirrored_lexicographic";
}

}  // namespace concino::detail
