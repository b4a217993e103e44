#include "call.hpp"

#include <concino/layout.hpp>

void call_layout() {
  constexpr kinds<cn::quadmesh, cn::hexmesh> cubes;
  constexpr kinds<cn::hexmesh> hexes;
  call("chord_of", [](auto& m) { cn::chord_of(m, first(cn::facets(m))); }, cubes);
  call("chords", [](auto& m) { cn::chords(m); }, cubes);
  call("sheet_of", [](auto& m) { cn::sheet_of(m, first(cn::edges(m))); }, hexes);
  call("sheets", [](auto& m) { cn::sheets(m); }, hexes);
  call("singular_verts", [](auto& m) { cn::singular_verts(m); }, cubes);
  call("singular_edges", [](auto& m) { cn::singular_edges(m); }, hexes);
  call("separatrices", [](auto& m) { cn::separatrices(m); }, cubes);
  call("coarse_layout", [](auto& m) { cn::coarse_layout(m); }, cubes);
}
