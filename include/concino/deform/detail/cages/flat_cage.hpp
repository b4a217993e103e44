// A closed cage as triangles: its polys, cut into triangles, with the edges that these share.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/deform/detail/cages/weighted_sums.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace concino::detail {

/// The polys of a cage as lists of verts.
struct cage_polys {
  std::vector<vec3> points;               // by index_of
  std::vector<std::uint32_t> first{0}, corners;  // those of poly p are from first[p] to before first[p + 1]
  std::vector<std::size_t> index;         // of each poly, for messages

  std::span<const std::uint32_t> poly(std::size_t p) const {
    return {corners.data() + first[p], corners.data() + first[p + 1]};
  }
};

/// Points are divided by `unit`, a power of 2, so that their box is of a size near 1. Points from num_verts on are
/// centres of polys: the mean of the corners of centre c is point num_verts + c.
struct flat_cage {
  std::vector<vec3> points;
  std::size_t num_verts = 0;  // the index bound of the cage
  double unit = 1, size = 0;  // the diagonal of the box, in units
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<vec3> normals;                         // of the triangles; 0 of those without area
  std::vector<std::array<std::uint32_t, 2>> edges;   // the smaller vert first
  std::vector<std::array<std::uint32_t, 3>> triangle_edges;  // edge k is opposite of corner k
  std::vector<std::uint32_t> centre_first{0}, centre_corners;

  std::size_t num_points() const { return points.size(); }
  /// Moves the weights of centres to their corners; `weights` has num_points() entries.
  void give_to_corners(std::vector<double>& weights) const;
};

/// Errors: invalid_mesh if a point is not finite, there are no polys, all points are equal, or an edge is not passed as
///         often in the one direction as in the other; `caller` stands in front.
flat_cage make_flat_cage(const cage_polys& cage, const char* caller);

template<class C>
cage_polys cage_polys_of(const C& cage, const char* caller) {
  cage_polys flat;
  flat.points = points_by_index(cage, caller);
  for (const poly_t<C> p : polys(cage)) {
    for (const vert_t<C> v : adj_p2v(cage, p)) flat.corners.push_back(static_cast<std::uint32_t>(index_of(cage, v)));
    flat.first.push_back(static_cast<std::uint32_t>(flat.corners.size()));
    flat.index.push_back(index_of(cage, p));
  }
  return flat;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/cages/flat_cage.ipp>
#endif
