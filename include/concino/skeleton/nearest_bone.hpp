// The bone of a skeleton that is nearest to each vert of a mesh.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/parallel.hpp>
#include <concino/geometry/lines_and_planes.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/skeleton/bones.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace concino {

namespace detail {

/// The number of the curve that is nearest to x; of equally near ones the first.
std::size_t nearest_curve(const std::vector<const bone_curve*>& curves, const vec3& x);

}  // namespace detail

/// The number of the nearest bone for each vert: nearest_bone(m, bones(k)), to label or to move a mesh by its skeleton.
/// Needs:  Embedded M with verts, no temporary; bones with points, one at least, of any graph.
/// Result: a map of std::size_t, of the places in `all`; of bones at the same distance the first, as at joints.
/// Cost:   O(verts x points of the bones); parallel.
/// Errors: invalid_argument if there are no bones, or one has no points.
template<class M, class G>
  requires requirement::is_lvalue_or_view<M> && Embedded<M> && requirement::has_verts<M>
vert_map<M, std::size_t> nearest_bone(M&& m, const std::vector<bone<G>>& all) {
  std::vector<const bone_curve*> curves;
  for (const bone<G>& b : all) {
    if (b.points.empty())
      core::throw_joined<invalid_argument>({"nearest_bone: bone ", curves.size(), " has no points"});
    curves.push_back(&b);
  }
  if (curves.empty()) core::throw_joined<invalid_argument>({"nearest_bone: there are no bones"});
  auto nearest = make_vert_map<std::size_t>(m, 0);
  parallel_for_each(verts(m), [&](const vert_t<M>& v) {
    nearest[v] = detail::nearest_curve(curves, to_vec3(point(m, v)));
  });
  return nearest;
}

// What to write instead of calls that cannot compile.
template<class... T> void nearest_bone(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void nearest_bone(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void nearest_bone(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/nearest_bone.ipp>
#endif
