// Green coordinates of points in a cage of triangles: they keep angles better than coordinates of the verts alone.
#pragma once

#include <concino/core/iterable.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/deform/detail/cages/green.hpp>
#include <concino/mesh/element_map.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace concino {

/// The weights of the verts and of the normals of a cage for a list of points.
class green_weights {
  detail::green_rows rows_;

 public:
  explicit green_weights(detail::green_rows rows) : rows_(std::move(rows)) {}

  std::size_t num_points() const { return rows_.num_verts == 0 ? 0 : rows_.of_verts.size() / rows_.num_verts; }
  std::size_t num_cage_verts() const { return rows_.num_verts; }
  std::size_t num_cage_polys() const { return rows_.triangles.size(); }
  /// The weights for point i: of the verts by index_of, without unit, and of the normals in the order of polys(cage),
  /// as lengths.
  std::span<const double> of_verts(std::size_t i) const {
    return {rows_.of_verts.data() + i * num_cage_verts(), num_cage_verts()};
  }
  std::span<const double> of_normals(std::size_t i) const {
    return {rows_.of_normals.data() + i * num_cage_polys(), num_cage_polys()};
  }

  /// The points in a bent cage.
  /// Needs:  the cage with other points: the same polys, in the same order.
  /// Errors: invalid_argument if verts or polys differ; invalid_mesh if a point of the bent cage is not finite.
  template<SurfaceMesh C>
    requires Embedded<C>
  std::vector<vec3> points_of(const C& bent) const {
    const detail::cage_polys flat = detail::cage_polys_of(bent, "points_of");
    detail::check_bent_cage(flat.points.size(), num_cage_verts());
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::size_t p = 0; p < flat.index.size(); ++p)
      if (const auto t = flat.poly(p); t.size() == 3) triangles.push_back({t[0], t[1], t[2]});
    detail::check_triangles(rows_, triangles);
    return rows_.points_of(flat.points);
  }
};

/// The same for the verts of a mesh: points_of(bent) is a map of points of the mesh.
template<class M>
class mesh_green_weights {
  detail::mesh_ref<M> mesh_;
  green_weights weights_;

 public:
  mesh_green_weights(const M& m, green_weights weights) : mesh_(m), weights_(std::move(weights)) {}

  const M& mesh() const { return mesh_.get(); }
  const green_weights& weights() const { return weights_; }

  template<SurfaceMesh C>
    requires Embedded<C>
  vert_map<M, vec3> points_of(const C& bent) const {
    const auto all = weights_.points_of(bent);
    auto moved = make_vert_map<vec3>(mesh_.get());
    for (const vert_t<M> v : verts(mesh_.get())) moved[v] = all[index_of(mesh_.get(), v)];
    return moved;
  }
};

/// Green coordinates: weights of the verts and of the normals of a cage for points inside. Angles change less than with
/// cage_coordinates, and the shape may leave the bent cage. auto moved = green_coordinates(cage, m).points_of(bent);
/// Needs:  cage: an Embedded SurfaceMesh of triangles, closed and consistently oriented, outwards or inwards. points: a
///         mesh, no temporary, whose verts they are, or any container; inside of the cage.
/// Result: weights that reproduce similarities: a cage that is moved, rotated and scaled moves the points likewise,
///         to 1e-12 of its size, and at a distance d of an edge to the larger of this and 1e-15 / d.
/// Cost:   O(points x triangles) time, parallel, and as much memory.
/// Errors: as cage_coordinates about the cage; unsupported if a poly is no triangle; invalid_mesh if one has no area;
///         invalid_argument if a point is not finite, or is not inside: it is outside or on the cage.
/// Source: Lipman, Levin and Cohen-Or 2008, "Green coordinates". The integrals over triangles are those of Wilton et
///         al. 1984, "Potential integrals for uniform and linear source distributions", and Van Oosterom and Strackee
///         1983 for solid angles.
template<SurfaceMesh C, class P>
  requires Embedded<C> && core::iterable<P>
green_weights green_coordinates(const C& cage, const P& points) {
  return green_weights(detail::make_green_rows(detail::cage_polys_of(cage, "green_coordinates"),
                                               detail::points_by_index(points, "green_coordinates"),
                                               detail::indices_of_points(points)));
}
template<SurfaceMesh C, class M>
  requires Embedded<C> && requirement::is_lvalue_or_view<M> && Embedded<M> && requirement::has_verts<M>
mesh_green_weights<std::remove_cvref_t<M>> green_coordinates(const C& cage, M&& m) {
  return {m, green_weights(detail::make_green_rows(detail::cage_polys_of(cage, "green_coordinates"),
                                                   detail::points_by_index(m, "green_coordinates"),
                                                   detail::indices_of_points(m)))};
}

// What to write instead of calls that cannot compile.
template<class... T> void green_coordinates(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void green_coordinates(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
