// What a tree over the polys of a mesh answers, and what it can be told.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/core/vec3.hpp>

#include <limits>

namespace concino {

/// What is nearest to a point: `point` of `poly`, at `distance`. False where there are no polys.
template<class M>
struct closest_hit {
  poly_t<M> poly{};
  vec3 point;
  double distance = std::numeric_limits<double>::infinity();
  bool found = false;

  explicit operator bool() const { return found; }
};

/// Where a ray meets a poly: at `point`, which is origin + parameter * direction but for rounding. False where it meets none.
template<class M>
struct crossing_hit {
  poly_t<M> poly{};
  vec3 point;
  double parameter = std::numeric_limits<double>::infinity();
  bool found = false;

  explicit operator bool() const { return found; }
};

struct ray_options {
  /// Where the ray ends, in lengths of its direction; 0 or more. A segment from a to b has the origin a, the direction b - a and the end 1.
  double max_parameter = std::numeric_limits<double>::infinity();
};

/// When a point is inside of a closed surface.
enum class inside_rule {
  winding,  // the surface winds round it, counted with sign: needs polygons that are wound alike; where closed parts overlap, all is inside
  parity    // a way out crosses the surface an odd number of times: any winding will do; of two closed parts in each other, the inner one is hollow
};

struct inside_options {
  inside_rule rule = inside_rule::winding;  // for closed surfaces; volumes do not ask
};

}  // namespace concino
