// A graph in space as flat arrays, and its bones as lists of numbers of verts.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/io/skeleton_graph.hpp>
#include <concino/skeleton/bone_curve.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

/// Verts are numbered in the order of verts(g). The neighbours of vert v are from neighbours[first[v]] to before
/// neighbours[first[v + 1]].
struct flat_curves {
  std::vector<vec3> points;
  std::vector<double> radii;  // empty if there are none
  std::vector<std::uint32_t> first{0}, neighbours;

  std::size_t num_neighbours(std::size_t v) const { return first[v + 1] - first[v]; }
};

/// Radii of graphs that have none.
struct no_radii {
  template<class V> double operator[](const V&) const { return 0; }
};
struct skeleton_radii {
  const skeleton& k;
  double operator[](vert_id v) const { return k.radius(v); }
};
template<class M> no_radii radii_of(const M&) { return {}; }
inline skeleton_radii radii_of(const skeleton& k) { return {k}; }

template<class M>
unsigned num_neighbours_up_to_3(const M& g, const vert_t<M>& v) {
  unsigned n = 0;
  for (const vert_t<M> w : adj_v2v(g, v)) {
    static_cast<void>(w);
    if (++n == 3) break;
  }
  return n;
}

/// Errors: invalid_mesh if a point is not finite, unsupported if there are more than 2^32 - 2 verts, and
///         invalid_argument if a radius is negative or not finite, with `who` in front.
template<class M, class Map>
flat_curves flat_curves_of(const M& g, const Map& radii, const char* who) {
  flat_curves flat;
  std::vector<std::uint32_t> number(vert_index_bound(g));
  for (const vert_t<M> v : verts(g)) {
    if (flat.points.size() >= std::numeric_limits<std::uint32_t>::max() - 1)
      core::throw_joined<unsupported>({who, ": the graph has more than 2^32 - 2 verts"});
    number[index_of(g, v)] = static_cast<std::uint32_t>(flat.points.size());
    flat.points.push_back(to_vec3(point(g, v)));
    flat.radii.push_back(static_cast<double>(radii[v]));
    if (!is_finite(flat.points.back()))
      core::throw_joined<invalid_mesh>({who, ": vert ", index_of(g, v), " has a coordinate that is not finite"});
    if (!(flat.radii.back() >= 0 && std::isfinite(flat.radii.back())))
      core::throw_joined<invalid_argument>(
          {who, ": vert ", index_of(g, v), " has a radius that is negative or not finite"});
  }
  for (const vert_t<M> v : verts(g)) {
    for (const vert_t<M> w : adj_v2v(g, v)) flat.neighbours.push_back(number[index_of(g, w)]);
    flat.first.push_back(static_cast<std::uint32_t>(flat.neighbours.size()));
  }
  bool any = false;
  for (const double r : flat.radii) any = any || r > 0;
  if (!any) flat.radii.clear();
  return flat;
}

/// The verts of each bone, in the order of bones(g).
std::vector<std::vector<std::uint32_t>> bone_walks(const flat_curves& g);

/// The points and radii of a walk.
bone_curve curve_along(const flat_curves& g, const std::vector<std::uint32_t>& walk);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/skeleton/detail/flat_curves.ipp>
#endif
