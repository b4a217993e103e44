// Merges two faces between the same two polys into one: the inverse of face_cut.
#pragma once

#include <concino/edit/edge_merge.hpp>
#include <concino/edit/detail/polys/list_topology.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace concino {

/// What an edit returns that makes a face: valid only if the edit was allowed.
template<class M> struct face_result : permission { face_t<M> face{}; };

namespace detail {

inline constexpr permission not_same_polys{refusal::wrong_set,
                                           "the faces are not two different ones of the same one or two polys"};
inline constexpr permission no_disk_of_faces{
    refusal::link_condition,
    "what the faces share is not one chain of edges, or is all of a boundary, or there is a third one inside"};

template<class M>
bool is_face_of(const M& m, const poly_t<M>& p, const face_t<M>& f) {
  for (const face_t<M> x : adj_p2f(m, p))
    if (x == f) return true;
  return false;
}

/// Whether the elements that vanish inside a union are at no other faces than f and g.
template<class M>
bool are_only_faces_inside(const general_cavity<M>& c, const merged_cycle& merged, const face_t<M>& f,
                           const face_t<M>& g) {
  const M& m = c.mesh();
  const auto are_these = [&](const auto& all) {
    for (const face_t<M> x : all)
      if (!(x == f) && !(x == g)) return false;
    return true;
  };
  for (const unsigned v : merged.inside)
    if (!are_these(adj_v2f(m, c.vert_at(v)))) return false;
  for (const auto& [a, b] : merged.removed)
    if (!are_these(adj_e2f(m, edge_between_verts(m, c.vert_at(a), c.vert_at(b))))) return false;
  return true;
}

template<class M>
permission face_merge_cavity(const M& m, const face_t<M>& f, const face_t<M>& g, general_cavity<M>& c,
                             std::vector<vert_t<M>>& verts) {
  if (f == g) return not_same_polys;
  for (const poly_t<M> p : adj_f2p(m, f)) {
    if (!is_face_of(m, p, g)) return not_same_polys;
    c.add_old(p);
  }
  if (c.num_old() == 0 || num_elements(adj_f2p(m, f)) != num_elements(adj_f2p(m, g))) return not_same_polys;
  for (unsigned k = 0; k < c.num_old(); ++k) {
    const poly_lists& old = c.old_polys();
    std::size_t at[2] = {};
    for (std::size_t i = old.first_list(k); i < old.last_list(k); ++i) {
      if (c.face(i) == f) at[0] = i;
      if (c.face(i) == g) at[1] = i;
    }
    const std::array<std::span<const unsigned>, 2> two{old.list(at[0]), old.list(at[1])};
    merged_cycle merged;
    if (const list_fault fault = merge_lists(two, merged); fault != list_fault::none)
      return fault == list_fault::winding ? permission{refusal::winding, "the faces run in contradictory directions"}
                                          : no_disk_of_faces;
    if (k == 0) {
      if (merged.removed.empty() || !are_only_faces_inside(c, merged, f, g)) return no_disk_of_faces;
      for (const unsigned v : merged.inside) c.remove(v);
      for (const unsigned v : merged.boundary) verts.push_back(c.vert_at(v));
    }
    for (std::size_t i = old.first_list(k); i < old.last_list(k); ++i)
      if (i == at[0]) c.add_list(merged.boundary);
      else if (i != at[1]) c.add_list(old.list(i));
    c.end_new(k);
  }
  return {};
}

/// The face of p with these verts.
template<class M>
face_t<M> face_with_verts(const M& m, const poly_t<M>& p, const std::vector<vert_t<M>>& its_verts) {
  for (const face_t<M> f : adj_p2f(m, p)) {
    std::size_t n = 0, found = 0;
    for (const vert_t<M> v : adj_f2v(m, f))
      ++n, found += std::find(its_verts.begin(), its_verts.end(), v) != its_verts.end();
    if (n == its_verts.size() && found == n) return f;
  }
  return face_t<M>{};
}

}  // namespace detail

/// Whether faces f and g can be merged. They have the same one or two polys. What they share is one chain of edges, not
/// a whole boundary, with no third face inside. Each poly keeps four faces, and the invariants hold.
/// Needs:  EditableVolumeMesh M that is an EditableGeneralMesh, faces of m.      Result: true, or the reason.
/// Cost:   the polys at f, and the faces and polys at their verts.      Errors: as face_merge.
template<EditableVolumeMesh M>
  requires EditableGeneralMesh<M>
permission can_face_merge(const M& m, face_t<M> f, face_t<M> g, const edit_options& options = {}) {
  detail::check_element(m, f, "can_face_merge", "face");
  detail::check_element(m, g, "can_face_merge", "face");
  detail::general_cavity<M> c(m);
  std::vector<vert_t<M>> its_verts;
  if (const permission p = detail::face_merge_cavity(m, f, g, c, its_verts); !p) return p;
  return detail::allow_general(options.keep, c);
}

/// Merges f and g into one face, across all edges that they share. Volumes change where the two are not in one plane.
/// Needs:  EditableVolumeMesh M that is an EditableGeneralMesh.
/// Result: the new face, or the reason why not. Other descriptors remain valid, apart from those of f and g, of the
///         edges that they share and of verts inside.
/// Cost:   that of can_face_merge, and the elements at the verts of the polys, but O(mesh) the first time.
/// Errors: invalid_mesh if f or g is not a face of m, and what an invariant throws. The mesh is unchanged then, also if
///         memory runs out.
template<EditableVolumeMesh M>
  requires EditableGeneralMesh<M>
face_result<M> face_merge(M& m, face_t<M> f, face_t<M> g, const edit_options& options = {}) {
  detail::check_element(m, f, "face_merge", "face");
  detail::check_element(m, g, "face_merge", "face");
  detail::general_cavity<M> c(m);
  std::vector<vert_t<M>> its_verts;
  if (const permission p = detail::face_merge_cavity(m, f, g, c, its_verts); !p) return {p};
  if (const permission p = detail::allow_general(options.keep, c); !p) return {p};
  typename detail::general_cavity<M>::prepared x;
  c.apply(m, x);
  return {{}, detail::face_with_verts(m, x.polys.front(), its_verts)};
}

// What to write instead of calls that cannot compile.
template<EditableVolumeMesh M, class... T>
  requires(arity_v<M> > 0)
void face_merge(const M&, const T&...) = delete;  // fixed number of faces: make m a polyhedralmesh

}  // namespace concino
