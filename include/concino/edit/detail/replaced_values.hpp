// The values of named properties follow a replacement of polys by others. They are found before the edit, by the origins of the new verts and polys, and
// written after it, which needs no memory.
#pragma once

#include <concino/concepts/cavity.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/edit/detail/saved_edit.hpp>
#include <concino/mesh/carried_values.hpp>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Verts have local numbers, those of the cavity. Edges and faces that old polys have keep their values; others come from the one old edge or face that has
/// all verts of which theirs were made, or have none.
template<class M>
class replaced_values {
  using key = std::vector<unsigned>;  // sorted numbers of verts

  const M& m_;
  const cavity<M>& c_;
  const correspondence& from_;
  core::local_numbers numbers_;                             // of existing verts
  std::vector<std::pair<std::size_t, unsigned>> new_verts_;  // index and number, sorted
  std::vector<std::vector<unsigned>> verts_of_;             // by new poly: its verts, each once; if there are properties of corners
  std::vector<std::size_t> first_corner_;                   // by new poly: the number of its first corner in the correspondence
  struct parts {
    element_kind kind;
    std::vector<key> keys;      // new ones, sorted
    std::vector<std::size_t> old;
    std::vector<unsigned char> is_written;
  };
  parts edges_{element_kind::edge, {}, {}, {}}, faces_{element_kind::face, {}, {}, {}};
  std::vector<std::size_t> old_corners_;
  mutable key scratch_;
  carried_values values_;

