// The floor of reading a surface: code by hand that stores all adjacencies in flat arrays, for one shape of polys, without the library. An edge has one or two
// polys, so this does not replace a mesh.
#pragma once

#include "buffer.hpp"

#include <stdexcept>

namespace bench::floors {

/// A surface with K verts per poly; K = 0: any number, with offsets. Entry s of poly p in p2e is the edge from its corner s to the next.
template<u32 K>
struct surface {
  buffer<double> points;                 // x y z
  buffer<u32> p_off;                     // only for K = 0
  buffer<u32> p2v, p2e, p2p;             // rows of length K or by p_off; p2p is `none` at the boundary
  buffer<u32> e2v, e2p;                  // two per edge; e2p is `none` at the boundary
  buffer<u32> v_off, v2v, v2e;           // v2v and v2e share v_off
  buffer<u32> vp_off, v2p;

  u32 num_verts() const { return static_cast<u32>(points.size() / 3); }
  u32 num_edges() const { return static_cast<u32>(e2v.size() / 2); }
  u32 num_polys() const { return static_cast<u32>(K ? p2v.size() / (K ? K : 1) : p_off.size() - 1); }
  u32 first(u32 p) const { return K ? K * p : p_off[p]; }
  u32 last(u32 p) const { return K ? K * p + K : p_off[p + 1]; }
  std::size_t bytes() const {
    return points.bytes() + p_off.bytes() + p2v.bytes() + p2e.bytes() + p2p.bytes() + e2v.bytes() + e2p.bytes() + v_off.bytes() +
           v2v.bytes() + v2e.bytes() + vp_off.bytes() + v2p.bytes();
  }
};

/// Computes all adjacencies from points, p_off and p2v, in one pass over the verts. An edge gets its number at its lower end, where a mark per vert says
/// whether it was visited before. At its higher end it has a number already.
template<u32 K>
void build(surface<K>& m) {
  const u32 nv = m.num_verts(), np = m.num_polys();
  const std::size_t corners = m.p2v.size();

  m.vp_off = buffer<u32>(nv + 1, 0);
  for (u32 v : m.p2v) ++m.vp_off[v + 1];
  prefix_sum(m.vp_off);
  m.v2p.resize(corners);
  {
    buffer<u32> at(nv);
    std::memcpy(at.data(), m.vp_off.data(), nv * sizeof(u32));
    for (u32 p = 0; p < np; ++p)
      for (u32 c = m.first(p); c != m.last(p); ++c) m.v2p[at[m.p2v[c]]++] = K ? c : p;
  }

  struct mark { u32 vert, edge, slot, poly; };
  buffer<mark> marks(nv, 0xff);
  m.p2e.resize(corners);
  m.p2p.resize(corners);
  m.e2v.reserve(2 * corners);
  m.e2p.reserve(2 * corners);
  m.v2v.reserve(2 * corners);
  m.v2e.reserve(2 * corners);
  m.v_off.resize(nv + 1);
  m.v_off[0] = 0;

  const u32* p2v = m.p2v.data();
  u32 *p2e = m.p2e.data(), *p2p = m.p2p.data(), *e2v = m.e2v.data(), *e2p = m.e2p.data(), *v2v = m.v2v.data(), *v2e = m.v2e.data();
  u32 ne = 0, nn = 0;
  for (u32 v = 0; v < nv; ++v) {
    auto meet = [&](u32 w, u32 slot, u32 p) {
      if (w < v) {
        const u32 e = p2e[slot];
        if (e2p[2 * e] != p) return;
        v2v[nn] = w;
        v2e[nn++] = e;
      } else if (mark& k = marks[w]; k.vert != v) {
        k = {v, ne, slot, p};
        e2v[2 * ne] = v;
        e2v[2 * ne + 1] = w;
        e2p[2 * ne] = p;
        e2p[2 * ne + 1] = none;
        p2e[slot] = ne;
        p2p[slot] = none;
        v2v[nn] = w;
        v2e[nn++] = ne++;
      } else {
        if (e2p[2 * k.edge + 1] != none) throw std::runtime_error("floor: an edge with three polys");
        p2e[slot] = k.edge;
        e2p[2 * k.edge + 1] = p;
        p2p[slot] = k.poly;
        p2p[k.slot] = p;
      }
    };
    for (u32 k = m.vp_off[v]; k != m.vp_off[v + 1]; ++k) {
      u32 c, p, a, b;
      if constexpr (K != 0) {
        c = m.v2p[k];
        p = c / K;
        a = K * p;
        b = a + K;
        m.v2p[k] = p;
      } else {
        p = m.v2p[k];
        a = m.first(p);
        b = m.last(p);
        for (c = a; p2v[c] != v;) ++c;
      }
      const u32 before = c == a ? b - 1 : c - 1;
      meet(p2v[before], before, p);
      meet(p2v[c + 1 == b ? a : c + 1], c, p);
    }
    m.v_off[v + 1] = nn;
  }
  m.e2v.resize(2 * ne);
  m.e2p.resize(2 * ne);
  m.v2v.resize(nn);
  m.v2e.resize(nn);
  m.e2v.shrink();
  m.e2p.shrink();
  m.v2v.shrink();
  m.v2e.shrink();
}

}  // namespace bench::floors
