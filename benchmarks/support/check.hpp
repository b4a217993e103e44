// Checks that the floor and the library hold the same mesh, by a sum of hashes over each adjacency. The sums depend neither on the numbers of edges and faces
// nor on the order of neighbours.
#pragma once

#include "../floor/cells.hpp"
#include "../floor/polyhedra.hpp"
#include "../floor/surface.hpp"

#include <concino/mesh.hpp>

#include <cstdint>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>

namespace bench {

using floors::u32;
using digest = std::map<std::string, std::uint64_t>;

inline std::uint64_t mix(std::uint64_t a, std::uint64_t b) {
  std::uint64_t x = a * 0x9E3779B97F4A7C15u + b + 0x632BE59BD9B4E019u;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}
inline std::uint64_t edge_key(std::uint64_t a, std::uint64_t b) { return a < b ? mix(a, b) : mix(b, a); }

/// Calls every verb for every element. Afterwards the mesh has built everything that it builds on first use.
template<class M>
digest digest_of(const M& m) {
  namespace cn = concino;
  digest d;
  d["V"] = cn::num_verts(m);
  d["E"] = cn::num_edges(m);
  d["P"] = cn::num_polys(m);
  auto edge = [&](auto e) {
    std::uint64_t ends[2] = {}, n = 0;
    for (auto v : cn::adj_e2v(m, e)) ends[n++ % 2] = cn::index_of(m, v);
    return edge_key(ends[0], ends[1]);
  };
  auto sum = [&](const char* name, auto&& from, auto&& neighbours, auto&& key_from, auto&& key_to) {
    std::uint64_t s = 0;
    for (auto x : from(m))
      for (auto y : neighbours(m, x)) s += mix(key_from(x), key_to(y));
    d[name] = s;
  };
  auto index = [&](auto x) { return static_cast<std::uint64_t>(cn::index_of(m, x)); };
  sum("v2v", cn::verts, cn::adj_v2v, index, index);
  sum("v2e", cn::verts, cn::adj_v2e, index, edge);
  sum("v2p", cn::verts, cn::adj_v2p, index, index);
  sum("e2v", cn::edges, cn::adj_e2v, edge, index);
  sum("e2p", cn::edges, cn::adj_e2p, edge, index);
  sum("p2v", cn::polys, cn::adj_p2v, index, index);
  sum("p2e", cn::polys, cn::adj_p2e, index, edge);
  sum("p2p", cn::polys, cn::adj_p2p, index, index);
  if constexpr (cn::VolumeMesh<M>) {
    d["F"] = cn::num_faces(m);
    auto face = [&](auto f) {
      std::uint64_t s = 0;
      for (auto v : cn::adj_f2v(m, f)) s += mix(1, cn::index_of(m, v));
      return s;
    };
    sum("v2f", cn::verts, cn::adj_v2f, index, face);
    sum("e2f", cn::edges, cn::adj_e2f, edge, face);
    sum("f2v", cn::faces, cn::adj_f2v, face, index);
    sum("f2e", cn::faces, cn::adj_f2e, face, edge);
    sum("f2p", cn::faces, cn::adj_f2p, face, index);
    sum("p2f", cn::polys, cn::adj_p2f, index, face);
  }
  return d;
}

namespace detail {

/// The sum over rows first(i) .. last(i) of `to`; entries `none` are skipped.
template<class First, class Last, class KeyFrom, class KeyTo>
std::uint64_t sum(u32 n, First first, Last last, const floors::buffer<u32>& to, KeyFrom from, KeyTo key) {
  std::uint64_t s = 0;
  for (u32 i = 0; i < n; ++i)
    for (u32 k = first(i); k != last(i); ++k)
      if (to[k] != floors::none) s += mix(from(i), key(to[k]));
  return s;
}

template<class M, class First, class Last, class FirstEdge, class LastEdge>
digest common(const M& m, const floors::buffer<u32>& p2v, const floors::buffer<u32>& p2e, First pv, Last pv_end, FirstEdge pe,
              LastEdge pe_end) {
  digest d;
  d["V"] = m.num_verts();
  d["E"] = m.num_edges();
  d["P"] = m.num_polys();
  auto same = [](u32 i) { return std::uint64_t{i}; };
  auto edge = [&](u32 e) { return edge_key(m.e2v[2 * e], m.e2v[2 * e + 1]); };
  auto v = [&](u32 i) { return m.v_off[i]; };
  auto v_end = [&](u32 i) { return m.v_off[i + 1]; };
  d["v2v"] = sum(m.num_verts(), v, v_end, m.v2v, same, same);
  d["v2e"] = sum(m.num_verts(), v, v_end, m.v2e, same, edge);
  d["v2p"] = sum(m.num_verts(), [&](u32 i) { return m.vp_off[i]; }, [&](u32 i) { return m.vp_off[i + 1]; }, m.v2p, same, same);
  d["e2v"] = sum(m.num_edges(), [](u32 i) { return 2 * i; }, [](u32 i) { return 2 * i + 2; }, m.e2v, edge, same);
  d["p2v"] = sum(m.num_polys(), pv, pv_end, p2v, same, same);
  d["p2e"] = sum(m.num_polys(), pe, pe_end, p2e, same, edge);
  return d;
}

}  // namespace detail

template<u32 K>
digest digest_of(const floors::surface<K>& m) {
  auto first = [&](u32 p) { return m.first(p); };
  auto last = [&](u32 p) { return m.last(p); };
  auto same = [](u32 i) { return std::uint64_t{i}; };
  digest d = detail::common(m, m.p2v, m.p2e, first, last, first, last);
  d["p2p"] = detail::sum(m.num_polys(), first, last, m.p2p, same, same);
  d["e2p"] = detail::sum(m.num_edges(), [](u32 i) { return 2 * i; }, [](u32 i) { return 2 * i + 2; }, m.e2p,
                         [&](u32 e) { return edge_key(m.e2v[2 * e], m.e2v[2 * e + 1]); }, same);
  return d;
}

template<class S>
digest digest_of(const floors::cells<S>& m) {
  auto row = [](u32 n) { return [n](u32 i) { return n * i; }; };
  auto end = [](u32 n) { return [n](u32 i) { return n * i + n; }; };
  auto same = [](u32 i) { return std::uint64_t{i}; };
  digest d = detail::common(m, m.p2v, m.p2e, row(S::verts), end(S::verts), row(S::edges), end(S::edges));
  d["F"] = m.num_faces();
  d["p2p"] = detail::sum(m.num_polys(), row(S::faces), end(S::faces), m.p2p, same, same);
  d["p2f"] = detail::sum(m.num_polys(), row(S::faces), end(S::faces), m.p2f, same, [&](u32 f) {
    std::uint64_t s = 0;
    for (u32 i : S::face[m.f2h[f] % S::faces]) s += mix(1, m.p2v[m.f2h[f] / S::faces * S::verts + i]);
    return s;
  });
  return d;
}

inline digest digest_of(const floors::polyhedra& m) {
  auto same = [](u32 i) { return std::uint64_t{i}; };
  auto at = [](const floors::buffer<u32>& off) { return [&off](u32 i) { return off[i]; }; };
  auto end = [](const floors::buffer<u32>& off) { return [&off](u32 i) { return off[i + 1]; }; };
  digest d = detail::common(m, m.p2v, m.p2e, at(m.pv_off), end(m.pv_off), at(m.pe_off), end(m.pe_off));
  d["F"] = m.num_faces();
  d["p2p"] = detail::sum(m.num_polys(), at(m.p_off), end(m.p_off), m.p2p, same, same);
  d["p2f"] = detail::sum(m.num_polys(), at(m.p_off), end(m.p_off), m.p2f, same, [&](u32 f) {
    f &= ~floors::polyhedra::outward;
    std::uint64_t s = 0;
    for (u32 k = m.f_off[f]; k != m.f_off[f + 1]; ++k) s += mix(1, m.f2v[k]);
    return s;
  });
  return d;
}

/// Throws if the two differ in a sum that both have.
inline void expect_same(const std::string& work, const digest& floor, const digest& ours) {
  std::string differ;
  for (const auto& [name, value] : floor)
    if (const auto it = ours.find(name); it != ours.end() && it->second != value) differ += " " + name;
  if (!differ.empty()) throw std::runtime_error(work + ": the floor and the library disagree on" + differ);
}

}  // namespace bench
