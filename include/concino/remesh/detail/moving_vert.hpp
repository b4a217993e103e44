// The tets at a vert, and where the vert has to be so that the least of their dihedral angles is as large as possible.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/remesh/detail/tet_quality.hpp>

#include <array>
#include <limits>

namespace concino::detail {

class moving_vert {
  static constexpr unsigned max_active = 24;

  core::small_array<std::array<vec3, 3>, 64> faces_;  // opposite to the vert; (vert, face) is a positive tet

  /// The gradient of the value between two faces of a tet (x, face) by x.
  static vec3 gradient(const tet_faces& t, const std::array<vec3, 3>& face, unsigned i, unsigned j) {
    const vec3 along[4] = {{}, face[2] - face[1], face[0] - face[2], face[1] - face[0]};
    const double value = t.between(i, j);
    vec3 sum;
    for (const auto& [k, l] : {std::array{i, j}, std::array{j, i}})
      if (k > 0 && t.length[k] > 0) sum += cross(along[k], (t.normal[l] - value * t.normal[k]) / t.length[k]);
    return t.is_positive ? sum : -1.0 * sum;
  }

  /// The shortest vector in the convex hull: the direction of steepest ascent of the minimum of functions with these
  /// gradients.
  static vec3 shortest_in_hull(const vec3* g, unsigned n) {
    vec3 x = g[0];
    for (unsigned step = 0; step < 40; ++step) {
      unsigned best = 0;
      for (unsigned i = 1; i < n; ++i)
        if (dot(x, g[i]) < dot(x, g[best])) best = i;
      const vec3 d = x - g[best];
      const double decrease = dot(x, d), squared = dot(d, d);
      if (!(decrease > 1e-3 * dot(x, x)) || squared == 0) break;
      x = x - std::min(1.0, decrease / squared) * d;
    }
    return x;
  }

  vec3 direction(const vec3& x, double least) const {
    const double limit = least < -1 ? least + 0.05 : 1.25 * (least + 1) - 1 + 1e-9;
    vec3 active[max_active];
    unsigned n = 0;
    for (const auto& f : faces_) {
      const tet_faces t(x, f[0], f[1], f[2]);
      for (const auto& [i, j] : tet_faces::pairs)
        if (n < max_active && t.signed_quality(t.between(i, j)) <= limit) active[n++] = gradient(t, f, i, j);
    }
    return n == 0 ? vec3{} : shortest_in_hull(active, n);
  }

 public:
  void clear() { faces_.clear(); }
  void add(const vec3& a, const vec3& b, const vec3& c) { faces_.push_back({a, b, c}); }
  std::size_t size() const { return faces_.size(); }

  /// The least quality of the tets if the vert lies at x. If it is at most `threshold`, the result is some value up to
  /// `threshold`.
  double quality_at(const vec3& x, double threshold = -std::numeric_limits<double>::infinity()) const {
    double least = 1;
    for (const auto& f : faces_) {
      least = std::min(least, tet_quality(x, f[0], f[1], f[2]));
      if (least <= threshold) break;
    }
    return least;
  }

  vec3 centre() const {
    vec3 sum;
    for (const auto& f : faces_) sum += f[0] + f[1] + f[2];
    return sum / (3.0 * static_cast<double>(faces_.size()));
  }

  /// Moves x to where the least quality is larger, and returns this quality. Steps of the active set method, each with
  /// a line search.
  double maximise(vec3& x) const {
    double best = quality_at(x);
    const vec3 middle = centre();
    if (const double q = quality_at(middle, best); q > best) x = middle, best = q;
    double radius = 0;
    for (const auto& f : faces_) radius += norm(f[0] - x) + norm(f[1] - x) + norm(f[2] - x);
    radius /= 3.0 * static_cast<double>(faces_.size());
    double step = 0.2 * radius;
    for (unsigned k = 0; k < 12; ++k) {
      const vec3 g = direction(x, best);
      const double length = norm(g);
      if (!(length * radius > 1e-4)) break;
      const double before = best;
      for (; step > 1e-3 * radius; step *= 0.5) {
        const vec3 y = x + (step / length) * g;
        if (const double q = quality_at(y, best); q > best) {
          x = y, best = q;
          break;
        }
      }
      if (!(best > before)) break;
      step = std::min(2 * step, 0.5 * radius);
    }
    return best;
  }
};

}  // namespace concino::detail
