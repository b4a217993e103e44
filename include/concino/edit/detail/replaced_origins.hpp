// replaced_origins: from which elements those that a replacement of polys makes come, for the values of named
// properties (edit_values.hpp).
#pragma once

#include <concino/concepts/cavity.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/edit/detail/edit_values.hpp>
#include <concino/edit/detail/saved_edit.hpp>
#include <concino/mesh/support/standard_cells.hpp>

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// Verts have local numbers, those of the cavity. Edges and faces that old polys have keep their values. Others come
/// from the old edges or faces that become them where verts take the places of removed ones; else from the one old edge
/// or face that has all verts of which theirs were made, if these are enough for one; else from those that vanish and
/// have no other verts, apart from removed ones without a successor; or they have none.
template<class M>
class replaced_origins {
  using key = std::vector<unsigned>;  // sorted numbers of verts

  const M& m_;
  const cavity<M>& c_;
  const correspondence& from_;
  edit_values<M>& to_;
  core::local_numbers number_of_vert_;  // in the cavity
  std::vector<unsigned> successor_;     // by number: a vert itself, or the one that takes its place, or `none`

  std::size_t num_polys() const { return (c_.poly_ends.size() > 0 ? c_.poly_ends : c_.ends).size(); }
  /// Calls f(first, last) for the corners of each polygon of new poly k: its faces, or itself in a surface.
  template<class F>
  void for_each_list(std::size_t k, const F& f) const {
    const auto start = [](const id_span<unsigned>& ends, std::size_t i) { return i == 0 ? 0u : ends[i - 1]; };
    if constexpr (VolumeMesh<M> && arity_v<M> > 0)  // the corners of cells are not those of one polygon
      return for_each_face(c_.corners.begin() + c_.ends[k], f);
    if (c_.poly_ends.size() == 0) return f(c_.corners.begin() + start(c_.ends, k), c_.corners.begin() + c_.ends[k]);
    for (unsigned i = start(c_.poly_ends, k); i < c_.poly_ends[k]; ++i)
      f(c_.corners.begin() + start(c_.ends, i), c_.corners.begin() + c_.ends[i]);
  }
  /// The same for a tet or hex whose corners end here.
  template<class F>
  void for_each_face(const unsigned* end, const F& f) const {
    const standard_cell& cell = standard_cell_of(arity_v<M> == 4 ? cell_shape::tet : cell_shape::hex);
    for (unsigned i = 0; i < cell.num_faces; ++i) {
      unsigned list[4] = {}, n = 0;
      for (; n < cell.face_size[i]; ++n) list[n] = (end - cell.num_verts)[cell.face_vert[i][n]];
      f(list, list + n);
    }
  }
  /// Calls f for the edges (n = 2) or the faces (n = 3) of new poly k, as lists of verts.
  template<class F>
  void for_each_edge_or_face(std::size_t k, unsigned n, const F& f) const {
    for_each_list(k, [&](const unsigned* first, const unsigned* last) {
      const auto size = static_cast<std::size_t>(last - first);
      if (n == 3) f(key(first, last));
      for (std::size_t i = 0; n == 2 && i < size; ++i) f(key{first[i], first[i + 1 < size ? i + 1 : 0]});
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

  using old_list = std::vector<std::pair<std::vector<std::uint32_t>, std::size_t>>;  // verts and index

  /// The old edges or faces that vanish, and have only these verts and removed ones. keys: of all new polys.
  void add_vanished(const old_list& old, const std::vector<std::pair<std::uint32_t, std::size_t>>& old_at,
                    const std::vector<key>& keys, const std::vector<std::uint32_t>& wanted,
                    std::vector<origin>& found) const {
    std::vector<std::uint32_t> allowed = wanted;
    for (std::size_t i = c_.verts.size() - c_.removed; i < c_.verts.size(); ++i)
      if (successor_[i] == number_of_vert_.none)
        allowed.push_back(static_cast<std::uint32_t>(index_of(m_, c_.verts[i])));
    std::sort(allowed.begin(), allowed.end());
    const auto stays = [&](const std::vector<std::uint32_t>& list) {
      key local;  // by number in the cavity
      for (const std::uint32_t v : list) local.push_back(number_of_vert_.find(v));
      return std::binary_search(keys.begin(), keys.end(), sorted(local));
    };
    for (const std::uint32_t v : wanted) {
      const auto at = std::equal_range(old_at.begin(), old_at.end(), std::pair{v, std::size_t{0}},
                                       [](const auto& a, const auto& b) { return a.first < b.first; });
      for (auto i = at.first; i != at.second; ++i) {
        const auto& [list, index] = old[i->second];
        const origin one{static_cast<std::uint32_t>(index)};
        if (std::includes(allowed.begin(), allowed.end(), list.begin(), list.end()) && !stays(list) &&
            std::find(found.begin(), found.end(), one) == found.end())
          found.push_back(one);
      }
    }
  }

  /// What old edges or faces with removed verts become, sorted, with their positions in `old`.
  std::vector<std::pair<key, std::size_t>> successors(const old_list& old, unsigned n) const {
    std::vector<std::pair<key, std::size_t>> all;
    for (std::size_t i = 0; i < old.size(); ++i) {
      key x;
      bool is_known = true, stays = true;
      for (const std::uint32_t v : old[i].first) {
        const unsigned number = number_of_vert_.find(v);
        x.push_back(successor_[number]);
        is_known = is_known && x.back() != number_of_vert_.none, stays = stays && x.back() == number;
      }
      x = sorted(std::move(x));
      x.erase(std::unique(x.begin(), x.end()), x.end());
      if (is_known && !stays && x.size() >= n) all.emplace_back(std::move(x), i);
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  /// Finds the new edges or faces, and their origins among those of the old polys.
  template<class Old>
  void add_edges_or_faces(element_kind kind, unsigned n, const Old& for_each_old) {
    old_list old;
    for_each_old([&](const auto& its_verts, std::size_t index) {
      std::vector<std::uint32_t> list;
      for (const vert_t<M> v : its_verts) list.push_back(static_cast<std::uint32_t>(index_of(m_, v)));
      std::sort(list.begin(), list.end());
      old.emplace_back(std::move(list), index);
    });
    std::sort(old.begin(), old.end());
    old.erase(std::unique(old.begin(), old.end()), old.end());
    for (const auto& [list, index] : old) to_.replaces(kind, index);
    std::vector<std::pair<std::uint32_t, std::size_t>> old_at;  // by vert: positions in `old`
    for (std::size_t i = 0; i < old.size(); ++i)
      for (const std::uint32_t v : old[i].first) old_at.emplace_back(v, i);
    std::sort(old_at.begin(), old_at.end());
    std::vector<key> keys;  // of new ones
    for (std::size_t k = 0; k < num_polys(); ++k)
      for_each_edge_or_face(k, n, [&](const key& x) { keys.push_back(sorted(x)); });
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    const auto become = successors(old, n);
    const auto by_verts = [](const auto& a, const auto& b) { return a.first < b.first; };
    for (const key& x : keys) {
      const auto wanted = origin_verts(x);
      const bool is_old = x.back() < c_.verts.size() &&
                          std::binary_search(old.begin(), old.end(), std::pair{wanted, std::size_t{0}}, by_verts);
      if (is_old) continue;
      std::vector<origin> found;
      const auto same = std::equal_range(become.begin(), become.end(), std::pair{x, std::size_t{0}}, by_verts);
      for (auto i = same.first; i != same.second; ++i)
        found.push_back({static_cast<std::uint32_t>(old[i->second].second)});
      const auto at = std::equal_range(old_at.begin(), old_at.end(), std::pair{wanted[0], std::size_t{0}}, by_verts);
      for (auto i = at.first; i != at.second && found.empty() && wanted.size() >= n; ++i)
        if (const auto& list = old[i->second];
            std::includes(list.first.begin(), list.first.end(), wanted.begin(), wanted.end()))
          found.push_back({static_cast<std::uint32_t>(list.second)});
      if (found.empty() && x.back() < c_.verts.size()) add_vanished(old, old_at, keys, wanted, found);
      to_.add_edge_or_face(kind, x, found, found);
    }
  }

  /// A corner at a vert that was there comes from the corners there of the polys of which its own was made. One at a
  /// new vert comes from those at the verts of which that was made.
  void add_corners() {
    core::local_numbers old_polys;
    for (const poly_t<M>& p : c_.polys) old_polys.add(index_of(m_, p));
    std::vector<unsigned> its_verts;  // each once
    for (std::size_t k = 0; k < num_polys(); ++k) {
      its_verts.clear();
      for_each_list(k, [&](const unsigned* first, const unsigned* last) {
        for (; first != last; ++first)
          if (std::find(its_verts.begin(), its_verts.end(), *first) == its_verts.end()) its_verts.push_back(*first);
      });
      const auto add = [&](std::uint32_t vert, double weight, std::vector<origin>& to) {
        for (const origin o : from_.polys[k]) {
          const poly_t<M>& p = c_.polys[old_polys.find(o.index)];
          auto corner = static_cast<std::uint32_t>(traits<M>::first_corner(m_, p));
          for (const vert_t<M> v : adj_p2v(m_, p)) {
            if (index_of(m_, v) == vert) to.push_back({corner, weight});
            ++corner;
          }
        }
      };
      for (const unsigned v : its_verts) {
        std::vector<origin> found;
        if (v < c_.verts.size()) add(static_cast<std::uint32_t>(index_of(m_, c_.verts[v])), 1, found);
        else
          for (const origin o : from_.verts[v - c_.verts.size()]) add(o.index, o.weight, found);
        to_.add_corner(v, found);
      }
      to_.end_corners();
    }
    for (const poly_t<M>& p : c_.polys)
      for (std::size_t i = 0, first = traits<M>::first_corner(m_, p), size = num_elements(adj_p2v(m_, p)); i < size;
           ++i)
        to_.replaces(element_kind::corner, first + i);
  }
  void add_verts_and_polys() {
    std::vector<origin> list;
    for (std::size_t i = 0; i < c_.points.size(); ++i)
      copy_origins(from_.verts[i], list), to_.add_vert(static_cast<unsigned>(c_.verts.size() + i), list, list);
    for (std::size_t k = 0; k < num_polys(); ++k) copy_origins(from_.polys[k], list), to_.add_poly(list, list);
    for (const poly_t<M>& p : c_.polys) to_.replaces(element_kind::poly, index_of(m_, p));
  }

 public:
  replaced_origins(const M& m, const cavity<M>& c, const correspondence& from, std::span<const replaced_vert> replaced,
                   edit_values<M>& to)
      : m_(m), c_(c), from_(from), to_(to) {
    for (const vert_t<M>& v : c.verts) {
      const unsigned number = number_of_vert_.add(index_of(m, v));
      successor_.push_back(number < c.verts.size() - c.removed ? number : number_of_vert_.none);
    }
    for (const replaced_vert& x : replaced) successor_[x.vert] = x.by;
  }

  void add(const property_set& all) {
    add_verts_and_polys();
    if (all.has(element_kind::corner)) add_corners();
    if (all.has(element_kind::edge))
      add_edges_or_faces(element_kind::edge, 2, [&](const auto& add) {
        for (const poly_t<M>& p : c_.polys)
          for (const edge_t<M> e : adj_p2e(m_, p)) add(adj_e2v(m_, e), index_of(m_, e));
      });
    if constexpr (VolumeMesh<M>)  // surfaces have no faces
      if (all.has(element_kind::face))
        add_edges_or_faces(element_kind::face, 3, [&](const auto& add) {
          for (const poly_t<M>& p : c_.polys)
            for (const face_t<M> f : adj_p2f(m_, p)) add(adj_f2v(m_, f), index_of(m_, f));
        });
  }
};

}  // namespace concino::detail
