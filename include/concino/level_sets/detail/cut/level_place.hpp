// Places on a level set in terms of the mesh, at a vert, on an edge, or on a diagonal of a polygon, and their numbers.
#pragma once

#include <concino/core/local_numbers.hpp>
#include <concino/core/vec3.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// A place between two verts, which is known by their numbers and by the element on which they lie.
struct level_place {
  enum kind_type : std::uint32_t { vert, edge, inside };
  kind_type kind;
  std::uint32_t element;       // of an edge or of a polygon; that of a vert is its number
  std::uint32_t below, above;  // verts; equal if the place is a vert

  friend bool operator==(const level_place&, const level_place&) = default;
};

/// Where a linear function has a value: 0 at the end with the value `below`, 1 at the one with the value `above`.
/// Needs:  below < level <= above; they may be infinite.      Result: in [0, 1].
inline double crossing_parameter(double below, double above, double level) {
  if (level == above) return 1;
  double t = (level - below) / (above - below);
  if (!std::isfinite(above - below)) {
    const bool starts_low = std::isinf(below), ends_high = std::isinf(above);
    t = starts_low && ends_high ? 0.5
        : starts_low            ? 1.0
        : ends_high             ? 0.0
                                : (0.5 * level - 0.5 * below) / (0.5 * above - 0.5 * below);
  }
  return t < 1 ? t : 1;
}

/// The point at a parameter from a to b. Coordinates in which a and b agree stay as they are.
inline vec3 crossing_point(const vec3& a, const vec3& b, double t) {
  if (t == 1) return b;
  const vec3 step = b - a;
  if (is_finite(step)) return a + t * step;
  return (1 - t) * a + t * b;
}

/// Places that are equal have one number; numbers are given in the order in which places come.
class place_numbers {
  core::local_numbers numbers_, ends_;

  std::size_t key(const level_place& x) {
    if (x.kind == level_place::vert) return x.element;
    if (x.kind == level_place::edge) return std::size_t{1} << 33 | x.element;
    // a diagonal is known by its ends and its face
    return std::size_t{2} << 33 | ends_.add(std::size_t{x.below} << 32 | x.above);
  }

 public:
  std::vector<level_place> places;

  std::uint32_t add(const level_place& x) {
    const unsigned number = numbers_.add(key(x));
    if (number == places.size()) places.push_back(x);
    return number;
  }
};

}  // namespace concino::detail
