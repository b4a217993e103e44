// The lines that remeshing keeps: boundaries, non-manifold edges, edges at which the surface turns by a large angle,
// and those that the caller names.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/geometry/normals.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>
#include <vector>

namespace concino::detail {

/// How far a vert may move.
enum class vert_freedom : std::uint8_t {
  surface,  // over the surface
  line,     // along the line on which it lies
  none,     // it is an end of lines, a sharp bend of one, or the surface is not manifold here
};

template<class M>
class feature_lines {
  std::vector<std::uint8_t> edges_;  // by index: whether it is part of a line
  std::vector<vert_freedom> verts_;

  template<class T>
  static T& at(std::vector<T>& values, std::size_t i) {
    if (i >= values.size()) values.resize(std::max(i + 1, 2 * values.size()));
    return values[i];
  }

  static bool is_sharp(const M& m, const edge_t<M>& e, double least_cosine) {
    vec3 normals[2];
    unsigned n = 0;
    for (const poly_t<M> p : adj_e2p(m, e)) {
      if (n < 2) normals[n] = normal(m, p);
      ++n;
    }
    return n != 2 || dot(normals[0], normals[1]) < least_cosine;
  }

  vert_freedom find_freedom(const M& m, const vert_t<M>& v, double least_cosine) const {
    vec3 along[2];
    unsigned n = 0;
    for (const edge_t<M> e : adj_v2e(m, v)) {
      if (!has(m, e)) continue;
      const auto ends = end_verts(m, e);
      const vec3 d = to_vec3(point(m, ends.first == v ? ends.second : ends.first)) - to_vec3(point(m, v));
      const double longest = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
      if (n < 2 && longest > 0) along[n] = d / longest, along[n] = along[n] / norm(along[n]);
      ++n;
    }
    if (n == 0) return is_one_fan(m, v) ? vert_freedom::surface : vert_freedom::none;
    return n == 2 && dot(along[0], along[1]) <= -least_cosine ? vert_freedom::line : vert_freedom::none;
  }

 public:
  /// Whether the polys at v are one fan: each is reached from the first across edges at v.
  static bool is_one_fan(const M& m, const vert_t<M>& v) {
    std::vector<poly_t<M>> fan;
    std::size_t n = 0;
    for (const poly_t<M> p : adj_v2p(m, v)) {
      if (fan.empty()) fan.push_back(p);
      ++n;
    }
    for (std::size_t i = 0; i < fan.size(); ++i)
      for (const edge_t<M> e : adj_p2e(m, fan[i])) {
        const auto ends = end_verts(m, e);
        if (ends.first != v && ends.second != v) continue;
        for (const poly_t<M> p : adj_e2p(m, e))
          if (std::find(fan.begin(), fan.end(), p) == fan.end()) fan.push_back(p);
      }
    return fan.size() == n;
  }

  /// is_named(e): whether the caller wants e to be part of a line.
  template<class F>
  feature_lines(const M& m, double angle_deg, const F& is_named)
      : edges_(edge_index_bound(m)), verts_(vert_index_bound(m), vert_freedom::none) {
    const double least_cosine = angle_deg >= 180 ? -2 : std::cos(angle_deg * std::numbers::pi / 180);
    for (const edge_t<M> e : edges(m)) edges_[index_of(m, e)] = is_sharp(m, e, least_cosine) || is_named(e);
    for (const vert_t<M> v : verts(m)) verts_[index_of(m, v)] = find_freedom(m, v, std::max(least_cosine, 0.0));
  }

  bool has(const M& m, const edge_t<M>& e) const {
    const std::size_t i = index_of(m, e);
    return i < edges_.size() && edges_[i];
  }
  vert_freedom freedom(const M& m, const vert_t<M>& v) const { return verts_[index_of(m, v)]; }

  /// After a split of the edge between a and b, which was part of a line or not: x is the new vert.
  void split(const M& m, bool was_on_line, const vert_t<M>& x, const vert_t<M>& a, const vert_t<M>& b) {
    at(verts_, index_of(m, x)) = was_on_line ? vert_freedom::line : vert_freedom::surface;
    for (const edge_t<M> e : adj_v2e(m, x)) {
      const auto ends = end_verts(m, e);
      const vert_t<M> other = ends.first == x ? ends.second : ends.first;
      at(edges_, index_of(m, e)) = was_on_line && (other == a || other == b);
    }
  }
  void set(const M& m, const edge_t<M>& e, bool is_on_line) { at(edges_, index_of(m, e)) = is_on_line; }
  void set(const M& m, const vert_t<M>& v, vert_freedom x) { at(verts_, index_of(m, v)) = x; }
};

}  // namespace concino::detail
