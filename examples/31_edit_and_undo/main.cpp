// Edit a mesh and undo it. Edits are checked before anything changes, named properties follow them, and what a transaction has not committed leaves no trace.
#include <concino/edit.hpp>
#include <concino/generate.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <stdexcept>
#include <vector>

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
  std::vector<cn::edge_id> all;
  for (const auto e : cn::edges(m)) all.push_back(e);
  try {
    cn::transaction t(m);
    const double area = cn::total_measure(m);
    for (const cn::edge_id e : all) {
      if (!cn::contains(m, e)) continue;
      if (const auto made = cn::edge_collapse(m, e); !made) fmt::print("edge {} stays: {}\n", cn::index_of(m, e), made.why);
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

  // Verts of any mesh can be merged, unless polys become degenerate. Verts at which parts of a surface only touch are split again.
  const cn::vert_id v{0}, near = *cn::adj_v2v(m, v).begin(), far{3};
  fmt::print("vert {} stays: {}\n", cn::index_of(m, near), cn::can_merge_verts(m, v, {near}).why);
  cn::merge_verts(m, v, {far});
  for (const auto& split_again : cn::split_vert_fans(m)) fmt::print("vert {} is split again, the new vert is {}\n", cn::index_of(m, split_again.origin), cn::index_of(m, split_again.vert));

  // Removed elements leave gaps in the numbering. This closes them and tells the new descriptors.
  cn::edge_collapse(m, cn::edge_id{5});
  fmt::print("{} verts, indices below {}\n", cn::num_verts(m), cn::vert_index_bound(m));
  const auto moved = cn::garbage_collect(m);
  fmt::print("{} verts, indices below {}; vert {} is vert {} now\n", cn::num_verts(m), cn::vert_index_bound(m), cn::index_of(m, split.vert), cn::index_of(m, *moved[split.vert]));
}
