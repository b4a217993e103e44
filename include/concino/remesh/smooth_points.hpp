// Smoothing of points: polys of better shapes without any change of the connectivity.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/remesh/detail/smoothing/point_smoother.hpp>

#include <cstddef>
#include <type_traits>

namespace concino {

struct smooth_points_options {
  unsigned max_rounds = 50;       // it ends sooner where a round changes hardly anything
  double feature_angle_deg = 40;  // edges where a surface or the boundary of a volume turns by more than this are lines
  bool slides = false;  // whether verts of lines move along them, and those of the boundary of a volume over it;
                        // otherwise they stay
  concino::progress progress = {};  // called with "smoothing points"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// The shape of a corner is its mean ratio: 1 where it is as in the regular poly, 0 where it is flat.
struct points_smoothing {
  unsigned num_rounds = 0;
  std::size_t num_moves = 0;
  std::size_t num_inverted_before = 0, num_inverted_after = 0;  // corners
  double min_shape_before = 1, min_shape_after = 1;  // shape of the corners that are not inverted
};

/// Moves verts so that the corners of polys come near to those of regular polys. The connectivity remains.
/// Needs:  AnyMesh with points that can be set; polys of any shape. is_fixed(v) names verts that stay. Lines are edges
///         that is_feature(e) names; in surfaces the boundary, edges that are not manifold, sharper than the angle or
///         between polys of different labels; in volumes the same edges of their boundary and of faces between labels.
///         labels: a map of polys, or a function of polys, to anything with ==, such as materials.
/// Result: what has become better. Verts of a surface move over the surface of the input. Verts of lines, and in
///         volumes those of the boundary and between labels, stay. If options.slides, the latter move over these faces
///         of the input and cross no line. Verts of lines move along those of the input and never past each other, but
///         ends, joints and sharp bends stay. So planes and straight lines are kept up to rounding; bent ones lose a
///         little where verts leave the bends. Verts at edges of a surface along which two polys run in the same
///         direction always stay. The least shape of all corners never becomes smaller, and no
///         corner is turned inside out, in surfaces as seen along the normal of the vert that moves, of each part
///         between lines if it slides. Inverted ones are turned back where a way is found; a fold of a flat surface is
///         an edge of 180 degrees, so let the angle be 180 there. In polys with more verts than a quad or a hex, reflex
///         corners are taken as intended: their verts stay. Corners of cells with more than three faces, such as the
///         top of a pyramid, are not measured.
/// Cost:   in each round O(corners), and a few closest points for each vert that moves over a surface.
/// Errors: invalid_argument if the angle is negative or not a number; invalid_mesh if a point is not finite; cancelled.
///         m is unchanged then.
/// Source: the energy: Knupp 2001, "Algebraic mesh quality metrics". One vert after the other by Newton's method:
///         Munson 2007, "Mesh shape-quality optimization using the inverse mean-ratio metric". Inverted corners:
///         Escobar, Rodriguez, Montenegro, Montero and Gonzalez-Yuste 2003, "Simultaneous untangling and smoothing of
///         tetrahedral meshes".
template<EmbeddedMesh M, class F, class E, class L>
  requires(MutablePoints<M> && std::is_invocable_r_v<bool, const F&, vert_t<M>> &&
           std::is_invocable_r_v<bool, const E&, edge_t<M>>)
points_smoothing smooth_points(M& m, const smooth_points_options& input_options, const F& is_fixed, const E& is_feature,
                               const L& labels) {
  const core::profiled_options profiled(input_options, "smooth_points");
  const smooth_points_options& options = *profiled;
  if (!(options.feature_angle_deg >= 0))
    core::throw_joined<invalid_argument>(
        {"smooth_points: options.feature_angle_deg is negative or not a number; it must be at least 0"});
  const detail::unit_points unit(m, "smooth_points");
  detail::point_smoother<M> smoother(m, unit, options.feature_angle_deg, options.slides, is_fixed,
                                     detail::kept_features<M, E, L>(m, is_feature, labels));
  points_smoothing result;
  smoother.run(options.max_rounds, options.progress, result);
  smoother.write(m, unit);
  return result;
}
template<EmbeddedMesh M, class F, class E>
  requires(MutablePoints<M> && std::is_invocable_r_v<bool, const F&, vert_t<M>> &&
           std::is_invocable_r_v<bool, const E&, edge_t<M>>)
points_smoothing smooth_points(M& m, const smooth_points_options& options, const F& is_fixed, const E& is_feature) {
  return smooth_points(m, options, is_fixed, is_feature, detail::no_features{});
}
template<EmbeddedMesh M, class F>
  requires(MutablePoints<M> && std::is_invocable_r_v<bool, const F&, vert_t<M>>)
points_smoothing smooth_points(M& m, const smooth_points_options& options, const F& is_fixed) {
  return smooth_points(m, options, is_fixed, detail::no_features{});
}
template<EmbeddedMesh M>
  requires MutablePoints<M>
points_smoothing smooth_points(M& m, const smooth_points_options& options = {}) {
  return smooth_points(m, options, [](const vert_t<M>&) { return false; });
}

// What to write instead of calls that cannot compile.
template<class... T> void smooth_points(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void smooth_points(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
