// edit_values: the values of named properties follow an edit. Before it, the operator says from which elements the new
// and changed ones come; the values are found then, by the rule of each property. After it they are written, which
// needs no memory.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/support/carried_values.hpp>

#include <algorithm>
#include <compare>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace concino {

/// A vert that an edit removes, and the one that takes its place: an existing one, or a new one. Both have the numbers
/// that the operator gives them.
struct replaced_vert {
  unsigned vert, by;

  friend auto operator<=>(const replaced_vert&, const replaced_vert&) = default;
};

namespace detail {

/// Models whose named properties follow the edits.
template<class M> concept carries_values = HasProperties<M> && requires(const M& m, poly_t<M> p) {
  traits<M>::first_corner(m, p);
};

inline void copy_origins(const auto& from, std::vector<origin>& to) {
  to.clear();
  for (const origin x : from) to.push_back(x);
}

/// Verts have numbers: existing ones 0, 1, 2, ... in the order that the operator gives, new ones consecutive numbers
/// from `first_new` on. Edges and faces are known by the numbers of their verts.
template<class M>
class edit_values {
 public:
  using key = std::vector<unsigned>;  // sorted numbers of verts
  using origin_list = std::span<const origin>;
  static constexpr std::size_t nowhere = ~std::size_t{0};

 private:
  struct edge_or_face {
    std::size_t number, stays_at;
    bool is_written = false;
  };
  using edge_or_face_map = std::map<key, edge_or_face>;

  core::local_numbers numbers_;  // of existing verts
  const unsigned first_new_;
  std::vector<std::size_t> new_index_;                       // of new verts, after the edit
  std::vector<std::pair<std::size_t, unsigned>> new_verts_;  // the same, with their numbers, sorted
  std::vector<unsigned> changed_verts_;
  std::vector<unsigned> corner_verts_;                       // of the new polys, one after another
  std::vector<std::size_t> corner_ends_;
  edge_or_face_map edges_, faces_;
  std::vector<std::pair<element_kind, std::size_t>> replaced_;
  correspondence origins_, of_sums_;
  key scratch_;
  std::optional<carried_values> values_;

  unsigned number_after(std::size_t index) const {
    if (const unsigned i = numbers_.find(index); i != core::local_numbers::none) return i;
    return std::lower_bound(new_verts_.begin(), new_verts_.end(), std::pair{index, 0u})->second;
  }
  void write_edge_or_face(element_kind kind, edge_or_face& x, std::size_t index) {
    if (!std::exchange(x.is_written, true)) values_->write(kind, x.number, index);  // a value can be moved once only
  }
  template<class Verts>
  void write_edge_or_face(const M& m, element_kind kind, edge_or_face_map& all, std::size_t index,
                          const Verts& its_verts) {
    scratch_.clear();
    for (const vert_t<M> v : its_verts) {
      if (scratch_.size() == scratch_.capacity()) return;  // larger than all that have values
      scratch_.push_back(number_after(index_of(m, v)));
    }
    std::sort(scratch_.begin(), scratch_.end());
    const auto at = all.find(scratch_);
    if (at != all.end()) write_edge_or_face(kind, at->second, index);
  }
  void write_corners(const M& m, std::size_t k, const poly_t<M>& p) {
    const auto first = corner_verts_.begin() + static_cast<std::ptrdiff_t>(k == 0 ? 0 : corner_ends_[k - 1]);
    const auto last = corner_verts_.begin() + static_cast<std::ptrdiff_t>(corner_ends_[k]);
    std::size_t corner = traits<M>::first_corner(m, p);
    for (const vert_t<M> v : adj_p2v(m, p))
      values_->write(
          element_kind::corner,
          static_cast<std::size_t>(std::find(first, last, number_after(index_of(m, v))) - corner_verts_.begin()),
          corner++);
  }

 public:
  edit_values(const M& m, std::span<const vert_t<M>> existing, unsigned first_new, std::size_t num_new)
      : first_new_(first_new), new_index_(num_new), new_verts_(num_new) {
    for (const vert_t<M>& v : existing) numbers_.add(index_of(m, v));
  }
  edit_values(const edit_values&) = delete;
  edit_values& operator=(const edit_values&) = delete;

