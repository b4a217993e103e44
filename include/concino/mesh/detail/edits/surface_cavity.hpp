// A cavity of a surface: its verts, edges and old polys by local numbers, and what changes at each of them.
#pragma once

#include <concino/concepts/ranges.hpp>
#include <concino/core/small_array.hpp>
#include <concino/mesh/detail/edits/cavity_changes.hpp>
#include <concino/mesh/detail/edits/cavity_edges.hpp>
#include <concino/mesh/detail/edits/cavity_input.hpp>

#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// Arity as of surface_tables.
template<unsigned Arity>
class surface_cavity {
 protected:
  const native_cavity& c_;
  const cavity_verts verts_;
  const unsigned num_old_verts_ = static_cast<unsigned>(c_.verts.size()),
                 num_verts_ = num_old_verts_ + static_cast<unsigned>(c_.points.size());
  cavity_edges edges_;
  core::small_array<vert_change, 24> changes_;
  core::small_array<unsigned, 48> old_corners_;     // of the old polys, as local numbers
  core::small_array<unsigned, 12> old_ends_;        // where those of each end, if polys differ in size
  core::small_array<unsigned, 48> edges_of_new_;    // of the new polys: the number of the edge after each corner
  core::small_array<poly_id, 8> of_lists_;  // polys in lists of old polys
  std::size_t num_new_edges_ = 0, num_unused_edges_ = 0;  // edges that the mesh did not have, and those that it loses

  template<class Tables>
  surface_cavity(const Tables& t, const native_cavity& c)
      : c_(c), verts_(c.verts), edges_(count_corners(t, c)), changes_(num_verts_, vert_change{}) {
    check_cavity(c, verts_, t.verts_, t.polys_, Arity);
    find_old_edges(t);
    find_new_edges(t);
    count_edges();
    for (unsigned v = num_old_verts_ - static_cast<unsigned>(c.removed); v < num_old_verts_; ++v)
      if (t.incident_.num_polys(verts_[v]) != changes_[v].polys_before) removed_vert_in_use(verts_[v]);
  }

  id_span<unsigned> corners(std::size_t k) const {
    const unsigned* const all = c_.corners.begin();
    return {all + (k == 0 ? 0 : c_.ends[k - 1]), all + c_.ends[k]};
  }
  id_span<unsigned> old_corners(std::size_t k) const {
    const unsigned* const all = old_corners_.begin();
    if constexpr (Arity > 0) return {all + Arity * k, all + Arity * k + Arity};
    else return {all + (k == 0 ? 0 : old_ends_[k - 1]), all + old_ends_[k]};
  }
  std::size_t num_new() const { return c_.ends.size(); }
  std::size_t num_added() const { return num_new() - c_.kept; }
  std::size_t num_corners() const { return c_.ends.empty() ? 0 : c_.ends[num_new() - 1]; }
  static std::size_t next(std::size_t i, std::size_t n) { return i + 1 == n ? 0 : i + 1; }

 private:
  template<class Tables>
  static std::size_t count_corners(const Tables& t, const native_cavity& c) {
    std::size_t n = c.ends.empty() ? 0 : c.ends[c.ends.size() - 1];
    for (const poly_id p : c.polys)
      if (t.polys_.contains(p)) n += t.p2v_.length(p.raw());
    return n;
  }

  template<class Tables>
  void find_old_edges(const Tables& t) {
    for (const poly_id p : c_.polys) {
      const auto v = t.p2v_[p.raw()];
      const id_span<edge_id> e = t.facet_adjacency_.facets(p);
      const auto n = static_cast<std::uint32_t>(v.size());
      const std::size_t first = old_corners_.size();
      for (const vert_id w : v) {
        old_corners_.push_back(verts_.local(w));
        if (old_corners_.back() == cavity_verts::none) missing_cavity_vert(p, w);
      }
      if constexpr (Arity == 0) old_ends_.push_back(static_cast<unsigned>(old_corners_.size()));
      for (std::uint32_t k = 0; k < n; ++k) {
        const unsigned a = old_corners_[first + k], b = old_corners_[first + next(k, n)];
        cavity_edge& x = edges_.at(a, b);
        x.id = e[k];
        ++x.old_polys;
        x.num_polys = t.facet_adjacency_.num_polys_at(p, k);
        if (x.num_polys == 2) x.first_poly = poly_id{t.facet_adjacency_.owner(e[k]).poly};
        ++changes_[a].polys_before;
        if (t.facet_adjacency_.neighbour(p, k).is_non_manifold())
          for (const poly_id q : t.adj_e2p(e[k])) of_lists_.push_back(q);
      }
    }
  }

  template<class Tables>
  void find_new_edges(const Tables& t) {
    for (std::size_t k = 0; k < num_new(); ++k) {
      const id_span<unsigned> v = corners(k);
      for (std::size_t i = 0; i < v.size(); ++i) {
        const unsigned a = v[i], b = v[next(i, v.size())];
        ++changes_[a].polys_after;
        cavity_edge& x = edges_.at(a, b);
        edges_of_new_.push_back(edges_.number(x));
        if (++x.new_polys > 1 || !x.id.is_none() || a >= num_old_verts_ || b >= num_old_verts_) continue;
        x.id = t.incident_.edge_between(verts_[a], verts_[b]);
        if (!x.id.is_none()) x.num_polys = static_cast<std::uint32_t>(num_elements(t.adj_e2p(x.id)));
      }
    }
  }

  void count_edges() {
    for (const cavity_edge& x : edges_) {
      if (x.id.is_none()) ++num_new_edges_, ++changes_[x.a].edges_gained, ++changes_[x.b].edges_gained;
      else if (x.is_unused()) ++num_unused_edges_, ++changes_[x.a].edges_lost, ++changes_[x.b].edges_lost;
    }
  }
};

}  // namespace concino::detail
