// Whether the new polys of a general_cavity are polys, and differ from others.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/edit/detail/polys/general_cavity.hpp>
#include <concino/edit/detail/polys/general_proposal.hpp>
#include <concino/edit/permission.hpp>

#include <algorithm>
#include <vector>

namespace concino::detail {

inline constexpr permission list_too_short{refusal::degenerate, "a polygon or face would have fewer than three verts"};
inline constexpr permission list_with_vert_twice{refusal::degenerate, "a polygon or face would have a vert twice"};
inline constexpr permission too_few_faces{refusal::degenerate, "a polyhedron would have fewer than four faces"};
inline constexpr permission general_same_verts{
    refusal::same_verts, "an edge, face or poly would have the same verts as another one, or as one of the mesh"};
inline constexpr permission loose_face_at_element{
    refusal::loose_face, "a face without polys is at the element; remove_unreferenced(m) removes it"};

template<class M>
bool are_joined_by_edge(const M& m, const vert_t<M>& a, const vert_t<M>& b) {
  for (const vert_t<M> x : adj_v2v(m, a))
    if (x == b) return true;
  return false;
}

/// Whether a face without polys is at a vert or an edge.
template<class M, class Faces>
bool is_any_loose(const M& m, const Faces& all) {
  for (const face_t<M> f : all)
    if (num_elements(adj_f2p(m, f)) == 0) return true;
  return false;
}

inline bool has_repeated_vert(std::span<const unsigned> list) { return sorted_list(list).size() < list.size(); }

/// What the lists say by themselves.
template<class M>
permission check_lists(const general_cavity<M>& c) {
  const poly_lists& all = c.new_polys();
  std::vector<std::vector<unsigned>> faces;
  for (std::size_t k = 0; k < c.num_new(); ++k) {
    faces.clear();
    for (std::size_t i = all.first_list(k); i < all.last_list(k); ++i) {
      if (all.list(i).size() < 3) return list_too_short;
      if (has_repeated_vert(all.list(i))) return list_with_vert_twice;
      if constexpr (VolumeMesh<M>) faces.push_back(sorted_list(all.list(i)));  // a polygon is one list
    }
    if constexpr (VolumeMesh<M>) {  // a polygon has no faces
      if (faces.size() < 4) return too_few_faces;
      std::sort(faces.begin(), faces.end());
      if (std::adjacent_find(faces.begin(), faces.end()) != faces.end()) return general_same_verts;
    }
  }
  return {};
}

/// The sorted indices of verts, or none if one of them is new.
template<class M>
std::vector<std::size_t> indices_of(const general_cavity<M>& c, std::span<const unsigned> list) {
  std::vector<std::size_t> all;
  for (const unsigned v : list) {
    if (v >= c.new_vert) return {};
    all.push_back(index_of(c.mesh(), c.vert_at(v)));
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}
template<class M, class R>
bool has_these_verts(const M& m, const R& its_verts, const std::vector<std::size_t>& wanted) {
  std::vector<std::size_t> all;
  for (const vert_t<M> v : its_verts) {
    all.push_back(index_of(m, v));
    if (all.size() > 4 * wanted.size() + 4) return false;  // a poly of any size need not be read as a whole
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all == wanted;
}

/// Whether a new face that no old poly has has the verts of a face of the mesh.
template<class M>
bool has_known_face(const general_cavity<M>& c) {
  if constexpr (VolumeMesh<M>) {  // surfaces have no faces
    std::vector<std::vector<unsigned>> old;
    for (std::size_t i = 0; i < c.old_polys().num_lists(); ++i) old.push_back(sorted_list(c.old_polys().list(i)));
    std::sort(old.begin(), old.end());
    const poly_lists& all = c.new_polys();
    for (std::size_t i = 0; c.num_new() > 0 && i < all.last_list(c.num_new() - 1); ++i) {
      if (std::binary_search(old.begin(), old.end(), sorted_list(all.list(i)))) continue;
      const auto wanted = indices_of(c, all.list(i));
      if (wanted.empty()) continue;
      for (const face_t<M> f : adj_v2f(c.mesh(), c.vert_at(all.list(i)[0])))
        if (has_these_verts(c.mesh(), adj_f2v(c.mesh(), f), wanted)) return true;
    }
  }
  return false;
}

/// Whether a new poly has the verts of another new one, or of a poly that stays.
template<class M>
bool has_known_poly(const general_cavity<M>& c) {
  std::vector<std::vector<unsigned>> sets;
  for (std::size_t k = 0; k < c.num_new(); ++k) {
    sets.push_back(sorted_list(c.new_polys().corners_of(k)));
    const auto wanted = indices_of(c, sets.back());
    if (wanted.empty()) continue;
    for (const poly_t<M> p : adj_v2p(c.mesh(), c.vert_at(sets.back()[0])))
      if (c.find_poly(index_of(c.mesh(), p)) == c.none && has_these_verts(c.mesh(), adj_p2v(c.mesh(), p), wanted))
        return true;
  }
  std::sort(sets.begin(), sets.end());
  return std::adjacent_find(sets.begin(), sets.end()) != sets.end();
}

/// Whether the edit is allowed: its lists are polys that differ from all others, the library of m can represent them,
/// and the invariants hold.
template<class M>
permission allow_general(const std::vector<invariant>& keep, const general_cavity<M>& c) {
  if (const permission p = check_lists(c); !p) return p;
  if (has_known_face(c) || has_known_poly(c)) return general_same_verts;
  if (const permission p = c.is_representable(); !p) return p;
  return ask_general(keep, c);
}

}  // namespace concino::detail
