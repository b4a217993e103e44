// Edits of triangles that the library and its peers do: up to 100,000 splits, flips and collapses of edges in the order of the edges, or in random order.
// Each run works on a copy of the mesh, which is made before the clock starts and has been edited once, so that its tables are editable.
#pragma once

#include "program.hpp"

#include <concino/edit.hpp>
#include <concino/mesh.hpp>

#include <algorithm>
#include <memory>
#include <random>
#include <stdexcept>
#include <vector>

namespace bench {

struct edit_counts {
  std::size_t done = 0, asked = 0;
};

/// The numbers of the edges to edit, at most 100,000.
inline std::vector<u32> edges_to_edit(std::size_t num_edges, bool shuffled) {
  std::vector<u32> all(num_edges);
  for (u32 i = 0; i < all.size(); ++i) all[i] = i;
  if (shuffled) std::shuffle(all.begin(), all.end(), std::mt19937(7));
  all.resize(std::min<std::size_t>(all.size(), 100'000));
  return all;
}

/// The CPU seconds that `edit(mesh, edge)` takes for all these edges, on a copy of m.
template<class M, class Edit>
double seconds_of_edits(const M& m, const std::vector<u32>& edges, const Edit& edit) {
  auto copy = std::make_unique<M>(m);
  return seconds_of([&] {
    edit_counts n;
    for (const u32 e : edges) n.asked += 1, n.done += edit(*copy, e);
    return n;
  });
}

/// A mesh of this library that was edited once: a vert was added and removed, of triangles an edge was flipped and flipped back too.
template<class M, class Arrays>
M editable(const Arrays& a) {
  M m(a);
  concino::remove_vert(m, concino::add_vert(m, {0, 0, 0}));
  if constexpr (concino::TriMesh<M>)
    for (const auto e : concino::edges(m))
      if (concino::edge_flip(m, e)) {
        if (!concino::edge_flip(m, e)) throw std::runtime_error("an edge cannot be flipped back");
        break;
      }
  return m;
}

template<class M>
bool split(M& m, u32 e) { return bool(concino::edge_split(m, concino::edge_id{e})); }
template<class M>
bool flip(M& m, u32 e) { return bool(concino::edge_flip(m, concino::edge_id{e})); }  // all edges remain, here and in the peers
template<class M>
bool collapse(M& m, u32 e) { return concino::contains(m, concino::edge_id{e}) && concino::edge_collapse(m, concino::edge_id{e}); }

/// Compares the three edits of a peer's triangle mesh with ours. Peer: static num_edges(m), and split(m, e), flip(m, e), collapse(m, e), which return
/// whether they were done. Edges have other numbers there, so not quite the same edges are edited.
template<class Peer, class PeerMesh>
void compare_edits(const program& p, const char* name, const surface_arrays& arrays, const PeerMesh& theirs) {
  const auto ours = editable<concino::trimesh>(arrays);
  if (Peer::num_edges(theirs) != concino::num_edges(ours)) throw std::runtime_error(std::string(name) + ": the meshes differ");
  for (const bool shuffled : {false, true}) {
    const auto edges = edges_to_edit(concino::num_edges(ours), shuffled);
    const auto run = [&](const char* edit, auto mine, auto peer) {
      const std::string work = std::string("edit.") + edit + (shuffled ? ".random" : "") + ".bunny16";
      if (!p.wants(work)) return;
      p.print(compare(work, p.rounds, {{name, [&] { return seconds_of_edits(theirs, edges, peer); }}, {"concino", [&] { return seconds_of_edits(ours, edges, mine); }}}));
    };
    run("split", split<concino::trimesh>, Peer::split);
    run("flip", flip<concino::trimesh>, Peer::flip);
    run("collapse", collapse<concino::trimesh>, Peer::collapse);
  }
}

}  // namespace bench
