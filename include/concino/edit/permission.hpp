// Whether an edit is allowed, and what it has made.
#pragma once

#include <concino/concepts/mesh_traits.hpp>

#include <string_view>

namespace concino {

/// Why an edit is refused.
enum class refusal : unsigned char {
  none,            // it is allowed
  not_simplices,   // a poly at the element is not a triangle or a tet; a general polyhedron is none
  wrong_number,    // the element has another number of polys than the operator needs
  same_verts,      // an edge, face or poly on the new verts exists already
  link_condition,  // the mesh would no longer be of the same kind: two parts would touch, or a part would vanish
  wrong_set,       // the polys that an operator is given are not those that it needs
  winding,         // the polys at the element run in contradictory directions
  degenerate,      // a poly would have a vert twice, or too few of them
  loose_face,      // a face without polys is at the element
  invariant,       // a condition in the options does not hold afterwards
  unsupported,     // the library of the mesh cannot represent the result
};

/// The answer of can_edge_flip(m, e) and its siblings: true, or a reason. An edit that is refused changes nothing, and
/// returns the same answer.
struct permission {
  refusal reason = refusal::none;
  std::string_view why = {};  // a sentence; its text has static lifetime, or belongs to the caller's condition

  explicit constexpr operator bool() const { return reason == refusal::none; }
};

/// What an edit returns: a permission, and the vert or edge that it made, which is valid only if the edit was
/// allowed.
template<class M> struct vert_result : permission { vert_t<M> vert{}; };
template<class M> struct edge_result : permission { edge_t<M> edge{}; };

}  // namespace concino
