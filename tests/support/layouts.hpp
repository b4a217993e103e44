// Meshes of quads and hexes for tests of layout/, and what must hold of the blocks of any of them.
#pragma once

#include <concino/generate/grid.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/subdivide_midpoint.hpp>
#include <concino/generate/torus.hpp>
#include <concino/io/load.hpp>
#include <concino/layout.hpp>
#include <concino/mesh.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace concino::testing {

template<class M>
struct named_mesh {
  std::string name;
  M mesh;
  bool is_orientable = true;
};

inline quadmesh concave_quads() {  // an L
  quadmesh m({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}},
             {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}});
  return m;
}

/// Meshes with their names, those of the corpus last, where it is.
template<class M>
std::vector<named_mesh<M>> meshes_with_layouts(bool with_large = true) {
  std::vector<named_mesh<M>> all;
  all.push_back({"grid", make_grid<M>({.cells = {4, 3, 2}})});
  all.push_back({"torus", make_torus<M>({.cells = {8, 5}})});
  all.push_back({"sphere", make_sphere<M>({.cells = 3})});
  std::vector<const char*> files;
  if constexpr (dimension_v<M> == 2) {
    all.push_back({"L", concave_quads()});
    all.push_back({"Klein bottle", quadmesh(rolled_grid(6, 5, true)), false});
    all.push_back({"projective plane", subdivide_midpoint(trimesh(projective_plane())), false});
    all.push_back({"two holes", quadmesh(holed_board(2))});
    files = {"quad/bamboo_pen_genus8.obj", "quad/bunny_quad.obj", "quad/hole_capsule.off", "quad/moebius.obj"};
  } else {
    files = {"hex/cylinder.vtk", "hex/hole.mesh", "hex/hollow_sphere.mesh", "hex/sgp_three_letters.mesh"};
    if (with_large) files.insert(files.end(), {"hex/double_hinge.mesh", "hex/ellipsoid.mesh", "hex/rockerarm.mesh"});
  }
  for (const char* file : files) {
    const auto path = corpus(file);
    if (!path.empty()) all.push_back({file, load<M>(path), std::string(file) != "quad/moebius.obj"});
  }
  return all;
}

/// The sizes of blocks in an order that does not depend on the storage of the mesh.
template<class L>
std::vector<std::array<std::uint32_t, 3>> sorted_sizes(const L& l) {
  std::vector<std::array<std::uint32_t, 3>> sizes;
  for (const layout_block& b : l.sizes) {
    sizes.push_back(b.size);
    std::sort(sizes.back().begin(), sizes.back().end());
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

/// Blocks are grids, and what they have in common agrees.
template<class M, class L>
void expect_grids(const M& m, const L& l) {
  constexpr std::size_t d = dimension_v<M>;
  REQUIRE(l.sizes.size() == l.num_blocks);
  std::vector<std::map<std::array<std::uint32_t, 3>, std::size_t>> seen(l.num_blocks);  // polys by their lowest corners
  for (const auto p : polys(m)) {
    const auto at = l.position.of(p);
    std::array<std::uint32_t, 3> low = at[0], high = at[0];
    for (const auto& x : at)
      for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], x[i]), high[i] = std::max(high[i], x[i]);
    for (std::size_t i = 0; i < d; ++i) CHECK((high[i] == low[i] + 1 && high[i] <= l.sizes[l.block[p]].size[i]));
    CHECK(++seen[l.block[p]][low] == 1);
  }
  bool is_periodic = false;
  for (std::size_t b = 0; b < l.num_blocks; ++b) {
    const auto& size = l.sizes[b].size;
    CHECK(seen[b].size() == std::size_t{size[0]} * size[1] * size[2]);
    for (const bool x : l.sizes[b].periodic) is_periodic = is_periodic || x;
  }
  CHECK(l.periodic == is_periodic);
  CHECK(l.blocks.has_value() == l.why_no_blocks.empty());
  if (is_periodic) CHECK(!l.blocks);
  // A facet between two blocks lies at an end of both, and so do those that it continues in each. What is beside one side of a block is one side of a block,
  // or the boundary.
  using side = std::array<std::uint32_t, 3>;  // a block, an axis, an end
  std::map<side, std::set<side>> beside;
  for (const auto f : facets(m)) {
    std::vector<side> its_sides;
    for (const auto p : adj_facet2p(m, f)) {
      std::array<std::uint32_t, 3> low{~0u, ~0u, ~0u}, high{};
      std::uint32_t k = 0;
      for (const auto v : adj_p2v(m, p)) {
        for (const auto x : adj_facet2v(m, f))
          if (x == v)
            for (std::size_t i = 0; i < d; ++i) {
              const auto at = l.position[{p, k}][i];
              low[i] = std::min(low[i], at), high[i] = std::max(high[i], at);
            }
        ++k;
      }
      const auto& block = l.sizes[l.block[p]];
      bool is_at_end = false, at_seam = false;
      for (std::size_t i = 0; i < d; ++i)
        if (low[i] == high[i]) {
          is_at_end = low[i] == 0 || low[i] == block.size[i];
          its_sides.push_back({l.block[p], static_cast<std::uint32_t>(i), low[i] == 0 ? 0u : 1u});
          at_seam = block.periodic[i];
        }
      if (l.is_interface[f]) CHECK(is_at_end);
      else CHECK((!is_at_end || at_seam));
      for (const auto q : other_polys(m, p, f))
        if (!(l.block[q] == l.block[p])) CHECK(l.is_interface[f]);
    }
    if (!l.is_interface[f] || its_sides.size() > 2) continue;
    if (its_sides.size() == 1) beside[its_sides[0]].insert(side{~0u, 0, 0});
    else if (its_sides.size() == 2) beside[its_sides[0]].insert(its_sides[1]), beside[its_sides[1]].insert(its_sides[0]);
  }
  for (const auto& [one, others] : beside) CHECK(others.size() == 1);
  if (!l.blocks) return;
  CHECK(num_polys(*l.blocks) == l.num_blocks);
  REQUIRE(num_verts(*l.blocks) == l.block_verts.size());
  std::size_t i = 0;
  for (const auto v : verts(*l.blocks)) CHECK(point(*l.blocks, v) == to_vec3(point(m, l.block_verts[i++])));
}

}  // namespace concino::testing
