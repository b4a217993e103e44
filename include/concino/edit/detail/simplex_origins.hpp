// simplex_origins: from which elements those that an edit of simplices makes or changes come, for the values of named
// properties (edit_values.hpp).
//
// A new poly comes from the old polys that the operator names, a new vert from the verts of the simplex in which it
// lies. An edge or face that has the new vert comes from the old one of which it is a part; one whose verts were merged
// from those that became it. Others have no origin, and get default values. Under the rule `sum`, what has no successor
// goes to the first element without an origin, and polys that vanish to a poly that stays.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/core/small_array.hpp>
#include <concino/core/vec3.hpp>
#include <concino/edit/detail/edit_values.hpp>
#include <concino/edit/proposed_edit.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace concino::detail {

/// An edge or face by the local numbers of its verts, ascending.
struct simplex_key {
  std::array<unsigned, 4> v{~0u, ~0u, ~0u, ~0u};
  unsigned n = 0;

  void add(unsigned x) {
    if (has(x)) return;
    if (n < 4) v[n] = x;
    for (unsigned i = std::min(n, 3u); i > 0 && v[i] < v[i - 1]; --i) std::swap(v[i], v[i - 1]);
    ++n;
  }
  bool has(unsigned x) const {
    return std::find(v.begin(), v.begin() + std::min(n, 4u), x) != v.begin() + std::min(n, 4u);
  }
  friend bool operator==(const simplex_key&, const simplex_key&) = default;
};

/// What an operator knows of its edit, by local numbers of verts.
struct edit_outline {
  static constexpr unsigned none = ~0u, added = none - 1;  // `added` is the number of the new vert

  unsigned size = 0;                       // verts of a simplex
  unsigned num_old = 0, num_new = 0;       // polys
  const unsigned* old_corners = nullptr;   // of these, one poly after another
  const unsigned* new_corners = nullptr;
  const poly_origin* origins = nullptr;    // of new polys
  const double* old_measures = nullptr;
  const double* new_measures = nullptr;
  core::small_array<origin, 4> around;     // the verts of the simplex in which the new vert lies, and its weights
  unsigned remaining = none, removed = none;  // two verts that become one
  double at = 0;                           // where the remaining vert lies: (1 - at) * remaining + at * removed
};

/// The area of a triangle (size 3), or the volume of a tet (size 4).
double simplex_measure(const vec3* corners, unsigned size);

/// The edges (n = 2) or faces (n = 3) of a simplex.
template<class F>
void for_each_subsimplex(const unsigned* corners, unsigned size, unsigned n, const F& f) {
  for (unsigned bits = 0; bits < 1u << size; ++bits) {
    simplex_key key;
    for (unsigned i = 0; i < size; ++i)
      if (bits >> i & 1) key.add(corners[i]);
    if (key.n == n) f(key);
  }
}

/// The old edges or faces of which a new one is a part, or which became it, with the size of the common part.
void find_origins(const edit_outline& e, const simplex_key& key, const std::vector<simplex_key>& old,
                  core::small_array<origin, 4>& found);

/// The origins of the new polys. With `sums`, polys that vanish are origins of the first new poly with which they share
/// a facet.
element_origins poly_origins(const edit_outline& e, const std::size_t* old_index, bool sums);

/// The origins of the corners of the new polys. first_corner: those of the old polys.
element_origins corner_origins(const edit_outline& e, const std::size_t* first_corner);

/// Says where the values of an edit of simplices come from.
template<class M>
class simplex_origins {
  /// Edges or faces.
  struct edges_or_faces {
    unsigned n;
    element_kind kind;
    std::vector<simplex_key> old = {};
    std::vector<std::size_t> old_index = {};
  };

  const M& m_;
  const edit_outline& e_;
  const std::span<const vert_t<M>> verts_;  // by local number
  const std::span<const poly_t<M>> polys_;
  edit_values<M>& to_;
  std::vector<std::size_t> vert_index_, poly_index_, first_corner_;  // in the mesh

  std::span<const origin> with_indices(std::span<const origin> from, const std::vector<std::size_t>& index,
                                       std::vector<origin>& list) const {
    list.clear();
    for (const origin& x : from) list.push_back({static_cast<std::uint32_t>(index[x.index]), x.weight});
    return list;
  }

