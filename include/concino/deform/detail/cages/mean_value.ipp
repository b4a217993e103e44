// Defines mean_value.hpp for cages in space.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/deform/detail/cages/mean_value.hpp>
#include <concino/geometry/closest_point.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace concino::detail {

/// Nearer to a vert, an edge or a triangle than this part of the size of the cage, a point is on it.
inline constexpr double on_cage = 1e-11;

CONCINO_INLINE void barycentric_weights(const flat_cage& cage, std::size_t triangle, const vec3& x,
                                        std::vector<double>& weights) {
  const auto& t = cage.triangles[triangle];
  const vec3 &a = cage.points[t[0]], &b = cage.points[t[1]], &c = cage.points[t[2]], n = cage.normals[triangle];
  const vec3 y = closest_point(x, a, b, c);
  double u = std::max(0.0, dot(cross(c - b, y - b), n)), v = std::max(0.0, dot(cross(a - c, y - c), n)),
         w = std::max(0.0, dot(cross(b - a, y - a), n));
  if (!(u + v + w > 0)) {  // without area: y is on an edge
    const vec3* corner[3] = {&a, &b, &c};
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (distance(*corner[k], *corner[(k + 1) % 3]) > distance(*corner[longest], *corner[(longest + 1) % 3]))
        longest = k;
    double part[3] = {0, 0, 0};
    const double whole = distance(*corner[longest], *corner[(longest + 1) % 3]);
    part[(longest + 1) % 3] = whole > 0 ? std::min(1.0, distance(*corner[longest], y) / whole) : 0;
    part[longest] = 1 - part[(longest + 1) % 3];
    u = part[0], v = part[1], w = part[2];
  }
  weights[t[0]] += u / (u + v + w);
  weights[t[1]] += v / (u + v + w);
  weights[t[2]] += w / (u + v + w);
}

CONCINO_INLINE double weights_on_cage(const flat_cage& cage, const vec3& x, std::vector<double>& weights) {
  std::size_t nearest = 0;
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cage.triangles.size(); ++i) {
    const auto& t = cage.triangles[i];
    const double d = distance(x, closest_point(x, cage.points[t[0]], cage.points[t[1]], cage.points[t[2]]));
    if (d < smallest) smallest = d, nearest = i;
  }
  std::fill(weights.begin(), weights.end(), 0.0);
  barycentric_weights(cage, nearest, x, weights);
  cage.give_to_corners(weights);
  return smallest;
}

/// The numbers w with w[0] u[0] + w[1] u[1] + w[2] u[2] = m for unit vectors u. If these lie in a plane, so does m but
/// for rounding errors, and of the solutions one is taken that does not amplify these.
CONCINO_INLINE void solve_in_three_directions(const vec3 (&u)[3], const vec3& m, double (&w)[3]) {
  // Of the vectors across u[0] the longer one comes first.
  const auto across = [&](const vec3& x) {
    const vec3 r = x - dot(u[0], x) * u[0];
    return r - dot(u[0], r) * u[0];
  };
  const vec3 r1 = across(u[1]), r2 = across(u[2]);
  const double s1 = norm(r1), s2 = norm(r2);
  const bool swapped = s2 > s1;
  const vec3 &second = swapped ? u[2] : u[1], &third = swapped ? u[1] : u[2];
  double a = 0, b = 0;
  if (std::max(s1, s2) > 1e-13) {
    const vec3 q2 = swapped ? r2 / s2 : r1 / s1, q3 = cross(u[0], q2);
    const double height = dot(q3, third), along = dot(q3, m);
    // The component of m across the plane is of the order of height^2 where the plane is seen from outside of the
    // triangle: below 1e-13 it is rounding.
    if (height != 0 && (std::abs(height) > 1e-8 || std::abs(along) > 1e-13)) b = along / height;
    a = (dot(q2, m) - b * dot(q2, third)) / dot(q2, second);
  }
  w[0] = dot(u[0], m) - a * dot(u[0], second) - b * dot(u[0], third);
  w[swapped ? 2 : 1] = a;
  w[swapped ? 1 : 2] = b;
}

/// Computes the coordinates of one point after the other.
class mean_value_point {
  const flat_cage& cage_;
  std::vector<vec3> direction_, turn_;  // of points; of edges: the normal of the plane through x, times half the angle
  std::vector<double> distance_;

 public:
  std::vector<double> weights;  // of all points of the cage

  explicit mean_value_point(const flat_cage& cage)
      : cage_(cage),
        direction_(cage.num_points()),
        turn_(cage.edges.size()),
        distance_(cage.num_points()),
        weights(cage.num_points()) {}

