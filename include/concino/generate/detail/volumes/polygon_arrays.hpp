// A surface as flat arrays, with the names that its elements have in messages; and its orientation.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Polygons as flat arrays. Points are the verts that have polys, in the order of the mesh. Elements are named in
/// messages by their indices in the mesh.
struct polygon_arrays {
  std::vector<vec3> points;
  std::vector<std::size_t> offsets{0};
  std::vector<std::uint32_t> corners;  // of poly i from offsets[i] to offsets[i + 1]: points
  std::vector<std::uint32_t> vert_index, poly_index;   // by point, by poly
  std::vector<std::uint32_t> point_of_vert;  // by position in verts(m); no_point where a vert has no poly

  static constexpr std::uint32_t no_point = ~0u;
  std::size_t num_polys() const { return offsets.size() - 1; }
};

template<class M>
polygon_arrays polygons_of(const M& m) {
  polygon_arrays a;
  std::vector<std::uint32_t> number(vert_index_bound(m), a.no_point);
  for (const poly_t<M> p : polys(m))
    for (const vert_t<M> v : adj_p2v(m, p)) number[index_of(m, v)] = 0;
  for (const vert_t<M> v : verts(m)) {
    const std::size_t i = index_of(m, v);
    if (number[i] != a.no_point) {
      number[i] = static_cast<std::uint32_t>(a.points.size());
      a.points.push_back(to_vec3(point(m, v)));
      a.vert_index.push_back(static_cast<std::uint32_t>(i));
    }
    a.point_of_vert.push_back(number[i]);
  }
  for (const poly_t<M> p : polys(m)) {
    for (const vert_t<M> v : adj_p2v(m, p)) a.corners.push_back(number[index_of(m, v)]);
    a.offsets.push_back(a.corners.size());
    a.poly_index.push_back(static_cast<std::uint32_t>(index_of(m, p)));
  }
  return a;
}

/// Reverses polys so that neighbours use their edge in opposite directions. Parts that had to be changed get a volume
/// of 0 or more.
/// Errors: invalid_mesh if a poly has fewer than three verts or repeats one, an edge has one poly or more than two, or
///         the surface has only one side.
void orient_alike(polygon_arrays& s);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/generate/detail/volumes/polygon_arrays.ipp>
#endif
