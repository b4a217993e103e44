// The floor of building a mesh of general polyhedra: code by hand that stores all adjacencies in flat arrays, without the library. A face has one or two polys.
#pragma once

#include "buffer.hpp"

#include <stdexcept>

namespace bench::floors {

struct polyhedra {
  buffer<double> points;                       // x y z
  buffer<u32> f_off, f2v;
  buffer<u32> p_off, p2f, p2p;                 // p2f and p2p share p_off; the top bit of p2f says that the face points outward
  buffer<u32> pv_off, p2v, pe_off, p2e;
  buffer<u32> e2v, e2p, f2h;                   // two verts and one poly per edge; one entry of p2f per face
  buffer<u32> v_off, v2v, v2e;                 // v2v and v2e share v_off
  buffer<u32> vp_off, v2p;

  static constexpr u32 outward = u32{1} << 31;
  u32 num_verts() const { return static_cast<u32>(points.size() / 3); }
  u32 num_edges() const { return static_cast<u32>(e2p.size()); }
  u32 num_faces() const { return static_cast<u32>(f_off.size() - 1); }
  u32 num_polys() const { return static_cast<u32>(p_off.size() - 1); }
  std::size_t bytes() const {
    return points.bytes() + f_off.bytes() + f2v.bytes() + p_off.bytes() + p2f.bytes() + p2p.bytes() + pv_off.bytes() + p2v.bytes() +
           pe_off.bytes() + p2e.bytes() + e2v.bytes() + e2p.bytes() + f2h.bytes() + v_off.bytes() + v2v.bytes() + v2e.bytes() +
           vp_off.bytes() + v2p.bytes();
  }
};

/// Computes all adjacencies from points, faces and polys.
inline void build(polyhedra& m) {
  const u32 nv = m.num_verts(), nf = m.num_faces(), np = m.num_polys();

  // The corners of the faces, grouped by vert; used only while building.
  buffer<u32> vf_off(nv + 1, 0), v2f(m.f2v.size());
  for (u32 v : m.f2v) ++vf_off[v + 1];
  prefix_sum(vf_off);
  {
    buffer<u32> at(nv);
    std::memcpy(at.data(), vf_off.data(), nv * sizeof(u32));
    for (u32 f = 0; f < nf; ++f)
      for (u32 c = m.f_off[f]; c != m.f_off[f + 1]; ++c) v2f[at[m.f2v[c]]++] = f;
  }

  // Edges, as in a surface.
  struct mark { u32 vert, edge; };
  buffer<mark> marks(nv, 0xff);
  buffer<u32> f2e(m.f2v.size());
  m.v_off.resize(nv + 1);
  m.v_off[0] = 0;
  u32 ne = 0;
  for (u32 v = 0; v < nv; ++v) {
    for (u32 k = vf_off[v]; k != vf_off[v + 1]; ++k) {
      const u32 f = v2f[k], a = m.f_off[f], b = m.f_off[f + 1];
      u32 c = a;
      while (m.f2v[c] != v) ++c;
      const u32 before = c == a ? b - 1 : c - 1, after = c + 1 == b ? a : c + 1;
      auto meet = [&](u32 w, u32 slot) {
        mark& x = marks[w];
        if (x.vert == v) {
          if (w > v) f2e[slot] = x.edge;
          return;
        }
        if (w > v) {
          x = {v, ne};
          f2e[slot] = ne++;
          m.e2v.push(v);
          m.e2v.push(w);
        } else {
          x.vert = v;
        }
        m.v2v.push(w);
        m.v2e.push(f2e[slot]);
      };
      meet(m.f2v[before], before);
      meet(m.f2v[after], c);
    }
    m.v_off[v + 1] = static_cast<u32>(m.v2v.size());
  }

  // Polys: the neighbours by the first half-face of each face; the verts and edges of the faces, each once, by marks.
  m.f2h = buffer<u32>(nf, 0xff);
  m.e2p = buffer<u32>(ne, 0xff);
  m.p2p.resize(m.p2f.size());
  m.pv_off.resize(np + 1);
  m.pe_off.resize(np + 1);
  m.pv_off[0] = m.pe_off[0] = 0;
  buffer<u32> poly_of(nf), seen_v(nv, 0xff), seen_e(ne, 0xff);
  for (u32 p = 0; p < np; ++p) {
    for (u32 k = m.p_off[p]; k != m.p_off[p + 1]; ++k) {
      const u32 f = m.p2f[k] & ~polyhedra::outward;
      if (m.f2h[f] == none) {
        m.f2h[f] = k;
        poly_of[f] = p;
        m.p2p[k] = none;
      } else {
        if (poly_of[f] == none) throw std::runtime_error("floor: a face with three polys");
        m.p2p[k] = poly_of[f];
        m.p2p[m.f2h[f]] = p;
        poly_of[f] = none;
      }
      for (u32 c = m.f_off[f]; c != m.f_off[f + 1]; ++c) {
        const u32 v = m.f2v[c], e = f2e[c];
        if (seen_v[v] != p) {
          seen_v[v] = p;
          m.p2v.push(v);
        }
        if (seen_e[e] != p) {
          if (seen_e[e] == none) m.e2p[e] = p;
          seen_e[e] = p;
          m.p2e.push(e);
        }
      }
    }
    m.pv_off[p + 1] = static_cast<u32>(m.p2v.size());
    m.pe_off[p + 1] = static_cast<u32>(m.p2e.size());
  }

  m.vp_off = buffer<u32>(nv + 1, 0);
  for (u32 v : m.p2v) ++m.vp_off[v + 1];
  prefix_sum(m.vp_off);
  m.v2p.resize(m.p2v.size());
  std::memcpy(seen_v.data(), m.vp_off.data(), nv * sizeof(u32));
  for (u32 p = 0; p < np; ++p)
    for (u32 c = m.pv_off[p]; c != m.pv_off[p + 1]; ++c) m.v2p[seen_v[m.p2v[c]]++] = p;

  m.e2v.shrink();
  m.v2v.shrink();
  m.v2e.shrink();
  m.p2v.shrink();
  m.p2e.shrink();
}

}  // namespace bench::floors
