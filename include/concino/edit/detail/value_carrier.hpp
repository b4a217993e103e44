// value_carrier: the values of named properties follow an edit of simplices. Before the edit it finds the values of all elements that will be new or
// change, by the origins of each, and afterwards it writes them.
//
// Origins: a new poly comes from the old polys that the operator names, a new vert from the verts of the simplex in which it lies. An edge or face that
// has the new vert comes from the old one of which it is a part; one whose verts were merged from those that became it. Others have no origin, and get
// default values. Under the rule `sum`, what has no successor goes to the first element without an origin, and polys that vanish to a poly that stays.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/end_verts.hpp>
#include <concino/core/small_array.hpp>
#include <concino/core/vec3.hpp>
#include <concino/edit/proposed_edit.hpp>
#include <concino/mesh/carried_values.hpp>
#include <concino/mesh/property.hpp>

#include <algorithm>
#include <array>
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
  bool has(unsigned x) const { return std::find(v.begin(), v.begin() + std::min(n, 4u), x) != v.begin() + std::min(n, 4u); }
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
void for_each_part(const unsigned* corners, unsigned size, unsigned n, const F& f) {
  for (unsigned bits = 0; bits < 1u << size; ++bits) {
    simplex_key key;
    for (unsigned i = 0; i < size; ++i)
      if (bits >> i & 1) key.add(corners[i]);
    if (key.n == n) f(key);
  }
}

/// The old edges or faces of which a new one is a part, or which became it, with the size of the common part.
void find_origins(const edit_outline& e, const simplex_key& key, const std::vector<simplex_key>& old, core::small_array<origin, 4>& found);

/// The origins of the new polys. With `sums`, polys that vanish are origins of the first new poly with which they share a facet.
element_origins poly_origins(const edit_outline& e, const std::size_t* old_index, bool sums);

/// The origins of the corners of the new polys. first_corner: those of the old polys.
element_origins corner_origins(const edit_outline& e, const std::size_t* first_corner);

template<class M>
class value_carrier {
  /// Edges or faces.
  struct parts {
    unsigned n;
    element_kind kind;
    std::vector<simplex_key> old;
    std::vector<std::size_t> old_index;
    std::vector<simplex_key> changed;  // those with values to write
  };

  const edit_outline& e_;
  std::vector<vert_t<M>> verts_;         // by local number
  std::vector<std::size_t> vert_index_;  // in the mesh
  std::vector<std::size_t> poly_index_, first_corner_;
  std::vector<unsigned> changed_verts_;
  parts edges_{2, element_kind::edge, {}, {}, {}}, faces_{3, element_kind::face, {}, {}, {}};
  correspondence origins_, of_sums_;
  carried_values values_;

  unsigned local(std::size_t index) const {
    return static_cast<unsigned>(std::find(vert_index_.begin(), vert_index_.end(), index) - vert_index_.begin());
  }
  template<class Verts>
  simplex_key key_of(const M& m, const Verts& all, std::size_t new_vert = ~std::size_t{0}) const {
    simplex_key key;
    for (const vert_t<M> v : all) key.add(index_of(m, v) == new_vert ? edit_outline::added : local(index_of(m, v)));
    return key;
  }

