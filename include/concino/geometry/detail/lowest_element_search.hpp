// Finds the vert, edge, face or poly of the lowest dimension that contains a place of a mesh.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/mesh/mesh_point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace concino::detail {

/// Finds the lowest element that contains a place, in coordinates times a power of two.
template<EmbeddedMesh M>
class lowest_element_search {
  using element = decltype(mesh_point<M>::element);

  const M& m_;
  const char* caller_;
  int exponent_ = 0;
  double rounding_ = 0, diameter_ = 0, thickness_ = 0;  // thickness_: the greatest extent of a polygon along its normal
  polygon_triangulator cut_;
  std::vector<vec3> corners_;

  static vec3 scaled(const vec3& x, int exponent) {
    return {std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)};
  }
  vec3 at(const vert_t<M>& v) const { return scaled(to_vec3(point(m_, v)), -exponent_); }

  template<class Verts>
  void set_scale(const Verts& verts, const vec3& x, const char* kind, std::size_t number) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    vec3 low(infinity, infinity, infinity), high = -low;
    for (const vert_t<M> v : verts) {
      const vec3 p = to_vec3(point(m_, v));
      if (!is_finite(p))
        core::throw_joined<invalid_mesh>({caller_, ": ", kind, ' ', number, " has points that are not finite"});
      for (const std::size_t k : {0u, 1u, 2u}) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    double largest = 0;
    for (const std::size_t k : {0u, 1u, 2u})
      largest = std::max({largest, std::abs(low[k]), std::abs(high[k]), std::abs(x[k])});
    exponent_ = largest > 0 ? std::ilogb(largest) + 1 : 0;
    diameter_ = norm(scaled(high, -exponent_) - scaled(low, -exponent_));
    rounding_ = 1e-12 * diameter_ + 8 * std::numeric_limits<double>::epsilon();
    thickness_ = 0;
  }

  /// The nearest vert or edge, if it contains x.
  template<class Verts, class Edges>
  std::optional<element> lowest_of(const Verts& verts, const Edges& edges, const vec3& x) const {
    std::optional<element> found;
    double least = rounding_;
    for (const vert_t<M> v : verts)
      if (const double d = distance(at(v), x); d <= least && (d < least || !found)) {
        least = d;
        found = v;
      }
    if (found) return found;
    for (const edge_t<M> e : edges) {
      const auto [a, b] = end_verts(m_, e);
      const vec3 from = at(a), along = at(b) - from;
      const double t = std::clamp(dot(x - from, along) / dot(along, along), 0.0, 1.0);
      if (const double d = distance(from + t * along, x); d <= least && (d < least || !found)) {
        least = d;
        found = edge_point<M>{e, t};
      }
    }
    return found;
  }

  /// Calls f(a, b, c) for the triangles of a polygon, in its direction.
  template<class F>
  void for_each_triangle(const F& f) {
    vec3 area;
    for (std::size_t i = 2; i < corners_.size(); ++i)
      area += cross(corners_[i - 1] - corners_[0], corners_[i] - corners_[0]);
    double low = 0, high = 0;
    for (const vec3& c : corners_) {
      const double height = dot(c - corners_[0], area);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    if (norm(area) > 0) thickness_ = std::max(thickness_, (high - low) / norm(area));
    for (const polygon_triangle& t : cut_(corners_)) f(corners_[t[0]], corners_[t[1]], corners_[t[2]]);
  }

  struct nearest {
    vec3 point;
    double distance = std::numeric_limits<double>::infinity();
    void take_nearer(const vec3& y, const vec3& x) {
      const double d = concino::distance(x, y);
      if (d < distance) *this = {y, d};
    }
  };

  template<class Verts>
  void read_corners(const Verts& verts) {
    corners_.clear();
    for (const vert_t<M> v : verts) corners_.push_back(at(v));
  }

  nearest nearest_in_polygon(const vec3& x) {
    nearest r;
    for_each_triangle(
        [&](const vec3& a, const vec3& b, const vec3& c) { r.take_nearer(closest_point(x, a, b, c), x); });
    if (corners_.size() < 3)
      for (const vec3& c : corners_) r.take_nearer(c, x);
    return r;
  }

  static double solid_angle(const vec3& a, const vec3& b, const vec3& c) {
    const double p = norm(a), q = norm(b), r = norm(c);
    return 2 * std::atan2(dot(cross(a, b), c), p * q * r + dot(a, b) * r + dot(b, c) * p + dot(c, a) * q);
  }

  /// The place in a poly that has no lower element: x, where it lies inside, or the nearest point of its border.
  std::pair<element, nearest> in_poly(const poly_t<M>& p, const vec3& x) {
    if constexpr (dimension_v<M> == 2) {  // a polygon has no inside in space
      read_corners(adj_p2v(m_, p));
      return {p, nearest_in_polygon(x)};
    } else {
      std::pair<element, nearest> r{p, {}};
      double around = 0;  // the solid angle of the border
      for (const face_t<M> f : adj_p2f(m_, p)) {
        const bool is_outward = face_is_outward(m_, p, f);
        read_corners(adj_f2v(m_, f));
        const double before = r.second.distance;
        for_each_triangle([&](const vec3& a, const vec3& b, const vec3& c) {
          r.second.take_nearer(closest_point(x, a, b, c), x);
          around += (is_outward ? 1 : -1) * solid_angle(a - x, b - x, c - x);
        });
        if (r.second.distance < before) r.first = f;
      }
      if (r.second.distance > rounding_ && std::abs(around) > 2 * std::numbers::pi) r = {p, {x, 0}};
      return r;
    }
  }

  /// A place and its distance from the position, as a part of the diameter; what is due to a polygon that is not planar
  /// does not count.
  struct result {
    mesh_point<M> place;
    double away = 0;
  };

  template<class Verts, class Edges, class Last>
  result find(const Verts& verts, const Edges& edges, const vec3& position, const Last& last) {
    const vec3 x = scaled(position, -exponent_);
    if (const auto e = lowest_of(verts, edges, x)) return {{*e, position_on(*e, position)}};
    const auto [element_of_last, y] = last(x);
    if (y.distance <= rounding_) return {{element_of_last, position}};
    const double away =
        diameter_ > 0 ? std::max(0.0, y.distance - thickness_) / diameter_ : std::numeric_limits<double>::infinity();
    if (const auto e = lowest_of(verts, edges, y.point)) return {{*e, position_on(*e, position)}, away};
    return {{element_of_last, scaled(y.point, exponent_)}, away};
  }

  vec3 position_on(const element& x, const vec3& otherwise) const {
    if (const auto* v = std::get_if<vert_t<M>>(&x)) return to_vec3(point(m_, *v));
    const auto* e = std::get_if<edge_point<M>>(&x);
    if (!e) return otherwise;
    const auto [a, b] = end_verts(m_, e->edge);
    return scaled(at(a) + e->parameter * (at(b) - at(a)), exponent_);
  }

 public:
  lowest_element_search(const M& m, const char* caller) : m_(m), caller_(caller) {}

  result operator()(const poly_t<M>& p, const vec3& position) {
    const auto& all = adj_p2v(m_, p);
    set_scale(all, position, "poly", index_of(m_, p));
    return find(all, adj_p2e(m_, p), position, [&](const vec3& x) { return in_poly(p, x); });
  }
  template<VolumeMesh V = M>
  result operator()(const face_t<V>& f, const vec3& position) {
    const auto& all = adj_f2v(m_, f);
    set_scale(all, position, "face", index_of(m_, f));
    return find(all, adj_f2e(m_, f), position, [&](const vec3& x) {
      read_corners(all);
      return std::pair<element, nearest>(f, nearest_in_polygon(x));
    });
  }
  result operator()(const vert_t<M>& v, const vec3&) { return {{v, to_vec3(point(m_, v))}}; }
  result operator()(const edge_point<M>& e, const vec3& position) {
    const auto& ends = adj_e2v(m_, e.edge);
    set_scale(ends, {}, "edge", index_of(m_, e.edge));
    const vec3 x = scaled(position_on(e, position), -exponent_);
    for (const vert_t<M> v : ends)
      if (distance(at(v), x) <= rounding_) return {{v, to_vec3(point(m_, v))}};
    return {{e, position_on(e, position)}};
  }
};

}  // namespace concino::detail
