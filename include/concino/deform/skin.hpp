// Skinning: the verts of a mesh follow the bones of a skeleton by weights.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/deform/affine_map.hpp>
#include <concino/deform/detail/cages/weighted_sums.hpp>
#include <concino/deform/detail/skin/blend.hpp>
#include <concino/deform/skin_weights.hpp>
#include <concino/mesh/element_map.hpp>

#include <concepts>
#include <cstddef>
#include <vector>

namespace concino {

/// How the transforms of bones are blended: their matrices, or their dual quaternions.
struct linear_blend_method {};
struct dual_quaternions_method {};
inline constexpr linear_blend_method linear_blend{};
inline constexpr dual_quaternions_method dual_quaternions{};

/// The verts of a mesh moved by the transforms of bones: skin(m, weights, transforms, dual_quaternions).
/// Needs:  Embedded M with verts, no temporary; weights for its index bound of verts, at each vert; an affine_map for
///         each bone, from the rest pose to the new one, in any container. For dual_quaternions they are rotations and
///         translations.
/// Result: a map of points. linear_blend: the sum of weights times the images of the point. It is affine in each
///         transform, and shrinks where bones are bent or twisted far. dual_quaternions: the image by the normalised
///         sum of dual quaternions, a rigid motion for each vert, which does not shrink. Of the two signs of each, the
///         one nearer to the bone of the largest weight.
/// Cost:   O(verts + weights), parallel.
/// Errors: invalid_argument if weights are for another number of verts or transforms for another number of bones, or a
///         vert has no weights. The same if a transform is not finite, or, for dual_quaternions, is not rigid to 1e-6;
///         invalid_mesh if a point is not finite.
/// Source: Magnenat-Thalmann, Laperriere and Thalmann 1988 for linear blending; Kavan, Collins, Zara and O'Sullivan
///         2007, "Skinning with dual quaternions".
template<class M, class T, class Method>
  requires requirement::is_lvalue_or_view<M> && Embedded<M> && requirement::has_verts<M> &&
      (std::same_as<Method, linear_blend_method> || std::same_as<Method, dual_quaternions_method>)
vert_map<M, vec3> skin(M&& m, const skin_weights& weights, const T& transforms, const Method&) {
  const auto points = detail::points_by_index(m, "skin");
  std::vector<affine_map> all;
  for (const affine_map& f : transforms) all.push_back(f);
  const auto used = detail::indices_of_points(m);
  detail::check_skin(weights, points.size(), used, all, std::same_as<Method, dual_quaternions_method>);
  const auto moved = std::same_as<Method, linear_blend_method>
                         ? detail::blend_linearly(points, used, weights, all)
                         : detail::blend_dual_quaternions(points, used, weights, all);
  auto result = make_vert_map<vec3>(m);
  for (const vert_t<M> v : verts(m)) result[v] = moved[index_of(m, v)];
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void skin(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void skin(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void skin(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
