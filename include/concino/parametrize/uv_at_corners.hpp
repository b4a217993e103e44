// uv_at_corners(m, cut.polys, surface, uv): the map of a surface that was cut open, at the corners of the one before.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/mesh/corner.hpp>
#include <concino/parametrize/detail/read_polys.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace concino {

/// The points that the corners of a surface have by a map of the same surface cut open along seams: auto cut =
/// cut_along(m, seams); const polygonmesh open(cut.surface); auto uv = uv_at_corners(m, cut.polys, open, lscm(open)).
/// Verts at seams have several points then.
/// Needs:  SurfaceMesh M and Open, M no temporary. origins: a container of polys of m; its i-th is poly i of `open`,
///         with corners in the same order. uv: a map from verts of `open` to points of the plane.
/// Result: a corner_map on m, which pictures take as texture_coordinates, map_distortion measures, and a
///         corner_property "texture" saves. Polys of m that are not in `origins` have the origin.
/// Cost:   O(corners).
/// Errors: invalid_argument if the numbers of polys differ, or those of the corners of a poly; invalid_mesh if one of
///         `origins` is no poly of m.
template<class M, class P, class Open, class U>
  requires requirement::is_lvalue_or_view<M> && SurfaceMesh<M> && SurfaceMesh<Open> &&
      detail::gives_uv<U, vert_t<Open>>
corner_map<std::remove_cvref_t<M>, uv_point> uv_at_corners(M&& m, const P& origins, const Open& open, const U& uv) {
  using mesh = std::remove_cvref_t<M>;
  auto result = make_corner_map<uv_point>(m, uv_point{0, 0});
  std::vector<std::size_t> size(poly_index_bound(m), 0);
  for (const poly_t<mesh> p : polys(m)) size[index_of(m, p)] = num_elements(adj_p2v(m, p));
  auto at = origins.begin();
  for (const poly_t<Open> q : polys(open)) {
    if (at == origins.end())
      throw invalid_argument("uv_at_corners: the open surface has more polys than are given; pass cut.polys");
    const poly_t<mesh> p = *at;
    ++at;
    if (!contains(m, p))
      throw invalid_mesh("uv_at_corners: one of the given polys is not a poly of the mesh that was cut");
    std::uint32_t k = 0;
    for (const vert_t<Open> v : adj_p2v(open, q)) {
      if (k < size[index_of(m, p)]) {
        const auto& x = uv[v];
        result[corner<mesh>{p, k}] = {static_cast<double>(x[0]), static_cast<double>(x[1])};
      }
      ++k;
    }
    if (k != size[index_of(m, p)])
      core::throw_joined<invalid_argument>({"uv_at_corners: poly ", index_of(m, p), " has ", size[index_of(m, p)],
                                            " corners, and ", k, " in the open surface; cut this mesh"});
  }
  if (at != origins.end())
    throw invalid_argument("uv_at_corners: the open surface has fewer polys than are given; pass cut.polys");
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void uv_at_corners(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void uv_at_corners(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
