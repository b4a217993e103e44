// singularities(field): where the directions of a field cannot agree, with an index; and turns along the boundary.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/directions/detail/surface/field_indices.hpp>
#include <concino/directions/direction_field.hpp>

#include <cstddef>
#include <vector>

namespace concino {

/// An element round which the directions of a field turn by index n-ths of a full turn: for 4 directions by quarters.
template<class X>
struct field_singularity {
  X element;
  int index = 0;  // not 0
};

/// A loop of boundary edges, by one of its edges, and how the field turns along it.
template<class M>
struct boundary_turn {
  edge_t<M> edge;
  int index = 0;  // of the tangent against the field, in n-ths of a full turn, with the surface on the left
};

/// The polys round which a field turns.
/// Needs:  a field of direction_field, and its mesh unchanged.
/// Result: polys in the order of polys(m), with the index of the field about each in n-ths of a full turn,
///         counter-clockwise. Along an edge a field turns by the smaller angle, at most half an n-th. On a closed
///         component the indices sum to n chi, where chi is the Euler characteristic; together with boundary_turns on
///         one with boundary. They do not depend on the order of storage or the size.
/// Cost:   O(corners).      Errors: none.
/// Source: Knoppel, Crane, Pinkall, Schroder 2013, "Globally optimal direction fields", section 5.
template<class M>
std::vector<field_singularity<poly_t<M>>> singularities(const direction_field_result<M>& field) {
  const detail::oriented_surface& s = field.surface();
  const auto index = detail::indices_of_polys(s, field.symmetry(), field.values());
  std::vector<field_singularity<poly_t<M>>> all;
  std::size_t i = 0;
  for (const poly_t<M> p : polys(field.mesh())) {
    if (index[i] != 0) all.push_back({p, index[i]});
    ++i;
  }
  return all;
}

/// How a field turns along each loop of the boundary.
/// Needs:  a field of direction_field, and its mesh unchanged.
/// Result: one for each loop, by its first edge in the order of polys: the turns of the tangent of the boundary
///         against the field, in n-ths of a full turn, along the loop with the surface on the left. For a field that
///         does not turn in a flat disk this is n; for one along a smooth boundary it is 0. With the indices of
///         singularities they sum to n chi on each component.
/// Cost:   O(corners).      Errors: none.
/// Source: the theorem of Poincare and Hopf, for surfaces with boundary.
template<class M>
std::vector<boundary_turn<M>> boundary_turns(const direction_field_result<M>& field) {
  const detail::oriented_surface& s = field.surface();
  const auto loops = detail::turns_of_loops(s, field.symmetry(), field.values());
  std::vector<boundary_turn<M>> all(loops.size());
  std::vector<std::size_t> loop_of(s.num_edges, loops.size());
  for (std::size_t k = 0; k < loops.size(); ++k) loop_of[loops[k].edge] = k;
  for (const edge_t<M> e : edges(field.mesh()))
    if (const std::size_t k = loop_of[index_of(field.mesh(), e)]; k < loops.size()) all[k] = {e, loops[k].index};
  return all;
}

// What to write instead of calls that cannot compile.
template<class... T> void singularities(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // pass the field: singularities(direction_field(m))

}  // namespace concino
