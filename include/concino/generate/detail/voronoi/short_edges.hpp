// Merges the verts of Voronoi cells that differ only by rounding, and removes the edges between them.
#pragma once

#include <concino/generate/detail/voronoi/site_lattice.hpp>
#include <concino/graph/disjoint_sets.hpp>

namespace concino::detail {

/// The cells of sites as loops of verts. In the plane, a cell has one loop, counter-clockwise. In space, it has one
/// loop for each face, counter-clockwise as seen from outside.
template<int D>
struct cell_loops {
  using position = std::array<double, D>;

  std::vector<position> positions;          // by vert, in lattice steps
  std::vector<std::uint8_t> walls;          // by vert: a bit for each wall of the box on which it lies
  std::vector<std::uint8_t> num_walls;      // by vert: the number of walls of the domain on which it lies
  std::vector<std::uint32_t> loop_offsets;  // by cell: its first loop
  std::vector<std::uint32_t> neighbours;    // by loop: the cell or wall behind it
  std::vector<std::uint32_t> vert_offsets;  // by loop: its first vert
  std::vector<std::uint32_t> loop_verts;
};

[[noreturn]] inline void throw_thin_cell(std::size_t cell) {
  core::throw_joined<invalid_argument>(
      {"Voronoi diagram: the cell of site ", cell,
       " is thinner than rounding errors of the box's size; remove the site or one next to it"});
}

/// The sets of verts to merge: those connected by negligibly short edges.
template<int D>
disjoint_sets close_verts(const cell_loops<D>& c) {
  constexpr double close = 512;  // lattice steps: below 2^-39 of the longest side of the box
  disjoint_sets same(c.positions.size());
  for (std::size_t l = 0; l + 1 < c.vert_offsets.size(); ++l)
    for (std::uint32_t first = c.vert_offsets[l], last = c.vert_offsets[l + 1], i = first; i < last; ++i) {
      const std::uint32_t a = c.loop_verts[i], b = c.loop_verts[i + 1 < last ? i + 1 : first];
      double squared = 0;
      for (std::size_t k = 0; k < D; ++k)
        squared += (c.positions[a][k] - c.positions[b][k]) * (c.positions[a][k] - c.positions[b][k]);
      if (squared <= close * close) same.unite(a, b);
    }
  return same;
}

/// The positions of merged verts, by the root of their set: the position of the vert on the most walls, moved onto the
/// walls of the others.
template<int D>
std::vector<typename cell_loops<D>::position> merged_positions(const cell_loops<D>& c, disjoint_sets& same,
                                                               const site_lattice<D>& sites) {
  std::vector<std::uint32_t> best(c.positions.size());
  std::vector<std::uint8_t> walls = c.walls;
  for (std::uint32_t v = 0; v < best.size(); ++v) {
    const std::size_t r = same.root(v);  // <= v
    if (r == v || c.num_walls[v] > c.num_walls[best[r]]) best[r] = v;
    walls[r] |= c.walls[v];
  }
  std::vector<typename cell_loops<D>::position> positions(best.size());
  for (std::size_t r = 0; r < best.size(); ++r) {
    positions[r] = c.positions[best[r]];
    for (std::size_t k = 0; k < D; ++k) {
      if (walls[r] >> 2 * k & 1) positions[r][k] = 0;
      if (walls[r] >> (2 * k + 1) & 1) positions[r][k] = static_cast<double>(sites.length(k));
    }
  }
  return positions;
}

/// Merges verts connected by negligibly short edges. Removes edges and loops without size, consistently in all cells
/// that have them. Numbers the verts in the order of their first occurrence in loops.
/// Errors: invalid_argument that names a site whose cell vanishes, or touches itself.
template<int D>
void merge_short_edges(cell_loops<D>& c, const site_lattice<D>& sites) {
  disjoint_sets same = close_verts(c);
  const auto positions = merged_positions(c, same, sites);
  c.positions.clear();
  c.walls.clear();
  constexpr std::uint32_t unnamed = ~0u;
  std::vector<std::uint32_t> name(positions.size(), unnamed);
  std::size_t loops = 0, out = 0;  // numbers of loops and corners that are kept; the arrays are compacted in place
  for (std::uint32_t cell = 0, loop = 0, from = 0; cell + 1 < c.loop_offsets.size(); ++cell) {
    const std::size_t first_loop = loops;
    for (const std::uint32_t last = c.loop_offsets[cell + 1]; loop < last; ++loop) {
      const std::size_t begin = out;
      for (const std::uint32_t to = c.vert_offsets[loop + 1]; from < to; ++from) {
        const auto v = static_cast<std::uint32_t>(same.root(c.loop_verts[from]));
        if (out == begin || c.loop_verts[out - 1] != v) c.loop_verts[out++] = v;
      }
      while (out - begin > 1 && c.loop_verts[out - 1] == c.loop_verts[begin]) --out;
      if (out - begin < 3) {
        out = begin;
        continue;
      }
      const std::uint32_t* const kept = c.loop_verts.data();
      for (std::size_t i = begin; i < out; ++i)
        if (std::find(kept + begin, kept + i, kept[i]) != kept + i) throw_thin_cell(cell);
      c.neighbours[loops++] = c.neighbours[loop];
      c.vert_offsets[loops] = static_cast<std::uint32_t>(out);
    }
    if (loops - first_loop < (D == 2 ? 1 : 4)) throw_thin_cell(cell);
    c.loop_offsets[cell + 1] = static_cast<std::uint32_t>(loops);
  }
  c.neighbours.resize(loops);
  c.vert_offsets.resize(loops + 1);
  c.loop_verts.resize(out);
  for (std::uint32_t& v : c.loop_verts) {
    if (name[v] == unnamed) {
      name[v] = static_cast<std::uint32_t>(c.positions.size());
      c.positions.push_back(positions[v]);
    }
    v = name[v];
  }
}

}  // namespace concino::detail
