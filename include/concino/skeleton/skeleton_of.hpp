// The curve skeleton of a closed surface.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/profiler.hpp>
#include <concino/core/progress.hpp>
#include <concino/io/skeleton_graph.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino {

struct skeleton_of_options {
  double area = 1e-3;        // the flow ends when a step changes the area by less than this part of the first one; from
                             // 1e-6 to 0.5
  int max_steps = 40;        // of the flow; >= 1
  bool keep_short = false;   // keep bones with a leaf that are shorter than 1.5 radii of their joint
  concino::progress progress = nullptr;  // called with "contracting", "collapsing edges"
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

/// A curve skeleton of a surface, and the verts that each of its nodes came from.
template<class M>
struct skeleton_of_result {
  concino::skeleton skeleton;               // with radii: the mean distances of these verts from their node
  std::vector<std::vector<vert_t<M>>> from;  // from[n]: the verts of the surface that became vert n of the skeleton;
                                            // each vert of a poly is in one of them
  double area = 1;                          // that the flow left, as a part of the first one
};

namespace detail {

/// A surface of triangles.
struct closed_triangles {
  std::vector<vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
struct collapsed_curve {
  concino::skeleton skeleton;
  std::vector<std::vector<std::uint32_t>> from;
  double area = 1;
};

/// Errors: invalid_mesh if the surface is not closed, manifold and oriented, or has no area.
collapsed_curve collapsed_to_curve(const closed_triangles& surface, const skeleton_of_options& options);

}  // namespace detail

/// The curve skeleton of a closed surface of triangles: bones(skeleton_of(m).skeleton).
/// Needs:  SurfaceMesh M, Embedded, whose polys are triangles; closed, manifold and oriented.
/// Result: the surface flows by its mean curvature, each vert drawn to the centre of a large ball inside that touches
///         the surface there. Short edges collapse, flat triangles are split, and what is thin stays where it is. What
///         is left is collapsed to a curve. A node is where its verts have come to. A surface like a ball has no
///         cycles, and a handle that is thin against its length gives one. A component gives one component. Lumps and
///         flat parts may have bones of their own. Scales exactly with powers of 2.
/// Cost:   for n verts, O(n log n), and a factorisation of a matrix of n rows, O(n^1.5), then some of fewer rows.
/// Errors: unsupported if a poly is no triangle. invalid_mesh if the surface has no polys, an edge without exactly two
///         triangles that are oriented alike, a point that is not finite, or no area. invalid_argument if an option is
///         out of range. cancelled; solver_error.
/// Source: Tagliasacchi, Alhashim, Olson and Zhang 2012, "Mean curvature skeletons"; the area that has shrunk resists
///         as in Au, Tai, Chu, Cohen-Or and Lee 2008, "Skeleton extraction by mesh contraction". Ma, Bae and Choi 2012,
///         "3D medial axis point approximation using nearest neighbors and the normal field", for the balls.
template<SurfaceMesh M>
  requires Embedded<M>
skeleton_of_result<M> skeleton_of(const M& m, const skeleton_of_options& options = {}) {
  const core::profiled_options profiled(options, "skeleton_of");
  detail::closed_triangles flat;
  std::vector<vert_t<M>> of_number;
  constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(vert_index_bound(m), none);
  for (const poly_t<M> p : polys(m)) {
    std::array<std::uint32_t, 3> corners{};
    std::size_t n = 0;
    for (const vert_t<M> v : adj_p2v(m, p)) {
      std::uint32_t& i = number[index_of(m, v)];
      if (i == none) {
        i = static_cast<std::uint32_t>(of_number.size());
        of_number.push_back(v);
        flat.points.push_back(to_vec3(point(m, v)));
        if (!is_finite(flat.points.back()))
          core::throw_joined<invalid_mesh>(
              {"skeleton_of: vert ", index_of(m, v), " has a coordinate that is not finite"});
      }
      if (n < 3) corners[n] = i;
      ++n;
    }
    if (n != 3)
      core::throw_joined<unsupported>(
          {"skeleton_of: poly ", index_of(m, p), " has ", n, " verts; pass to_triangles(m)"});
    flat.triangles.push_back(corners);
  }
  detail::collapsed_curve curve = detail::collapsed_to_curve(flat, *profiled);
  skeleton_of_result<M> result{std::move(curve.skeleton), {}, curve.area};
  for (const auto& some : curve.from) {
    result.from.emplace_back();
    for (const std::uint32_t v : some) result.from.back().push_back(of_number[v]);
  }
  return result;
}

// What to write instead of calls that cannot compile.
template<class... T> void skeleton_of(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void skeleton_of(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/skeleton_of.ipp>
#endif
