// Smooths points: one vert after the other moves to where the shape energy of the corners at it is smaller.
#pragma once

#include <concino/convert/convert.hpp>
#include <concino/core/progress.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/remesh/detail/corner_energy.hpp>
#include <concino/remesh/detail/feature_lines.hpp>
#include <concino/remesh/detail/unit_points.hpp>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace concino::detail {

/// Moves one vert after the other.
template<class M>
class point_smoother {
  static constexpr unsigned dimension = dimension_v<M>;

  const corner_frames<M> corners_;
  std::vector<vec3> points_;
  std::vector<unsigned> free_, changed_;  // verts that may move; by vert, the last round in which a corner at it
                                          // changed
  polygonmesh input_;                             // of surfaces
  std::optional<poly_tree<polygonmesh>> surface_;  // of the input
  double largest_ = 0;  // no corner may have a worse shape than 1 / largest_

  vec3 normal_at(unsigned v) const {
    vec3 sum;
    if constexpr (dimension == 2)  // volumes need none
      for (const unsigned* k = corners_.begin(v); k != corners_.end(v); ++k) {
        const unsigned* const x = corners_.frames[*k].verts;
        sum += cross(points_[x[1]] - points_[x[0]], points_[x[2]] - points_[x[0]]);
      }
    const double length = norm(sum);
    return length > 0 ? sum / length : vec3{};
  }

  /// The matrix of a corner, as seen from vert number v.
  corner_matrix<dimension> matrix_of(const corner_frame& f, unsigned v) const {
    return {f, corners_.ideals[f.ideal], points_, dimension == 2 ? normal_at(v) : vec3{}, v, points_[v]};
  }

  corner_energy energy(unsigned v, const vec3& normal, const vec3& x, double delta,
                       bool has_derivatives = false) const {
    return energy_at<dimension>(corners_, points_, normal, v, x, delta, has_derivatives);
  }

  /// A positive number, of the size of the determinants, if a corner at v is inverted.
  double barrier_width(unsigned v, const vec3& normal) const {
    double least = std::numeric_limits<double>::infinity(), sum = 0;
    for (const unsigned* k = corners_.begin(v); k != corners_.end(v); ++k) {
      const corner_frame& f = corners_.frames[*k];
      const double det =
          corner_matrix<dimension>(f, corners_.ideals[f.ideal], points_, normal, v, points_[v]).determinant();
      least = std::min(least, det), sum += std::abs(det);
    }
    if (least > 0) return 0;
    const double small = 0.02 * sum / static_cast<double>(corners_.end(v) - corners_.begin(v));
    return std::sqrt(small * (small - least));
  }

  bool move(unsigned v, double& moved) {
    const vec3 normal = normal_at(v), x = points_[v];
    if (dimension == 2 && dot(normal, normal) == 0) return false;
    const double delta = barrier_width(v, normal);
    const corner_energy now = energy(v, normal, x, delta, true);
    if (!(now.value < std::numeric_limits<double>::infinity())) return false;
    vec3 g = now.gradient, step;
    symmetric_matrix h = now.hessian;
    if constexpr (dimension == 2) {  // the vert moves within its tangent plane
      g = g - dot(g, normal) * normal;
      const vec3 hn = h * normal;
      const double nhn = dot(normal, hn);
      // P h P + n n', with P = 1 - n n'
      h.add_product(0.5, normal - hn), h.add_product(-0.5, normal + hn);
      h.add_product(nhn + 1, normal);
    }
    step = h.solve(-1.0 * g);
    if (!(dot(step, g) < 0)) step = -1.0 * g;
    double longest = 0;
    for (const unsigned* k = corners_.begin(v); k != corners_.end(v); ++k)
      longest = std::max(longest, norm(points_[corners_.frames[*k].verts[corners_.frames[*k].verts[0] == v]] - x));
    if (const double length = norm(step); length > 0.5 * longest) step = (0.5 * longest / length) * step;
    if (!(norm(step) > 1e-4 * longest)) return false;
    for (unsigned halvings = 0; halvings < 8; ++halvings, step = 0.5 * step) {
      vec3 y = x + step;
      if (surface_) y = surface_->closest(y).point;
      const corner_energy then = energy(v, normal, y, delta);
      if (!(then.value < now.value) || then.num_inverted > now.num_inverted || then.largest > largest_) continue;
      points_[v] = y;
      moved += (now.value - then.value) / now.value;
      return true;
    }
    return false;
  }

