// What properties give values to, element_kind, and how values follow changes of the mesh, property_rule.
#pragma once

#include <string_view>

namespace concino {

/// What a property gives values to: the elements of a kind; `mesh`: the mesh as a whole, one value; `corner`: each vert
/// of each poly.
enum class element_kind { vert, edge, face, poly, mesh, corner };

/// The name of a kind of elements: "vert", "edge", "face", "poly", "mesh" or "corner".
/// Needs:  one of the kinds above.      Result: a text with static lifetime.      Cost: O(1).      Errors: none.
inline std::string_view to_string(element_kind k) {
  constexpr std::string_view names[] = {"vert", "edge", "face", "poly", "mesh", "corner"};
  return names[static_cast<unsigned>(k)];
}

/// How the value of a property at an element follows from the values at its origins, when elements are copied, split,
/// merged or interpolated. A pure copy has the value of its origin by the first two rules.
enum class property_rule {
  interpolate,  // the mean, weighted by the size of the common part: of numbers, vectors, arrays of numbers, colours
  copy,         // the value of the origin with the largest weight: of anything, such as names and labels
  sum,          // values are split and added, so that the sum over all elements does not change: masses, counts
};

/// The name of a rule: "interpolate", "copy" or "sum".
/// Needs:  one of the rules above.      Result: a text with static lifetime.      Cost: O(1).      Errors: none.
inline std::string_view to_string(property_rule r) {
  constexpr std::string_view names[] = {"interpolate", "copy", "sum"};
  return names[static_cast<unsigned>(r)];
}

}  // namespace concino
