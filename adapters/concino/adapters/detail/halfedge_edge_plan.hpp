// The edges that `rewire` changes in a half-edge mesh of another library, found before anything changes. A library is
// described by a struct K of static functions, whose half-edges are numbers: those of edge e are 2 e and 2 e + 1.
//
//   struct K {
//     using mesh = ..., vert = ..., poly = ...;
//     static constexpr char two_polys[] = "in ... at most two polys share an edge, ...", one_closed_fan[] = "...",
//     one_edge[] = "..."; static unsigned index(vert), index(poly);                     static bool contains(const
//     mesh&, vert), contains(const mesh&, poly); static unsigned next(const mesh&, unsigned h);                static
//     void set_next(mesh&, unsigned h, unsigned next);       // and the previous of `next` static unsigned target(const
//     mesh&, unsigned h);              static void set_target(mesh&, unsigned h, unsigned v); static unsigned
//     poly_of(const mesh&, unsigned h);             static void set_poly(mesh&, unsigned h, unsigned p);          //
//     `none`: at the border static unsigned halfedge_from(const mesh&, unsigned v);       static void
//     set_halfedge_from(mesh&, unsigned v, unsigned h); // `none`: no edges static unsigned halfedge_of(const mesh&,
//     unsigned p);         static void set_halfedge_of(mesh&, unsigned p, unsigned h);   // it ends at the first vert
//     static unsigned num_edges(const mesh&);                       // the index bound
//   };
#pragma once

#include <concino/adapters/detail/halfedge_cavity.hpp>

#include <algorithm>
#include <cstdint>

namespace concino::detail {

/// The edges of old and new polys, and what has a poly on either side afterwards.
template<class K>
class halfedge_edge_plan {
 public:
  using mesh = typename K::mesh;
  static constexpr unsigned none = ~0u;

  /// Why the library cannot represent the mesh, and where.
  struct obstacle {
    const char* why = nullptr;
    unsigned vert = none, other_vert = none;  // local numbers
  };

  core::small_array<planned_edge, 32> edges;
  core::small_array<unsigned, 96> corner_halfedges;  // the half-edge that begins at each new corner
  unsigned num_new_edges = 0;
  obstacle refused;

  /// Needs: a checked cavity of m, which must exist while the plan is used.
  halfedge_edge_plan(const mesh& m, const halfedge_cavity<K>& c) : m_(m), c_(c) {
    list_keys();
    if (add_old_polys() && add_new_polys()) find_other_edges();
  }

  /// The corner after i in its poly.
  unsigned next_corner(unsigned i) const { return next_corner_[i]; }

 protected:
  const mesh& m_;
  const halfedge_cavity<K>& c_;
  core::small_array<std::uint64_t, 96> keys_;  // of edges, sorted: both verts
  core::small_array<unsigned, 96> next_corner_;
  core::small_array<unsigned, 32> new_edges_;  // places in `edges`
  core::local_numbers existing_;               // edges of the mesh
  core::small_array<unsigned, 32> existing_places_;  // of these, in `edges`

  bool refuse(const char* why, unsigned v, unsigned w = none) {
    refused = {why, v, w};
    return false;
  }
  /// The place in `edges` of an edge of the mesh, or `none`.
  unsigned place_of_existing(unsigned e) const {
    const unsigned k = existing_.find(e);
    return k == none ? none : existing_places_[k];
  }
  static std::uint64_t key(unsigned a, unsigned b) { return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b); }
  planned_edge& edge_of(unsigned a, unsigned b) {
    return edges[static_cast<std::size_t>(std::lower_bound(keys_.begin(), keys_.end(), key(a, b)) - keys_.begin())];
  }

  unsigned local_target(unsigned h, unsigned p) const {
    const unsigned v = K::target(m_, h), i = c_.local.find(v);
    if (i == none)
      core::throw_joined<invalid_mesh>({"rewire: vert ", v, " of old poly ", p,
                                        " is not among the verts of the cavity; list all verts of old and new polys"});
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
    std::sort(keys_.begin(), keys_.end());
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
      return e.has_old_poly[a > b] = true;
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
        existing_.add(e.halfedge >> 1);
        existing_places_.push_back(i);
      }
      for (const unsigned d : {0u, 1u}) {
        const unsigned p = e.is_new ? none : K::poly_of(m_, e.halfedge ^ d);
        e.has_other_poly[d] = p != none && c_.old.find(p) == none;
        if (e.corner[d] == none) continue;
        if (e.has_other_poly[d]) return refuse(K::two_polys, e.verts[d], e.verts[1 - d]);
        corner_halfedges[e.corner[d]] = e.halfedge ^ d;
      }
    }
    return true;
  }
};

}  // namespace concino::detail
