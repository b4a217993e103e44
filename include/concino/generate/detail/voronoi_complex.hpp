// All cells of a Voronoi diagram glued together: verts and faces that neighbours share become one.
#pragma once

#include <concino/generate/detail/voronoi_cell.hpp>
#include <concino/graph/detail/disjoint_sets.hpp>
#include <concino/parallel.hpp>

#include <span>

namespace concino::detail {

/// The cells of D-dimensional sites: for every site its verts and loops of these. In a plane a cell has one loop, counter-clockwise; in space one for each
/// face, counter-clockwise seen from outside.
template<int D>
class voronoi_complex {
 public:
  using key = std::array<std::uint32_t, D + 1>;  // the sites and walls that make a vert, ascending; wall k of the box is number of sites + k
  using place = std::array<double, D>;

  explicit voronoi_complex(const site_lattice<D>& sites) : sites_(sites) {
    const std::size_t n = sites.size(), chunk = 256, chunks = (n + chunk - 1) / chunk;
    std::vector<part> parts(chunks);
    parallel_for(
        chunks,
        [&](std::size_t c) {
          voronoi_cell<D> cell;
          scratch s;
          for (std::size_t i = c * chunk; i < std::min(n, (c + 1) * chunk); ++i) add_cell(cell, static_cast<std::uint32_t>(i), s, parts[c]);
        },
        1);
    glue(parts);
    parts = {};
    merge();
  }

  std::size_t num_verts() const { return places_.size(); }

  /// The loops of a cell are numbered from first_loop(cell) to first_loop(cell + 1) - 1.
  std::uint32_t first_loop(std::uint32_t cell) const { return first_loop_[cell]; }
  /// The site beyond a loop, or its wall (see key); in a plane it means nothing.
  std::uint32_t beyond(std::uint32_t loop) const { return beyond_[loop]; }
  std::span<const std::uint32_t> verts(std::uint32_t loop) const {
    return {loop_verts_.data() + first_loop_vert_[loop], loop_verts_.data() + first_loop_vert_[loop + 1]};
  }
  vec3 point(std::uint32_t v) const {
    vec3 x = sites_.domain().min;
    for (std::size_t k = 0; k < D; ++k) x[k] = sites_.from_lattice(places_[v][k], k);
    return x;
  }

 private:
  /// What one chunk of cells found, cell after cell.
  struct part {
    std::vector<key> keys;
    std::vector<place> places;                   // of the verts, right where the cell is that of the lowest site of the key
    std::vector<std::uint32_t> num_verts;        // per cell
    std::vector<std::uint32_t> num_loops;        // per cell
    std::vector<std::uint32_t> beyond;           // per loop
    std::vector<std::uint32_t> num_loop_verts;   // per loop
    std::vector<std::uint32_t> loop_verts;       // as numbered within the cell
  };
  struct scratch {
    std::vector<std::pair<double, std::uint32_t>> ring;
    std::vector<std::array<std::uint32_t, 3>> corners;  // plane, next plane around the vert, vert
  };

  const site_lattice<D>& sites_;
  std::vector<place> places_;  // per vert, in lattice steps
  std::vector<std::uint8_t> walls_;  // per vert, a bit for each wall it lies on
  std::vector<std::uint32_t> first_loop_, beyond_, first_loop_vert_, loop_verts_;

