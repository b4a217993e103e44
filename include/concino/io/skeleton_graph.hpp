// Curve skeletons: graphs in space with a radius at each vert. They model PrimalGraph and Embedded, so graph algorithms
// run on them.
#pragma once

#include <concino/concepts/descriptors.hpp>
#include <concino/concepts/mesh_traits.hpp>
#include <concino/concepts/ranges.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

/// A curve skeleton: verts with points and radii, joined by edges. <concino/io/skeleton.hpp> reads and writes them.
///
///   skeleton k({{0, 0, 0}, {1, 0, 0}}, {{vert_id{0}, vert_id{1}}}, {0.5, 0.25});
///   auto d = dijkstra(k, vert_id{0});
///   double r = k.radius(vert_id{1});
class skeleton {
  std::vector<vec3> points_;
  std::vector<double> radii_;
  std::vector<std::array<vert_id, 2>> edges_;
  std::vector<std::uint32_t> first_{0};  // neighbours_[first_[v]] is the first neighbour of v
  std::vector<vert_id> neighbours_;
  std::vector<edge_id> incident_;  // the edge to each neighbour

 public:
  /// No verts.
  skeleton() = default;
  /// Verts 0, 1, ... with these points, and edges between them. Verts without edges are allowed. Without `radii`, all
  /// radii are 0.
  /// Errors: invalid_mesh if an edge has a vert that does not exist, joins a vert with itself, or is there twice.
  ///         invalid_argument if there are radii, but not one for each point. unsupported for more elements than ids
  ///         can number.
  explicit skeleton(std::vector<vec3> points, std::vector<std::array<vert_id, 2>> all_edges = {},
                    std::vector<double> radii = {});

  std::size_t num_verts() const { return points_.size(); }
  std::size_t num_edges() const { return edges_.size(); }

  const vec3& point(vert_id v) const { return points_[v.raw()]; }
  void set_point(vert_id v, const vec3& p) { points_[v.raw()] = p; }

  /// Whether radii are stored; without them all are 0.
  bool has_radii() const { return !radii_.empty(); }
  double radius(vert_id v) const { return radii_.empty() ? 0 : radii_[v.raw()]; }
  void set_radius(vert_id v, double r) {
    if (radii_.empty()) radii_.resize(points_.size());
    radii_[v.raw()] = r;
  }

  const std::array<vert_id, 2>& end_verts(edge_id e) const { return edges_[e.raw()]; }
  /// The neighbours of a vert, in the order of their indices, and the edges to them.
  id_span<vert_id> neighbours(vert_id v) const {
    return {neighbours_.data() + first_[v.raw()], neighbours_.data() + first_[v.raw() + 1]};
  }
  id_span<edge_id> incident_edges(vert_id v) const {
    return {incident_.data() + first_[v.raw()], incident_.data() + first_[v.raw() + 1]};
  }

  const std::vector<vec3>& points() const { return points_; }
  const std::vector<double>& radii() const { return radii_; }
  const std::vector<std::array<vert_id, 2>>& edges() const { return edges_; }

  friend bool operator==(const skeleton& a, const skeleton& b) {
    return a.points_ == b.points_ && a.radii_ == b.radii_ && a.edges_ == b.edges_;
  }
};

template<>
struct mesh_traits<skeleton> {
  using vert = vert_id;
  using edge = edge_id;

  static std::size_t num_verts(const skeleton& k) { return k.num_verts(); }
  static std::size_t vert_index_bound(const skeleton& k) { return k.num_verts(); }
  static std::size_t index_of(const skeleton&, vert_id v) { return v.raw(); }
  static id_range<vert_id> verts(const skeleton& k) { return id_range<vert_id>(k.num_verts()); }
  static id_span<vert_id> adj_v2v(const skeleton& k, vert_id v) { return k.neighbours(v); }

  static std::size_t num_edges(const skeleton& k) { return k.num_edges(); }
  static std::size_t edge_index_bound(const skeleton& k) { return k.num_edges(); }
  static std::size_t index_of(const skeleton&, edge_id e) { return e.raw(); }
  static id_range<edge_id> edges(const skeleton& k) { return id_range<edge_id>(k.num_edges()); }
  static std::array<vert_id, 2> adj_e2v(const skeleton& k, edge_id e) { return k.end_verts(e); }
  static id_span<edge_id> adj_v2e(const skeleton& k, vert_id v) { return k.incident_edges(v); }

  static const vec3& point(const skeleton& k, vert_id v) { return k.point(v); }
  template<class X>
  static void set_point(skeleton& k, vert_id v, const X& x) {
    k.set_point(v, vec3(x[0], x[1], x[2]));
  }
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/io/detail/skeleton/skeleton_graph.ipp>
#endif
