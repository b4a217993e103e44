// Results and options of the queries of a poly_tree.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/core/vec3.hpp>

#include <limits>

namespace concino {

/// The nearest point: `point` of `poly`, at `distance`. Converts to false if there are no polys.
template<class M>
struct closest_hit {
  poly_t<M> poly{};
  vec3 point;
  double distance = std::numeric_limits<double>::infinity();
  bool found = false;

  explicit operator bool() const { return found; }
};

/// A hit of a ray with a poly at `point`, which is origin + parameter * direction up to rounding. Converts to false if
/// there is no hit.
template<class M>
struct crossing_hit {
  poly_t<M> poly{};
  vec3 point;
  double parameter = std::numeric_limits<double>::infinity();
  bool found = false;

  explicit operator bool() const { return found; }
};

struct ray_options {
  /// Where the ray ends, in lengths of its direction; 0 or more. A segment from a to b has the origin a, the direction
  /// b - a and the end 1.
  double max_parameter = std::numeric_limits<double>::infinity();
};

/// The rule by which a point is inside a closed surface.
enum class inside_rule {
  winding,  // signed winding number not 0: needs consistently oriented polygons; if closed parts overlap, all of them
            // is inside
  parity    // odd number of crossings on a path to the outside: any orientation is allowed; of two nested closed parts,
            // the inner one is hollow
};

struct inside_options {
  inside_rule rule = inside_rule::winding;  // for closed surfaces; ignored for volumes
};

}  // namespace concino