  void add_verts() {
    std::vector<origin> list;
    const auto add = [&](unsigned v, std::span<const origin> from) {
      with_indices(from, vert_index_, list);
      to_.add_vert(v, list, list);
    };
    if (e_.remaining != edit_outline::none) {
      const origin two[] = {{e_.remaining, 1 - e_.at}, {e_.removed, e_.at}};
      add(e_.remaining, two);
    } else if (!e_.around.empty()) {
      add(edit_outline::added, {e_.around.begin(), e_.around.size()});
      for (const origin x : e_.around) {
        const origin itself[] = {{x.index, 1}};
        add(x.index, itself);
      }
    }
  }
  void add_polys() {
    const element_origins from = poly_origins(e_, poly_index_.data(), false),
                          sums = poly_origins(e_, poly_index_.data(), true);
    std::vector<origin> a, b;
    for (unsigned k = 0; k < e_.num_new; ++k) {
      copy_origins(from[k], a), copy_origins(sums[k], b);
      to_.add_poly(a, b);
    }
  }
  void add_corners() {
    const element_origins from = corner_origins(e_, first_corner_.data());
    std::vector<origin> list;
    for (unsigned k = 0, i = 0; k < e_.num_new; ++k) {
      for (; i < (k + 1) * e_.size; ++i) {
        copy_origins(from[i], list);
        to_.add_corner(e_.new_corners[i], list);
      }
      to_.end_corners();
    }
  }

  template<class X, class Verts>
  void add_old(edges_or_faces& p, const X& x, const Verts& its_verts) {
    simplex_key key;
    for (const vert_t<M> v : its_verts)
      key.add(static_cast<unsigned>(std::find(verts_.begin(), verts_.end(), v) - verts_.begin()));
    if (std::find(p.old.begin(), p.old.end(), key) != p.old.end()) return;
    p.old.push_back(key);
    p.old_index.push_back(index_of(m_, x));
    to_.replaces(p.kind, p.old_index.back());
  }
  /// Whether the mesh has this edge or face, which is not one of the old polys.
  bool exists_outside(const edges_or_faces& p, const simplex_key& key) const {
    if (key.has(edit_outline::added) || std::find(p.old.begin(), p.old.end(), key) != p.old.end()) return false;
    for (const poly_t<M> q : adj_v2p(m_, verts_[key.v[0]])) {
      bool all = true;
      for (unsigned i = 1; i < key.n; ++i) {
        bool found = false;
        for (const vert_t<M> v : adj_p2v(m_, q)) found = found || v == verts_[key.v[i]];
        all = all && found;
      }
      if (all) return true;
    }
    return false;
  }
  void add_edges_or_faces(const edges_or_faces& p) {
    std::vector<simplex_key> changed;  // those with values to write
    for (unsigned k = 0; k < e_.num_new; ++k)
      for_each_subsimplex(e_.new_corners + k * e_.size, e_.size, p.n, [&](const simplex_key& key) {
        if (std::find(changed.begin(), changed.end(), key) == changed.end() && !exists_outside(p, key))
          changed.push_back(key);
      });
    std::vector<unsigned char> has_successor(p.old.size(), 0);
    std::vector<std::vector<origin>> lists;
    for (const simplex_key& key : changed) {
      core::small_array<origin, 4> found;
      find_origins(e_, key, p.old, found);
      for (const origin& x : found) has_successor[x.index] = 1;
      lists.emplace_back(found.begin(), found.end());
    }
    std::size_t lost = 0;
    std::vector<origin> from, sums;
    for (std::size_t i = 0; i < changed.size(); ++i) {
      with_indices(lists[i], p.old_index, from);
      sums = from;
      while (lists[i].empty() && lost < p.old.size() && has_successor[lost]) ++lost;
      if (lists[i].empty() && lost < p.old.size()) sums.push_back({static_cast<std::uint32_t>(p.old_index[lost++]), 1});
      to_.add_edge_or_face(p.kind, {changed[i].v.begin(), changed[i].v.begin() + p.n}, from, sums);
    }
  }

 public:
  simplex_origins(const M& m, const edit_outline& e, std::span<const vert_t<M>> verts, std::span<const poly_t<M>> polys,
                  edit_values<M>& to)
      : m_(m), e_(e), verts_(verts), polys_(polys), to_(to) {
    for (const vert_t<M>& v : verts) vert_index_.push_back(index_of(m, v));
    for (const poly_t<M>& p : polys) {
      poly_index_.push_back(index_of(m, p));
      first_corner_.push_back(traits<M>::first_corner(m, p));
      to.replaces(element_kind::poly, poly_index_.back());
      for (unsigned i = 0; i < e.size; ++i) to.replaces(element_kind::corner, first_corner_.back() + i);
    }
  }
  void add(const property_set& all) {
    if (all.has(element_kind::vert)) add_verts();
    if (all.has(element_kind::poly)) add_polys();
    if (all.has(element_kind::corner)) add_corners();
    if (all.has(element_kind::edge)) {
      edges_or_faces old{2, element_kind::edge};
      for (const poly_t<M>& p : polys_)
        for (const edge_t<M> x : adj_p2e(m_, p)) add_old(old, x, adj_e2v(m_, x));
      add_edges_or_faces(old);
    }
    if constexpr (VolumeMesh<M>)  // surfaces have no faces
      if (all.has(element_kind::face)) {
        edges_or_faces old{3, element_kind::face};
        for (const poly_t<M>& p : polys_)
          for (const face_t<M> x : adj_p2f(m_, p)) add_old(old, x, adj_f2v(m_, x));
        add_edges_or_faces(old);
      }
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/edit/detail/simplex_origins.ipp>
#endif
