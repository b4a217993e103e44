#include "call.hpp"

#include <concino/edit.hpp>
#include <concino/layout.hpp>

#include <vector>

void call_layout() {
  constexpr kinds<cn::quadmesh, cn::hexmesh> cubes;
  constexpr kinds<cn::quadmesh> quads;
  constexpr kinds<cn::hexmesh> hexes;
  call("chord_of", [](auto& m) { cn::chord_of(m, first(cn::facets(m))); }, cubes);
  call("chords", [](auto& m) { cn::chords(m); }, cubes);
  call("sheet_of", [](auto& m) { cn::sheet_of(m, first(cn::edges(m))); }, hexes);
  call("sheets", [](auto& m) { cn::sheets(m); }, hexes);
  call("singular_verts", [](auto& m) { cn::singular_verts(m); }, cubes);
  call("singular_edges", [](auto& m) { cn::singular_edges(m); }, hexes);
  call("separatrices", [](auto& m) { cn::separatrices(m); }, cubes);
  call("can_collapse_chord", [](auto& m) { cn::can_collapse_chord(m, cn::chord_of(m, first(cn::edges(m)))); }, quads);
  call("collapse_chord", [](auto& m) { cn::collapse_chord(m, cn::chord_of(m, first(cn::edges(m)))); }, quads);
  call("can_collapse_sheet", [](auto& m) { cn::can_collapse_sheet(m, cn::sheet_of(m, first(cn::edges(m)))); }, hexes);
  call("collapse_sheet", [](auto& m) { cn::collapse_sheet(m, cn::sheet_of(m, first(cn::edges(m)))); }, hexes);
  call("can_insert_chord", [](auto& m) { cn::can_insert_chord(m, cn::collapse_chord(m, cn::chord_of(m, first(cn::edges(m)))).edges); }, quads);
  call("insert_chord", [](auto& m) { cn::insert_chord(m, cn::collapse_chord(m, cn::chord_of(m, first(cn::edges(m)))).edges); }, quads);
  call("can_insert_sheet", [](auto& m) { cn::can_insert_sheet(m, cn::collapse_sheet(m, cn::sheet_of(m, first(cn::edges(m)))).faces); }, hexes);
  call("insert_sheet", [](auto& m) { cn::insert_sheet(m, cn::collapse_sheet(m, cn::sheet_of(m, first(cn::edges(m)))).faces); }, hexes);
  call("can_pillow", [](auto& m) { cn::can_pillow(m, std::vector{first(cn::polys(m))}); }, cubes);
  call("pillow", [](auto& m) { cn::pillow(m, std::vector{first(cn::polys(m))}, {.keep = {cn::min_quality(0.01)}}); }, cubes);
  call("can_diagonal_collapse", [](auto& m) { cn::can_diagonal_collapse(m, first(cn::polys(m)), cn::vert_id{0}); }, quads);
  call("diagonal_collapse", [](auto& m) { cn::diagonal_collapse(m, first(cn::polys(m)), cn::vert_id{0}); }, quads);
  call("coarse_layout", [](auto& m) { cn::coarse_layout(m); }, cubes);
}
