// Transfers values and properties from one mesh to a mesh that was made of it, by the correspondence of their elements.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/message.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/detail/properties/match_elements.hpp>
#include <concino/mesh/element_origins.hpp>
#include <concino/mesh/property.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace concino {

/// The origins of copied elements: the n-th element of the new mesh is a copy of the n-th of `sources`, which are
/// elements of the mesh before.
/// Needs:  index_of(before, x) for each source.      Result: one origin for each.      Cost: O(sources).      Errors:
///         none.
template<class M, class X>
element_origins origins_of(const M& before, const std::vector<X>& sources) {
  std::vector<std::uint32_t> single;
  single.reserve(sources.size());
  for (const X& x : sources) single.push_back(static_cast<std::uint32_t>(index_of(before, x)));
  return element_origins(std::move(single));
}

namespace detail {

void check_origins(element_kind kind, const element_origins& origins, std::size_t bound_before,
                   std::size_t bound_after);
void check_origins(const correspondence& c, const property_set& properties, const index_bounds& before,
                   const index_bounds& after);

}  // namespace detail

/// Finds the origins of edges and faces from those of their verts, if c does not have them. The origin of an edge is
/// the edge between the origins of its ends; the origin of a face is the face around the origins of its verts. Half of
/// an edge has half of it as weight; parts of a face have equal weights.
/// Needs:  AnyMesh both, of the same dimension; c.verts for each vert of m.
/// Result: c.edges, and in volumes c.faces, if they were empty. New edges and faces in the interior of old polys have
///         no origin. Nor have edges whose verts do not have exactly two origins, and faces whose verts have fewer than
///         three. Removed verts are no origins.
/// Cost:   O(elements), times the edges or faces at a vert.
/// Errors: invalid_argument if c.verts is for another number of verts, or has an origin that is out of range in the
///         mesh before.
template<AnyMesh From, AnyMesh To>
  requires(dimension_v<From> == dimension_v<To>)
void match_edges_and_faces(const From& before, const To& m, correspondence& c) {
  detail::check_origins(element_kind::vert, c.verts, vert_index_bound(before), vert_index_bound(m));
  const detail::elements_by_index<vert_t<From>> by_index(before, verts(before), vert_index_bound(before));
  if (c.edges.size() == 0) c.edges = detail::match_edges(before, m, c.verts, by_index);
  if constexpr (dimension_v<To> == 3)  // surfaces have no faces
    if (c.faces.size() == 0) c.faces = detail::match_faces(before, m, c.verts, by_index);
}

/// Transfers values at the elements of the mesh before to those of the new mesh: heat_of_new = transfer_values(c.verts,
/// heat.values(), property_rule::interpolate).
/// Needs:  from[i] of every origin i; T with a mean (interpolate) or with a sum (sum), as for properties.
/// Result: a value for each element of the new mesh by index; T() for those without origin.
/// Cost:   O(elements and origins).
/// Errors: invalid_argument if an origin has no value, or T does not allow the rule.
template<class T>
std::vector<std::remove_const_t<T>> transfer_values(const element_origins& origins, std::span<T> from,
                                                    property_rule rule) {
  using value = std::remove_const_t<T>;
  detail::column source(detail::values_of<value>, from.size());
  std::copy(from.begin(), from.end(), static_cast<value*>(source.data()));
  if (!source.set_rule(rule))
    core::throw_joined<invalid_argument>(
        {"transfer_values: values of this type do not allow the rule \"", to_string(rule), "\""});
  for (std::size_t i = 0; i < origins.size(); ++i)
    for (const origin x : origins[i])
      if (x.index >= from.size())
        core::throw_joined<invalid_argument>({"transfer_values: element ", i, " was made of element ", x.index,
                                              ", but there are ", from.size(), " values"});
  const detail::column taken(source, origins);
  const value* const first = static_cast<const value*>(taken.data());
  return {first, first + taken.size()};
}

/// Transfers all named properties of one mesh to another that was made of it, each by its rule (set_property_rule), and
/// those of the mesh as a whole.
/// Needs:  a mesh of this library, or a view of one that has its properties; m, of the same dimension, of this library;
///         c, the origins of m. c may omit edges and faces: they follow from the verts. It may omit corners too: the
///         origins of a corner are corners of the origins of its poly, at the origins of its vert.
/// Result: m has these properties; one of the same kind and name is replaced. Elements without origin have a default
///         value.
/// Cost:   O(elements and origins) for each property; that of match_edges_and_faces if there are properties of edges or
///         faces.
/// Errors: invalid_argument if c does not fit the meshes; m is unchanged then.
template<ShowsProperties From, HasProperties To>
  requires AnyMesh<From> && AnyMesh<To> && (dimension_v<From> == dimension_v<To>)
void transfer_properties(const From& before, To& m, const correspondence& c) {
  const property_set& source = traits<From>::properties(before);
  correspondence complete;
  const auto lacks = [&](element_kind kind, const element_origins& origins) {
    return source.has(kind) && origins.size() == 0;
  };
  const bool lacks_corners = lacks(element_kind::corner, c.corners);
  const bool has_all = !lacks_corners && !lacks(element_kind::edge, c.edges) && !lacks(element_kind::face, c.faces);
  if (!has_all) {
    complete = c;
    match_edges_and_faces(before, m, complete);
    if constexpr (NumbersCorners<From> && NumbersCorners<To>)
      if (lacks_corners) {
        detail::check_origins(element_kind::poly, c.polys, poly_index_bound(before), poly_index_bound(m));
        complete.corners = detail::match_corners(before, m, c.verts, c.polys);
      }
  }
  const correspondence& used = has_all ? c : complete;
  detail::index_bounds from{vert_index_bound(before), edge_index_bound(before), 0, poly_index_bound(before)};
  detail::index_bounds to{vert_index_bound(m), edge_index_bound(m), 0, poly_index_bound(m)};
  if constexpr (NumbersCorners<From> && NumbersCorners<To>)
    from.corners = traits<From>::corner_index_bound(before), to.corners = traits<To>::corner_index_bound(m);
  // surfaces have no faces
  if constexpr (dimension_v<To> == 3) from.faces = face_index_bound(before), to.faces = face_index_bound(m);
  detail::check_origins(used, source, from, to);
  traits<To>::properties(m).transfer(source, used);
}

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/mesh/detail/properties/correspondence.ipp>
#endif
