// Compares chords, singularities and blocks of meshes whose polys are quads or hexes.
#pragma once

#include <agreement/matched.hpp>

#include <concino/layout.hpp>
#include <concino/mesh/support/native_mesh_of.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

namespace concino::agreement {

struct layouts {
  static constexpr const char* name = "layouts";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M> && requirement::may_be_quads_or_hexes<M>;
  static constexpr bool needs_a_shape = true;  // quads, on surfaces

  /// What does not depend on descriptors: verts and polys have their numbers in the order of the ranges, facets the numbers of their verts.
  struct description {
    std::map<numbers, std::array<std::vector<numbers>, 3>> chords;  // by its smallest facet: its facets, and whether it is closed and crosses itself
    std::map<unsigned, std::array<unsigned, 3>> singular;
    std::vector<std::uint32_t> blocks;  // by poly
    std::map<numbers, bool> interfaces;
    std::size_t num_blocks = 0, num_separatrices = 0, num_sheets = 0;
    bool periodic = false, has_mesh = false;

    friend bool operator==(const description&, const description&) = default;
  };

  template<class M, class Number>
  static description describe(const M& m, const Number& number_of_vert) {
    description d;
    const auto key = [&](const facet_t<M>& f) {
      numbers all;
      for (const auto v : adj_facet2v(m, f)) all.push_back(number_of_vert(v));
      return sorted(all);
    };
    for (const auto& c : chords(m)) {
      std::vector<numbers> all;
      for (const auto& f : c.facets) all.push_back(key(f));
      std::sort(all.begin(), all.end());
      const numbers smallest = all.front();
      d.chords[smallest] = {all, std::vector<numbers>(c.is_closed), std::vector<numbers>(c.crosses_itself)};
    }
    for (const auto& x : singular_verts(m)) d.singular[number_of_vert(x.element)] = {x.valence, x.on_boundary, x.is_manifold};
    const auto l = coarse_layout(m);
    for (const auto p : polys(m)) d.blocks.push_back(l.block[p]);
    for (const auto f : facets(m)) d.interfaces[key(f)] = l.is_interface[f];
    d.num_blocks = l.num_blocks, d.periodic = l.periodic, d.has_mesh = l.blocks.has_value();
    d.num_separatrices = separatrices(m).size();
    if constexpr (HexMesh<M>) d.num_sheets = sheets(m).size();
    return d;
  }

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using M = typename B::other_mesh;
    constexpr std::size_t n = dimension_v<M> == 2 ? 4 : 8;
    std::vector<unsigned> number(vert_index_bound(both.native));
    std::vector<vec3> points;
    for (const auto v : both.verts.all) number[v.raw()] = static_cast<unsigned>(points.size()), points.push_back(to_vec3(point(both.native, v)));
    const auto number_there = [&](const vert_t<M>& v) { return number[both.verts.back(v).raw()]; };
    std::vector<numbers> lists;  // in the order of the other mesh, as a reference without fixed arity does not know that of hexes
    for (const auto p : polys(both.other)) {
      lists.emplace_back();
      for (const auto v : adj_p2v(both.other, p)) lists.back().push_back(number_there(v));
      if (lists.back().size() != n) return false;
    }
    const typename core::native_mesh_of<dimension_v<M>, n>::type native(points, lists);
    const auto expected = describe(native, [](vert_id v) { return v.raw(); }), found = describe(both.other, number_there);
    expect(expected.chords == found.chords, "the same chords");
    expect(expected.singular == found.singular, "the same singular verts");
    expect(expected.blocks == found.blocks && expected.interfaces == found.interfaces, "the same blocks");
    expect(expected == found, "as many separatrices and sheets");
    return !lists.empty();
  }
};

}  // namespace concino::agreement
