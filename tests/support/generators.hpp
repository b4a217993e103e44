// Checks generators of the first homology group of a closed surface: they are closed walks, and cutting along them gives a disk.
#pragma once

#include <concino/graph/boundary_loops.hpp>
#include <concino/graph/cut_along.hpp>
#include <concino/graph/homology.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <support/disk.hpp>

#include <doctest/doctest.h>

#include <set>

namespace concino::testing {

/// Checks that consecutive verts of a walk are the ends of its edges, and that the last edge leads back to the first vert.
template<class M>
void check_closed(const M& m, const edge_walk<M>& loop) {
  REQUIRE(loop.is_closed());
  for (std::size_t i = 0; i < loop.edges.size(); ++i) {
    const auto& a = loop.verts[i];
    const auto& b = loop.verts[(i + 1) % loop.verts.size()];
    bool has_a = false, has_b = false;
    for (const auto v : adj_e2v(m, loop.edges[i])) {
      has_a = has_a || v == a;
      has_b = has_b || v == b;
    }
    REQUIRE(has_a);
    REQUIRE(has_b);
  }
}

template<class M>
void check_is_disk(const cut_along_result<M>& cut) {
  const polygonmesh disk(cut.surface);
  const auto shape = topology_of(disk);
  CHECK(shape.edges_are_manifold);
  CHECK(shape.verts_are_manifold);
  CHECK(shape.pieces == 1);
  CHECK(shape.chi == 1);
  const auto border = boundary_loops(disk);
  CHECK(border.count == 1);
  CHECK(border.loops.size() == 1);
}

template<class M>
void check_generators(const M& m, std::size_t expected) {
  const auto loops = homology_generators(m);
  CHECK(loops.size() == expected);
  for (const auto& loop : loops) {
    check_closed(m, loop);
    CHECK(loop.verts.front() == loops.front().verts.front());
  }
  if (expected > 0) check_is_disk(cut_along(m, loops));

  const auto cycles = homology_generators(m, {.from_root = false});
  REQUIRE(cycles.size() == expected);
  for (std::size_t i = 0; i < expected; ++i) {
    check_closed(m, cycles[i]);
    std::set<std::size_t> different;
    for (const auto& v : cycles[i].verts) different.insert(index_of(m, v));
    CHECK(different.size() == cycles[i].verts.size());
    CHECK(cycles[i].edges.size() <= loops[i].edges.size());
  }
}

}  // namespace concino::testing
