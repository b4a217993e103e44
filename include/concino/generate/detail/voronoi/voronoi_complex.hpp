// All cells of a Voronoi diagram, in which neighbouring cells share their verts and faces.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/generate/detail/voronoi/short_edges.hpp>
#include <concino/generate/detail/voronoi/voronoi_cell.hpp>

#include <span>

namespace concino::detail {

/// The Voronoi diagram of sites.
template<int D>
class voronoi_complex : private cell_loops<D> {
 public:
  using typename cell_loops<D>::position;
  using key = std::array<std::uint32_t, D + 1>;  // the sites and walls that define a vert, ascending; wall k is number
                                                 // of sites + k, those of the box first

  /// domain: walls within the box.
  explicit voronoi_complex(const site_lattice<D>& sites, std::span<const lattice_plane<D>> domain = {})
      : sites_(sites), domain_(domain) {
    const std::size_t n = sites.size(), chunk = 256, chunks = (n + chunk - 1) / chunk;
    std::vector<cell_chunk> parts(chunks);
    parallel_for(
        chunks,
        [&](std::size_t c) {
          voronoi_cell<D> cell;
          scratch s;
          for (std::size_t i = c * chunk; i < std::min(n, (c + 1) * chunk); ++i)
            add_cell(cell, static_cast<std::uint32_t>(i), s, parts[c]);
        },
        1);
    glue(parts);
    parts = {};
    merge_short_edges<D>(*this, sites);
  }

  std::uint32_t num_cells() const { return sites_.size(); }
  std::size_t num_verts() const { return positions.size(); }
  vec3 point(std::uint32_t v) const {
    vec3 x = sites_.domain().min;
    for (std::size_t k = 0; k < D; ++k) x[k] = sites_.from_lattice(positions[v][k], k);
    return x;
  }
  /// The loops of a cell are numbered from first_loop(cell) to first_loop(cell + 1) - 1.
  std::uint32_t first_loop(std::uint32_t cell) const { return loop_offsets[cell]; }
  /// The site behind a loop, or its wall (see key); meaningless in the plane.
  std::uint32_t beyond(std::uint32_t loop) const { return neighbours[loop]; }
  std::span<const std::uint32_t> verts(std::uint32_t loop) const {
    return {loop_verts.data() + vert_offsets[loop], loop_verts.data() + vert_offsets[loop + 1]};
  }

 private:
  /// The verts and loops of a chunk of cells, cell after cell.
  struct cell_chunk {
    std::vector<key> keys;
    std::vector<position> positions;            // of verts for which the cell's site is the lowest in their key
    std::vector<std::uint32_t> num_verts;        // by cell
    std::vector<std::uint32_t> num_loops;        // by cell
    std::vector<std::uint32_t> beyond;           // by loop: the site or wall behind it
    std::vector<std::uint32_t> num_loop_verts;   // by loop
    std::vector<std::uint32_t> loop_verts;       // numbers within the cell
  };
  struct scratch {
    std::vector<std::pair<double, std::uint32_t>> ring;
    std::vector<std::array<std::uint32_t, 3>> corners;  // plane, next plane around the vert, vert
  };

  using cell_loops<D>::positions;
  using cell_loops<D>::walls;
  using cell_loops<D>::num_walls;
  using cell_loops<D>::loop_offsets;
  using cell_loops<D>::neighbours;
  using cell_loops<D>::vert_offsets;
  using cell_loops<D>::loop_verts;

  const site_lattice<D>& sites_;
  std::span<const lattice_plane<D>> domain_;

