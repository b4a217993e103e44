// What `rewire` changes in a half-edge mesh of another library, found before anything changes: the edges, then the fans
// of polys round each vert.
#pragma once

#include <concino/adapters/detail/halfedge_edge_plan.hpp>

namespace concino::detail {

template<class K>
class halfedge_plan : public halfedge_edge_plan<K> {
  using base = halfedge_edge_plan<K>;
  using base::c_, base::m_, base::new_edges_, base::next_corner_, base::place_of_existing;

 public:
  using typename base::mesh;
  using base::corner_halfedges, base::edges, base::none, base::refused;

  /// The half-edge `out` follows `in` along the border.
  struct border_link {
    unsigned in, out;
  };
  /// A half-edge that leaves a vert: one at the border if there is one.
  struct leaving_halfedge {
    unsigned vert, halfedge;
  };
  core::small_array<border_link, 32> border_links;
  core::small_array<leaving_halfedge, 32> leaving;

  /// Needs: a checked cavity of m, which must exist while the plan is used.
  halfedge_plan(const mesh& m, const halfedge_cavity<K>& c) : base(m, c) {
    if (refused.why) return;
    list_edges_at_verts();
    for (unsigned v = 0; v < c_.num_all_verts(); ++v)
      if (!plan_vert(v)) return;
  }

 private:
  core::small_array<unsigned, 32> first_edge_at_;  // of each vert, in edges_at_
  core::small_array<unsigned, 64> edges_at_;
  core::small_array<unsigned, 32> ring_;

  void list_edges_at_verts() {
    first_edge_at_.resize(c_.num_all_verts() + 1, 0);
    for (const planned_edge& e : edges)
      for (const unsigned v : e.verts) ++first_edge_at_[v + 1];
    for (unsigned v = 0; v < c_.num_all_verts(); ++v) first_edge_at_[v + 1] += first_edge_at_[v];
    edges_at_.resize(2 * edges.size(), none);
    core::small_array<unsigned, 32> end;
    for (unsigned v = 0; v < c_.num_all_verts(); ++v) end.push_back(first_edge_at_[v]);
    for (unsigned i = 0; i < edges.size(); ++i)
      for (const unsigned v : edges[i].verts) edges_at_[end[v]++] = i;
  }
  /// The place in `edges` of a half-edge's edge, or `none`.
  unsigned place_of(unsigned h) const {
    const unsigned bound = K::num_edges(m_), e = h >> 1;
    return e >= bound ? new_edges_[e - bound] : place_of_existing(e);
  }
  /// The half-edge that follows h in its poly, or `none` at the border.
  unsigned next_in_poly(unsigned h) const {
    const unsigned i = place_of(h);
    if (i == none) return K::poly_of(m_, h) == none ? none : K::next(m_, h);
    const planned_edge& e = edges[i];
    const unsigned d = h != e.halfedge;
    if (e.corner[d] != none) return corner_halfedges[next_corner_[e.corner[d]]];
    return e.has_other_poly[d] ? K::next(m_, h) : none;
  }
  /// A half-edge that leaves v and remains.
  unsigned remaining_halfedge(unsigned v) const {
    for (unsigned k = first_edge_at_[v];; ++k)
      if (const planned_edge& e = edges[edges_at_[k]]; e.remains()) return e.halfedge ^ (e.verts[0] != v);
  }
  /// Lists the half-edges that will leave v.
  void list_ring(unsigned v) {
    ring_.clear();
    if (v < c_.num_verts())
      if (const unsigned first = K::halfedge_from(m_, c_.verts[v]); first != none) {
        unsigned h = first;
        do {
          const unsigned i = place_of_existing(h >> 1);
          if (i == none || edges[i].remains()) ring_.push_back(h);
          h = K::next(m_, h ^ 1);
        } while (h != first);
      }
    for (unsigned k = first_edge_at_[v]; k < first_edge_at_[v + 1]; ++k)
      if (const planned_edge& e = edges[edges_at_[k]]; e.is_new) ring_.push_back(e.halfedge ^ (e.verts[0] != v));
  }
  /// Whether new polys fill, between the same edges, the same parts of the ring round v as old ones. Then the ring is
  /// otherwise as before.
  bool keeps_ring(unsigned v) const {
    unsigned sectors = 0, visited = 0;  // of old and of new polys, and those that a walk from one edge to another meets
    for (unsigned k = first_edge_at_[v]; k < first_edge_at_[v + 1]; ++k) {
      const planned_edge& e = edges[edges_at_[k]];
      const unsigned in = e.verts[0] == v;  // the direction towards v
      const bool old_in = e.has_old_poly[in], old_out = e.has_old_poly[1 - in], new_in = e.corner[in] != none,
                 new_out = e.corner[1 - in] != none;
      sectors += old_in + new_in;
      if ((old_in && !old_out) != (new_in && !new_out) || (!old_in && old_out) != (!new_in && new_out)) return false;
      if (!old_in || old_out) continue;
      const auto end = [&](const auto& next_of, const auto& goes_on) {
        for (unsigned g = e.halfedge ^ in;;) {
          const unsigned h = next_of(g);
          ++visited;
          if (!goes_on(h ^ 1)) return h;
          g = h ^ 1;
        }
      };
      const auto is_old = [&](unsigned h) {
        const planned_edge& x = edges[place_of(h)];
        return x.has_old_poly[h != x.halfedge];
      };
      const auto is_new = [&](unsigned h) {
        const planned_edge& x = edges[place_of(h)];
        return x.corner[h != x.halfedge] != none;
      };
      if (end([&](unsigned g) { return K::next(m_, g); }, is_old) !=
          end([&](unsigned g) { return next_in_poly(g); }, is_new))
        return false;
    }
    return visited == sectors;
  }
  /// Links the fans of polys at v along the border, in the order of their first half-edges.
  bool plan_vert(unsigned v) {
    if (first_edge_at_[v] == first_edge_at_[v + 1]) {
      if (c_.is_removed(v) && K::halfedge_from(m_, c_.verts[v]) != none) c_.refuse_removal(v);
      return true;
    }
    if (v < c_.num_verts() && !c_.is_removed(v) && keeps_ring(v)) {
      const unsigned h = K::halfedge_from(m_, c_.verts[v]), i = place_of_existing(h >> 1);
      if (i != none && !edges[i].remains()) leaving.push_back({v, remaining_halfedge(v)});
      return true;
    }
    list_ring(v);
    if (c_.is_removed(v) && !ring_.empty()) c_.refuse_removal(v);
    std::size_t visited = 0;
    unsigned at_border = none;
    const auto follow = [&](unsigned h) {  // round the vert, to the end of the fan or back to h
      for (unsigned g = h;;) {
        ++visited;
        const unsigned after = next_in_poly(g ^ 1);
        if (after == none || after == h || visited > ring_.size()) return g ^ 1;
        g = after;
      }
    };
    for (const unsigned h : ring_) {
      if (next_in_poly(h) != none) continue;
      if (at_border == none) at_border = h;
      else border_links[border_links.size() - 1].out = h;
      border_links.push_back({follow(h), at_border});
    }
    if (at_border == none && !ring_.empty()) follow(ring_[0]);
    if (visited != ring_.size()) return this->refuse(K::one_closed_fan, v);
    leaving.push_back({v, ring_.empty() ? none : at_border == none ? ring_[0] : at_border});
    return true;
  }
};

}  // namespace concino::detail