  // What the operator says. Indices are those of the mesh before. `of_sums` are the origins under the rule `sum`.

  /// The next vert with a value to write, by its number.
  void add_vert(unsigned number, origin_list from, origin_list of_sums) {
    changed_verts_.push_back(number);
    origins_.verts.add(from), of_sums_.verts.add(of_sums);
  }
  /// The next new poly.
  void add_poly(origin_list from, origin_list of_sums) { origins_.polys.add(from), of_sums_.polys.add(of_sums); }
  /// A corner of the next new poly whose corners do not end yet, at the vert with this number.
  void add_corner(unsigned number, origin_list from) {
    corner_verts_.push_back(number);
    origins_.corners.add(from), of_sums_.corners.add(from);
  }
  void end_corners() { corner_ends_.push_back(corner_verts_.size()); }
  /// A new edge or face. stays_at: its index, if it remains where it is.
  void add_edge_or_face(element_kind kind, const key& verts, origin_list from, origin_list of_sums,
                        std::size_t stays_at = nowhere) {
    const bool is_edge = kind == element_kind::edge;
    element_origins& all = is_edge ? origins_.edges : origins_.faces;
    (is_edge ? edges_ : faces_).emplace(verts, edge_or_face{all.size(), stays_at});
    all.add(from), (is_edge ? of_sums_.edges : of_sums_.faces).add(of_sums);
    if (scratch_.capacity() < verts.size() + 1) scratch_.reserve(verts.size() + 1);
  }
  /// An element of the mesh before whose values may be replaced; verts need not be named.
  void replaces(element_kind kind, std::size_t index) { replaced_.emplace_back(kind, index); }

  /// Finds the values, after all has been said.
  void find(const property_set& properties) { values_.emplace(properties, origins_, of_sums_); }

  /// Calls f(kind, index) for every element of the mesh before whose values write() may replace.
  template<class F>
  void for_each_replaced(const F& f) const {
    for (const unsigned v : changed_verts_)
      if (v < first_new_) f(element_kind::vert, numbers_[v]);
    for (const auto& [kind, index] : replaced_) f(kind, index);
  }

  /// After the edit.
  void write(const M& m, const vert_t<M>* new_verts, std::span<const poly_t<M>> new_polys) noexcept {
    for (unsigned j = 0; j < new_verts_.size(); ++j)
      new_index_[j] = index_of(m, new_verts[j]), new_verts_[j] = {new_index_[j], first_new_ + j};
    std::sort(new_verts_.begin(), new_verts_.end());
    for (std::size_t i = 0; i < changed_verts_.size(); ++i) {
      const unsigned v = changed_verts_[i];
      values_->write(element_kind::vert, i, v < first_new_ ? numbers_[v] : new_index_[v - first_new_]);
    }
    for (auto& [verts, x] : edges_)
      if (x.stays_at != nowhere) write_edge_or_face(element_kind::edge, x, x.stays_at);
    for (auto& [verts, x] : faces_)
      if (x.stays_at != nowhere) write_edge_or_face(element_kind::face, x, x.stays_at);
    for (std::size_t k = 0; k < new_polys.size(); ++k) {
      const poly_t<M>& p = new_polys[k];
      if (origins_.polys.size() > 0) values_->write(element_kind::poly, k, index_of(m, p));
      if (!corner_ends_.empty()) write_corners(m, k, p);
      if (!edges_.empty())
        for (const edge_t<M> e : adj_p2e(m, p))
          write_edge_or_face(m, element_kind::edge, edges_, index_of(m, e), adj_e2v(m, e));
      if constexpr (VolumeMesh<M>)  // surfaces have no faces
        if (!faces_.empty())
          for (const face_t<M> f : adj_p2f(m, p))
            write_edge_or_face(m, element_kind::face, faces_, index_of(m, f), adj_f2v(m, f));
    }
  }
};

}  // namespace detail

}  // namespace concino