  void add_origins_of_verts() {
    const auto add = [&](unsigned v, std::span<const origin> from) {
      changed_verts_.push_back(v);
      core::small_array<origin, 4> by_index;
      for (const origin x : from) by_index.push_back({static_cast<std::uint32_t>(vert_index_[x.index]), x.weight});
      origins_.verts.add({by_index.begin(), by_index.size()});
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

  void add_origins_of_parts(const M& m, parts& p, element_origins& from, element_origins& sums) {
    std::vector<unsigned char> has_successor(p.old.size(), 0);
    for (unsigned k = 0; k < e_.num_new; ++k)
      for_each_part(e_.new_corners + k * e_.size, e_.size, p.n, [&](const simplex_key& key) {
        if (std::find(p.changed.begin(), p.changed.end(), key) != p.changed.end() || exists_outside(m, p, key)) return;
        p.changed.push_back(key);
      });
    std::vector<std::vector<origin>> lists;
    for (const simplex_key& key : p.changed) {
      core::small_array<origin, 4> found;
      find_origins(e_, key, p.old, found);
      for (origin& x : found) has_successor[x.index] = 1;
      lists.emplace_back(found.begin(), found.end());
    }
    std::size_t lost = 0;
    for (const auto& list : lists) {
      std::vector<origin> by_index;
      for (const origin& x : list) by_index.push_back({static_cast<std::uint32_t>(p.old_index[x.index]), x.weight});
      from.add(std::span<const origin>(by_index));
      while (list.empty() && lost < p.old.size() && has_successor[lost]) ++lost;
      if (list.empty() && lost < p.old.size()) by_index.push_back({static_cast<std::uint32_t>(p.old_index[lost++]), 1});
      sums.add(std::span<const origin>(by_index));
    }
  }

  /// Whether the mesh has this edge or face, which is not one of the old polys.
  bool exists_outside(const M& m, const parts& p, const simplex_key& key) const {
    if (key.has(edit_outline::added) || std::find(p.old.begin(), p.old.end(), key) != p.old.end()) return false;
    for (const poly_t<M> q : adj_v2p(m, verts_[key.v[0]])) {
      bool all = true;
      for (unsigned i = 1; i < key.n; ++i) {
        bool found = false;
        for (const vert_t<M> v : adj_p2v(m, q)) found = found || index_of(m, v) == vert_index_[key.v[i]];
        all = all && found;
      }
      if (all) return true;
    }
    return false;
  }
  template<class Of>
  static void find_old(parts& p, const Of& all_of_poly) {
    all_of_poly([&](const simplex_key& key, std::size_t index) {
      if (std::find(p.old.begin(), p.old.end(), key) != p.old.end()) return;
      p.old.push_back(key);
      p.old_index.push_back(index);
    });
  }

  carried_values find(const M& m, const vert_t<M>* verts, unsigned num_verts, const poly_t<M>* polys) {
    const property_set& all = traits<M>::properties(m);
    verts_.assign(verts, verts + num_verts);
    for (const vert_t<M>& v : verts_) vert_index_.push_back(index_of(m, v));
    for (unsigned k = 0; k < e_.num_old; ++k) {
      poly_index_.push_back(index_of(m, polys[k]));
      first_corner_.push_back(traits<M>::first_corner(m, polys[k]));
    }
    if (all.has(element_kind::vert)) add_origins_of_verts();
    of_sums_.verts = origins_.verts;
    if (all.has(element_kind::poly)) origins_.polys = poly_origins(e_, poly_index_.data(), false), of_sums_.polys = poly_origins(e_, poly_index_.data(), true);
    if (all.has(element_kind::corner)) of_sums_.corners = origins_.corners = corner_origins(e_, first_corner_.data());
    if (all.has(element_kind::edge)) {
      find_old(edges_, [&](const auto& add) {
        for (unsigned k = 0; k < e_.num_old; ++k)
          for (const edge_t<M> x : adj_p2e(m, polys[k])) add(key_of(m, adj_e2v(m, x)), index_of(m, x));
      });
      add_origins_of_parts(m, edges_, origins_.edges, of_sums_.edges);
    }
    if constexpr (VolumeMesh<M>)  // surfaces have no faces
      if (all.has(element_kind::face)) {
        find_old(faces_, [&](const auto& add) {
          for (unsigned k = 0; k < e_.num_old; ++k)
            for (const face_t<M> x : adj_p2f(m, polys[k])) add(key_of(m, adj_f2v(m, x)), index_of(m, x));
        });
        add_origins_of_parts(m, faces_, origins_.faces, of_sums_.faces);
      }
    return carried_values(all, origins_, of_sums_);
  }

 public:
  value_carrier(const M& m, const edit_outline& e, const vert_t<M>* verts, unsigned num_verts, const poly_t<M>* polys)
      : e_(e), values_(find(m, verts, num_verts, polys)) {}

  /// Calls f(kind, index) for every element of the mesh before whose values write() may replace.
  template<class F>
  void for_each_replaced(const F& f) const {
    for (const unsigned v : changed_verts_)
      if (v != edit_outline::added) f(element_kind::vert, vert_index_[v]);
    for (const std::size_t p : poly_index_) f(element_kind::poly, p);
    for (const std::size_t c : first_corner_)
      for (unsigned i = 0; i < e_.size; ++i) f(element_kind::corner, c + i);
    for (const std::size_t x : edges_.old_index) f(element_kind::edge, x);
    for (const std::size_t x : faces_.old_index) f(element_kind::face, x);
  }

  /// After the edit: `polys` are the new ones.
  void write(const M& m, const vert_t<M>& new_vert, const poly_t<M>* polys) noexcept {
    const std::size_t fresh = e_.around.empty() ? ~std::size_t{0} : index_of(m, new_vert);
    for (std::size_t i = 0; i < changed_verts_.size(); ++i) values_.write(element_kind::vert, i, changed_verts_[i] == edit_outline::added ? fresh : vert_index_[changed_verts_[i]]);
    for (unsigned k = 0; k < e_.num_new; ++k) {
      values_.write(element_kind::poly, k, index_of(m, polys[k]));
      for (unsigned i = 0; i < e_.size; ++i) values_.write(element_kind::corner, k * e_.size + i, traits<M>::first_corner(m, polys[k]) + i);
      const auto write_part = [&](parts& p, const simplex_key& key, std::size_t index) {
        const auto at = std::find(p.changed.begin(), p.changed.end(), key);
        if (at == p.changed.end()) return;
        values_.write(p.kind, static_cast<std::size_t>(at - p.changed.begin()), index);
        *at = {};  // a value can be moved once only
      };
      if (!edges_.changed.empty())
        for (const edge_t<M> x : adj_p2e(m, polys[k])) write_part(edges_, key_of(m, adj_e2v(m, x), fresh), index_of(m, x));
      if constexpr (VolumeMesh<M>)  // surfaces have no faces
        if (!faces_.changed.empty())
          for (const face_t<M> x : adj_p2f(m, polys[k])) write_part(faces_, key_of(m, adj_f2v(m, x), fresh), index_of(m, x));
    }
  }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/edit/detail/value_carrier.ipp>
#endif
