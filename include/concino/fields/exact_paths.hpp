// Shortest paths over triangle meshes: their points and lengths.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/surface_mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/unfolded_triangles.hpp>
#include <concino/core/vec3.hpp>
#include <concino/fields/detail/exact/path_tree.hpp>
#include <concino/geometry/support/unfolded_surface.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace concino {

/// A shortest path over a surface. It is straight between consecutive points; each piece lies in one triangle or along
/// an edge. points: from the source to the target, both included; one if they are the same, none if no path exists.
/// length: the sum of the lengths of the pieces, in units of length; +inf if no path exists.
template<class M>
struct geodesic_path {
  std::vector<mesh_point<M>> points;
  double length = std::numeric_limits<double>::infinity();
};

/// The shortest paths from one set of sources to all verts. Copies share the stored data.
template<SurfaceMesh M>
  requires Embedded<M>
class exact_paths {
  struct contents {
    std::shared_ptr<const core::unfolded_surface> prepared;
    detail::path_tree tree;
    std::optional<mesh_point<M>> source_point;  // the source, if it is inside a triangle
    std::vector<vert_t<M>> vert;         // by index
    std::vector<edge_t<M>> edge;
  };
  vert_map<M, double> distances_;
  std::shared_ptr<const contents> contents_;

 public:
  /// Called by prepared_exact_geodesics::paths_from.
  exact_paths(vert_map<M, double> distances, std::shared_ptr<const core::unfolded_surface> prepared,
              detail::path_tree tree, std::optional<mesh_point<M>> source_point)
      : distances_(std::move(distances)) {
    const M& m = distances_.mesh();
    contents c{std::move(prepared), std::move(tree), std::move(source_point), {}, {}};
    c.vert.resize(vert_index_bound(m));
    for (const vert_t<M> v : verts(m)) c.vert[index_of(m, v)] = v;
    c.edge.resize(edge_index_bound(m));
    for (const edge_t<M> e : edges(m)) c.edge[index_of(m, e)] = e;
    contents_ = std::make_shared<const contents>(std::move(c));
  }

  /// The distance of each vert from the sources, in units of length; +inf where no path exists.
  const vert_map<M, double>& distances() const { return distances_; }

  /// The shortest path from the nearest source to vert v.
  /// Needs:  the mesh has not changed since it was prepared.
  /// Result: see geodesic_path. Its length is the distance at v minus the initial distance of its source, to a relative
  ///         error of 1e-12. If there are several shortest paths, it is one of them, the same in every run.
  /// Cost:   O(number of points).
  /// Errors: invalid_mesh if v is not a vert of the mesh.
  geodesic_path<M> path_to(const vert_t<M>& v) const {
    const M& m = distances_.mesh();
    if (!contains(m, v)) throw invalid_mesh("exact_paths: the target is not a vert of the mesh; take it from verts(m)");
    geodesic_path<M> path;
    if (distances_[v] == std::numeric_limits<double>::infinity()) return path;
    const core::unfolded_triangles& t = contents_->prepared->triangles;
    for (const detail::path_tree::stop& s : contents_->tree.path_to(t, static_cast<int>(index_of(m, v))))
      path.points.push_back(point_at(m, t, s));
    const double unit = std::ldexp(1.0, -t.exponent);  // so that no square overflows
    double length = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i)
      length += distance(unit * path.points[i - 1].position, unit * path.points[i].position);
    path.length = std::ldexp(length, t.exponent);
    return path;
  }

 private:
  mesh_point<M> point_at(const M& m, const core::unfolded_triangles& t, const detail::path_tree::stop& s) const {
    if (s.vert >= 0) {
      const vert_t<M> v = contents_->vert[static_cast<std::size_t>(s.vert)];
      return {v, to_vec3(point(m, v))};
    }
    if (s.side < 0) return *contents_->source_point;
    const edge_t<M> e = contents_->edge[static_cast<std::size_t>(t.edge[static_cast<std::size_t>(s.side)])];
    std::array<vec3, 2> end;
    bool is_along = true;
    std::size_t k = 0;
    for (const vert_t<M> v : adj_e2v(m, e)) {
      if (k == 0) is_along = static_cast<int>(index_of(m, v)) == t.start(s.side);
      if (k < 2) end[k++] = to_vec3(point(m, v));
    }
    const double parameter = is_along ? s.along : 1 - s.along;
    return {edge_point<M>{e, parameter}, (1 - parameter) * end[0] + parameter * end[1]};
  }
};

}  // namespace concino
