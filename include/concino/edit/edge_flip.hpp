// Flips an edge between two triangles: it is replaced by the edge between the two verts opposite to it.
#pragma once

#include <concino/edit/detail/cavity_builder.hpp>

#include <concino/concepts/end_verts.hpp>

namespace concino {

namespace detail {

inline constexpr permission not_two_triangles{refusal::wrong_number, "the edge does not have two triangles"};
inline constexpr permission opposite_edge_exists{refusal::same_verts, "the two verts opposite to the edge are the same, or joined by an edge already"};
inline constexpr permission contradictory_winding{refusal::winding, "the two triangles at the edge run along it in the same direction"};

template<class M>
struct flip_cavity {
  cavity_builder<M> cavity;
  unsigned a = 0, b = 0, c = 0, d = 0;  // the ends of the edge, and the vert opposite to it in the first and in the second triangle

  explicit flip_cavity(const M& m) : cavity(m) {}
};

template<class M>
permission edge_flip_cavity(const M& m, const edge_t<M>& e, flip_cavity<M>& f) {
  const auto ends = end_verts(m, e);
  cavity_builder<M>& c = f.cavity;
  f.a = c.vert(ends.first), f.b = c.vert(ends.second);
  for (const poly_t<M> p : adj_e2p(m, e)) {
    if (c.num_old() == 2) return not_two_triangles;
    if (!c.add_old(p)) return not_simplices;
  }
  if (c.num_old() != 2) return not_two_triangles;
  const auto position = [&](unsigned k, unsigned v) { return static_cast<unsigned>(std::find(c.corners(k), c.corners(k) + 3, v) - c.corners(k)); };
  const auto is_along = [&](unsigned k) { return (position(k, f.a) + 1) % 3 == position(k, f.b); };
  f.c = c.corners(0)[3 - position(0, f.a) - position(0, f.b)];
  f.d = c.corners(1)[3 - position(1, f.a) - position(1, f.b)];
  if (is_along(0) == is_along(1)) return contradictory_winding;
  if (f.c == f.d) return opposite_edge_exists;
  for (const vert_t<M> v : adj_v2v(m, c.vert_at(f.c)))
    if (v == c.vert_at(f.d)) return opposite_edge_exists;
  c.add_new(0, f.b, f.d);
  c.add_new(1, f.a, f.c);
  c.keep(2);
  c.mix_origins();
  return {};
}

}  // namespace detail

/// Whether e can be flipped: it has two triangles, which are consistently oriented, and the verts opposite to it are not joined yet.
/// Needs:  EditableSurfaceMesh M, an edge of m.      Result: true, or the reason.
/// Cost:   the edges at an opposite vert.            Errors: invalid_mesh if e is not an edge of m.
template<EditableSurfaceMesh M>
permission can_edge_flip(const M& m, edge_t<M> e) {
  detail::check_element(m, e, "can_edge_flip", "edge");
  detail::flip_cavity<M> f(m);
  return detail::edge_flip_cavity(m, e, f);
}

/// Replaces e by the edge between the two verts opposite to it.
/// Needs:  EditableSurfaceMesh M.
/// Result: the new edge, or the reason why not. The triangle at the first end of e keeps the descriptor of the first triangle of adj_e2p, the other that of
///         the second. Other descriptors remain valid, apart from e.
/// Cost:   the elements at the verts of the triangles, but O(mesh) the first time.
/// Errors: invalid_mesh if e is not an edge of m. The mesh is unchanged then, also if memory runs out.
template<EditableSurfaceMesh M>
edge_result<M> edge_flip(M& m, edge_t<M> e) {
  detail::check_element(m, e, "edge_flip", "edge");
  detail::flip_cavity<M> f(m);
  if (const permission p = detail::edge_flip_cavity(m, e, f); !p) return {p, {}};
  f.cavity.apply(m);
  const vert_t<M> c = f.cavity.vert_at(f.c), d = f.cavity.vert_at(f.d);
  for (const edge_t<M> x : adj_v2e(m, c)) {
    const auto ends = end_verts(m, x);
    if (ends.first == d || ends.second == d) return {{}, x};
  }
  return {};
}

}  // namespace concino
