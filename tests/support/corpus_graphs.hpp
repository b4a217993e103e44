// The primal and dual graphs of every mesh of the corpus, with random barriers.
#pragma once

#include <support/barred_graph.hpp>
#include <support/corpus_meshes.hpp>

#include <filesystem>
#include <random>
#include <utility>
#include <variant>
#include <vector>

namespace concino::testing {

/// Closes one node in twenty and one crossing in ten: large parts of the mesh stay connected, but on detours.
template<class Side>
void build_walls(barred_graph<Side>& g, std::mt19937& random) {
  const auto close = [&](std::vector<char>& flags, std::size_t n, unsigned of) {
    flags.resize(n);
    for (char& c : flags) c = random() % of != 0;
  };
  close(g.free_node, g.bound(), 20);
  close(g.free_crossing, Side::num_crossings(g.m), 10);
  g.salt = static_cast<unsigned>(random());
}
template<class Side>
void tear_down_walls(barred_graph<Side>& g) {
  g.free_node.assign(g.free_node.size(), 1);
  g.free_crossing.assign(g.free_crossing.size(), 1);
}

/// Calls check(g) for both graphs of each mesh, with barriers. check may change g. Without a corpus the test is skipped. Files of more than 300 kB are
/// left to long runs.
template<class F>
void for_corpus_graphs(const F& check) {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::mt19937 random(40);
  for (const auto& row : rows) {
    if (std::filesystem::file_size(row.file) > 300'000 && !long_run()) continue;
    INFO(row.name);
    std::visit(
        [&]<class M>(M&& m) {
          barred_graph<primal_side<M>> on_verts{std::move(m), {}, {}};
          build_walls(on_verts, random);
          check(on_verts);
          barred_graph<dual_side<M>> on_polys{std::move(on_verts.m), {}, {}};
          build_walls(on_polys, random);
          check(on_polys);
        },
        load_any(row.file.string()));
  }
}

}  // namespace concino::testing