  void add_cell(voronoi_cell<D>& cell, std::uint32_t i, scratch& s, cell_chunk& out) const {
    cell.begin(sites_, i);
    sites_.for_each_near(i, [&] { return cell.security_radius(); }, s.ring, [&](std::uint32_t j, double squared) {
      if (squared <= cell.security_radius() * cell.security_radius()) cell.cut(sites_, j);
    });
    // last, when few walls are near the cell
    for (std::uint32_t w = 0; w < domain_.size(); ++w) cell.cut(sites_, domain_[w], sites_.size() + 2 * D + w);

    const auto generator = [&](std::uint32_t plane) {
      return plane < 2 * D ? sites_.size() + plane : cell.beyond(plane);
    };
    for (const auto& v : cell.verts()) {
      key k{i};
      for (std::size_t d = 0; d < D; ++d) k[d + 1] = generator(v.planes[d]);
      std::sort(k.begin(), k.end());
      position x{};
      if (k[0] == i) x = cell.position(v);
      for (std::size_t d = 0; d < D; ++d) x[d] += static_cast<double>(sites_[i][d]);
      out.keys.push_back(k);
      out.positions.push_back(x);
    }
    const std::size_t nv = cell.verts().size();
    out.num_verts.push_back(static_cast<std::uint32_t>(nv));

    s.corners.clear();
    for (std::uint32_t v = 0; v < nv; ++v) {
      const auto& p = cell.verts()[v].planes;
      if constexpr (D == 2) s.corners.push_back({0, p[0], v});
      else for (std::size_t k = 0; k < D; ++k) s.corners.push_back({p[k], p[(k + 1) % D], v});
    }
    std::sort(s.corners.begin(), s.corners.end());
    std::uint32_t loops = 0;
    for (auto b = s.corners.begin(); b != s.corners.end(); ++loops) {
      const auto e = std::find_if(b, s.corners.end(), [&](const auto& c) { return c[0] != (*b)[0]; });
      out.beyond.push_back(generator((*b)[0]));
      out.num_loop_verts.push_back(static_cast<std::uint32_t>(e - b));
      auto at = b;
      for (auto n = b; n != e; ++n) {  // adds the vert between two consecutive planes around the loop, then moves on to
                                       // the next pair
        const auto& p = cell.verts()[(*at)[2]].planes;
        out.loop_verts.push_back((*at)[2]);
        std::uint32_t next;
        if constexpr (D == 2) next = p[1];
        else next = p[0] == (*b)[0] ? p[2] : p[1] == (*b)[0] ? p[0] : p[1];
        at = std::find_if(b, e, [&](const auto& c) { return c[1] == next; });
        assert(at != e);
      }
      b = e;
    }
    out.num_loops.push_back(loops);
  }

  /// Merges the verts of all cells. The first cell in the key of a vert creates it, and the other cells look it up
  /// there.
  void glue(const std::vector<cell_chunk>& parts) {
    std::vector<std::size_t> first_vert{0};
    std::vector<key> keys;
    std::vector<std::uint32_t> name;
    loop_offsets = {0};
    vert_offsets = {0};
    for (const cell_chunk& p : parts) {
      keys.insert(keys.end(), p.keys.begin(), p.keys.end());
      std::size_t v = 0, l = 0, c = 0;
      for (std::size_t i = 0; i < p.num_verts.size(); ++i) {
        const auto cell = static_cast<std::uint32_t>(first_vert.size() - 1);
        const std::size_t base = first_vert.back();
        for (std::uint32_t k = 0; k < p.num_verts[i]; ++k, ++v) {
          const key& x = p.keys[v];
          if (x[0] == cell) {
            name.push_back(static_cast<std::uint32_t>(positions.size()));
            positions.push_back(p.positions[v]);
            std::uint8_t on = 0, count = 0;
            for (const std::uint32_t g : x) {
              if (g >= sites_.size()) ++count;
              if (g >= sites_.size() && g < sites_.size() + 2 * D)
                on = static_cast<std::uint8_t>(on | 1u << (g - sites_.size()));
            }
            walls.push_back(on);
            num_walls.push_back(count);
          } else {
            std::size_t at = first_vert[x[0]];
            while (at < first_vert[x[0] + 1] && keys[at] != x) ++at;
            assert(at < first_vert[x[0] + 1] && "cells disagree on a vert");
            name.push_back(name[at]);
          }
        }
        first_vert.push_back(name.size());
        for (std::uint32_t k = 0; k < p.num_loops[i]; ++k, ++l) {
          neighbours.push_back(p.beyond[l]);
          for (std::uint32_t n = 0; n < p.num_loop_verts[l]; ++n) loop_verts.push_back(name[base + p.loop_verts[c++]]);
          vert_offsets.push_back(static_cast<std::uint32_t>(loop_verts.size()));
        }
        loop_offsets.push_back(static_cast<std::uint32_t>(neighbours.size()));
      }
    }
  }
};

}  // namespace concino::detail
