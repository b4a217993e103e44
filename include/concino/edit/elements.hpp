// Adding and removing verts and polys. No element but the removed ones changes its name, so descriptors, maps and properties stay right;
// indices of removed elements are left as gaps. An edit that fails leaves a mesh of this library, its adjacencies and its properties as they
// were, also where memory ran out (std::bad_alloc) or a property's default value threw.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>

#include <cassert>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace concino {

namespace requirement {

template<class M> concept has_add_vert = requires(std::remove_cvref_t<M>& m, vec3 x) { { traits<M>::add_vert(m, x) } -> std::convertible_to<vert_t<M>>; };
template<class M> concept has_remove_vert = requires(std::remove_cvref_t<M>& m, vert_t<M> v) { traits<M>::remove_vert(m, v); };
template<class M> concept has_add_poly =
    requires(std::remove_cvref_t<M>& m, std::span<const vert_t<M>> corners) { { traits<M>::add_poly(m, corners) } -> std::convertible_to<poly_t<M>>; };
template<class M> concept has_add_face =
    requires(std::remove_cvref_t<M>& m, std::span<const vert_t<M>> corners) { { traits<M>::add_face(m, corners) } -> std::convertible_to<face_t<M>>; };
template<class M> concept has_add_poly_of_faces = requires(std::remove_cvref_t<M>& m, std::span<const face_t<M>> faces, std::span<const unsigned char> outward) {
  { traits<M>::add_poly(m, faces, outward) } -> std::convertible_to<poly_t<M>>;
};
template<class M> concept has_remove_poly = requires(std::remove_cvref_t<M>& m, poly_t<M> p) { traits<M>::remove_poly(m, p); };

}  // namespace requirement

/// A new vert at x, without edges.
/// Needs:  a mesh whose traits offer add_vert. Maps made before do not know the new vert.
/// Result: its descriptor. Properties grow by a default value.
/// Cost:   O(1), but O(verts) the first time.
/// Errors: none of its own.
template<requirement::has_add_vert M>
vert_t<M> add_vert(M& m, const vec3& x) {
  return traits<M>::add_vert(m, x);
}

/// A new poly on verts of m: cyclic order in surfaces, the standard order for tets and hexes. Edges and faces that are there are shared,
/// the others are made.
/// Needs:  a mesh whose traits offer add_poly of verts.
/// Result: its descriptor. Properties grow by default values.
/// Cost:   the elements at its verts, but O(mesh) the first time.
/// Errors: invalid_mesh if there are too few or too many verts, one twice, or one that is not in m, or if the library that m is of cannot link the
///         poly; m is unchanged then. unsupported if m would have more than 2^32 adjacencies of one kind.
template<requirement::has_add_poly M>
poly_t<M> add_poly(M& m, std::span<const vert_t<M>> corners) {
  return traits<M>::add_poly(m, corners);
}
template<requirement::has_add_poly M>
poly_t<M> add_poly(M& m, std::initializer_list<vert_t<M>> corners) {
  return traits<M>::add_poly(m, std::span<const vert_t<M>>(corners.begin(), corners.size()));
}

/// A new face on verts of a mesh of general polyhedra, to build a poly from. Edges that are there are shared; a second face on the same verts is
/// another face.
/// Needs:  a mesh whose traits offer add_face; verts in cyclic order.
/// Result: its descriptor; it is of no poly yet. Properties grow by default values.
/// Cost:   the elements at its verts, but O(mesh) the first time.
/// Errors: invalid_mesh if there are less than three verts, one twice, or one that is not in m; m is unchanged then. unsupported as add_poly.
template<requirement::has_add_face M>
face_t<M> add_face(M& m, std::span<const vert_t<M>> corners) {
  return traits<M>::add_face(m, corners);
}
template<requirement::has_add_face M>
face_t<M> add_face(M& m, std::initializer_list<vert_t<M>> corners) {
  return traits<M>::add_face(m, std::span<const vert_t<M>>(corners.begin(), corners.size()));
}

/// A new polyhedron of faces of m, each with whether its verts run counter-clockwise seen from outside it.
/// Needs:  a mesh whose traits offer add_poly of faces. Whether the faces close the poly and the flags are right, validate(m) says.
/// Result: its descriptor. Properties grow by default values.
/// Cost:   at most the square of the corners of its faces, and the elements at these, but O(mesh) the first time.
/// Errors: invalid_mesh if there is no face, one twice, or one that is not in m; m is unchanged then. unsupported as add_poly of verts.
template<requirement::has_add_poly_of_faces M>
poly_t<M> add_poly(M& m, std::initializer_list<std::pair<face_t<M>, bool>> face_list) {
  std::vector<face_t<M>> list;
  std::vector<unsigned char> outward;
  for (const auto& [f, out] : face_list) list.push_back(f), outward.push_back(out);
  return traits<M>::add_poly(m, std::span<const face_t<M>>(list), std::span<const unsigned char>(outward));
}

/// Takes p away, and with it the edges and faces that nothing else has; verts stay.
/// Needs:  a mesh whose traits offer remove_poly.
/// Result: none; no other element changes its name.
/// Cost:   the elements at its verts, but O(mesh) the first time.
/// Errors: invalid_mesh if p is not a poly of m.
template<requirement::has_remove_poly M>
void remove_poly(M& m, poly_t<M> p) {
  if (!contains(m, p)) core::throw_joined<invalid_mesh>({"poly ", index_of(m, p), " cannot be removed: it is not a poly of the mesh"});
  traits<M>::remove_poly(m, p);
}

/// Takes v away and the polys at it first. All or nothing: where the traits offer reserve_removal(m, polys), they find the memory for taking
/// these polys and verts away before the first goes.
/// Needs:  a mesh whose traits offer remove_vert and remove_poly.
/// Result: none; no other element changes its name.
/// Cost:   that of removing the polys at v one after another.
/// Errors: invalid_mesh if v is not a vert of m.
template<requirement::has_remove_vert M>
  requires requirement::has_remove_poly<M>
void remove_vert(M& m, vert_t<M> v) {
  if (!contains(m, v)) core::throw_joined<invalid_mesh>({"vert ", index_of(m, v), " cannot be removed: it is not a vert of the mesh"});
  std::vector<poly_t<M>> around;
  for (const auto& p : adj_v2p(m, v)) around.push_back(p);
  if constexpr (requires { traits<M>::reserve_removal(m, std::span<const poly_t<M>>(around)); }) traits<M>::reserve_removal(m, std::span<const poly_t<M>>(around));
  for (const auto& p : around) traits<M>::remove_poly(m, p);
  traits<M>::remove_vert(m, v);
}

}  // namespace concino
