// A closed surface of quads around a curve skeleton.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/skeleton/detail/flat_curves.hpp>

#include <cmath>

namespace concino {

struct skeleton_tube_options {
  double radius = 0;  // of verts whose own radius is 0, or that have none; in units of the graph. >= 0
};

namespace detail {

/// All radii are positive.
surface_arrays tube_around(const flat_curves& g);

}  // namespace detail

/// A surface around a curve skeleton or another graph in space: subdivide_catmull_clark(tube(k)) is smooth.
/// Needs:  EmbeddedGraph M. The radius at each vert, of a skeleton its own, is positive.
/// Result: a closed, manifold, oriented surface of quads for each component; its genus is the number of independent
///         cycles of the component. Around a vert with two neighbours it has four verts, at the distance of the radius.
///         Around any other vert it has a cube in a ball of that radius, with as many faces as needed. Bones begin at
///         those that face them. The surface may intersect itself where bones are closer to one another than their
///         radii, or shorter.
/// Cost:   O(verts + edges), and O(n^2) at a vert with n neighbours.
/// Errors: as bones; invalid_argument if the graph has no verts, if a radius is 0 and options.radius is, too, or if
///         that is negative or not finite.
/// Source: a joint is a block of quads, as the branching polyhedra of Baerentzen, Misztal and Welnicka 2012,
///         "Converting skeletal structures to quad dominant meshes".
template<EmbeddedGraph M>
quadmesh tube(const M& g, const skeleton_tube_options& options = {}) {
  if (!(options.radius >= 0 && std::isfinite(options.radius)))
    core::throw_joined<invalid_argument>({"skeleton_tube_options: radius is ", core::number_text(options.radius),
                                          "; it has to be finite and not negative"});
  detail::flat_curves flat = detail::flat_curves_of(g, detail::radii_of(g), "tube");
  if (flat.points.empty()) core::throw_joined<invalid_argument>({"tube: the graph has no verts"});
  flat.radii.resize(flat.points.size());
  std::size_t i = 0;
  for (const vert_t<M> v : verts(g)) {
    double& r = flat.radii[i++];
    if (r == 0) r = options.radius;
    if (r == 0)
      core::throw_joined<invalid_argument>(
          {"tube: vert ", index_of(g, v), " has radius 0; set radii, or pass {.radius = r}"});
  }
  return quadmesh(detail::tube_around(flat));
}

// What to write instead of calls that cannot compile.
template<class... T> void tube(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void tube(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/tube.ipp>
#endif
