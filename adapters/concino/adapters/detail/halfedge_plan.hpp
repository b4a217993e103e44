// What `rewire` changes in a half-edge mesh of another library, found before anything changes. A library is described by a struct K of static functions, whose
// half-edges are numbers: those of edge e are 2 e and 2 e + 1.
//
//   struct K {
//     using mesh = ..., vert = ..., poly = ...;
//     static constexpr char two_polys[] = "in ... at most two polys share an edge, ...", one_closed_fan[] = "...", one_edge[] = "...";
//     static unsigned index(vert), index(poly);                     static bool contains(const mesh&, vert), contains(const mesh&, poly);
//     static unsigned next(const mesh&, unsigned h);                static void set_next(mesh&, unsigned h, unsigned next);       // and the previous of `next`
//     static unsigned target(const mesh&, unsigned h);              static void set_target(mesh&, unsigned h, unsigned v);
//     static unsigned poly_of(const mesh&, unsigned h);             static void set_poly(mesh&, unsigned h, unsigned p);          // `none`: at the border
//     static unsigned halfedge_from(const mesh&, unsigned v);       static void set_halfedge_from(mesh&, unsigned v, unsigned h); // `none`: no edges
//     static unsigned halfedge_of(const mesh&, unsigned p);         static void set_halfedge_of(mesh&, unsigned p, unsigned h);   // it ends at the first vert
//     static unsigned num_edges(const mesh&);                       // the index bound
//   };
#pragma once

#include <concino/adapters/detail/halfedge_cavity.hpp>

#include <utility>

namespace concino::detail {

template<class K>
class halfedge_plan {
 public:
  using mesh = typename K::mesh;
  static constexpr unsigned none = ~0u;

  /// The half-edge `out` follows `in` along the border.
  struct border_link {
    unsigned in, out;
  };
  /// A half-edge that leaves a vert: one at the border if there is one.
  struct leaving_halfedge {
    unsigned vert, halfedge;
  };
  /// Why the library cannot represent the mesh, and where.
  struct obstacle {
    const char* why = nullptr;
    unsigned vert = none, other_vert = none;  // local numbers
  };

  core::small_array<planned_edge, 32> edges;
  core::small_array<unsigned, 96> corner_halfedges;  // the half-edge that begins at each new corner
  core::small_array<border_link, 32> border_links;
  core::small_array<leaving_halfedge, 32> leaving;
  unsigned num_new_edges = 0;
  obstacle refused;

  /// Needs: a checked cavity of m, which must exist while the plan is used.
  halfedge_plan(const mesh& m, const halfedge_cavity<K>& c) : m_(m), c_(c) {
    list_keys();
    if (!add_old_polys() || !add_new_polys() || !find_other_edges()) return;
    list_edges_at_verts();
    for (unsigned v = 0; v < c_.num_all_verts(); ++v)
      if (!plan_vert(v)) return;
  }

  /// The corner after i in its poly.
  unsigned next_corner(unsigned i) const { return next_corner_[i]; }

 private:
  const mesh& m_;
  const halfedge_cavity<K>& c_;
  core::small_array<std::uint64_t, 96> keys_;       // of edges, sorted: both verts
  core::small_array<unsigned, 96> next_corner_;
  core::small_array<unsigned, 32> new_edges_;       // places in `edges`
  places_of_numbers existing_;                      // places in `edges` of edges of the mesh
  core::small_array<unsigned, 32> first_edge_at_;   // of each vert, in edges_at_
  core::small_array<unsigned, 64> edges_at_;
  core::small_array<unsigned, 32> ring_;

