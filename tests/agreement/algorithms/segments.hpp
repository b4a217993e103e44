// Compares min_cut, segment_polys and segment_verts: their results are unique, so they do not depend on the order of elements.
#pragma once

#include <agreement/algorithms/searches.hpp>
#include <agreement/matched.hpp>

#include <concino/graph/min_cut.hpp>
#include <concino/graph/segment.hpp>

namespace concino::agreement {

struct segments {
  static constexpr const char* name = "segments";
  template<class M> static constexpr bool runs_on = has_a_graph<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    bool any = false;
    each_graph(both, [&](const auto& nodes) {
      if (nodes.empty()) return;
      const auto a = nodes.first(), c = nodes.last();
      if (a == c) return;
      any = true;
      const auto expected = min_cut(both.native, a, c, scrambled_length);
      const auto found = min_cut(both.other, nodes.to(a), nodes.to(c), scrambled_in(nodes));
      expect_close(expected.capacity, found.capacity, expected.capacity, "the same capacity");
      for (const auto x : nodes.all) expect(expected.on_source_side[x] == found.on_source_side[nodes.to(x)], "the same cut");
      const auto back = [&](const auto& x) { return nodes.back(x); };
      const auto cost_of = [](auto x, int l) { return 3 * scrambled(x.raw(), static_cast<unsigned>(1000000 + l)); };
      for (const int labels : {2, 3}) {
        const segment_options options = {.labels = labels, .smoothness = 0.4};
        const auto compare = [&](const auto& native, const auto& other) {
          expect_close(native.energy, other.energy, native.energy, "the same energy");
          for (const auto x : nodes.all) expect(native.label[x] == other.label[nodes.to(x)], "the same label");
        };
        const auto other_cost = [&](const auto& x, int l) { return cost_of(back(x), l); };
        if constexpr (std::same_as<typename std::remove_cvref_t<decltype(nodes)>::id, poly_id>)
          compare(segment_polys(both.native, cost_of, options), segment_polys(both.other, other_cost, options));
        else compare(segment_verts(both.native, cost_of, options), segment_verts(both.other, other_cost, options));
      }
    });
    return any;
  }
};

}  // namespace concino::agreement
