// Chords of quads and sheets of hexes by one name each, layers, for tests of their edits; random edits of layers.
#pragma once

#include <concino/layout.hpp>
#include <concino/mesh.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <doctest/doctest.h>

#include <array>
#include <random>
#include <set>
#include <vector>

namespace concino::testing {

template<SurfaceMesh M>
auto layers_of(const M& m) { return chords(m); }
template<VolumeMesh M>
auto layers_of(const M& m) { return sheets(m); }
template<SurfaceMesh M>
auto layer_through(const M& m, const edge_t<M>& e) { return chord_of(m, e); }
template<VolumeMesh M>
auto layer_through(const M& m, const edge_t<M>& e) { return sheet_of(m, e); }
template<class M>
auto& edges_of(chord<M>& c) { return c.facets; }
template<class M>
auto& edges_of(sheet<M>& s) { return s.edges; }
template<class M>
const auto& polys_of(const chord<M>& c) { return c.polys; }
template<class M>
const auto& polys_of(const sheet<M>& s) { return s.polys; }
template<class L>
void cut_short(L& layer) { edges_of(layer).pop_back(); }

template<class M>
permission can_collapse_layer(const M& m, const chord<M>& c, const collapse_sheet_options& o = {}) { return can_collapse_chord(m, c, o); }
template<class M>
permission can_collapse_layer(const M& m, const sheet<M>& s, const collapse_sheet_options& o = {}) { return can_collapse_sheet(m, s, o); }
template<class M>
auto collapse_layer(M& m, const chord<M>& c, const collapse_sheet_options& o = {}) { return collapse_chord(m, c, o); }
template<class M>
auto collapse_layer(M& m, const sheet<M>& s, const collapse_sheet_options& o = {}) { return collapse_sheet(m, s, o); }
template<class M>
const auto& facets_of(const collapsed_chord<M>& c) { return c.edges; }
template<class M>
const auto& facets_of(const collapsed_sheet<M>& s) { return s.faces; }
template<class M>
auto insert_layer(M& m, const std::vector<facet_t<M>>& all, const insert_sheet_options& o = {}) {
  permission allowed;
  inserted_sheet<M> r;
  if constexpr (SurfaceMesh<M>) allowed = can_insert_chord(m, all, o), r = insert_chord(m, all, o);
  else allowed = can_insert_sheet(m, all, o), r = insert_sheet(m, all, o);
  CHECK(allowed.reason == r.reason);
  return r;
}

template<class M>
std::ptrdiff_t chi_of(const M& m) {
  std::size_t chi = num_verts(m) - num_edges(m);
  if constexpr (VolumeMesh<M>) chi += num_faces(m) - num_polys(m);
  else chi += num_polys(m);
  return static_cast<std::ptrdiff_t>(chi);
}
template<class M>
std::array<std::size_t, 4> counts_of(const M& m) {
  return {num_verts(m), num_edges(m), num_facets(m), num_polys(m)};
}
/// Sizes and shapes of all layers, sorted.
template<class M>
auto summary_of_layers(const M& m) {
  std::multiset<std::array<std::size_t, 4>> all;
  for (auto s : layers_of(m)) all.insert({edges_of(s).size(), s.polys.size(), s.is_closed, s.crosses_itself});
  return all;
}

/// Random collapses, insertions, pillows and, of quads, collapses along diagonals. What is collapsed is inserted again half of the time. Laws hold at
/// intervals, the Euler characteristic always. Returns the numbers of edits that were made, of each sort.
template<class M>
std::array<std::size_t, 4> edit_layers_at_random(M& m, unsigned num_edits, unsigned seed, std::size_t max_polys) {
  std::mt19937 random(seed);
  const auto chi = chi_of(m);
  std::array<std::size_t, 4> made{};
  const auto any = [&](const auto& range, std::size_t count) {
    auto it = range.begin();
    for (std::size_t i = random() % count; i > 0; --i) ++it;
    return *it;
  };
  for (unsigned k = 1; k <= num_edits; ++k) {
    const unsigned what = num_polys(m) > max_polys ? 0 : random() % 4;
    if (what < 2 || (what == 3 && VolumeMesh<M>)) {
      const auto s = layer_through(m, any(edges(m), num_edges(m)));
      const auto counts = counts_of(m);
      if (const auto back = collapse_layer(m, s)) {
        ++made[0];
        if (!facets_of(back).empty() && what > 0) {
          const auto r = insert_layer(m, facets_of(back));
          CHECK(r);
          if (r) ++made[1];
          CHECK((!r || counts_of(m) == counts));
        }
      } else {
        CHECK(counts_of(m) == counts);
      }
    } else if (what == 2) {
      std::vector<poly_t<M>> some{any(polys(m), num_polys(m))};
      for (const auto p : adj_p2p(m, some[0]))
        if (random() % 2) some.push_back(p);
      made[2] += bool(pillow(m, some, {.at_boundary = random() % 2 == 0}));
    } else {
      if constexpr (SurfaceMesh<M>) {
        const auto p = any(polys(m), num_polys(m));
        made[3] += bool(diagonal_collapse(m, p, any(adj_p2v(m, p), 4)));
      }
    }
    REQUIRE(chi_of(m) == chi);
    if (k % 100 == 0 || k == num_edits) REQUIRE(check_laws(m).empty());
  }
  return made;
}

}  // namespace concino::testing
