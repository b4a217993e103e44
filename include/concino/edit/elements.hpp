// Adding and removing verts, faces and polys. The other elements keep their descriptors, so descriptors, maps and
// properties remain valid; indices of removed elements become gaps. An edit that fails leaves a mesh of this library,
// its adjacencies and its properties unchanged, even if memory ran out (std::bad_alloc) or a property's default value
// threw.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/edit/transaction.hpp>

#include <algorithm>
#include <cassert>
#include <initializer_list>
#include <span>
#include <string>
#include <vector>

namespace concino {

namespace requirement {

template<class M> concept has_add_vert = requires(std::remove_cvref_t<M>& m, vec3 x) {
  { traits<M>::add_vert(m, x) } -> std::convertible_to<vert_t<M>>;
};
template<class M> concept has_remove_vert = requires(std::remove_cvref_t<M>& m, vert_t<M> v) {
  traits<M>::remove_vert(m, v);
};
template<class M> concept has_add_poly = requires(std::remove_cvref_t<M>& m, std::span<const vert_t<M>> corners) {
  { traits<M>::add_poly(m, corners) } -> std::convertible_to<poly_t<M>>;
};
template<class M> concept has_add_face = requires(std::remove_cvref_t<M>& m, std::span<const vert_t<M>> corners) {
  { traits<M>::add_face(m, corners) } -> std::convertible_to<face_t<M>>;
};
template<class M>
concept has_add_poly_of_faces = requires(std::remove_cvref_t<M>& m, std::span<const face_t<M>> faces,
                                         std::span<const unsigned char> outward) {
  { traits<M>::add_poly(m, faces, outward) } -> std::convertible_to<poly_t<M>>;
};
template<class M> concept has_remove_face = requires(std::remove_cvref_t<M>& m, face_t<M> f) {
  traits<M>::remove_face(m, f);
};
template<class M> concept has_remove_poly = requires(std::remove_cvref_t<M>& m, poly_t<M> p) {
  traits<M>::remove_poly(m, p);
};

}  // namespace requirement

/// Adds a vert at x, without edges.
/// Needs:  a mesh whose traits have add_vert. Maps made before have no value for the new vert.
/// Result: its descriptor. Properties get a default value for it.
/// Cost:   O(1), but O(verts) the first time.
/// Errors: none of its own.
template<requirement::has_add_vert M>
vert_t<M> add_vert(M& m, const vec3& x) {
  return traits<M>::add_vert(m, x);
}

/// Adds a poly on verts of m: in cyclic order in surfaces, in the standard order for tets and hexes. Existing edges and
/// faces are shared, missing ones are added.
/// Needs:  a mesh whose traits have add_poly for verts.
/// Result: its descriptor. Properties get default values for the new elements.
/// Cost:   the elements at its verts, but O(mesh) the first time.
/// Errors: invalid_mesh if there are too few or too many verts, a repeated vert, or one that is not in m, or if the
///         library of m cannot link the poly; m is unchanged then. unsupported if m would have more than 2^32
///         adjacencies of one kind.
template<requirement::has_add_poly M>
poly_t<M> add_poly(M& m, std::span<const vert_t<M>> corners) {
  return traits<M>::add_poly(m, corners);
}
template<requirement::has_add_poly M>
poly_t<M> add_poly(M& m, std::initializer_list<vert_t<M>> corners) {
  return traits<M>::add_poly(m, std::span<const vert_t<M>>(corners.begin(), corners.size()));
}

/// Adds a face on verts of a mesh of general polyhedra, from which a poly can be built. Existing edges are shared; a
/// second face on the same verts is a different face.
/// Needs:  a mesh whose traits have add_face; verts in cyclic order.
/// Result: its descriptor; it has no poly yet. Properties get default values for the new elements.
/// Cost:   the elements at its verts, but O(mesh) the first time.
/// Errors: invalid_mesh if there are less than three verts, a repeated vert, or one that is not in m; m is unchanged
///         then. unsupported as add_poly.
template<requirement::has_add_face M>
face_t<M> add_face(M& m, std::span<const vert_t<M>> corners) {
  return traits<M>::add_face(m, corners);
}
template<requirement::has_add_face M>
face_t<M> add_face(M& m, std::initializer_list<vert_t<M>> corners) {
  return traits<M>::add_face(m, std::span<const vert_t<M>>(corners.begin(), corners.size()));
}

/// Adds a polyhedron of faces of m, each with a flag whether its verts run counter-clockwise seen from outside the
/// polyhedron.
/// Needs:  a mesh whose traits have add_poly for faces. validate(m) checks whether the faces close the poly and the
///         flags are right.
/// Result: its descriptor. Properties get default values for the new elements.
/// Cost:   at most the square of the corners of its faces, and the elements at these, but O(mesh) the first time.
/// Errors: invalid_mesh if there is no face, a repeated face, or one that is not in m; m is unchanged then. unsupported
///         as add_poly of verts.
template<requirement::has_add_poly_of_faces M>
poly_t<M> add_poly(M& m, std::initializer_list<std::pair<face_t<M>, bool>> face_list) {
  std::vector<face_t<M>> list;
  std::vector<unsigned char> outward;
  for (const auto& [f, out] : face_list) list.push_back(f), outward.push_back(out);
  return traits<M>::add_poly(m, std::span<const face_t<M>>(list), std::span<const unsigned char>(outward));
}

/// Removes p, and the edges and faces that belong to nothing else; verts stay.
/// Needs:  a mesh whose traits have remove_poly.
/// Result: none; other elements keep their descriptors.
/// Cost:   the elements at its verts, but O(mesh) the first time.
/// Errors: invalid_mesh if p is not a poly of m.
template<requirement::has_remove_poly M>
void remove_poly(M& m, poly_t<M> p) {
  if (!contains(m, p))
    core::throw_joined<invalid_mesh>(
        {"remove_poly: poly ", index_of(m, p), " cannot be removed: it is not a poly of the mesh"});
  traits<M>::remove_poly(m, p);
}

namespace detail {

/// The strong exception guarantee: if the traits have reserve_removal(m, polys), it allocates the memory for removing
/// these polys, and faces and verts, before the first one is removed.
template<class M>
void reserve_removal(M& m, const std::vector<poly_t<M>>& polys) {
  if constexpr (requires { traits<M>::reserve_removal(m, std::span<const poly_t<M>>(polys)); })
    traits<M>::reserve_removal(m, std::span<const poly_t<M>>(polys));
}

/// Removes the polys of a surface at v, and v, at once.
template<class M>
void remove_polys_and_vert(M& m, const std::vector<poly_t<M>>& polys, const vert_t<M>& v) {
  std::vector<vert_t<M>> all;
  for (const poly_t<M>& p : polys)
    for (const vert_t<M> x : adj_p2v(m, p))
      if (!(x == v)) all.push_back(x);
  std::sort(all.begin(), all.end(),
            [&](const vert_t<M>& a, const vert_t<M>& b) { return index_of(m, a) < index_of(m, b); });
  all.erase(std::unique(all.begin(), all.end()), all.end());
  all.push_back(v);
  rewire(m,
         cavity<M>{.polys = {polys.data(), polys.data() + polys.size()},
                   .verts = {all.data(), all.data() + all.size()},
                   .removed = 1},
         cavity_result<M>{});
}

}  // namespace detail

/// Removes f, after the polys at it. Edges that have no other face are removed too; verts stay.
/// Needs:  a volume whose traits have remove_poly, and remove_face if faces without polys can exist.
/// Result: none; other elements keep their descriptors.
/// Cost:   that of removing the polys at f one after another.
/// Errors: invalid_mesh if f is not a face of m.
template<requirement::has_remove_poly M>
  requires VolumeMesh<M>
void remove_face(M& m, face_t<M> f) {
  if (!contains(m, f))
    core::throw_joined<invalid_mesh>(
        {"remove_face: face ", index_of(m, f), " cannot be removed: it is not a face of the mesh"});
  std::vector<poly_t<M>> at_face;
  for (const auto& p : adj_f2p(m, f)) at_face.push_back(p);
  detail::reserve_removal(m, at_face);
  detail::edit_in_steps(m, [&] {
    for (const auto& p : at_face) traits<M>::remove_poly(m, p);
    if constexpr (requirement::has_remove_face<M>)
      if (contains(m, f)) traits<M>::remove_face(m, f);
  });
}

/// Removes v and the polys at it. The edit has the strong exception guarantee in an EditableSurfaceMesh, or if the
/// traits have reserve_removal(m, polys).
/// Needs:  a mesh whose traits have remove_vert and remove_poly.
/// Result: none; other elements keep their descriptors.
/// Cost:   that of removing the polys at v one after another.
/// Errors: invalid_mesh if v is not a vert of m.
template<requirement::has_remove_vert M>
  requires requirement::has_remove_poly<M>
void remove_vert(M& m, vert_t<M> v) {
  if (!contains(m, v))
    core::throw_joined<invalid_mesh>(
        {"remove_vert: vert ", index_of(m, v), " cannot be removed: it is not a vert of the mesh"});
  std::vector<poly_t<M>> around;
  for (const auto& p : adj_v2p(m, v)) around.push_back(p);
  // in volumes a removed vert may have faces without polys
  if constexpr (EditableSurfaceMesh<M>) return detail::remove_polys_and_vert(m, around, v);
  detail::reserve_removal(m, around);
  detail::edit_in_steps(m, [&] {
    for (const auto& p : around) traits<M>::remove_poly(m, p);
    traits<M>::remove_vert(m, v);
  });
}

}  // namespace concino
