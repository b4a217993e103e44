// Compares add_vert, add_poly, remove_poly and remove_vert on copies of meshes that have them, and splits, flips and collapses of edges and merges of polys where polys can be replaced.
#pragma once

#include <agreement/copies.hpp>
#include <agreement/matched.hpp>

#include <concino/edit/edge_collapse.hpp>
#include <concino/edit/edge_flip.hpp>
#include <concino/edit/edge_split.hpp>
#include <concino/edit/elements.hpp>
#include <concino/edit/merge_polys.hpp>
#include <concino/validate/check_laws.hpp>

#include <algorithm>
#include <span>
#include <type_traits>
#include <vector>

namespace concino::agreement {

struct edits {
  static constexpr const char* name = "edits";
  template<class M> static constexpr bool runs_on =
      EmbeddedMesh<M> && std::is_copy_constructible_v<M> && requirement::has_add_vert<M> && requirement::has_add_poly<M> &&
      requirement::has_remove_poly<M> && requirement::has_remove_vert<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    using M = typename B::other_mesh;
    using N = typename B::native_mesh;
    if (!both.polys.empty()) {
      N here = both.native;
      M there = both.other;
      for (const auto p : {both.polys.first(), both.polys.last()})
        if (contains(here, p)) {
          remove_poly(here, p);
          remove_poly(there, both.polys.to(p));
        }
      expect_same(here, there, "after polys were removed");
      const auto v = both.verts.all[both.verts.all.size() / 2];
      remove_vert(here, v);
      remove_vert(there, both.verts.to(v));
      expect_same(here, there, "after a vert was removed");
    }
    M there = both.other;
    std::vector<vert_t<M>> corners;
    constexpr int n = arity_v<M> ? arity_v<M> : dimension_v<M> == 2 ? 3 : 4;
    static constexpr double corner[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (int i = 0; i < n; ++i) {
      const double* const x = corner[n == 4 && dimension_v<M> == 3 && i == 3 ? 4 : i];
      corners.push_back(add_vert(there, vec3{50 + x[0], x[1], x[2]}));
    }
    const poly_t<M> p = add_poly(there, std::span<const vert_t<M>>(corners));
    expect(num_polys(there) == num_polys(both.native) + 1 && num_verts(there) == num_verts(both.native) + corners.size(), "one poly more, on verts of its own");
    std::size_t found = 0;
    for (const auto v : adj_p2v(there, p)) found += v == corners[found % corners.size()];
    expect(found == corners.size(), "the corners of the new poly");
    for (const auto q : both.polys.all) {
      numbers expected, now;
      for (const auto v : adj_p2v(both.native, q)) expected.push_back(v.raw());
      for (const auto v : adj_p2v(there, both.polys.to(q))) now.push_back(both.verts.back(v).raw());
      expect(sorted(expected) == sorted(now), "the others have the corners that they had");
    }
    expect(check_laws(there).empty(), "the laws hold after an addition");
    if constexpr (EditableSurfaceMesh<M> && EditableSurfaceMesh<N>) {
      constexpr bool only_simplices = EditableGeneralMesh<M> != EditableGeneralMesh<N>;  // meshes of quads refuse what polygons allow
      for (std::size_t i = 0; i < both.edges.all.size(); i += both.edges.all.size() / 3 + 1) {
        const auto e = both.edges.all[i];
        if constexpr (requirement::can_split_edges<M> && requirement::can_split_edges<N>)
          expect_same_edit(both, e, [](auto& m, const auto& x) -> permission { return edge_split(m, x, 0.5, {.only_simplices = only_simplices}); });
        expect_same_edit(both, e, [](auto& m, const auto& x) -> permission { return edge_flip(m, x); });
        expect_same_edit(both, e, [](auto& m, const auto& x) -> permission { return edge_collapse(m, x, {.only_simplices = only_simplices}); });
        if constexpr (EditableGeneralMesh<M> && EditableGeneralMesh<N>) expect_same_edit(both, e, [](auto& m, const auto& x) -> permission { return merge_polys(m, x); });
      }
    }
    return true;
  }

  /// An edit of edge e gives the same polys, up to the names of the verts that it makes or merges, or is refused. Some libraries cannot represent each result.
  template<class B, class Edit>
  static void expect_same_edit(const B& both, edge_id e, const Edit& edit) {
    auto here = both.native;
    auto there = both.other;
    const auto ends = end_verts(here, e);
    const permission expected = edit(here, e), found = edit(there, both.edges.to(e));
    if (found.reason != refusal::unsupported) expect(bool(expected) == bool(found), "the same edits are allowed");
    if (!expected || !found) return;
    const std::size_t bound = vert_index_bound(both.other), native_bound = vert_index_bound(both.native);
    const auto canonical = [&](vert_id v) { return v == ends.second ? ends.first.raw() : v.raw() < native_bound ? v.raw() : ~0u; };
    std::vector<numbers> all, others;
    for (const auto p : polys(here)) {
      all.emplace_back();
      for (const auto v : adj_p2v(here, p)) all.back().push_back(canonical(v));
    }
    for (const auto p : polys(there)) {
      others.emplace_back();
      for (const auto v : adj_p2v(there, p)) others.back().push_back(index_of(there, v) < bound ? canonical(both.verts.back(v)) : ~0u);
    }
    for (auto* const lists : {&all, &others}) {
      for (numbers& x : *lists) x = rotated(x);
      std::sort(lists->begin(), lists->end());
    }
    expect(all == others, "the same polys after an edit of an edge");
    expect(check_laws(there).empty(), "the laws hold after an edit of an edge");
  }

  template<class N, class M>
  static void expect_same(const N& here, const M& there, const char* when) {
    INFO(std::string(when));
    const auto native = general_copy(here);
    const matched<std::remove_cvref_t<decltype(native)>, M> both(native, there);  // throws if they differ
    for (const auto p : both.polys.all) {
      numbers expected, found;
      for (const auto v : adj_p2v(native, p)) expected.push_back(v.raw());
      for (const auto v : adj_p2v(there, both.polys.to(p))) found.push_back(both.verts.back(v).raw());
      expect(sorted(expected) == sorted(found), "polys of the same verts");
    }
    expect(check_laws(there).empty(), "the laws hold");
  }
};

}  // namespace concino::agreement