  std::size_t num_polys() const { return (c_.poly_ends.size() > 0 ? c_.poly_ends : c_.ends).size(); }
  /// Calls f(first, last) for the corners of each polygon of new poly k: its faces, or itself.
  template<class F>
  void for_each_list(std::size_t k, const F& f) const {
    const auto start = [](const id_span<unsigned>& ends, std::size_t i) { return i == 0 ? 0u : ends[i - 1]; };
    if (c_.poly_ends.size() == 0) return f(c_.corners.begin() + start(c_.ends, k), c_.corners.begin() + c_.ends[k]);
    for (unsigned i = start(c_.poly_ends, k); i < c_.poly_ends[k]; ++i) f(c_.corners.begin() + start(c_.ends, i), c_.corners.begin() + c_.ends[i]);
  }
  /// Calls f for the edges (n = 2) or the faces (n = 3) of new poly k, as lists of verts.
  template<class F>
  void for_each_part(std::size_t k, unsigned n, const F& f) const {
    for_each_list(k, [&](const unsigned* first, const unsigned* last) {
      const auto size = static_cast<std::size_t>(last - first);
      if constexpr (dimension_v<M> == 3 && arity_v<M> == 4) {  // one list is a tet, whose parts are all of its pairs and triples
        for (unsigned i = 0; i < 4; ++i)
          for (unsigned j = i + 1; j < 4; ++j) {
            if (n == 2) f(key{first[i], first[j]});
            for (unsigned l = j + 1; n == 3 && l < 4; ++l) f(key{first[i], first[j], first[l]});
          }
      } else {
        if (n == 3) f(key(first, last));
        for (std::size_t i = 0; n == 2 && i < size; ++i) f(key{first[i], first[i + 1 < size ? i + 1 : 0]});
      }
    });
  }
  static key sorted(key x) {
    std::sort(x.begin(), x.end());
    return x;
  }
  /// The existing verts of which these were made, each once.
  std::vector<std::uint32_t> origin_verts(const key& x) const {
    std::vector<std::uint32_t> all;
    for (const unsigned v : x) {
      if (v < c_.verts.size()) all.push_back(static_cast<std::uint32_t>(index_of(m_, c_.verts[v])));
      else
        for (const origin o : from_.verts[v - c_.verts.size()]) all.push_back(o.index);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  /// Finds the new edges or faces, and their origins among those of the old polys.
  template<class Old>
  element_origins find_parts(parts& all, unsigned n, const Old& for_each_old) {
    std::vector<std::pair<std::vector<std::uint32_t>, std::size_t>> old;  // verts and index
    for_each_old([&](const auto& its_verts, std::size_t index) {
      std::vector<std::uint32_t> list;
      for (const vert_t<M> v : its_verts) list.push_back(static_cast<std::uint32_t>(index_of(m_, v)));
      std::sort(list.begin(), list.end());
      old.emplace_back(std::move(list), index);
    });
    std::sort(old.begin(), old.end());
    old.erase(std::unique(old.begin(), old.end()), old.end());
    for (const auto& [list, index] : old) all.old.push_back(index);
    std::vector<std::pair<std::uint32_t, std::size_t>> old_at;  // by vert: positions in `old`
    for (std::size_t i = 0; i < old.size(); ++i)
      for (const std::uint32_t v : old[i].first) old_at.emplace_back(v, i);
    std::sort(old_at.begin(), old_at.end());
    for (std::size_t k = 0; k < num_polys(); ++k) for_each_part(k, n, [&](const key& x) { all.keys.push_back(sorted(x)); });
    std::sort(all.keys.begin(), all.keys.end());
    all.keys.erase(std::unique(all.keys.begin(), all.keys.end()), all.keys.end());
    element_origins origins;
    std::vector<key> kept;
    for (key& x : all.keys) {
      const auto wanted = origin_verts(x);
      const auto by_verts = [](const auto& a, const auto& b) { return a.first < b.first; };
      const bool is_old = x.back() < c_.verts.size() && std::binary_search(old.begin(), old.end(), std::pair{wanted, std::size_t{0}}, by_verts);
      if (is_old) continue;
      std::vector<origin> found;
      const auto at = std::equal_range(old_at.begin(), old_at.end(), std::pair{wanted[0], std::size_t{0}}, by_verts);
      for (auto i = at.first; i != at.second && found.empty(); ++i)
        if (const auto& list = old[i->second]; std::includes(list.first.begin(), list.first.end(), wanted.begin(), wanted.end()))
          found.push_back({static_cast<std::uint32_t>(list.second)});
      origins.add(std::span<const origin>(found));
      kept.push_back(std::move(x));
    }
    all.keys = std::move(kept);
    all.is_written.assign(all.keys.size(), 0);
    return origins;
  }

  /// A corner at a vert that was there comes from the corner of the same poly there, one at a new vert from those at the verts of which that was made.
  element_origins find_corners() {
    element_origins origins;
    core::local_numbers old_polys;
    for (const poly_t<M>& p : c_.polys) old_polys.add(index_of(m_, p));
    std::size_t n = 0;
    verts_of_.resize(num_polys());
    for (std::size_t k = 0; k < num_polys(); ++k) {
      for_each_list(k, [&](const unsigned* first, const unsigned* last) {
        for (; first != last; ++first)
          if (std::find(verts_of_[k].begin(), verts_of_[k].end(), *first) == verts_of_[k].end()) verts_of_[k].push_back(*first);
      });
      first_corner_.push_back(n);
      n += verts_of_[k].size();
      const poly_t<M>& p = c_.polys[old_polys.find((*from_.polys[k].begin()).index)];
      const auto add = [&](std::uint32_t vert, double weight, std::vector<origin>& to) {
        auto corner = static_cast<std::uint32_t>(traits<M>::first_corner(m_, p));
        for (const vert_t<M> v : adj_p2v(m_, p)) {
          if (index_of(m_, v) == vert) to.push_back({corner, weight});
          ++corner;
        }
      };
      for (const unsigned v : verts_of_[k]) {
        std::vector<origin> found;
        if (v < c_.verts.size()) add(static_cast<std::uint32_t>(index_of(m_, c_.verts[v])), 1, found);
        else
          for (const origin o : from_.verts[v - c_.verts.size()]) add(o.index, o.weight, found);
        origins.add(std::span<const origin>(found));
      }
    }
    for (const poly_t<M>& p : c_.polys)
      for (std::size_t i = 0, first = traits<M>::first_corner(m_, p), size = num_elements(adj_p2v(m_, p)); i < size; ++i) old_corners_.push_back(first + i);
    return origins;
  }

  carried_values find() {
    const property_set& all = traits<M>::properties(m_);
    for (const vert_t<M>& v : c_.verts) numbers_.add(index_of(m_, v));
    correspondence origins;
    if (all.has(element_kind::vert)) origins.verts = from_.verts;
    if (all.has(element_kind::poly)) origins.polys = from_.polys;
    if (all.has(element_kind::corner)) origins.corners = find_corners();
    if (all.has(element_kind::edge))
      origins.edges = find_parts(edges_, 2, [&](const auto& add) {
        for (const poly_t<M>& p : c_.polys)
          for (const edge_t<M> e : adj_p2e(m_, p)) add(adj_e2v(m_, e), index_of(m_, e));
      });
    if constexpr (VolumeMesh<M>)  // surfaces have no faces
      if (all.has(element_kind::face))
        origins.faces = find_parts(faces_, 3, [&](const auto& add) {
          for (const poly_t<M>& p : c_.polys)
            for (const face_t<M> f : adj_p2f(m_, p)) add(adj_f2v(m_, f), index_of(m_, f));
        });
    new_verts_.resize(c_.points.size());
    std::size_t longest = 4;
    for (const key& x : faces_.keys) longest = std::max(longest, x.size());
    scratch_.reserve(longest + 1);
    return carried_values(all, origins, origins);
  }

  unsigned number_after(std::size_t index) const {
    if (const unsigned i = numbers_.find(index); i != core::local_numbers::none) return i;
    return std::lower_bound(new_verts_.begin(), new_verts_.end(), std::pair{index, 0u})->second;
  }
  template<class Verts>
  void write_part(parts& all, std::size_t index, const Verts& its_verts) {
    scratch_.clear();
    for (const vert_t<M> v : its_verts) {
      if (scratch_.size() == scratch_.capacity()) return;  // larger than all new ones
      scratch_.push_back(number_after(index_of(m_, v)));
    }
    std::sort(scratch_.begin(), scratch_.end());
    const auto at = std::lower_bound(all.keys.begin(), all.keys.end(), scratch_);
    if (at == all.keys.end() || *at != scratch_) return;
    const auto i = static_cast<std::size_t>(at - all.keys.begin());
    if (!std::exchange(all.is_written[i], 1)) values_.write(all.kind, i, index);
  }

 public:
  replaced_values(const M& m, const cavity<M>& c, const correspondence& from) : m_(m), c_(c), from_(from), values_(find()) {}

  /// Calls f(kind, index) for every element of the mesh before whose values write() may replace.
  template<class F>
  void for_each_replaced(const F& f) const {
    for (const poly_t<M>& p : c_.polys) f(element_kind::poly, index_of(m_, p));
    for (const std::size_t i : old_corners_) f(element_kind::corner, i);
    for (const std::size_t i : edges_.old) f(element_kind::edge, i);
    for (const std::size_t i : faces_.old) f(element_kind::face, i);
  }

  /// After the edit.
  void write(const cavity_result<M>& made) noexcept {
    for (std::size_t i = 0; i < new_verts_.size(); ++i) {
      new_verts_[i] = {index_of(m_, made.verts[i]), static_cast<unsigned>(c_.verts.size() + i)};
      values_.write(element_kind::vert, i, new_verts_[i].first);
    }
    std::sort(new_verts_.begin(), new_verts_.end());
    for (std::size_t k = 0; k < num_polys(); ++k) {
      const poly_t<M>& p = made.polys[k];
      values_.write(element_kind::poly, k, index_of(m_, p));
      if (!first_corner_.empty()) {
        std::size_t corner = traits<M>::first_corner(m_, p);
        for (const vert_t<M> v : adj_p2v(m_, p)) {
          const auto at = std::find(verts_of_[k].begin(), verts_of_[k].end(), number_after(index_of(m_, v)));
          values_.write(element_kind::corner, first_corner_[k] + static_cast<std::size_t>(at - verts_of_[k].begin()), corner++);
        }
      }
      if (!edges_.keys.empty())
        for (const edge_t<M> e : adj_p2e(m_, p)) write_part(edges_, index_of(m_, e), adj_e2v(m_, e));
      if constexpr (VolumeMesh<M>)  // surfaces have no faces
        if (!faces_.keys.empty())
          for (const face_t<M> f : adj_p2f(m_, p)) write_part(faces_, index_of(m_, f), adj_f2v(m_, f));
    }
  }
};

}  // namespace concino::detail
