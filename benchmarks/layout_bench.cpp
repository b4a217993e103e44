// Measures chords, sheets and blocks of quads and hexes, and their edits: collapses and insertions of chords and sheets, pillows, collapses of diagonals: seconds.
#include "support/kinds.hpp"

#include <concino/generate/grid.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/layout.hpp>

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace cn = concino;

template<class F>
void measure(const bench::program& p, const std::string& work, const F& f) {
  if (p.wants(work)) p.print(bench::compare(work, p.rounds, {{"concino", [&] { return bench::seconds_of(f); }}}));
}

/// Calls f(mesh, poly) for a thousand polys of a copy, which is made before the clock starts.
template<class M, class F>
void measure_edits(const bench::program& p, const std::string& work, const M& m, const F& f) {
  if (!p.wants(work)) return;
  p.print(bench::compare(work, p.rounds, {{"concino", [&] {
    auto copy = std::make_unique<M>(m);
    const std::size_t n = cn::num_polys(m), step = n / 1000 + 1;
    return bench::seconds_of([&] {
      std::size_t done = 0;
      for (std::size_t i = 0; i < n; i += step)
        if (const cn::poly_id x{i}; cn::contains(*copy, x)) done += f(*copy, x);
      if (done == 0) throw std::runtime_error(work + ": no edit was possible");
      return done;
    });
  }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (!p.wants("layout.")) return;
    const auto quads = cn::make_sphere<cn::quadmesh>({.cells = p.data.tiny ? 8u : 128u});
    const auto hexes = cn::make_sphere<cn::hexmesh>({.cells = p.data.tiny ? 4u : 32u});
    measure(p, "layout.chords.quad98k", [&] { return cn::chords(quads).size(); });
    measure(p, "layout.sheets.hex131k", [&] { return cn::sheets(hexes).size(); });
    measure(p, "layout.blocks.quad98k", [&] { return cn::coarse_layout(quads).num_blocks; });
    measure(p, "layout.blocks.hex131k", [&] { return cn::coarse_layout(hexes).num_blocks; });
    auto surface = quads;
    measure(p, "layout.collapse-insert.quad98k", [&] {
      const auto back = cn::collapse_chord(surface, cn::chord_of(surface, *cn::edges(surface).begin()));
      if (!back || !cn::insert_chord(surface, back.edges)) throw std::runtime_error("layout: a chord is not collapsed and inserted");
      return cn::num_polys(surface);
    });
    measure_edits(p, "layout.pillow.quad98k", quads, [](auto& x, cn::poly_id q) { return bool(cn::pillow(x, std::vector{q})); });
    measure_edits(p, "layout.pillow.hex131k", hexes, [](auto& x, cn::poly_id q) { return bool(cn::pillow(x, std::vector{q})); });
    measure_edits(p, "layout.diagonal.quad98k", quads, [](auto& x, cn::poly_id q) { return bool(cn::diagonal_collapse(x, q, *cn::adj_p2v(x, q).begin())); });
    auto m = hexes;
    measure(p, "layout.collapse-insert.hex131k", [&] {
      const auto back = cn::collapse_sheet(m, cn::sheet_of(m, *cn::edges(m).begin()));
      if (!back || !cn::insert_sheet(m, back.faces)) throw std::runtime_error("layout: a sheet is not collapsed and inserted");
      return cn::num_polys(m);
    });
  });
}
