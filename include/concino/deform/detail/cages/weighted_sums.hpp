// Points of meshes and lists by their index, and sums of weights times such points.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

[[noreturn, gnu::cold]] void throw_point_not_finite(const char* caller, const char* what, std::size_t index);

/// The points of the verts of a mesh, by index_of, or those of a container. Those of deleted verts are the origin.
/// Errors: invalid_mesh if a point is not finite; invalid_argument, if it is one of a container.
template<class C>
std::vector<vec3> points_by_index(const C& c, const char* caller) {
  std::vector<vec3> points;
  if constexpr (Embedded<C>) {
    points.resize(vert_index_bound(c));
    for (const vert_t<C> v : verts(c)) {
      const vec3 x = points[index_of(c, v)] = to_vec3(point(c, v));
      if (!is_finite(x)) throw_point_not_finite(caller, "vert", index_of(c, v));
    }
  } else {
    for (const auto& x : c) {
      points.push_back(to_vec3(x));
      if (!is_finite(points.back())) throw_point_not_finite(caller, "point", points.size() - 1);
    }
  }
  return points;
}

/// The indices of the points of points_by_index, without those of deleted verts.
template<class C>
std::vector<std::size_t> indices_of_points(const C& c) {
  std::vector<std::size_t> all;
  if constexpr (Embedded<C>) {
    for (const vert_t<C> v : verts(c)) all.push_back(index_of(c, v));
  } else {
    for (const auto& x : c) static_cast<void>(x), all.push_back(all.size());
  }
  return all;
}

/// For each of n rows of weights the sum of weights times points.
/// Errors: invalid_argument if a row has another number of weights than there are points.
std::vector<vec3> weighted_sums(const std::vector<double>& weights, std::size_t row_size, std::size_t n,
                                const std::vector<vec3>& points);

/// Errors: invalid_argument unless a bent cage has as many verts as the cage.
void check_bent_cage(std::size_t found, std::size_t expected);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/cages/weighted_sums.ipp>
#endif
