// Checks the polys around the edges of tables of tets and hexes.
#pragma once

#include <concino/mesh/cell_tables.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace concino::testing {

/// The number of polys at e that can be reached from the first of them through faces at e with two polys.
template<class Tables>
std::size_t reached_around(const Tables& t, edge_id e, const std::vector<poly_id>& polys) {
  std::set<unsigned> met = {polys[0].raw()};
  std::vector<poly_id> waiting = {polys[0]};
  while (!waiting.empty()) {
    const poly_id p = waiting.back();
    waiting.pop_back();
    for (const face_id f : t.adj_p2f(p)) {
      const auto edges = t.adj_f2e(f);
      const auto two = t.adj_f2p(f);
      if (two.size() != 2 || std::find(edges.begin(), edges.end(), e) == edges.end()) continue;
      for (const poly_id q : two)
        if (met.insert(q.raw()).second) waiting.push_back(q);
    }
  }
  return met.size();
}

/// Checks that the polys around each edge are complete. They are found through faces if they are one ring or fan, and stored in a list otherwise.
template<class Tables>
void edges_are_right(const Tables& t) {
  std::vector<std::vector<poly_id>> at(t.edges().bound());
  for (const poly_id p : t.polys().all())
    for (const edge_id e : t.adj_p2e(p)) at[e.raw()].push_back(p);
  for (const edge_id e : t.edges().all()) {
    std::vector<poly_id> around;
    for (const poly_id p : t.adj_e2p(e)) around.push_back(p);
    std::sort(around.begin(), around.end());
    CHECK(around == at[e.raw()]);
    CHECK(t.is_non_manifold(e) == (reached_around(t, e, around) != around.size()));
  }
}

}  // namespace concino::testing