  /// The least shape of corners that are not inverted, and the number of the others.
  void measure(double& least, std::size_t& num_inverted) const {
    least = 1, num_inverted = 0;
    for (const corner_frame& f : corners_.frames) {
      const auto c = matrix_of(f, f.verts[0]);
      if (!(c.determinant() > 0)) ++num_inverted;
      else least = std::min(least, c.shape());
    }
  }

 public:
  point_smoother(const point_smoother&) = delete;  // the tree refers to the input
  point_smoother& operator=(const point_smoother&) = delete;
  template<class F>
  point_smoother(const M& m, const unit_points& unit, double feature_angle_deg, const F& is_fixed) : corners_(m) {
    points_.reserve(num_verts(m));
    for (const vert_t<M> v : verts(m)) points_.push_back(unit.at(m, v));
    changed_.assign(points_.size(), 1);
    std::vector<bool> stays(points_.size());
    for (const corner_frame& f : corners_.frames)
      if (f.is_of_general_poly && !(matrix_of(f, f.verts[0]).determinant() > 0))
        for (unsigned i = 0; i <= dimension; ++i) stays[f.verts[i]] = true;
    unsigned i = 0;
    const auto add_free = [&](const vert_t<M>& v, bool may_move) {
      if (may_move && !stays[i] && corners_.begin(i) != corners_.end(i) && !is_fixed(v)) free_.push_back(i);
      ++i;
    };
    if constexpr (dimension == 2) {  // volumes have no creases inside, and their points need no surface
      input_ = convert<polygonmesh>(m);
      for (const vert_id v : verts(input_)) set_point(input_, v, unit.at(input_, v));
      surface_.emplace(input_);
      const feature_lines<M> lines(m, feature_angle_deg, [&](const edge_t<M>& e) { return !runs_both_ways(m, e); });
      for (const vert_t<M> v : verts(m)) add_free(v, lines.freedom(m, v) == vert_freedom::surface);
    } else {
      for (const vert_t<M> v : verts(m)) add_free(v, !is_boundary(m, v));
    }
  }

  /// Whether the two polys at e run along it in opposite directions, as they do where the surface is consistently
  /// oriented.
  static bool runs_both_ways(const M& m, const edge_t<M>& e) {
    const auto [a, b] = end_verts(m, e);
    unsigned forward = 0, backward = 0;
    for (const poly_t<M> p : adj_e2p(m, e)) {
      vert_t<M> before{};
      for (const vert_t<M> v : adj_p2v(m, p)) before = v;
      for (const vert_t<M> v : adj_p2v(m, p)) {
        forward += before == a && v == b, backward += before == b && v == a;
        before = v;
      }
    }
    return forward <= 1 && backward <= 1;
  }

  /// result: a points_smoothing.
  template<class Result>
  void run(unsigned max_rounds, const concino::progress& progress, Result& result) {
    measure(result.min_shape_before, result.num_inverted_before);
    largest_ = (1 + 1e-12) / result.min_shape_before;
    while (result.num_rounds < max_rounds) {
      report_progress(progress, static_cast<double>(result.num_rounds) / max_rounds, "smoothing points");
      const unsigned round = ++result.num_rounds + 1;
      std::size_t moves = 0;
      double gain = 0;
      for (const unsigned v : free_) {
        if (changed_[v] + 1 < round || !move(v, gain)) continue;
        ++moves;
        for (const unsigned* k = corners_.begin(v); k != corners_.end(v); ++k)
          for (unsigned i = 0; i <= dimension; ++i) changed_[corners_.frames[*k].verts[i]] = round;
      }
      result.num_moves += moves;
      if (moves == 0 || gain < 1e-4 * static_cast<double>(free_.size())) break;
    }
    report_progress(progress, 1, "smoothing points");
    measure(result.min_shape_after, result.num_inverted_after);
  }

  /// Writes the points that have moved.
  void write(M& m, const unit_points& unit) const {
    unsigned i = 0, next = 0;
    for (const vert_t<M> v : verts(m)) {
      if (next < free_.size() && free_[next] == i) {
        ++next;
        if (!(points_[i] == unit.at(m, v))) set_point(m, v, unit.to_mesh(points_[i]));
      }
      ++i;
    }
  }
};

}  // namespace concino::detail
