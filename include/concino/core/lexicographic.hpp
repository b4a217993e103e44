// The lexicographic order of points: a choice among the verts of a poly that does not depend on the order in which
// these are stored.
#pragma once

#include <concino/core/vec3.hpp>

namespace concino::core {

/// Whether a comes before b by x, then by y, then by z. Points that are not finite have some place.
inline bool is_lexicographically_less(const vec3& a, const vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  return a.z < b.z;
}

}  // namespace concino::core