  /// The error of the linear functions, relative to the size of the cage and the distance to it.
  double compute(const vec3& x) {
    std::fill(weights.begin(), weights.end(), 0.0);
    for (std::size_t i = 0; i < cage_.num_points(); ++i) {
      const vec3 d = cage_.points[i] - x;
      distance_[i] = norm(d);
      direction_[i] = distance_[i] > 0 ? d / distance_[i] : vec3();
    }
    if (!is_on_edge(x) && !is_on_triangle(x)) add_triangles();
    cage_.give_to_corners(weights);
    return normalise(x);
  }

 private:
  bool is_on_edge(const vec3& x) {
    const double near = on_cage * cage_.size;
    for (std::size_t e = 0; e < cage_.edges.size(); ++e) {
      const auto [a, b] = cage_.edges[e];
      const vec3 n = cross(direction_[a], direction_[b]);
      const double sine = norm(n), cosine = dot(direction_[a], direction_[b]);
      const double length = distance(cage_.points[a], cage_.points[b]);
      if (distance_[a] <= near || distance_[b] <= near ||
          (cosine < 0 && distance_[a] * distance_[b] * sine <= near * length)) {
        const double t =
            length > 0
                ? std::clamp(dot(x - cage_.points[a], cage_.points[b] - cage_.points[a]) / (length * length), 0.0, 1.0)
                : 0;
        weights[a] += 1 - t;
        weights[b] += t;
        return true;
      }
      turn_[e] = sine > 0 ? (std::atan2(sine, cosine) / (2 * sine)) * n : vec3();
    }
    return false;
  }
  bool is_on_triangle(const vec3& x) {
    const double near = on_cage * cage_.size;
    for (std::size_t i = 0; i < cage_.triangles.size(); ++i) {
      const auto& t = cage_.triangles[i];
      if (std::abs(dot(cage_.points[t[0]] - x, cage_.normals[i])) > near) continue;
      const vec3 y = closest_point(x, cage_.points[t[0]], cage_.points[t[1]], cage_.points[t[2]]);
      if (distance(x, y) > near) continue;
      barycentric_weights(cage_, i, x, weights);
      return true;
    }
    return false;
  }
  void add_triangles() {
    for (std::size_t i = 0; i < cage_.triangles.size(); ++i) {
      const auto& t = cage_.triangles[i];
      const vec3 u[3] = {direction_[t[0]], direction_[t[1]], direction_[t[2]]};
      vec3 mean;  // the integral of unit vectors over the spherical triangle
      for (std::size_t k = 0; k < 3; ++k) {
        const auto e = cage_.triangle_edges[i][k];
        mean += cage_.edges[e][0] == t[(k + 1) % 3] ? turn_[e] : -turn_[e];
      }
      double w[3];
      solve_in_three_directions(u, mean, w);
      for (std::size_t k = 0; k < 3; ++k) weights[t[k]] += w[k] / distance_[t[k]];
    }
  }
  double normalise(const vec3& x) {
    double sum = 0, far = cage_.size;
    for (std::size_t i = 0; i < cage_.num_verts; ++i) sum += weights[i];
    if (!(std::abs(sum) > 0)) return std::numeric_limits<double>::infinity();
    vec3 error;
    for (std::size_t i = 0; i < cage_.num_verts; ++i) {
      weights[i] /= sum;
      if (weights[i] == 0) continue;
      error += weights[i] * (cage_.points[i] - x);
      far = std::max(far, distance_[i]);
    }
    return norm(error) / far;
  }
};

CONCINO_INLINE std::vector<double> mean_value_weights(const flat_cage& cage, const std::vector<vec3>& points,
                                                      const std::vector<std::size_t>& rows, const char* caller) {
  std::vector<double> all(points.size() * cage.num_verts);
  std::vector<double> errors(rows.size());
  constexpr std::size_t chunk = 32;
  parallel_for(
      (rows.size() + chunk - 1) / chunk,
      [&](std::size_t c) {
        mean_value_point at(cage);
        for (std::size_t i = c * chunk; i < std::min(rows.size(), (c + 1) * chunk); ++i) {
          errors[i] = at.compute(points[rows[i]] / cage.unit);
          std::copy_n(at.weights.begin(), cage.num_verts,
                      all.begin() + static_cast<std::ptrdiff_t>(rows[i] * cage.num_verts));
        }
      },
      1);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!(errors[i] <= 1e-9))
      core::throw_joined<invalid_argument>({caller, ": point ", rows[i],
                                            " is too far from the cage: its coordinates would not be accurate"});
  return all;
}

}  // namespace concino::detail
