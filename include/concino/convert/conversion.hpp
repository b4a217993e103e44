// The result of convert_with_correspondence(): a mesh, and the correspondence between its elements and those of the
// original.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/element_origins.hpp>

#include <cassert>
#include <concepts>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

namespace detail {

/// face_t<M> if M is a volume, otherwise a type that nothing converts to.
template<class M>
struct face_if_any {
  struct type {};
};
template<class M>
  requires(dimension_v<M> == 3)
struct face_if_any<M> { using type = face_t<M>; };

}  // namespace detail

/// A converted mesh with its correspondence to the original, which is valid as long as neither mesh is changed. The
/// original must stay in place; if it is a view, a copy of the view is stored.
template<class To, class From>
class conversion {
  using source_face = typename detail::face_if_any<From>::type;
  using face = typename detail::face_if_any<To>::type;

  vert_map<From, vert_t<To>> verts_;
  poly_map<From, poly_t<To>> polys_;
  std::vector<std::uint32_t> faces_;  // by index of a face: its number in the new mesh, if the new mesh numbers faces
                                      // as they were passed

  /// By index of an element of the new mesh: the index of the corresponding element of the original.
  template<class R, class Of>
  element_origins origins(const R& elements, std::size_t bound, const Of& of) const {
    std::vector<std::uint32_t> source(bound, element_origins::none);
    for (const auto x : elements) source[index_of(mesh, of(x))] = static_cast<std::uint32_t>(index_of(from(), x));
    return element_origins(std::move(source));
  }

 public:
  To mesh;

  conversion(To result, vert_map<From, vert_t<To>> vert_names, poly_map<From, poly_t<To>> poly_names,
             std::vector<std::uint32_t> face_numbers = {})
      : verts_(std::move(vert_names)), polys_(std::move(poly_names)), faces_(std::move(face_numbers)),
        mesh(std::move(result)) {}

  const From& from() const { return verts_.mesh(); }
  const vert_t<To>& vert_of(const vert_t<From>& v) const { return verts_[v]; }
  const poly_t<To>& poly_of(const poly_t<From>& p) const { return polys_[p]; }

  /// The edge of the new mesh that corresponds to e. Searches the edges at one of its verts.      Cost: O(number of
  /// edges there).
  edge_t<To> edge_of(const edge_t<From>& e) const {
    const auto ends = end_verts(from(), e);
    const vert_t<To> a = vert_of(ends.first), b = vert_of(ends.second);
    for (const edge_t<To> x : adj_v2e(mesh, a)) {
      const auto found = end_verts(mesh, x);
      if (found.first == b || found.second == b) return x;
    }
    assert(false && "every edge of a mesh is an edge of what it was converted to");
    return edge_t<To>();
  }

  /// The face of the new mesh that corresponds to f. Unless the numbers of faces are known, searches the faces at one
  /// of its verts for one with the same verts.      Cost: O(number of faces there).
  face face_of(const source_face& f) const
    requires(dimension_v<From> == 3)
  {
    if constexpr (std::constructible_from<face, std::uint32_t>)
      if (!faces_.empty()) return face(faces_[index_of(from(), f)]);
    std::vector<vert_t<To>> wanted;
    for (const vert_t<From> v : adj_f2v(from(), f)) wanted.push_back(vert_of(v));
    for (const face x : adj_v2f(mesh, wanted[0])) {
      std::size_t found_verts = 0, n = 0;
      for (const vert_t<To> v : adj_f2v(mesh, x)) {
        ++n;
        for (const vert_t<To>& w : wanted) found_verts += w == v;
      }
      if (n == wanted.size() && found_verts == n) return x;
    }
    assert(false && "every face of a mesh is a face of what it was converted to");
    return face();
  }

  /// The origins of the elements of the new mesh, for one kind or for all kinds.
  element_origins vert_origins() const {
    return origins(verts(from()), vert_index_bound(mesh), [&](const auto& x) { return vert_of(x); });
  }
  element_origins edge_origins() const {
    return origins(edges(from()), edge_index_bound(mesh), [&](const auto& x) { return edge_of(x); });
  }
  element_origins face_origins() const {
    // Surfaces have no faces.
    if constexpr (dimension_v<From> == 3)
      return origins(faces(from()), face_index_bound(mesh), [&](const auto& x) { return face_of(x); });
    else return {};
  }
  element_origins poly_origins() const {
    return origins(polys(from()), poly_index_bound(mesh), [&](const auto& x) { return poly_of(x); });
  }
  concino::correspondence correspondence() const {
    return {vert_origins(), edge_origins(), face_origins(), poly_origins()};
  }

  /// Copies values to a map on the new mesh: to[vert_of(v)] = from_map[v] for all verts, or the same for edges, faces
  /// or polys if `from_map` is a map on these.
  template<class A, class B>
    requires(ReadableMap<A, vert_t<From>>)
  void transfer(const A& from_map, B&& to) const {
    for (const vert_t<From> v : verts(from())) to[vert_of(v)] = from_map[v];
  }
  template<class A, class B>
    requires(ReadableMap<A, edge_t<From>>)
  void transfer(const A& from_map, B&& to) const {
    for (const edge_t<From> e : edges(from())) to[edge_of(e)] = from_map[e];
  }
  template<class A, class B>
    requires(ReadableMap<A, source_face>)
  void transfer(const A& from_map, B&& to) const {
    for (const source_face f : faces(from())) to[face_of(f)] = from_map[f];
  }
  template<class A, class B>
    requires(ReadableMap<A, poly_t<From>>)
  void transfer(const A& from_map, B&& to) const {
    for (const poly_t<From> p : polys(from())) to[poly_of(p)] = from_map[p];
  }
};

}  // namespace concino
