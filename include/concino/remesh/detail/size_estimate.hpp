// The lengths that edges need at verts: from the curvature of the surface and of its feature lines, and limits on how
// fast lengths grow.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/parallel.hpp>
#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/normals.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

namespace concino::detail {

/// An order for queues that give the least entry first.
struct smaller_size {
  bool operator()(const std::pair<double, std::size_t>& a, const std::pair<double, std::size_t>& b) const {
    return a > b;
  }
};

/// The symmetric 2 x 2 matrix that maps tangents to changes of the normal, by least squares over the edges of a
/// polygon.
/// Source: Rusinkiewicz 2004, "Estimating curvatures and their derivatives on triangle meshes".
class normal_change {
  double uu_ = 0, uv_ = 0, vv_ = 0, right_a_ = 0, right_b_ = 0, right_c_ = 0;

 public:
  void add(double u, double v, double change_u, double change_v) {
    uu_ += u * u, uv_ += u * v, vv_ += v * v;
    right_a_ += u * change_u, right_b_ += v * change_u + u * change_v, right_c_ += v * change_v;
  }

  /// The greatest normal curvature, without its sign. The normal equations for the entries a, b, c of [a b; b c] have
  /// the rows (uu, uv, 0), (uv, uu + vv, uv) and (0, uv, vv).
  double greatest_curvature() const {
    const double sum = uu_ + vv_, area = uu_ * vv_ - uv_ * uv_;
    if (!(area > 0)) return 0;
    const double off =
        (right_b_ - uv_ / uu_ * right_a_ - uv_ / vv_ * right_c_) / (sum - uv_ * uv_ / uu_ - uv_ * uv_ / vv_);
    const double a = (right_a_ - uv_ * off) / uu_, c = (right_c_ - uv_ * off) / vv_;
    return std::abs(a + c) / 2 + std::hypot((a - c) / 2, off);
  }
};

/// A surface whose points are moved to the middle of their box and scaled by a power of two to about 1, so that squares
/// neither overflow nor vanish.
template<class M>
class size_estimate {
  const M& m_;
  std::vector<vec3> points_;
  poly_map<M, vec3> normals_;
  double cosine_;  // of the angle above which an edge is a feature
  int exponent_ = 0;
  double diagonal_ = 0;

  const vec3& at(const vert_t<M>& v) const { return points_[index_of(m_, v)]; }

  void scale_points() {
    for (const vert_t<M> v : verts(m_))
      if (!is_finite(to_vec3(point(m_, v))))
        core::throw_joined<invalid_mesh>(
            {"adaptive_size: the point of vert ", index_of(m_, v), " is not finite; validate(m) lists all of them"});
    if (num_verts(m_) == 0) return;
    const box b = bounding_box(m_);
    const vec3 centre = 0.5 * b.min + 0.5 * b.max, half = b.max - centre;
    std::frexp(std::max({half.x, half.y, half.z}), &exponent_);
    const auto scaled = [&](double x) { return std::ldexp(x, -exponent_); };
    for (const vert_t<M> v : verts(m_)) {
      const vec3 x = to_vec3(point(m_, v)) - centre;
      points_[index_of(m_, v)] = {scaled(x.x), scaled(x.y), scaled(x.z)};
    }
    diagonal_ = 2 * norm(vec3{scaled(half.x), scaled(half.y), scaled(half.z)});
  }

  /// The normal at vert v of the smooth part of the surface to which a poly with this normal belongs: over the polys at
  /// v that turn from it by no more than the angle, so that neither sharp edges nor the winding of other parts matter.
  /// With weights that are exact for verts on a sphere; with areas, the curvature of a sphere would be wrong by a
  /// tenth, however fine its triangles.
  /// Source: Max 1999, "Weights for computing vertex normals from facet normals".
  vec3 smooth_normal(const vert_t<M>& v, const vec3& normal) const {
    vec3 sum;
    for (const poly_t<M> p : adj_v2p(m_, v))
      if (dot(normals_[p], normal) >= cosine_) sum += weighted_normal(p, v);
    const double length = norm(sum);
    return length > 0 && std::isfinite(length) ? sum / length : normal;
  }

  vec3 weighted_normal(const poly_t<M>& p, const vert_t<M>& v) const {
    vec3 first, last, before, after;
    bool is_first = true, is_at_first = false, is_next = false;
    for (const vert_t<M> w : adj_p2v(m_, p)) {
      const vec3 x = at(w);
      if (is_next) after = x;
      is_next = w == v;
      if (is_next) before = last, is_at_first = is_first;
      if (is_first) first = x;
      is_first = false;
      last = x;
    }
    if (is_next) after = first;
    if (is_at_first) before = last;
    const vec3 forward = after - at(v), back = before - at(v);
    const double squares = dot(forward, forward) * dot(back, back);
    return squares > 0 ? cross(forward, back) / squares : vec3{};
  }

