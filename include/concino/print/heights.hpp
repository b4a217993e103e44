// heights: the heights of layers of equal thickness from the bottom of a mesh to its top.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/bounding_box.hpp>

#include <vector>

namespace concino {

namespace detail {

/// bottom, bottom + thickness ... below top.
std::vector<double> heights_between(double bottom, double top, double thickness);

}  // namespace detail

/// The heights of layers for slice_mesh: z of the lowest vert, and from there on in steps of the thickness up to below
/// the highest vert.
/// Needs:  Embedded mesh or graph with finite points; a thickness above 0.
/// Result: ascending heights, one for each begun layer; a rest below 1e-9 of the thickness counts as rounding. None if
///         there are no verts, or all have one height.
/// Cost:   O(verts + layers).
/// Errors: invalid_argument if the thickness is not finite and above 0, or gives more than 10^8 layers. invalid_mesh if
///         the heights of verts are not finite.
template<Embedded M>
  requires requirement::has_verts<M>
std::vector<double> heights(const M& m, double thickness) {
  const box b = bounding_box(m);
  return b.is_empty() ? detail::heights_between(0, 0, thickness) : detail::heights_between(b.min.z, b.max.z, thickness);
}

// What to write instead of calls that cannot compile.
template<class... T> void heights(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void heights(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/print/detail/slices/heights.ipp>
#endif
