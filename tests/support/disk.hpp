// Checks whether a surface is a disk, by its components and Euler characteristic.
#pragma once

#include <concino/concepts/surface_mesh.hpp>

#include <vector>

namespace concino::testing {

/// The number of components of a surface, connected through edges, and its Euler characteristic, which counts only verts of polys.
struct topology {
  int pieces = 0, chi = 0;
  bool edges_are_manifold = true, verts_are_manifold = true;
};

template<SurfaceMesh M>
topology topology_of(const M& m) {
  topology t;
  for (const auto v : verts(m)) {
    std::vector<poly_t<M>> star, fan;
    for (const auto p : adj_v2p(m, v)) star.push_back(p);
    if (star.empty()) continue;
    ++t.chi;
    const auto holds = [](const auto& list, const auto& x) {
      for (const auto& y : list)
        if (x == y) return true;
      return false;
    };
    fan.push_back(star[0]);
    for (std::size_t i = 0; i < fan.size(); ++i)
      for (const auto e : adj_v2e(m, v)) {
        std::vector<poly_t<M>> sides;
        for (const auto p : adj_e2p(m, e)) sides.push_back(p);
        if (holds(sides, fan[i]))
          for (const auto& q : sides)
            if (!holds(fan, q)) fan.push_back(q);
      }
    t.verts_are_manifold = t.verts_are_manifold && fan.size() == star.size();
  }
  for (const auto e : edges(m)) {
    int n = 0;
    for ([[maybe_unused]] const auto p : adj_e2p(m, e)) ++n;
    t.chi -= n > 0;
    t.edges_are_manifold = t.edges_are_manifold && n <= 2;
  }
  std::vector<unsigned char> met(poly_index_bound(m));
  for (const auto p : polys(m)) {
    ++t.chi;
    if (met[index_of(m, p)]) continue;
    ++t.pieces;
    std::vector<poly_t<M>> waiting{p};
    met[index_of(m, p)] = 1;
    while (!waiting.empty()) {
      const auto x = waiting.back();
      waiting.pop_back();
      for (const auto q : adj_p2p(m, x)) {
        if (met[index_of(m, q)]) continue;
        met[index_of(m, q)] = 1;
        waiting.push_back(q);
      }
    }
  }
  return t;
}

}  // namespace concino::testing
