// Measures edits of triangles and tets, with and without a transaction, and of polygons and polyhedra. The programs of peers measure the same edits of theirs
// beside ours.
#include "support/edits.hpp"

#include <concino/generate/dual_mesh.hpp>

#include <stdexcept>

namespace {

template<class M, class Arrays>
void edits(const bench::program& p, const std::string& name, const Arrays& arrays) {
  const M m = bench::editable<M>(arrays);
  const auto run = [&](const char* edit, auto f) {
    const std::string work = std::string("edit.") + edit + "." + name;
    if (!p.wants(work)) return;
    const auto edges = bench::edges_to_edit(concino::num_edges(m), false);
    M check = m;
    std::size_t done = 0;
    for (const bench::u32 e : edges) done += f(check, e);
    if (done == 0) throw std::runtime_error(work + ": no edit was possible");
    const auto recorded = [&, f] {
      auto copy = std::make_unique<M>(m);
      return bench::seconds_of([&] {
        concino::transaction t(*copy);
        for (const bench::u32 e : edges) f(*copy, e);
        return t.commit();
      });
    };
    p.print(bench::compare(work, p.rounds, {{"recorded", recorded}, {"concino", [&, f] { return bench::seconds_of_edits(m, edges, f); }}}));
  };
  run("split", bench::split<M>);
  run("flip", bench::flip<M>);
  run("collapse", bench::collapse<M>);
}

/// The first 20,000 splits of edges, merges of polys and collapses of edges of cells.
template<class M>
void poly_edits(const bench::program& p, const std::string& name, const M& m) {
  const auto run = [&](const char* edit, const auto& range, auto f) {
    const std::string work = std::string("edit.polys.") + edit + "." + name;
    if (!p.wants(work)) return;
    std::vector<std::remove_cvref_t<decltype(*range.begin())>> all;
    for (const auto x : range)
      if (all.size() < 20'000) all.push_back(x);
    p.print(bench::compare(work, p.rounds, {{"concino", [&, f] {
      auto copy = std::make_unique<M>(m);
      return bench::seconds_of([&] {
        std::size_t done = 0;
        for (const auto x : all)
          if (concino::contains(*copy, x)) done += f(*copy, x);
        return done;
      });
    }}}));
  };
  run("split", concino::edges(m), [](M& x, auto e) { return bool(concino::edge_split(x, e)); });
  run("merge", concino::facets(m), [](M& x, auto f) { return bool(concino::merge_polys(x, f)); });
  run("collapse", concino::edges(m), [](M& x, auto e) { return bool(concino::edge_collapse(x, e)); });
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    edits<concino::trimesh>(p, "bunny16", p.data.bunny16());
    edits<concino::tetmesh>(p, "tet200k", p.data.tet200k());
    poly_edits(p, "bunny16", concino::dual_mesh(concino::trimesh(p.data.bunny16())));
    poly_edits(p, "tet200k", concino::dual_mesh(concino::tetmesh(p.data.tet200k())));
  });
}
