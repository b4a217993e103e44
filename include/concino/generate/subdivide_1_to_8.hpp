// Subdivision of tets and hexes into eight.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/generate/detail/subdivide/corner_hexes.hpp>
#include <concino/mesh/tetmesh.hpp>

#include <vector>

namespace concino {

namespace detail {

/// Splits an octahedron into four tets around its shortest diagonal, of equal ones the first. `middle` are the new
/// verts of the edges 01 02 03 12 13 23 of a tet.
template<class Take>
void split_octahedron(const std::array<vert_id, 6>& middle, const std::vector<vec3>& points, const Take& take) {
  // Each diagonal, then the other four verts around it, so that the tets are oriented as the one around them.
  static constexpr std::uint8_t diagonals[3][6] = {{0, 5, 1, 2, 4, 3}, {1, 4, 2, 0, 3, 5}, {2, 3, 0, 1, 5, 4}};
  const auto length = [&](const std::uint8_t* d) {
    return norm(points[middle[d[1]].raw()] - points[middle[d[0]].raw()]);
  };
  const std::uint8_t* best = diagonals[0];
  for (const auto& d : diagonals)
    if (length(d) < length(best)) best = d;
  for (unsigned k = 0; k < 4; ++k)
    take(middle[best[0]], middle[best[1]], middle[best[2 + k]], middle[best[2 + (k + 1) % 4]]);
}

template<class M>
subdivided<tetmesh> subdivide_tets(const M& m, const subdivide_options& o) {
  using new_verts = refined_verts<M, refined_kinds{.edges = true}>;
  check_subdivided_counts<tetmesh>("subdivide_1_to_8", new_verts::expected_size(m),
                                   8.0 * static_cast<double>(num_polys(m)));
  const new_verts refined(m);
  const mean_rule<M> rule{m};
  cell_arrays a{refined_points(refined, rule), std::vector<vert_id>(32 * num_polys(m)), 4};
  vert_id* next = a.verts.data();
  const auto add = [&](vert_id v0, vert_id v1, vert_id v2, vert_id v3) {
    next[0] = v0, next[1] = v1, next[2] = v2, next[3] = v3;
    next += 4;
  };
  for (const poly_t<M> p : polys(m)) {
    std::array<vert_id, 4> v;
    std::array<vert_id, 6> e;
    std::size_t k = 0;
    for (const vert_t<M> x : adj_p2v(m, p)) v[k++] = refined[x];
    k = 0;
    for (const edge_t<M> x : adj_p2e(m, p)) e[k++] = refined[x];  // 01 02 03 12 13 23
    add(v[0], e[0], e[1], e[2]), add(e[0], v[1], e[3], e[4]), add(e[1], e[3], v[2], e[5]), add(e[2], e[4], e[5], v[3]);
    split_octahedron(e, a.points, add);
  }
  return with_origins(tetmesh(std::move(a)), refined, rule, o, [&] { return repeated_polys(m, 8); });
}

}  // namespace detail

/// Splits each tet or hex into eight of its kind.
/// Needs:  Embedded TetMesh or HexMesh.
/// Result: a tetmesh or hexmesh. Its verts are those of verts(m), then those of edges(m) at the midpoints; of hexes
///         also those of faces and of polys at the means of their verts. Poly i of polys(m) becomes polys 8 i to 8 i +
///         7. A tet is split into a tet at each of its verts, similar to it, and four around the shortest diagonal of
///            the octahedron between them. Polys are oriented as m. Volumes do not change, if the faces of hexes are
///            planar. Named properties
///         are transferred by their rules.
/// Cost:   O(size of the result); the points in parallel.
/// Errors: invalid_argument if times is 0, or if the result would have too many elements.
/// Source: Bey 1995, "Tetrahedral grid refinement"; the shortest diagonal: Zhang 1995, "Successive subdivisions of
///         tetrahedra and multigrid methods on tetrahedral meshes".
template<TetMesh M>
  requires Embedded<M>
tetmesh subdivide_1_to_8(const M& m, const subdivide_options& options = {}) {
    return detail::subdivide_repeatedly(
        "subdivide_1_to_8", 8, m, detail::no_creases(), options,
        [&](const auto& mesh, const auto&, unsigned) { return detail::subdivide_tets(mesh, options); });
}
template<HexMesh M>
  requires Embedded<M>
hexmesh subdivide_1_to_8(const M& m, const subdivide_options& options = {}) {
    return detail::subdivide_repeatedly("subdivide_1_to_8", 8, m, detail::no_creases(), options,
                                        [&](const auto& mesh, const auto&, unsigned) {
                                          return detail::subdivide_in_hexes("subdivide_1_to_8", mesh, options);
                                        });
}

// What to write instead of calls that cannot compile.
template<class... T> void subdivide_1_to_8(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void subdivide_1_to_8(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
