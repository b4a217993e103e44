// Smooths points: one vert after the other moves to where the shape energy of the corners at it is smaller.
#pragma once

#include <concino/core/progress.hpp>
#include <concino/remesh/detail/smoothing/corner_energy.hpp>
#include <concino/remesh/detail/smoothing/corner_normals.hpp>
#include <concino/remesh/detail/smoothing/kept_features.hpp>
#include <concino/remesh/detail/smoothing/kept_surface.hpp>
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
  std::optional<kept_surface> kept_;      // of surfaces, and of volumes if verts slide
  const bool slides_;
  corner_normals<M> normals_;
  double largest_ = 0;  // no corner may have a worse shape than 1 / largest_

  using normals = typename corner_normals<M>::by_fan;

  /// The matrix of the corner that k points to, as seen from vert number v.
  corner_matrix<dimension> matrix_of(const unsigned* k, unsigned v, const normals& n) const {
    const corner_frame& f = corners_.frames[*k];
    return {f, corners_.ideals[f.ideal], points_, n[normals_.fan(k)], v, points_[v]};
  }

  /// Calls each(frame, matrix) for the corners whose tip is v.
  template<class F>
  void for_each_corner_of(unsigned v, const F& each) const {
    normals n;
    normals_.find(v, points_, n);
    for (const unsigned* k = corners_.begin(v); k != corners_.end(v); ++k)
      if (corners_.frames[*k].verts[0] == v) each(corners_.frames[*k], matrix_of(k, v, n));
  }

  corner_energy energy(unsigned v, const normals& n, const vec3& x, double delta, bool has_derivatives = false) const {
    return energy_at<dimension>(
        corners_, points_, [&](const unsigned* k) -> const vec3& { return n[normals_.fan(k)]; }, v, x, delta,
        has_derivatives);
  }

  /// A positive number, of the size of the determinants, if a corner at v is inverted.
  double barrier_width(unsigned v, const normals& n) const {
    double least = std::numeric_limits<double>::infinity(), sum = 0;
    for (const unsigned* k = corners_.begin(v); k != corners_.end(v); ++k) {
      const double det = matrix_of(k, v, n).determinant();
      least = std::min(least, det), sum += std::abs(det);
    }
    if (least > 0) return 0;
    const double small = 0.02 * sum / static_cast<double>(corners_.end(v) - corners_.begin(v));
    return std::sqrt(small * (small - least));
  }

  /// Newton's step, along what v may move on.
  vec3 step_of(unsigned v, const normals& n, const corner_energy& now) const {
    vec3 g = now.gradient;
    symmetric_matrix h = now.hessian;
    const vert_motion motion = kept_ ? kept_->motions[v] : vert_motion::space;
    if (motion == vert_motion::line) {
      const vec3 t = kept_->tangent(v);
      const double slope = dot(g, t), bend = dot(t, h * t);
      return (bend > 0 ? -slope / bend : -slope) * t;
    }
    if (motion == vert_motion::surface) {  // the vert moves within its tangent plane
      const vec3 normal = dimension == 2 ? n[0] : kept_->normal(v);
      g = g - dot(g, normal) * normal;
      const vec3 hn = h * normal;
      const double nhn = dot(normal, hn);
      // P h P + n n', with P = 1 - n n'
      h.add_product(0.5, normal - hn), h.add_product(-0.5, normal + hn);
      h.add_product(nhn + 1, normal);
    }
    const vec3 step = h.solve(-1.0 * g);
    return dot(step, g) < 0 ? step : -1.0 * g;
  }

  /// Whether v may move from x by `step`, and where it comes to be.
  bool find_place(unsigned v, const vec3& x, const vec3& step, kept_surface::place& to) const {
    if (slides_) return kept_->find_place(v, x, step, to);
    to.point = kept_ ? kept_->closest(x + step) : x + step;
    return true;
  }

  bool move(unsigned v, double& moved) {
    normals n;
    if (!normals_.find(v, points_, n)) return false;
    const vec3 x = points_[v];
    const double delta = barrier_width(v, n);
    const corner_energy now = energy(v, n, x, delta, true);
    if (!(now.value < std::numeric_limits<double>::infinity())) return false;
    vec3 step = step_of(v, n, now);
    double longest = 0;
    for (const unsigned* k = corners_.begin(v); k != corners_.end(v); ++k)
      longest = std::max(longest, norm(points_[corners_.frames[*k].verts[corners_.frames[*k].verts[0] == v]] - x));
    if (const double length = norm(step); length > 0.5 * longest) step = (0.5 * longest / length) * step;
    if (!(norm(step) > 1e-4 * longest)) return false;
    for (unsigned halvings = 0; halvings < 8; ++halvings, step = 0.5 * step) {
      kept_surface::place to;
      if (!find_place(v, x, step, to)) continue;
      const corner_energy then = energy(v, n, to.point, delta);
      if (!(then.value < now.value) || then.num_inverted > now.num_inverted || then.largest > largest_) continue;
      points_[v] = to.point;
      if (slides_) kept_->set(v, to);
      moved += (now.value - then.value) / now.value;
      return true;
    }
    return false;
  }

  /// The least shape of corners that are not inverted, and the number of the others.
  void measure(double& least, std::size_t& num_inverted) const {
    least = 1, num_inverted = 0;
    for (unsigned v = 0; v < points_.size(); ++v)
      for_each_corner_of(v, [&](const corner_frame&, const corner_matrix<dimension>& c) {
        if (!(c.determinant() > 0)) ++num_inverted;
        else least = std::min(least, c.shape());
      });
  }

  /// Verts that never move: those that the caller names, reflex corners of general polys, verts without corners.
  template<class F>
  std::vector<bool> fixed_verts(const M& m, const F& is_fixed) const {
    std::vector<bool> stays(points_.size());
    for (unsigned v = 0; v < points_.size(); ++v)
      for_each_corner_of(v, [&](const corner_frame& f, const corner_matrix<dimension>& c) {
        if (f.is_of_general_poly && !(c.determinant() > 0))
          for (unsigned i = 0; i <= dimension; ++i) stays[f.verts[i]] = true;
      });
    unsigned i = 0;
    for (const vert_t<M> v : verts(m)) {
      if (corners_.begin(i) == corners_.end(i) || is_fixed(v)) stays[i] = true;
      ++i;
    }
    return stays;
  }

 public:
  point_smoother(const point_smoother&) = delete;  // the tree refers to the input
  point_smoother& operator=(const point_smoother&) = delete;
  template<class F, class Features>
  point_smoother(const M& m, const unit_points& unit, double feature_angle_deg, bool slides, const F& is_fixed,
                 const Features& features)
      : corners_(m), slides_(slides), normals_(corners_) {
    points_.reserve(num_verts(m));
    for (const vert_t<M> v : verts(m)) points_.push_back(unit.at(m, v));
    changed_.assign(points_.size(), 1);
    std::vector<bool> stays = fixed_verts(m, is_fixed);
    vert_pairs named = features.edges_of_lines();
    // the boundary of a surface is among its lines, that of a volume is a surface
    if constexpr (dimension == 2) {
      for (const edge_t<M> e : edges(m)) {
        if (runs_both_ways(m, e)) continue;
        const auto [a, b] = end_verts(m, e);
        named.emplace_back(features.number(a), features.number(b));
        stays[named.back().first] = stays[named.back().second] = true;
      }
    } else if (!slides) {
      for (const auto& [a, b] : named) stays[a] = stays[b] = true;
      features.for_each_interface([&](const face_t<M>& f) {
        for (const vert_t<M> v : adj_f2v(m, f)) stays[features.number(v)] = true;
      });
      for (const vert_t<M> v : verts(m))
        if (is_boundary(m, v)) stays[features.number(v)] = true;
    }
    if (dimension == 2 || slides) kept_.emplace(features.surface(unit), std::move(named), feature_angle_deg, stays);
    if (dimension == 2 && slides) normals_.find_fans(*kept_);
    for (unsigned v = 0; v < points_.size(); ++v) {
      const vert_motion motion = kept_ ? kept_->motions[v] : vert_motion::space;
      if (!stays[v] && motion != vert_motion::none && (slides || motion != vert_motion::line)) free_.push_back(v);
    }
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
