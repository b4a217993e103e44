// An operator of your own. All edits of this library are made of one function, rewire, which replaces a few polys by others at once. Here it removes an
// edge of a mesh of polygons: the two polygons at it become one. It works on every editable surface, can be undone, and never leaves half an edit behind.
#include <concino/concepts/end_verts.hpp>
#include <concino/edit.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <vector>

namespace cn = concino;

/// Joins the two polygons at e. Returns false if there are not two, or if they share more than e.
template<cn::EditableSurfaceMesh M>
bool join_polys(M& m, cn::edge_t<M> e) {
  using span = cn::id_span<unsigned>;
  std::vector<cn::poly_t<M>> old;
  for (const auto p : cn::adj_e2p(m, e)) old.push_back(p);
  if (old.size() != 2) return false;

  // The cavity numbers its verts 0, 1, 2, ...: those of the first polygon, from the second end of e on, then the others of the second polygon.
  const auto around = [&](cn::poly_t<M> p, cn::vert_t<M> from, cn::vert_t<M> to) {
    std::vector<cn::vert_t<M>> all;
    for (const auto v : cn::adj_p2v(m, p)) all.push_back(v);
    while (!(all.front() == from && all.back() == to) && !(all.front() == to && all.back() == from)) std::rotate(all.begin(), all.begin() + 1, all.end());
    return all;
  };
  const auto [a, b] = cn::end_verts(m, e);
  std::vector<cn::vert_t<M>> verts = around(old[0], a, b);
  const auto second = around(old[1], a, b);
  if (second.front() != verts.back()) return false;  // their windings contradict each other
  for (std::size_t i = 1; i + 1 < second.size(); ++i) {
    for (const auto v : verts)
      if (v == second[i]) return false;
    verts.push_back(second[i]);
  }

  std::vector<unsigned> corners;
  for (unsigned i = 0; i < verts.size(); ++i) corners.push_back(i);
  const auto end = static_cast<unsigned>(corners.size());
  cn::poly_t<M> joined;
  cn::rewire(m, {.polys = {old.data(), old.data() + 2},
                 .verts = {verts.data(), verts.data() + verts.size()},
                 .corners = span(corners.data(), corners.data() + corners.size()),
                 .ends = span(&end, &end + 1),
                 .kept = 1},  // the new polygon has the descriptor of the first old one
             {.polys = &joined});
  return true;
}

int main() {
  cn::polygonmesh m({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, {{0, 1, 4, 3}, {1, 2, 5}, {1, 5, 4}});
  fmt::print("{} polygons, {} edges, area {}\n", cn::num_polys(m), cn::num_edges(m), cn::total_measure(m));

  cn::transaction t(m);
  for (unsigned i = 0; i < cn::edge_index_bound(m); ++i)
    if (cn::contains(m, cn::edge_id{i}) && join_polys(m, cn::edge_id{i})) fmt::print("edge {} is gone: {} polygons\n", i, cn::num_polys(m));
  for (const auto p : cn::polys(m)) {
    fmt::print("poly {} has the verts", cn::index_of(m, p));
    for (const auto v : cn::adj_p2v(m, p)) fmt::print(" {}", cn::index_of(m, v));
    fmt::print("\n");
  }
  fmt::print("area {}\n", cn::total_measure(m));
  t.roll_back();
  fmt::print("undone: {} polygons, {} edges\n", cn::num_polys(m), cn::num_edges(m));
}
