// Bodies of repair_log.hpp: the sentences of a repair.
#pragma once

#include <concino/core/message.hpp>
#include <concino/repair/detail/repair_log.hpp>

#include <algorithm>

namespace concino::detail {

/// The sentence of one kind: what is said of one element and of several, and the kind of elements.
struct repair_sentence {
  const char *one, *several;
  bool names_verts;
};

inline constexpr repair_sentence repair_sentences[num_repair_kinds] = {
    {" vert became one with others, at their mean", " verts became one with others, at their mean", true},
    {" poly lost corners whose verts were merged", " polys lost corners whose verts were merged", false},
    {" degenerate poly was removed", " degenerate polys were removed", false},
    {" triangle without area was collapsed", " triangles without area were collapsed", false},
    {" poly with the same verts as an earlier one was removed",
     " polys with the same verts as earlier ones were removed", false},
    {" poly that intersected others was removed", " polys that intersected others were removed", false},
    {" non-manifold vert was split into fans", " non-manifold verts were split into fans", true},
    {" poly was turned", " polys were turned", false},
    {" hole was filled", " holes were filled", true},
    {" face became one with a face of the same verts", " faces became one with faces of the same verts", true},
    {" vert without polys was removed", " verts without polys were removed", true},
    {" face without polys was removed", " faces without polys were removed", true},
    {" triangle has no area; options.degenerate can remove or collapse it",
     " triangles have no area; options.degenerate can remove or collapse them", false},
    {" component is one-sided, so that it cannot be oriented",
     " components are one-sided, so that they cannot be oriented", false},
    {" hole has no filling whose triangles have area and are new",
     " holes have no filling whose triangles have area and are new", true},
    {" poly intersects others", " polys intersect others", false},
    {" polyhedron is open", " polyhedra are open", false},
    {" cell is inverted, but wound like its neighbours: turning it would not help, its verts have to move",
     " cells are inverted, but wound like their neighbours: turning them would not help, their verts have to move",
     false}};

/// Not holes, faces and components, which are named by one of their verts or polys.
inline bool names_elements_themselves(repair_kind kind) {
  for (const repair_kind k : {repair_kind::filled_holes, repair_kind::united_faces, repair_kind::removed_faces,
                              repair_kind::one_sided, repair_kind::left_hole})
    if (kind == k) return false;
  return true;
}

CONCINO_INLINE void repair_log::write(repair_result& to) {
  const auto rename = [](std::vector<std::uint32_t>& all, const std::vector<std::uint32_t>& index) {
    for (std::uint32_t& x : all)
      if (x < index.size()) x = index[x];
  };
  for (std::size_t k = 0; k < num_repair_kinds; ++k) {
    std::vector<std::uint32_t>& all = elements_[k];
    if (all.empty()) continue;
    const repair_sentence& s = repair_sentences[k];
    const auto kind = static_cast<repair_kind>(k);
    if (!std::is_sorted(all.begin(), all.end())) std::sort(all.begin(), all.end());
    if (names_elements_themselves(kind)) all.erase(std::unique(all.begin(), all.end()), all.end());
    rename(all, s.names_verts ? vert_index_ : poly_index_);
    std::string what =
        core::joined({all.size(), all.size() == 1 ? s.one : s.several, ": ",
                      s.names_verts ? (all.size() == 1 ? "vert " : "verts ") : (all.size() == 1 ? "poly " : "polys ")});
    constexpr std::size_t most = 6;
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i)
      what += core::joined({i == 0 ? "" : i + 1 == all.size() ? " and " : ", ", all[i]});
    if (all.size() > most) what += core::joined({" and ", all.size() - most, " more"});
    (is_left(kind) ? to.left : to.done).push_back(what);
    to.records.push_back({kind, std::move(all), std::move(what)});
  }
  for (repair_record& r : single_) {
    rename(r.elements, poly_index_);
    (is_left(r.kind) ? to.left : to.done).push_back(r.what);
    to.records.push_back(std::move(r));
  }
}

}  // namespace concino::detail
