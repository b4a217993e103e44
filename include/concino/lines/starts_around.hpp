// starts_around: points round the centroid of a poly, from which a bundle of lines begins.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <vector>

namespace concino {

/// Points inside a poly, round its centroid: auto bundle = integral_lines(m, g, starts_around(m, p)), as in Fig. 4 of
/// the paper.
/// Needs:  EmbeddedMesh; p is a poly of m. part: in (0, 1).
/// Result: a point for each vert of p, in their order: at this part of the way from the centroid to the vert. They lie
///         in the poly if it is star-shaped seen from its centroid, as convex ones are.
/// Cost:   O(size of the poly).      Errors: invalid_mesh if p is no poly of m; invalid_argument if part is out of its
///         range.
/// Source: paper section 2.2, Fig. 4.
template<EmbeddedMesh M>
std::vector<mesh_point<M>> starts_around(const M& m, const poly_t<M>& p, double part = 0.5) {
  if (!contains(m, p))
    core::throw_joined<invalid_mesh>({"starts_around: poly ", index_of(m, p), " is no poly of the mesh"});
  if (!(part > 0 && part < 1))
    core::throw_joined<invalid_argument>(
        {"starts_around: part is ", core::number_text(part), "; it must be between 0 and 1"});
  const vec3 middle = centroid(m, p);
  std::vector<mesh_point<M>> starts;
  for (const vert_t<M> v : adj_p2v(m, p)) starts.push_back({p, middle + part * (to_vec3(point(m, v)) - middle)});
  return starts;
}

// What to write instead of calls that cannot compile.
template<class... T> void starts_around(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void starts_around(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class... T> void starts_around(mistake::any_mesh, mistake::number<mistake::name_the_element>, ...) = delete;  // elements have types: poly_id{0}, not 0

}  // namespace concino
