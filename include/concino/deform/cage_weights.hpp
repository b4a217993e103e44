// Coordinates of points in a cage: the weights of its verts, which move the points as the cage is bent.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/iterable.hpp>
#include <concino/core/vec3.hpp>
#include <concino/deform/detail/cages/weighted_sums.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace concino {

/// The weights of the verts of a cage for a list of points: points_of(bent) is where the points are in a bent cage.
/// Weights sum to 1 for each point. They are stored for each point and vert, 8 bytes each.
class cage_weights {
  std::size_t num_cage_verts_ = 0;
  std::vector<double> values_;

 public:
  cage_weights() = default;
  /// values: those of the first point, of the second, ...
  cage_weights(std::size_t num_cage_verts, std::vector<double> values)
      : num_cage_verts_(num_cage_verts), values_(std::move(values)) {}

  std::size_t num_points() const { return num_cage_verts_ == 0 ? 0 : values_.size() / num_cage_verts_; }
  /// The index bound of the verts of the cage, or the number of corners of a polygon.
  std::size_t num_cage_verts() const { return num_cage_verts_; }
  /// The weights of point i, by index_of the verts of the cage; 0 at those of deleted verts.
  std::span<const double> of(std::size_t i) const { return {values_.data() + i * num_cage_verts_, num_cage_verts_}; }

  /// The points in a bent cage: the sums of weights times its points.
  /// Needs:  a mesh with as many verts as the cage, in the same order, such as a copy of it whose points were set, or
  ///         with_points(cage, map); of a polygon its corners, in any container.
  /// Result: as many points as were given.      Cost: O(points x verts of the cage); parallel.
  /// Errors: invalid_argument if the number of verts differs; invalid_mesh if one of its points is not finite.
  template<class C>
    requires(Embedded<C> && requirement::has_verts<C>) || core::iterable<C>
  std::vector<vec3> points_of(const C& bent) const {
    return detail::weighted_sums(values_, num_cage_verts_, num_points(), detail::points_by_index(bent, "points_of"));
  }
};

/// The weights of the verts of a cage for the verts of a mesh: points_of(bent) is a map of points of the mesh.
template<class M>
class mesh_cage_weights {
  detail::mesh_ref<M> mesh_;
  cage_weights weights_;

 public:
  mesh_cage_weights(const M& m, cage_weights weights) : mesh_(m), weights_(std::move(weights)) {}

  const M& mesh() const { return mesh_.get(); }
  /// By index_of the verts of the mesh; those of deleted verts are 0.
  const cage_weights& weights() const { return weights_; }
  std::span<const double> of(const vert_t<M>& v) const { return weights_.of(index_of(mesh_.get(), v)); }

  /// As cage_weights::points_of; the result is a map, for with_points(m, map) or to set the points of m.
  template<class C>
    requires(Embedded<C> && requirement::has_verts<C>) || core::iterable<C>
  vert_map<M, vec3> points_of(const C& bent) const {
    const auto all = weights_.points_of(bent);
    auto moved = make_vert_map<vec3>(mesh_.get());
    for (const vert_t<M> v : verts(mesh_.get())) moved[v] = all[index_of(mesh_.get(), v)];
    return moved;
  }
};

}  // namespace concino