 public:
  size_estimate(const M& m, double feature_angle_deg)
      : m_(m), points_(vert_index_bound(m)), normals_(poly_normals(m)),
        cosine_(std::cos(std::min(feature_angle_deg, 180.0) / 180 * std::numbers::pi)) {
    scale_points();
  }

  double diagonal() const { return diagonal_; }
  double scaled(double length) const { return std::ldexp(length, -exponent_); }
  double unscaled(double length) const { return std::ldexp(length, exponent_); }

  double poly_curvature(const poly_t<M>& p) const {
    const vec3 n = normals_[p];
    if (n == vec3{}) return 0;
    const vec3 least = std::abs(n.x) <= std::abs(n.y) && std::abs(n.x) <= std::abs(n.z) ? vec3{1, 0, 0}
                       : std::abs(n.y) <= std::abs(n.z)                                 ? vec3{0, 1, 0}
                                                                                        : vec3{0, 0, 1};
    const vec3 across = cross(n, least), u = across / norm(across), v = cross(n, u);
    normal_change change;
    const auto add = [&](const vec3& edge, const vec3& turn) {
      change.add(dot(edge, u), dot(edge, v), dot(turn, u), dot(turn, v));
    };
    vec3 first, first_normal, before, before_normal;
    bool is_first = true;
    for (const vert_t<M> w : adj_p2v(m_, p)) {
      const vec3 x = at(w), normal = smooth_normal(w, n);
      if (is_first) first = x, first_normal = normal;
      else add(x - before, normal - before_normal);
      is_first = false;
      before = x, before_normal = normal;
    }
    add(first - before, first_normal - before_normal);
    return change.greatest_curvature();
  }

  /// Whether the surface ends, branches or turns by more than the angle at e.
  bool is_feature(const edge_t<M>& e) const {
    vec3 normal;
    std::size_t n = 0;
    bool is_sharp = false;
    for (const poly_t<M> p : adj_e2p(m_, e)) {
      if (n++ > 0) is_sharp = is_sharp || !(dot(normals_[p], normal) >= cosine_);
      normal = normals_[p];
    }
    return n != 2 || is_sharp;
  }

  /// The curvature of the feature line through v: that of the circle through v and the two next verts. 0 if there is no
  /// such line, or it has a bend as sharp as a feature, which stays a corner.
  double line_curvature(const vert_t<M>& v) const {
    vec3 to[2];
    std::size_t n = 0;
    for (const edge_t<M> e : adj_v2e(m_, v)) {
      if (!is_feature(e)) continue;
      if (n == 2) return 0;
      const auto [a, b] = end_verts(m_, e);
      to[n++] = at(a == v ? b : a) - at(v);
    }
    if (n != 2) return 0;
    const double product = norm(to[0]) * norm(to[1]), chord = distance(to[0], to[1]);
    if (!(product > 0 && chord > 0) || -dot(to[0], to[1]) < cosine_ * product) return 0;
    return 2 * norm(cross(to[0], to[1])) / (product * chord);
  }

  /// Lowers sizes so that they grow by no more than the gradation times the length of the edges between verts.
  template<class Sizes>
  void limit_growth(Sizes& sizes, double gradation) const {
    using entry = std::pair<double, std::size_t>;
    std::vector<vert_t<M>> vert;
    std::vector<entry> start;
    for (const vert_t<M> v : verts(m_)) {
      start.emplace_back(sizes[v], vert.size());
      vert.push_back(v);
    }
    std::vector<std::size_t> number(vert_index_bound(m_));
    for (std::size_t i = 0; i < vert.size(); ++i) number[index_of(m_, vert[i])] = i;
    std::priority_queue queue(smaller_size(), std::move(start));
    while (!queue.empty()) {
      const auto [size, i] = queue.top();
      queue.pop();
      const vert_t<M> v = vert[i];
      if (size > sizes[v]) continue;  // it was lowered since
      for (const vert_t<M> w : adj_v2v(m_, v)) {
        const double most = size + gradation * distance(at(v), at(w));
        if (!(most < sizes[w])) continue;
        sizes[w] = most;
        queue.emplace(most, number[index_of(m_, w)]);
      }
    }
  }
};

}  // namespace concino::detail
