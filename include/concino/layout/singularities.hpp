// Singular verts of quads, singular edges and verts of hexes: where another number of polys meets than in a grid.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/layout/detail/cube_tables.hpp>

#include <vector>

namespace concino {

/// A vert or edge at which the mesh is not like a grid.
template<class X>
struct singularity {
  X element;
  std::uint32_t valence = 0;  // the polys at it; of a vert of hexes, the singular edges at it
  bool on_boundary = false;
  bool is_manifold = true;  // the polys at it are one fan, and no facet at it has more than two
};

namespace detail {

template<class X, class R>
std::vector<singularity<X>> singular_ridges(const cube_tables& t, const R& elements) {
  std::vector<singularity<X>> all;
  const ridge_fans fans(t);
  auto at = fans.shapes.begin();
  for (const X x : elements) {
    const ridge_shape& s = *at++;
    if (!s.is_regular()) all.push_back({x, s.valence, s.on_boundary, s.is_manifold});
  }
  return all;
}

}  // namespace detail

/// The singular verts of a mesh of quads. Regular are verts with four quads around them, boundary verts with two, and
/// verts without polys. So the corners of a rectangle are singular: one quad. Verts that are not manifold are singular.
/// Needs:  a surface whose polys are quads.
/// Result: the singular verts in the order of verts(m), with the numbers of their quads. If the surface is manifold,
///         the sum of 4 - valence over those in the interior and of 2 - valence over those on the boundary is four
///         times the Euler characteristic.
/// Cost:   O(elements).
/// Errors: invalid_mesh if a poly is not a quad.
/// Source: Bommes et al. 2013, "Quad-mesh generation and processing: a survey", section 2.
template<requirement::may_be_quads M>
std::vector<singularity<vert_t<M>>> singular_verts(const M& m) {
  return detail::singular_ridges<vert_t<M>>(detail::cube_tables_of(m, "singular_verts"), verts(m));
}

/// The singular edges of a mesh of hexes. Regular are edges with four hexes around them, boundary edges with two, and
/// edges without polys. So the twelve edges of a box are singular: one hex. Edges that are not manifold are singular.
/// Needs:  HexMesh M.
/// Result: the singular edges in the order of edges(m), with the numbers of their hexes.
/// Cost:   O(elements).
/// Errors: none.
/// Source: Gao, Deng, Chen 2015, "Hexahedral mesh re-parameterization from aligned base-complex".
template<HexMesh M>
std::vector<singularity<edge_t<M>>> singular_edges(const M& m) {
  return detail::singular_ridges<edge_t<M>>(detail::cube_tables_of(m, "singular_edges"), edges(m));
}

/// The singular verts of a mesh of hexes: where singular edges end or meet. These are all verts with singular edges but
/// those with two of one valence, both on the boundary or neither, which continue each other.
/// Needs:  HexMesh M.
/// Result: the singular verts in the order of verts(m), with the numbers of singular edges at them. is_manifold says
///         whether all these edges are manifold.
/// Cost:   O(elements).
/// Errors: none.
/// Source: Gao, Deng, Chen 2015, as above.
template<HexMesh M>
std::vector<singularity<vert_t<M>>> singular_verts(const M& m) {
  struct ends_here {
    std::uint32_t count = 0, valence = 0;
    bool on_boundary = false, is_like = true, is_manifold = true;
  };
  std::vector<ends_here> at(vert_index_bound(m));
  for (const auto& e : singular_edges(m))
    for (const vert_t<M> v : adj_e2v(m, e.element)) {
      ends_here& x = at[index_of(m, v)];
      x.is_like = x.is_like && (x.count == 0 || (x.valence == e.valence && x.on_boundary == e.on_boundary));
      x.is_manifold = x.is_manifold && e.is_manifold;
      ++x.count, x.valence = e.valence, x.on_boundary = e.on_boundary;
    }
  std::vector<singularity<vert_t<M>>> all;
  for (const vert_t<M> v : verts(m))
    if (const ends_here& x = at[index_of(m, v)]; x.count > 0 && !(x.count == 2 && x.is_like && x.is_manifold))
      all.push_back({v, x.count, is_boundary(m, v), x.is_manifold});
  return all;
}

// What to write instead of calls that cannot compile.
template<class... T> void singular_verts(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void singular_edges(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()

}  // namespace concino
