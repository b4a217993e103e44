// One polygon of a surface after another, as triangles with their neighbours inside the polygon.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/lines/detail/cells/field_reader.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// A triangle of a polygon. Side k joins corner k and the next one.
template<class M>
struct polygon_piece {
  static constexpr std::size_t diagonal = SIZE_MAX;

  poly_t<M> poly = poly_t<M>();
  unsigned number = 0;                 // among the triangles of the polygon
  bool is_zero = false;                // no area, or no field in its plane
  std::array<std::size_t, 3> corner{}; // of the polygon
  std::array<std::size_t, 3> edge{};   // of each side: the number among the polygon's edges, or `diagonal`
  std::array<vert_t<M>, 3> verts = {vert_t<M>(), vert_t<M>(), vert_t<M>()};
  std::array<vec3, 3> at;
  vec3 normal, field;
};

/// A value for each corner of a polygon: on the stack where all polygons have the same size.
template<class M, class T>
class corner_values {
  static constexpr std::size_t fixed = static_cast<std::size_t>(arity_v<M>);
  std::conditional_t<(fixed > 0), std::array<T, fixed>, std::vector<T>> values_;

 public:
  template<class Range, class F>
  void assign(const Range& from, const F& f) {
    if constexpr (fixed > 0) {  // no growth
      std::size_t k = 0;
      for (const auto& x : from) values_[k++] = f(x);
    } else {
      values_.clear();
      for (const auto& x : from) values_.push_back(f(x));
    }
  }
  std::size_t size() const { return values_.size(); }
  const T* begin() const { return values_.data(); }
  const T* end() const { return values_.data() + size(); }
  const T& operator[](std::size_t k) const { return values_[k]; }
};

template<class M>
class polygon_reader {
  polygon_triangulator cut_;
  std::vector<polygon_triangle> triangles_;
  poly_t<M> poly_ = poly_t<M>();
  bool is_read_ = false;
  vec3 normal_;

 public:
  corner_values<M, vert_t<M>> verts;
  corner_values<M, edge_t<M>> edges;  // the k-th joins the k-th vert and the next one
  corner_values<M, vec3> points;
  vec3 field;                    // set by the caller
  bool is_flat = true;           // all corners are in one plane but for 1e-9 of the size: then all triangles have its
                                 // normal

  /// False if p is the polygon read last.
  bool read(const M& m, const poly_t<M>& p) {
    if (is_read_ && p == poly_) return false;
    is_read_ = true;
    poly_ = p;
    verts.assign(adj_p2v(m, p), [](const vert_t<M>& v) { return v; });
    edges.assign(adj_p2e(m, p), [](const edge_t<M>& e) { return e; });
    points.assign(verts, [&](const vert_t<M>& v) { return to_vec3(point(m, v)); });
    double zero = 0;  // or not a number, if a coordinate is infinite or not a number
    for (const vec3& x : points) zero += 0 * x.x + 0 * x.y + 0 * x.z;
    if (!(zero == 0)) throw_points_not_finite(index_of(m, p));
    if (points.size() == 3) {
      triangles_.assign(1, {0, 1, 2});
      normal_ = triangle_normal(points[0], points[1], points[2]);
    } else {
      read_polygon();
    }
    return true;
  }

  /// The field has changed.
  void invalidate() { is_read_ = false; }

  const vert_t<M>& vert(unsigned triangle, unsigned k) const { return verts[triangles_[triangle][k]]; }
  unsigned num_pieces() const { return static_cast<unsigned>(triangles_.size()); }

  polygon_piece<M> piece(unsigned t) const {
    polygon_piece<M> r;
    read_piece(t, r);
    return r;
  }
  void read_piece(unsigned t, polygon_piece<M>& r) const {
    const polygon_triangle& c = triangles_[t];
    r.poly = poly_;
    r.number = t;
    for (std::size_t k = 0; k < 3; ++k) {
      r.corner[k] = c[k];
      r.verts[k] = verts[c[k]];
      r.at[k] = points[c[k]];
      r.edge[k] = next_corner(c[k]) == c[(k + 1) % 3] ? c[k] : polygon_piece<M>::diagonal;
    }
    r.normal = is_flat ? normal_ : triangle_normal(r.at[0], r.at[1], r.at[2]);
    r.field = field;
    r.is_zero = cross(field, r.normal) == vec3();
  }

  /// The triangle on the other side of diagonal k of a triangle, and its side there.
  std::pair<unsigned, unsigned> beside(const polygon_piece<M>& in, unsigned k) const {
    return find(in.corner[(k + 1) % 3], in.corner[k]);
  }

  /// The triangle at an edge of the polygon, and its side there.
  std::pair<unsigned, unsigned> with_edge(const edge_t<M>& edge) const {
    for (std::size_t k = 0; k < edges.size(); ++k)
      if (edges[k] == edge)
        return edges.size() == 3 ? std::pair(0u, static_cast<unsigned>(k)) : find(k, next_corner(k));
    return {};
  }

  /// The triangle that contains x, seen along the normal; of several, and outside all, the nearest.
  unsigned nearest_piece(const vec3& x) const {
    unsigned best = 0;
    double best_depth = -std::numeric_limits<double>::infinity();
    for (unsigned t = 0; t < num_pieces(); ++t) {
      const polygon_piece<M> r = piece(t);
      const double depth = depth_in_triangle(x, r.at, r.normal);
      if (depth > best_depth) {
        best_depth = depth;
        best = t;
      }
    }
    return best;
  }

  const corner_values<M, vec3>& corner_points() const { return points; }

 private:
  std::size_t next_corner(std::size_t k) const { return k + 1 == verts.size() ? 0 : k + 1; }

  void read_polygon() {
    const auto found = cut_(points);
    triangles_.assign(found.begin(), found.end());
    std::size_t first = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      if (lies_before(points[i], points[first])) first = i;
    const std::size_t n = points.size();
    normal_ = {};
    double size = 0;
    for (std::size_t i = 1; i < n; ++i) {
      const vec3 a = points[(first + i) % n] - points[first];
      if (i + 1 < n) normal_ += cross(a, points[(first + i + 1) % n] - points[first]);
      size = std::max(size, norm(a));
    }
    const double length = norm(normal_);
    is_flat = true;
    for (const vec3& x : points) is_flat = is_flat && std::abs(dot(x - points[first], normal_)) <= 1e-9 * size * length;
  }

  /// The triangle whose side goes from corner a to corner b.
  std::pair<unsigned, unsigned> find(std::size_t a, std::size_t b) const {
    for (unsigned t = 0; t < num_pieces(); ++t)
      for (unsigned k = 0; k < 3; ++k)
        if (triangles_[t][k] == a && triangles_[t][(k + 1) % 3] == b) return {t, k};
    return {};
  }
};

}  // namespace concino::detail