  bool refuse(const char* why, unsigned v, unsigned w = none) {
    refused = {why, v, w};
    return false;
  }
  static std::uint64_t key(unsigned a, unsigned b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }
  planned_edge& edge_of(unsigned a, unsigned b) { return edges[static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key(a, b)) - keys_.begin())]; }

  unsigned local_target(unsigned h, unsigned p) const {
    const unsigned v = K::target(m_, h), i = c_.local.find(v);
    if (i == none) core::throw_joined<invalid_mesh>({"rewire: vert ", v, " of old poly ", p, " is not among the verts of the cavity; list all verts of old and new polys"});
    return i;
  }
  /// Calls f(half-edge, local number of its start, that of its end) for all half-edges of old polys.
  template<class F>
  bool for_each_old(const F& f) const {
    for (const unsigned p : c_.polys) {
      const unsigned first = K::halfedge_of(m_, p);
      unsigned h = first, from = local_target(h ^ 1, p);
      do {
        const unsigned to = local_target(h, p);
        if (!f(h, from, to)) return false;
        from = to;
        h = K::next(m_, h);
      } while (h != first);
    }
    return true;
  }

  void list_keys() {
    for_each_old([&](unsigned, unsigned a, unsigned b) {
      keys_.push_back(key(a, b));
      return true;
    });
    next_corner_.resize(c_.num_corners(), none);
    for (unsigned k = 0, i = 0; k < c_.ends.size(); ++k)
      for (const unsigned first = i; i < c_.ends[k]; ++i) {
        next_corner_[i] = i + 1 < c_.ends[k] ? i + 1 : first;
        keys_.push_back(key(c_.corners[i], c_.corners[next_corner_[i]]));
      }
    core::sort_numbers(keys_.begin(), keys_.end());
    keys_.resize(static_cast<std::size_t>(std::unique(keys_.begin(), keys_.end()) - keys_.begin()), 0);
    for (const std::uint64_t k : keys_) {
      planned_edge e;
      e.verts[0] = static_cast<unsigned>(k >> 32), e.verts[1] = static_cast<unsigned>(k);
      edges.push_back(e);
    }
  }
  bool add_old_polys() {
    return for_each_old([&](unsigned h, unsigned a, unsigned b) {
      planned_edge& e = edge_of(a, b);
      const unsigned ascending = a < b ? h : h ^ 1;
      if (e.halfedge != none && e.halfedge != ascending) return refuse(K::one_edge, a, b);
      e.halfedge = ascending;
      return e.had_old_poly = true;
    });
  }
  bool add_new_polys() {
    for (unsigned i = 0; i < c_.num_corners(); ++i) {
      const unsigned a = c_.corners[i], b = c_.corners[next_corner_[i]];
      planned_edge& e = edge_of(a, b);
      if (e.corner[a > b] != none) return refuse(K::two_polys, a, b);
      e.corner[a > b] = i;
    }
    return true;
  }
  /// The half-edge from a to b, or `none`: searched at the one that has fewer edges.
  unsigned find_halfedge(unsigned a, unsigned b) const {
    const unsigned at_a = K::halfedge_from(m_, a), at_b = K::halfedge_from(m_, b);
    if (at_a == none || at_b == none) return none;
    unsigned g = at_a, h = at_b;
    do {
      if (K::target(m_, g) == b) return g;
      if (K::target(m_, h) == a) return h ^ 1;
      g = K::next(m_, g ^ 1), h = K::next(m_, h ^ 1);
    } while (g != at_a && h != at_b);
    return none;
  }
  bool find_other_edges() {
    corner_halfedges.resize(c_.num_corners(), none);
    for (unsigned i = 0; i < edges.size(); ++i) {
      planned_edge& e = edges[i];
      const unsigned a = e.verts[0], b = e.verts[1];
      if (e.halfedge == none && b < c_.num_verts()) e.halfedge = find_halfedge(c_.verts[a], c_.verts[b]);
      e.is_new = e.halfedge == none;
      if (e.is_new) {
        e.halfedge = 2 * (K::num_edges(m_) + num_new_edges++);
        new_edges_.push_back(i);
      } else {
        existing_.add(e.halfedge >> 1, i);
      }
      for (const unsigned d : {0u, 1u}) {
        const unsigned p = e.is_new ? none : K::poly_of(m_, e.halfedge ^ d);
        e.has_other_poly[d] = p != none && c_.old.find(p) == none;
        if (e.corner[d] == none) continue;
        if (e.has_other_poly[d]) return refuse(K::two_polys, e.verts[d], e.verts[1 - d]);
        corner_halfedges[e.corner[d]] = e.halfedge ^ d;
      }
    }
    existing_.sort();
    return true;
  }

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
    return e >= bound ? new_edges_[e - bound] : existing_.find(e);
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
  /// Lists the half-edges that will leave v.
  void list_ring(unsigned v) {
    ring_.clear();
    if (v < c_.num_verts())
      if (const unsigned first = K::halfedge_from(m_, c_.verts[v]); first != none) {
        unsigned h = first;
        do {
          const unsigned i = existing_.find(h >> 1);
          if (i == none || edges[i].remains()) ring_.push_back(h);
          h = K::next(m_, h ^ 1);
        } while (h != first);
      }
    for (unsigned k = first_edge_at_[v]; k < first_edge_at_[v + 1]; ++k)
      if (const planned_edge& e = edges[edges_at_[k]]; e.is_new) ring_.push_back(e.halfedge ^ (e.verts[0] != v));
  }
  /// Links the fans of polys at v along the border, in the order of their first half-edges.
  bool plan_vert(unsigned v) {
    if (first_edge_at_[v] == first_edge_at_[v + 1]) {
      if (c_.is_removed(v) && K::halfedge_from(m_, c_.verts[v]) != none) c_.refuse_removal(v);
      return true;
    }
    list_ring(v);
    if (c_.is_removed(v) && !ring_.empty()) c_.refuse_removal(v);
    std::size_t met = 0;
    unsigned at_border = none;
    const auto follow = [&](unsigned h) {  // round the vert, to the end of the fan or back to h
      for (unsigned g = h;;) {
        ++met;
        const unsigned after = next_in_poly(g ^ 1);
        if (after == none || after == h || met > ring_.size()) return g ^ 1;
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
    if (met != ring_.size()) return refuse(K::one_closed_fan, v);
    leaving.push_back({v, ring_.empty() ? none : at_border == none ? ring_[0] : at_border});
    return true;
  }
};

}  // namespace concino::detail
