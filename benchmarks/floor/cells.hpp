// The floor of building a tet or hex mesh: code by hand that stores the adjacencies of a volume of one shape in flat arrays, without the library. A face has
// one or two polys. Adjacencies that are not stored follow from those that are: f2v and f2p from the half-face, e2p by walking around the edge, v2f and v2e
// from the polys of v.
#pragma once

#include "buffer.hpp"

#include <stdexcept>

namespace bench::floors {

struct tet_shape {
  static constexpr u32 verts = 4, edges = 6, faces = 4, face_size = 3;
  static constexpr u32 edge[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
  static constexpr u32 face[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
};

struct hex_shape {
  static constexpr u32 verts = 8, edges = 12, faces = 6, face_size = 4;
  static constexpr u32 edge[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6}, {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  static constexpr u32 face[6][4] = {{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7}, {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}};
};

/// The three edges and the three faces at each corner of the shape. An edge has its number and its other corner. A face has its number, the corners before
/// and after, and in quads the opposite corner.
template<class S>
struct corner_table {
  struct edge_at { u32 edge, other; };
  struct face_at { u32 face, before, after, opposite; };
  edge_at edges[S::verts][3] = {};
  face_at faces[S::verts][3] = {};

  constexpr corner_table() {
    for (u32 v = 0; v < S::verts; ++v) {
      u32 n = 0;
      for (u32 e = 0; e < S::edges; ++e)
        for (u32 i = 0; i < 2; ++i)
          if (S::edge[e][i] == v) edges[v][n++] = {e, S::edge[e][1 - i]};
      n = 0;
      for (u32 f = 0; f < S::faces; ++f)
        for (u32 i = 0; i < S::face_size; ++i)
          if (S::face[f][i] == v)
            faces[v][n++] = {f, S::face[f][(i + S::face_size - 1) % S::face_size], S::face[f][(i + 1) % S::face_size],
                             S::face_size == 4 ? S::face[f][(i + 2) % S::face_size] : v};
    }
  }
};

template<class S>
struct cells {
  buffer<double> points;                  // x y z
  buffer<u32> p2v, p2e, p2f, p2p;         // rows of the lengths in S; p2p is `none` at the boundary
  buffer<u32> e2v, e2p;                   // two verts and one poly per edge
  buffer<u32> f2h;                        // one half-face per face: S::faces * poly + local face
  buffer<u32> v_off, v2v, v2e;            // v2v and v2e share v_off
  buffer<u32> vp_off, v2p;

  u32 num_verts() const { return static_cast<u32>(points.size() / 3); }
  u32 num_edges() const { return static_cast<u32>(e2p.size()); }
  u32 num_faces() const { return static_cast<u32>(f2h.size()); }
  u32 num_polys() const { return static_cast<u32>(p2v.size() / S::verts); }
  std::size_t bytes() const {
    return points.bytes() + p2v.bytes() + p2e.bytes() + p2f.bytes() + p2p.bytes() + e2v.bytes() + e2p.bytes() + f2h.bytes() +
           v_off.bytes() + v2v.bytes() + v2e.bytes() + vp_off.bytes() + v2p.bytes();
  }
};

/// Computes all adjacencies from points and p2v, in one pass over the verts. An edge gets its number at its lowest vert, by a mark per vert. A face gets
/// its number at its lowest vert, in a small square table: the two edges of the face at that vert identify it.
template<class S>
void build(cells<S>& m) {
  static constexpr corner_table<S> at_corner{};
  static constexpr u32 side = 64;
  const u32 nv = m.num_verts(), np = m.num_polys();

  m.vp_off = buffer<u32>(nv + 1, 0);
  for (u32 v : m.p2v) ++m.vp_off[v + 1];
  prefix_sum(m.vp_off);
  m.v2p.resize(m.p2v.size());
  {
    buffer<u32> at(nv);
    std::memcpy(at.data(), m.vp_off.data(), nv * sizeof(u32));
    for (u32 c = 0; c < S::verts * np; ++c) m.v2p[at[m.p2v[c]]++] = c;
  }

  struct mark { u32 vert, edge, place; };
  buffer<mark> marks(nv, 0xff);
  buffer<u32> table(side * side, 0);
  u32 used[side * side / 2];
  m.p2e.resize(std::size_t{S::edges} * np);
  m.p2f.resize(std::size_t{S::faces} * np);
  m.p2p.resize(std::size_t{S::faces} * np);
  m.e2v.reserve(2 * std::size_t{S::edges} * np);
  m.e2p.reserve(std::size_t{S::edges} * np);
  m.f2h.reserve(std::size_t{S::faces} * np);
  m.v2v.reserve(2 * std::size_t{S::edges} * np);
  m.v2e.reserve(2 * std::size_t{S::edges} * np);
  m.v_off.resize(nv + 1);
  m.v_off[0] = 0;

  const u32* p2v = m.p2v.data();
  u32 *p2e = m.p2e.data(), *p2f = m.p2f.data(), *p2p = m.p2p.data(), *e2v = m.e2v.data(), *e2p = m.e2p.data(), *f2h = m.f2h.data();
  u32 *v2v = m.v2v.data(), *v2e = m.v2e.data();
  u32 ne = 0, nf = 0, nn = 0;
  for (u32 v = 0; v < nv; ++v) {
    u32 places = 0, num_used = 0;
    for (u32 k = m.vp_off[v]; k != m.vp_off[v + 1]; ++k) {
      const u32 c = m.v2p[k], p = c / S::verts, i = c % S::verts;
      const u32* pv = p2v + S::verts * p;
      m.v2p[k] = p;
      for (const auto& x : at_corner.edges[i]) {
        const u32 w = pv[x.other], slot = S::edges * p + x.edge;
        mark& b = marks[w];
        if (b.vert == v) {
          if (w > v) p2e[slot] = b.edge;
        } else if (w > v) {
          b = {v, ne, places++};
          e2v[2 * ne] = v;
          e2v[2 * ne + 1] = w;
          e2p[ne] = p;
          p2e[slot] = ne;
          v2v[nn] = w;
          v2e[nn++] = ne++;
        } else {
          b.vert = v;
          v2v[nn] = w;
          v2e[nn++] = p2e[slot];
        }
      }
      if (places > side) throw std::runtime_error("floor: a vert with more than 64 higher neighbours");
      for (const auto& x : at_corner.faces[i]) {
        const u32 a = pv[x.before], b = pv[x.after];
        if (a < v || b < v || pv[x.opposite] < v) continue;
        const u32 s = marks[a].place, t = marks[b].place, cell = s < t ? side * s + t : side * t + s, half = S::faces * p + x.face;
        if (const u32 met = table[cell]) {
          const u32 other = met - 1;
          p2f[half] = p2f[other];
          p2p[half] = other / S::faces;
          p2p[other] = p;
          table[cell] = 0;
        } else {
          f2h[nf] = half;
          p2f[half] = nf++;
          p2p[half] = none;
          table[cell] = half + 1;
          used[num_used++] = cell;
        }
      }
    }
    while (num_used) table[used[--num_used]] = 0;
    m.v_off[v + 1] = nn;
  }
  m.e2v.resize(2 * ne);
  m.e2p.resize(ne);
  m.f2h.resize(nf);
  m.v2v.resize(nn);
  m.v2e.resize(nn);
  m.e2v.shrink();
  m.e2p.shrink();
  m.f2h.shrink();
  m.v2v.shrink();
  m.v2e.shrink();
}

}  // namespace bench::floors
