// Measures chords, sheets and blocks of quads and hexes, and collapses and insertions of sheets: seconds.
#include "support/kinds.hpp"

#include <concino/generate/grid.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/layout.hpp>

#include <stdexcept>
#include <string>

namespace {

namespace cn = concino;

template<class F>
void measure(const bench::program& p, const std::string& work, const F& f) {
  if (p.wants(work)) p.print(bench::compare(work, p.rounds, {{"concino", [&] { return bench::seconds_of(f); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (!p.wants("layout.")) return;
    const auto quads = cn::make_sphere<cn::quadmesh>({.cells = 128});
    const auto hexes = cn::make_sphere<cn::hexmesh>({.cells = 32});
    measure(p, "layout.chords.quad98k", [&] { return cn::chords(quads).size(); });
    measure(p, "layout.sheets.hex131k", [&] { return cn::sheets(hexes).size(); });
    measure(p, "layout.blocks.quad98k", [&] { return cn::coarse_layout(quads).num_blocks; });
    measure(p, "layout.blocks.hex131k", [&] { return cn::coarse_layout(hexes).num_blocks; });
    auto m = hexes;
    measure(p, "layout.collapse-insert.hex131k", [&] {
      const auto back = cn::collapse_sheet(m, cn::sheet_of(m, *cn::edges(m).begin()));
      if (!back || !cn::insert_sheet(m, back.faces)) throw std::runtime_error("layout: a sheet is not collapsed and inserted");
      return cn::num_polys(m);
    });
  });
}
