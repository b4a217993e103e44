// Curve skeletons with other verts on the same curves: evenly spaced, or with one vert more.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/io/skeleton_graph.hpp>
#include <concino/skeleton/bones.hpp>

#include <cstddef>

namespace concino {

namespace detail {

skeleton respaced(const flat_curves& g, double spacing);

}  // namespace detail

/// A skeleton on the same curves with evenly spaced verts: respace(k, 0.5).
/// Needs:  EmbeddedGraph M; spacing > 0, in units of the graph.
/// Result: leaves, joints and verts without edges remain, first and in the order of verts(g), and with them a vert of
///         each cycle that has no joints; then the new verts of one bone after another. Each bone has the number of
///         edges for which their length along the curve is nearest to the spacing: one at least, three of a cycle, and
///         two of a bone whose ends are joined by a shorter one. Radii are interpolated.
/// Cost:   O(verts + edges + new verts).
/// Errors: as bones; invalid_argument if the spacing is not positive and finite, or so small that verts cannot be
///         numbered.
template<EmbeddedGraph M>
skeleton respace(const M& g, double spacing) {
  return detail::respaced(detail::flat_curves_of(g, detail::radii_of(g), "respace"), spacing);
}

/// A skeleton, and the vert where a bone was split.
struct split_bone_result {
  skeleton result;
  vert_id vert;           // of the result, at the fraction of the length of the bone
  bool is_added = false;  // false if the skeleton had this vert; then the result is a copy of it
};

/// Splits a bone of a skeleton at a fraction of its length: split_bone(k, bones(k)[2], 0.5).
/// Needs:  a bone of k; a fraction from 0 to 1.
/// Result: the skeleton with a vert more, after all others, on an edge of the bone, with the radius interpolated. The
///         edge becomes that from its first end to the new vert, and a new one follows all others. Where the bone has a
///         vert, none is added.
/// Cost:   O(size of the skeleton).
/// Errors: invalid_argument as sample, or if the verts of the bone are not joined in k.
split_bone_result split_bone(const skeleton& k, const bone<skeleton>& b, double fraction);

// What to write instead of calls that cannot compile.
template<class... T> void respace(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void respace(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/respace.ipp>
#endif