  void add_cell(voronoi_cell<D>& cell, std::uint32_t i, scratch& s, part& out) const {
    cell.begin(sites_, i);
    sites_.for_each_near(i, [&] { return cell.reach(); }, s.ring, [&](std::uint32_t j, double squared) {
      if (squared <= cell.reach() * cell.reach()) cell.cut(sites_, j);
    });

    const auto generator = [&](std::uint32_t plane) { return plane < 2 * D ? sites_.size() + plane : cell.beyond(plane); };
    for (const auto& v : cell.verts()) {
      key k{i};
      for (std::size_t d = 0; d < D; ++d) k[d + 1] = generator(v.planes[d]);
      std::sort(k.begin(), k.end());
      place x{};
      for (std::size_t d = 0; d < D; ++d) x[d] = static_cast<double>(sites_[i][d]) + cell.place(v, d);
      out.keys.push_back(k);
      out.places.push_back(x);
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
      for (auto n = b; n != e; ++n) {  // the vert between this plane and that one, and then the one between that one and the next
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

  /// The first cell of a vert's key makes it, the others find it there: the key says where.
  void glue(const std::vector<part>& parts) {
    std::vector<std::size_t> first_vert{0};
    std::vector<key> keys;
    std::vector<std::uint32_t> name;
    first_loop_ = {0};
    first_loop_vert_ = {0};
    for (const part& p : parts) {
      keys.insert(keys.end(), p.keys.begin(), p.keys.end());
      std::size_t v = 0, l = 0, c = 0;
      for (std::size_t i = 0; i < p.num_verts.size(); ++i) {
        const auto cell = static_cast<std::uint32_t>(first_vert.size() - 1);
        const std::size_t base = first_vert.back();
        for (std::uint32_t k = 0; k < p.num_verts[i]; ++k, ++v) {
          const key& x = p.keys[v];
          if (x[0] == cell) {
            name.push_back(static_cast<std::uint32_t>(places_.size()));
            places_.push_back(p.places[v]);
            std::uint8_t walls = 0;
            for (const std::uint32_t g : x)
              if (g >= sites_.size()) walls = static_cast<std::uint8_t>(walls | 1u << (g - sites_.size()));
            walls_.push_back(walls);
          } else {
            std::size_t at = first_vert[x[0]];
            while (at < first_vert[x[0] + 1] && keys[at] != x) ++at;
            assert(at < first_vert[x[0] + 1] && "cells disagree on a vert");
            name.push_back(name[at]);
          }
        }
        first_vert.push_back(name.size());
        for (std::uint32_t k = 0; k < p.num_loops[i]; ++k, ++l) {
          beyond_.push_back(p.beyond[l]);
          for (std::uint32_t n = 0; n < p.num_loop_verts[l]; ++n) loop_verts_.push_back(name[base + p.loop_verts[c++]]);
          first_loop_vert_.push_back(static_cast<std::uint32_t>(loop_verts_.size()));
        }
        first_loop_.push_back(static_cast<std::uint32_t>(beyond_.size()));
      }
    }
  }

  /// Verts joined by edges too short to matter become one, the edges and the faces without area vanish for all cells around.
  void merge() {
    constexpr double close = 512;  // lattice steps: below 2^-39 of the longest side of the box
    disjoint_sets same(places_.size());
    for_each_edge([&](std::uint32_t a, std::uint32_t b) {
      double squared = 0;
      for (std::size_t k = 0; k < D; ++k) squared += (places_[a][k] - places_[b][k]) * (places_[a][k] - places_[b][k]);
      if (squared <= close * close) same.unite(a, b);
    });
    // The place of those that became one is that of the one on most walls, moved onto the walls of the others.
    std::vector<std::uint32_t> root(places_.size()), best(places_.size());
    std::vector<std::uint8_t> walls = walls_;
    const auto more_walls = [&](std::uint32_t a, std::uint32_t b) { return count(walls_[a]) > count(walls_[b]); };
    for (std::uint32_t v = 0; v < root.size(); ++v) {
      root[v] = static_cast<std::uint32_t>(same.root(v));
      if (root[v] == v) best[v] = v;
      else if (more_walls(v, best[root[v]])) best[root[v]] = v;
      walls[root[v]] |= walls_[v];
    }
    // Verts are numbered as loops first meet them.
    constexpr std::uint32_t unnamed = ~0u;
    std::vector<std::uint32_t> name(places_.size(), unnamed);
    std::vector<place> kept;
    std::size_t out = 0, loop = 0, kept_loops = 0;
    std::uint32_t from = 0;
    for (std::uint32_t cell = 0; cell < sites_.size(); ++cell) {
      const std::uint32_t last = first_loop_[cell + 1];
      const std::size_t first_kept = kept_loops;
      for (; loop < last; ++loop) {
        const std::size_t begin = out;
        for (const std::uint32_t to = first_loop_vert_[loop + 1]; from < to; ++from) {
          const std::uint32_t r = root[loop_verts_[from]];
          if (out == begin || loop_verts_[out - 1] != r) loop_verts_[out++] = r;
        }
        while (out - begin > 1 && loop_verts_[out - 1] == loop_verts_[begin]) --out;
        if (out - begin < 3) {
          out = begin;
          continue;
        }
        refuse_pinched(cell, begin, out);
        beyond_[kept_loops++] = beyond_[loop];
        first_loop_vert_[kept_loops] = static_cast<std::uint32_t>(out);
      }
      if (kept_loops - first_kept < (D == 2 ? 1 : 4)) refuse(cell);
      first_loop_[cell + 1] = static_cast<std::uint32_t>(kept_loops);
    }
    beyond_.resize(kept_loops);
    first_loop_vert_.resize(kept_loops + 1);
    loop_verts_.resize(out);
    for (std::uint32_t& v : loop_verts_) {
      if (name[v] == unnamed) {
        name[v] = static_cast<std::uint32_t>(kept.size());
        place x = places_[best[v]];
        for (std::size_t k = 0; k < D; ++k) {
          if (walls[v] >> 2 * k & 1) x[k] = 0;
          if (walls[v] >> (2 * k + 1) & 1) x[k] = static_cast<double>(sites_.side(k));
        }
        kept.push_back(x);
      }
      v = name[v];
    }
    places_ = std::move(kept);
  }

  static int count(std::uint8_t bits) {
    int n = 0;
    for (; bits; bits = static_cast<std::uint8_t>(bits & (bits - 1))) ++n;
    return n;
  }

  template<class Visit>
  void for_each_edge(const Visit& visit) const {
    for (std::size_t l = 0; l + 1 < first_loop_vert_.size(); ++l)
      for (std::uint32_t b = first_loop_vert_[l], e = first_loop_vert_[l + 1], c = b; c < e; ++c) visit(loop_verts_[c], loop_verts_[c + 1 < e ? c + 1 : b]);
  }

  void refuse_pinched(std::uint32_t cell, std::size_t begin, std::size_t end) const {
    for (std::size_t a = begin; a < end; ++a)
      for (std::size_t b = a + 1; b < end; ++b)
        if (loop_verts_[a] == loop_verts_[b]) refuse(cell);
  }
  [[noreturn]] static void refuse(std::uint32_t cell) {
    throw_joined<invalid_argument>({"the Voronoi cell of site ", cell, " is thinner than rounding of the size of the box; remove the site or one of those next to it"});
  }
};

}  // namespace concino::detail
