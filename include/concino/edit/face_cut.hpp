// Cuts a face of polyhedra along a chord between two of its verts.
#pragma once

#include <concino/edit/face_merge.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace concino {

/// What face_cut has made, which is valid only if it was allowed: the edge, and the faces, of which the first one has
/// the verts from a on to b in the order of adj_f2v.
template<class M>
struct face_cut_result : permission {
  edge_t<M> edge{};
  std::array<face_t<M>, 2> faces{face_t<M>{}, face_t<M>{}};
};

namespace detail {

inline constexpr permission no_chord{refusal::wrong_set,
                                     "the ends of the chord are not two verts of it that are not neighbours"};

/// Cuts a cyclic list between a and b. Returns false if it lacks one of them, or they are neighbours.
inline bool cut_list(std::span<const unsigned> list, unsigned a, unsigned b,
                     std::array<std::vector<unsigned>, 2>& parts) {
  const auto i = static_cast<std::size_t>(std::find(list.begin(), list.end(), a) - list.begin());
  const auto j = static_cast<std::size_t>(std::find(list.begin(), list.end(), b) - list.begin());
  if (i == list.size() || j == list.size() || i == j) return false;
  const auto copy = [&](std::size_t first, std::size_t last, std::vector<unsigned>& to) {
    to.clear();
    for (std::size_t k = first;; k = k + 1 < list.size() ? k + 1 : 0) {
      to.push_back(list[k]);
      if (k == last) return to.size() > 2;
    }
  };
  return copy(i, j, parts[0]) && copy(j, i, parts[1]);
}

template<class M>
permission face_cut_cavity(const M& m, const face_t<M>& f, const vert_t<M>& a, const vert_t<M>& b,
                           general_cavity<M>& c, std::array<std::vector<vert_t<M>>, 2>& verts) {
  for (const poly_t<M> p : adj_f2p(m, f)) c.add_old(p);
  if (c.num_old() == 0) return loose_face_at_element;
  const unsigned from = c.vert(a), to = c.vert(b);
  std::array<std::vector<unsigned>, 2> parts;
  for (unsigned k = 0; k < c.num_old(); ++k) {
    for (std::size_t i = c.old_polys().first_list(k); i < c.old_polys().last_list(k); ++i) {
      if (!(c.face(i) == f)) {
        c.add_list(c.old_polys().list(i));
        continue;
      }
      if (!cut_list(c.old_polys().list(i), from, to, parts)) return no_chord;
      if (k == 0 && !face_is_outward(m, c.poly(0), f)) std::swap(parts[0], parts[1]);
      for (unsigned part = 0; part < 2; ++part) {
        c.add_list(parts[part]);
        for (const unsigned v : parts[part])
          if (k == 0) verts[part].push_back(c.vert_at(v));
      }
    }
    c.end_new(k);
  }
  return are_joined_by_edge(m, a, b) ? general_same_verts : permission{};
}

}  // namespace detail

/// Whether f can be cut between a and b: they are verts of it, not neighbours and not joined by an edge, no face has
/// the verts of a part already, and the invariants hold.
/// Needs:  EditableVolumeMesh M that is an EditableGeneralMesh, a face and verts of m.
/// Result: true, or the reason.      Cost: the polys at f, and the faces and polys at their verts.
/// Errors: as face_cut.
template<EditableVolumeMesh M>
  requires EditableGeneralMesh<M>
permission can_face_cut(const M& m, face_t<M> f, vert_t<M> a, vert_t<M> b, const edit_options& options = {}) {
  detail::check_element(m, f, "can_face_cut", "face");
  detail::check_element(m, a, "can_face_cut", "vert");
  detail::check_element(m, b, "can_face_cut", "vert");
  detail::general_cavity<M> c(m);
  std::array<std::vector<vert_t<M>>, 2> its_verts;
  if (const permission p = detail::face_cut_cavity(m, f, a, b, c, its_verts); !p) return p;
  return detail::allow_general(options.keep, c);
}

/// Cuts f along the chord between a and b. The shape of a face that is not plane changes.
/// Needs:  EditableVolumeMesh M that is an EditableGeneralMesh.
/// Result: the edge and the two faces, or the reason why not. Other descriptors remain valid, apart from that of f.
/// Cost:   that of can_face_cut, and the elements at the verts of the polys, but O(mesh) the first time.
/// Errors: invalid_mesh if f, a or b is not an element of m, and what an invariant throws. The mesh is unchanged then,
///         also if memory runs out.
template<EditableVolumeMesh M>
  requires EditableGeneralMesh<M>
face_cut_result<M> face_cut(M& m, face_t<M> f, vert_t<M> a, vert_t<M> b, const edit_options& options = {}) {
  detail::check_element(m, f, "face_cut", "face");
  detail::check_element(m, a, "face_cut", "vert");
  detail::check_element(m, b, "face_cut", "vert");
  detail::general_cavity<M> c(m);
  std::array<std::vector<vert_t<M>>, 2> its_verts;
  face_cut_result<M> r;
  static_cast<permission&>(r) = detail::face_cut_cavity(m, f, a, b, c, its_verts);
  if (r) static_cast<permission&>(r) = detail::allow_general(options.keep, c);
  if (!r) return r;
  typename detail::general_cavity<M>::prepared x;
  c.apply(m, x);
  r.edge = detail::edge_between_verts(m, a, b);
  for (unsigned i = 0; i < 2; ++i) r.faces[i] = detail::face_with_verts(m, x.polys.front(), its_verts[i]);
  return r;
}

// What to write instead of calls that cannot compile.
template<EditableVolumeMesh M, class... T>
  requires(arity_v<M> > 0)
void face_cut(const M&, const T&...) = delete;  // fixed number of faces: make m a polyhedralmesh

}  // namespace concino
