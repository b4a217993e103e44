// Defines contraction.hpp.
#pragma once

#include <concino/skeleton/detail/contraction.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <utility>

namespace concino::detail {

CONCINO_INLINE contraction::contraction(const std::vector<vec3>& points,
                                        const std::vector<std::array<std::uint32_t, 3>>& triangles)
    : mesh_(points.size(), triangles), points_(points), balls_(medial_balls(points, triangles)) {
  is_frozen_.resize(points.size());
  measure();
  masses_ = areas_;
  first_area_ = area_;
  vec3 low = points[0], high = points[0];
  for (const vec3& x : points)
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  shortest_ = 0.004 * distance(low, high);
}

CONCINO_INLINE void contraction::measure() {
  areas_.assign(points_.size(), 0);
  area_ = 0;
  for (const auto& t : mesh_.triangles()) {
    const double part = norm(cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]])) / 2;
    for (const index v : t) areas_[v] += part / 3;
    area_ += part;
  }
}

/// An implicit step with positive cotangent weights: no point leaves the convex hull of the points and the centres.
CONCINO_INLINE void contraction::step() {
  std::vector<int> number(points_.size(), -1);
  std::vector<index> free;
  for (index v = 0; v < points_.size(); ++v) {
    if (!mesh_.is_alive(v) || is_frozen_[v]) continue;
    number[v] = static_cast<int>(free.size());
    free.push_back(v);
  }
  if (free.empty()) return;
  const auto n = static_cast<Eigen::Index>(free.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, 3);
  const auto add = [&](index v, double weight, const vec3& x) {
    entries.emplace_back(number[v], number[v], weight);
    for (std::size_t k = 0; k < 3; ++k) right(number[v], static_cast<Eigen::Index>(k)) += weight * x[k];
  };
  constexpr double largest_cotangent = 1e5;
  for (const auto& t : mesh_.triangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const index v = t[k], a = t[(k + 1) % 3], b = t[(k + 2) % 3];
      const vec3 to_a = points_[a] - points_[v], to_b = points_[b] - points_[v];
      const double sine = norm(cross(to_a, to_b)), cosine = dot(to_a, to_b);
      // Angles above 90 degrees would repel: their weights are nearly 0.
      const double of_angle = cosine > 0 ? cosine / std::max(sine, cosine / largest_cotangent) : 1e-6;
      const double weight = time_ * of_angle / 2;
      for (const auto& [i, j] : {std::pair(a, b), std::pair(b, a)}) {
        if (number[i] < 0) continue;
        if (number[j] < 0) {
          add(i, weight, points_[j]);
          continue;
        }
        entries.emplace_back(number[i], number[i], weight);
        entries.emplace_back(number[i], number[j], -weight);
      }
    }
  for (const index v : free) {
    const double mass = std::max(masses_[v], 1e-12 * first_area_);
    const double radius = balls_[v].radius > 0 ? std::max(balls_[v].radius, 1e-6) : 1;
    const double unit = mass / (radius * radius);
    add(v, unit * std::clamp(mass / std::max(areas_[v], 1e-300), 1.0, 1e8), points_[v]);
    if (balls_[v].radius > 0) add(v, unit, balls_[v].centre);
  }
  Eigen::SparseMatrix<double> system(n, n);
  system.setFromTriplets(entries.begin(), entries.end());
  solver_.factorize(system);
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::VectorXd x = solver_.solve(right.col(static_cast<Eigen::Index>(k)));
    for (const index v : free) points_[v][k] = x[number[v]];
  }
  time_ *= 2;
  collapse_short_edges();
  split_flat_triangles();
  freeze_thin_parts();
  measure();
}

CONCINO_INLINE void contraction::collapse_short_edges() {
  for (bool any = true; any;) {
    any = false;
    for (index v = 0; v < points_.size(); ++v) {
      if (!mesh_.is_alive(v) || is_frozen_[v]) continue;
      index to = v;
      double length = shortest_;
      for (const index w : mesh_.neighbours(v)) {
        const double d = distance(points_[v], points_[w]);
        if (d >= length || !mesh_.is_collapsible(v, w)) continue;
        to = w;
        length = d;
      }
      if (to == v) continue;
      mesh_.collapse(v, to);
      if (!is_frozen_[to]) points_[to] = (points_[v] + points_[to]) / 2;
      masses_[to] += masses_[v];
      const auto gap = [&](index x) { return norm(balls_[x].centre - points_[to]); };
      if (balls_[v].radius > 0 && (!(balls_[to].radius > 0) || gap(v) < gap(to))) balls_[to] = balls_[v];
      any = true;
    }
  }
}

CONCINO_INLINE void contraction::split_flat_triangles() {
  for (const auto& t : mesh_.triangles())
    for (std::size_t k = 0; k < 3; ++k) {
      const index c = t[k], a = std::min(t[(k + 1) % 3], t[(k + 2) % 3]), b = std::max(t[(k + 1) % 3], t[(k + 2) % 3]);
      const auto& opposite = mesh_.opposite(c);
      if (!std::binary_search(opposite.begin(), opposite.end(), std::array<index, 2>{a, b})) break;
      const vec3 to_a = points_[a] - points_[c], to_b = points_[b] - points_[c], edge = points_[b] - points_[a];
      constexpr double cosine_of_110_degrees = -0.34202014332566873;
      if (dot(to_a, to_b) > cosine_of_110_degrees * norm(to_a) * norm(to_b)) continue;
      const double length = norm(edge), fraction = -dot(to_a, edge) / (length * length);
      if (!(std::min(fraction, 1 - fraction) * length >= shortest_) || (is_frozen_[a] && is_frozen_[b])) continue;
      mesh_.split(a, b);
      points_.push_back(points_[a] + fraction * edge);
      medial_ball ball = fraction < 0.5 ? balls_[a] : balls_[b];
      if (balls_[a].radius > 0 && balls_[b].radius > 0)
        ball = {balls_[a].centre + fraction * (balls_[b].centre - balls_[a].centre),
                balls_[a].radius + fraction * (balls_[b].radius - balls_[a].radius)};
      balls_.push_back(ball);
      is_frozen_.push_back(0);
      masses_.push_back((masses_[a] + masses_[b]) / 3);
      masses_[a] *= 2.0 / 3;
      masses_[b] *= 2.0 / 3;
      break;
    }
}

CONCINO_INLINE void contraction::freeze_thin_parts() {
  std::vector<index> thin;
  for (index v = 0; v < points_.size(); ++v) {
    if (!mesh_.is_alive(v) || is_frozen_[v]) continue;
    // Before a vert has come to the centre of its ball, edges of triangles that are in no thin part may be short.
    const bool has_arrived =
        balls_[v].radius > 0 && distance(points_[v], balls_[v].centre) < shortest_ + 0.1 * balls_[v].radius;
    const double limit = has_arrived ? shortest_ : 0.1 * shortest_;
    std::size_t count = 0;
    for (const index w : mesh_.neighbours(v)) count += distance(points_[v], points_[w]) < limit;
    if (count >= 2) thin.push_back(v);
  }
  for (const index v : thin) is_frozen_[v] = 1;
}

CONCINO_INLINE triangle_complex contraction::curve() {
  triangle_complex curve = mesh_;
  curve.collapse_to_curve(points_, masses_);
  return curve;
}

}  // namespace concino::detail
