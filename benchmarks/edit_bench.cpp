// Measures edits of triangles and tets, with and without a transaction. The programs of peers measure the same edits of theirs beside ours.
#include "support/edits.hpp"

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

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    edits<concino::trimesh>(p, "bunny16", p.data.bunny16());
    edits<concino::tetmesh>(p, "tet200k", p.data.tet200k());
  });
}
