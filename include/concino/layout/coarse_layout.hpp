// The blocks of a mesh of quads or hexes: grids that meet at the lines or faces that go out from its singularities.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/layout/detail/blocks.hpp>
#include <concino/mesh/corner.hpp>
#include <concino/mesh/facet_map.hpp>
#include <concino/mesh/support/native_mesh_of.hpp>

#include <optional>
#include <string_view>
#include <vector>

namespace concino {

/// What coarse_layout finds. Its maps refer to the mesh.
template<class M>
struct block_layout {
  using block_mesh = typename core::native_mesh_of<dimension_v<M>, dimension_v<M> == 2 ? 4 : 8>::type;

  std::size_t num_blocks = 0;
  poly_map<M, std::uint32_t> block;                      // below num_blocks
  facet_map<M, bool> is_interface;                       // whether it bounds its blocks; so do facets at the boundary
  corner_map<M, std::array<std::uint32_t, 3>> position;  // (i, j, k) of each corner in the grid of its block; k = 0
                                                         // in surfaces
  std::vector<layout_block> sizes;                       // of the blocks
  bool periodic = false;                                 // a block continues with its own polys
  std::optional<block_mesh> blocks;                      // a poly for each block, if they are a mesh
  std::vector<vert_t<M>> block_verts;                    // of m: the verts of that mesh, in its order
  std::string_view why_no_blocks;                        // why they are not
};

/// Divides a mesh of quads or hexes into blocks, grids of polys. They meet at the separatrices of the mesh. Blocks fit:
/// a face of one is a face of the other.
/// Needs:  a surface whose polys are quads, or a HexMesh, with points, no temporary.
/// Result: the blocks, numbered in the order of their first polys, the position of each corner in its block, and the
///         mesh whose polys are the blocks: its verts are those at their corners, with their points. There is none if a
///         block has no corners, as the one of a torus, or touches itself, or two blocks would have edges or faces on
///         the same verts; why_no_blocks says so. The polys of a block are as many as its size says, but of a periodic
///         block that comes back with its axes exchanged. Positions along a periodic axis begin somewhere. i, j and k
///         run as in the first poly of the block. Elements without polys belong to no block.
/// Cost:   O(elements), but O(b log b) for the mesh of b blocks.
/// Errors: invalid_mesh if a poly is not a quad.
/// Source: Bommes, Lempfer, Kobbelt 2011, "Global structure optimization of quadrilateral meshes"; Gao, Deng, Chen
///         2015; paper section 2.2, "Utilities".
template<class M>
  requires requirement::is_lvalue_or_view<M> && requirement::may_be_quads_or_hexes<M> && Embedded<M>
      block_layout<std::remove_cvref_t<M>> coarse_layout(M&& m) {
    const detail::cube_tables t = detail::cube_tables_of(m, "coarse_layout");
    const detail::block_tables b = detail::find_blocks(t);
    block_layout<std::remove_cvref_t<M>> r{b.blocks.size(),
                                           make_poly_map<std::uint32_t>(m),
                                           make_facet_map<bool>(m),
                                           make_corner_map<std::array<std::uint32_t, 3>>(m),
                                           b.blocks,
                                           b.is_periodic,
                                           {},
                                           {},
                                           b.why_no_mesh};
    std::size_t p = 0, f = 0;
    for (const poly_t<M> x : polys(m)) {
      r.block[x] = b.block[p];
      for (unsigned k = 0; k < t.num_corners(); ++k)
        r.position.of(x)[k] = b.positions[p * t.num_corners() + detail::corner_places[k]];
      ++p;
    }
    for (const facet_t<M> x : facets(m)) r.is_interface[x] = b.is_interface[f++] != 0;
    if (!b.why_no_mesh.empty()) return r;
    const auto all = detail::by_number<vert_t<M>>(verts(m), num_verts(m));
    std::conditional_t<dimension_v<M> == 2, surface_arrays, cell_arrays> a;
    a.arity = t.num_corners();
    for (const std::uint32_t v : b.verts) {
      r.block_verts.push_back(all[v]);
      a.points.push_back(to_vec3(point(m, all[v])));
    }
    for (const std::uint32_t v : b.cells) a.verts.push_back(vert_id{v});
    r.blocks.emplace(std::move(a));
    return r;
  }

// What to write instead of calls that cannot compile.
template<class... T> void coarse_layout(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void coarse_layout(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void coarse_layout(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
