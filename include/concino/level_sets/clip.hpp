// clip and split: a mesh, cut along a level set or a plane.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/level_sets/detail/clip/surface_clipper.hpp>
#include <concino/level_sets/detail/clip/volume_clipper.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/cut/plane_heights.hpp>

namespace concino {

namespace detail {

template<class M, class U>
auto clip_mesh(const M& m, const U& u, double level, bool both, const clip_options& input_options,
               const char* caller) {
  const core::profiled_options profiled(input_options, caller);
  const clip_options& options = *profiled;
  check_vert_values(m, u, caller);
  sort_levels({level}, caller);
  report_progress(options.progress, 0, "clipping");
  // polygons are cut by chords, polyhedra by caps
  if constexpr (dimension_v<M> == 2) return surface_clipper<M, U>(m, u, level, both, caller).run(options, caller);
  else return volume_clipper<M, U>(m, u, level, both, caller).run(options, caller);
}

}  // namespace detail

/// The part of a mesh where a function, linear on edges, is at least a value.
/// Needs:  EmbeddedMesh; in volumes, the faces of the polys that are cut form spheres. u[v] is a number for each vert.
/// Result: a polygonmesh or a polyhedralmesh. Polys that are not cut keep their verts, and their order; parts of polys
///         follow, in the order of their polys. Likewise verts and faces. The cut is that of isolines and isosurface:
///         cut_edges or cut_faces. A poly with k lines or cycles across it has k + 1 parts; parts that only touch are
///         separate. Faces on the boundary that are cut but not planar become triangles about the mean of their points,
///         so that the volumes of the parts of a poly sum to its volume. `from` has the elements of m of which those of
///         the result were made. Named properties of verts are interpolated, those of other elements inherited. Parts
///         are closed, and have positive measures where polys are about convex; elsewhere they may overlap or turn
///         over: the report counts this.
/// Cost:   O(elements of m), and O(n log n) for n polys that are cut.
/// Errors: invalid_argument if a value is NaN, naming the vert, or if u is a map of another mesh. unsupported as
///         isosurface, and, if options.convex_only, that names a poly that would be cut but is not convex. cancelled.
template<EmbeddedMesh M, class U>
  requires requirement::gives_numbers<U, vert_t<M>>
auto clip(const M& m, const U& u, double value, const clip_options& options = {}) {
  return detail::clip_mesh(m, u, value, false, options, "clip");
}

/// The part of a mesh above a plane.
/// Needs:  as clip; a plane with a normal of any length but 0.
/// Result: as clip with the heights of the verts above the plane.      Cost: as clip.
/// Errors: as clip, and invalid_argument if the plane has no normal or is not finite.
template<EmbeddedMesh M>
auto clip(const M& m, const plane& p, const clip_options& options = {}) {
  return detail::clip_mesh(m, detail::heights_above(m, p, "clip"), 0, false, options, "clip");
}

/// A mesh, cut along a level set or a plane, with the parts on both sides.
/// Needs:  as clip.      Result: as clip; above[i] says whether poly i is above.      Cost: as clip.      Errors: as
///         clip.
template<EmbeddedMesh M, class U>
  requires requirement::gives_numbers<U, vert_t<M>>
auto split(const M& m, const U& u, double value, const clip_options& options = {}) {
  return detail::clip_mesh(m, u, value, true, options, "split");
}
template<EmbeddedMesh M>
auto split(const M& m, const plane& p, const clip_options& options = {}) {
  return detail::clip_mesh(m, detail::heights_above(m, p, "split"), 0, true, options, "split");
}

// What to write instead of calls that cannot compile.
template<class... T> void clip(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void clip(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void split(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void split(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void clip(M&&, const U&, double, ...) = delete;  // a number at each vert: make_vert_map<double>(m)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(EmbeddedMesh<M> && !requirement::gives_numbers<U, vert_t<M>>)
void split(M&&, const U&, double, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
