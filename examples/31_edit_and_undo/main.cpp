// Edit a mesh and undo it. Edits are checked before anything changes, named properties follow them, and what a transaction has not committed leaves no trace.
#include <concino/edit.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <stdexcept>

namespace cn = concino;

int main() {
  auto m = cn::icosphere(1);
  const auto height = cn::vert_property<double>(m, "height");
  for (const auto v : cn::verts(m)) height[v] = cn::point(m, v).z;
  const auto print = [&](const char* what) {
    fmt::print("{:<22} {} verts, {} triangles, area {:.4f}\n", what, cn::num_verts(m), cn::num_polys(m), cn::total_measure(m));
  };
  print("an icosphere:");

  // An edit returns what it has made, or the reason why it was refused.
  const auto split = cn::edge_split(m, cn::edge_id{0}, 0.25);
  fmt::print("the new vert is {}, at height {:.3f}\n", cn::index_of(m, split.vert), height[split.vert]);
  print("an edge split:");

  // All edits of a transaction are undone unless it is committed: here, because too much of the area is lost.
  try {
    cn::transaction t(m);
    const double area = cn::total_measure(m);
    for (unsigned i = 0; i < cn::edge_index_bound(m); ++i) {
      const cn::edge_id e{i};
      if (!cn::contains(m, e)) continue;
      if (const auto made = cn::edge_collapse(m, e); !made) fmt::print("edge {} stays: {}\n", i, made.why);
      if (cn::total_measure(m) < 0.9 * area) throw std::runtime_error("a tenth of the area is lost");
    }
    t.commit();
  } catch (const std::runtime_error& e) {
    fmt::print("undone: {}\n", e.what());
  }
  print("as before:");

  // Committed edits can be undone later, and done again.
  cn::transaction t(m);
  for (unsigned i = 0; i < 30; ++i) cn::edge_split(m, cn::edge_id{i});
  auto edits = t.commit();
  print("30 edges split:");
  edits.undo();
  print("undone:");
  edits.redo();
  print("done again:");

  // Removed elements leave gaps in the numbering. This closes them and tells the new descriptors.
  cn::edge_collapse(m, cn::edge_id{5});
  fmt::print("{} verts, indices below {}\n", cn::num_verts(m), cn::vert_index_bound(m));
  const auto moved = cn::garbage_collect(m);
  fmt::print("{} verts, indices below {}; vert {} is vert {} now\n", cn::num_verts(m), cn::vert_index_bound(m), cn::index_of(m, split.vert), cn::index_of(m, *moved[split.vert]));
}
