// Iterates over all adjacencies of a mesh, for checks that are the same for each of them.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/message.hpp>
#include <concino/core/vec3.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace concino::testing::detail {

/// Calls f("adj_v2v", 'v', verts, adj_v2v) and so on. The arguments are the name, the letter and the range of the
/// elements of its argument, and the verb.
template<class M, class F>
void for_each_adjacency([[maybe_unused]] const M& m, const F& f) {
  if constexpr (PrimalGraph<M>) f("adj_v2v", 'v', verts, adj_v2v);
  if constexpr (DualGraph<M>) f("adj_p2p", 'p', polys, adj_p2p);
  if constexpr (AnyMesh<M>) {
    f("adj_v2e", 'v', verts, adj_v2e);
    f("adj_v2p", 'v', verts, adj_v2p);
    f("adj_e2v", 'e', edges, adj_e2v);
    f("adj_e2p", 'e', edges, adj_e2p);
    f("adj_p2v", 'p', polys, adj_p2v);
    // the verb would sort
    f("adj_p2e", 'p', polys,
      [](const M& mesh, const poly_t<M>& p) -> decltype(auto) { return traits<M>::adj_p2e(mesh, p); });
  }
  if constexpr (VolumeMesh<M>) {  // surfaces have no faces
    f("adj_v2f", 'v', verts, adj_v2f);
    f("adj_e2f", 'e', edges, adj_e2f);
    f("adj_f2v", 'f', faces, adj_f2v);
    f("adj_f2e", 'f', faces,
      [](const M& mesh, const face_t<M>& x) -> decltype(auto) { return traits<M>::adj_f2e(mesh, x); });
    f("adj_f2p", 'f', faces, adj_f2p);
    f("adj_p2f", 'p', polys, adj_p2f);
  }
}

template<class M, class R>
std::vector<std::size_t> indices(const M& m, const R& ring) {
  std::vector<std::size_t> all;
  const auto end = ring.end();
  for (auto it = ring.begin(); it != end; ++it) all.push_back(index_of(m, *it));
  return all;
}

inline std::string name(char letter, std::size_t index) { return concino::core::joined({letter, index}); }

/// A hash of the results of all verbs of m.
template<class M>
std::uint64_t digest(const M& m) {
  std::uint64_t sum = 0;
  const auto take = [&](std::uint64_t x) { sum = (sum ^ x) * 0x9e3779b97f4a7c15u + (sum >> 29); };
  for_each_adjacency(m, [&](const char*, char, const auto& all, const auto& adjacent) {
    for (const auto x : all(m)) {
      take(index_of(m, x));
      for (const std::size_t i : indices(m, adjacent(m, x))) take(i);
    }
  });
  if constexpr (Embedded<M>)
    for (const vert_t<M> v : verts(m)) {
      const vec3 x = to_vec3(point(m, v));
      for (const double c : {x.x, x.y, x.z}) take(std::bit_cast<std::uint64_t>(c));
    }
  return sum;
}

}  // namespace concino::testing::detail
