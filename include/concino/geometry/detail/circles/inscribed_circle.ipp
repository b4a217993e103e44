// Defines inscribed_circle.hpp. The plane is divided into boxes. Over a box, the distance from an edge is below a
// linear function, with an error of the square of the box's size, and a linear programme bounds the smallest of these
// distances. So a few boxes of each size remain about a largest circle. In a convex polygon one box is enough.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/inscribed_circle.hpp>
#include <concino/geometry/orientation.hpp>
#include <concino/geometry/support/convex_cuts.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace concino::detail {

/// The linear function value + dot(slope, x - centre), where the centre is that of a box.
struct planar_bound {
  double value;
  vec3 slope;
};

/// The largest value of the smallest of linear functions over a box, and where it is.
class smallest_bound_search {
  std::vector<vec3> loop_, scratch_;

 public:
  vec3 place;           // from the centre of the box
  double rounding = 0;  // functions that differ by less count as equal: those of the edges at one corner

  double operator()(const std::vector<planar_bound>& bounds, const vec3& half) {
    double largest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const planar_bound& b = bounds[i];
      if (b.value + dot(b.slope, place) >= largest - rounding) continue;
      // The optimum is on the plane of this function, where it is below all of those before it.
      loop_ = {{-half.x, -half.y, 0}, {half.x, -half.y, 0}, {half.x, half.y, 0}, {-half.x, half.y, 0}};
      for (std::size_t j = 0; j < i && !loop_.empty(); ++j) {
        const vec3 slope = bounds[j].slope - b.slope;
        const double value = bounds[j].value - b.value + rounding;
        core::cut_convex_loop(
            loop_, scratch_, [&](const vec3& x) { return value + dot(slope, x); }, [](const vec3&) {});
      }
      double found = -std::numeric_limits<double>::infinity();
      for (const vec3& x : loop_)
        if (const double q = b.value + dot(b.slope, x); q > found) found = q, place = x;
      if (found < largest && !loop_.empty()) largest = found;
    }
    return largest;
  }
};

class largest_circle_search {
  using index = std::uint32_t;
  struct box {
    vec3 centre, half;
    double bound;
    std::vector<index> edges;  // that may be the nearest ones to a point of the box
  };

  vec3 along_{1, 0, 0}, upward_{0, 1, 0};  // the axes of boxes: those of the longest edge
  std::vector<vec3> from_, direction_;     // of edges, turned to these axes
  std::vector<double> length_;
  std::vector<box> boxes_;  // a heap, the largest bound first
  std::vector<planar_bound> bounds_;
  smallest_bound_search bound_;
  double excluded_ = 0;  // boxes with smaller bounds are left out; the largest bound of those that were left out
  bool is_convex_ = true;

 public:
  vec3 centre;
  double radius = 0, upper = 0;

  explicit largest_circle_search(const std::vector<vec3>& corners) {
    const std::size_t n = corners.size();
    double longest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const vec3 d = corners[i + 1 == n ? 0 : i + 1] - corners[i];
      if (norm(d) > longest) longest = norm(d), along_ = d / longest;
    }
    upward_ = {-along_.y, along_.x, 0};
    const auto turned = [&](const vec3& x) { return vec3{dot(x, along_), dot(x, upward_), 0}; };
    for (std::size_t i = 0; i < n; ++i) {
      from_.push_back(turned(corners[i]));
      const vec3 d = turned(corners[i + 1 == n ? 0 : i + 1]) - from_[i];
      length_.push_back(norm(d));
      direction_.push_back(d / length_.back());
    }
    for (std::size_t i = 0; i < n && is_convex_; ++i)
      is_convex_ = orient2d(corners[i], corners[i + 1 == n ? 0 : i + 1], corners[(i + 2) % n]) >= 0;
  }

  void run(const inscribed_circle_options& options) {
    box whole = box_of_all();
    const double rounding = 1e-15 * (whole.half.x + whole.half.y);
    bound_.rounding = rounding;
    examine(std::move(whole), 0);
    std::size_t num_parts = 1;
    while (!boxes_.empty()) {
      const double least = std::max(radius / (1 - options.tolerance), radius + 3 * rounding);
      if (boxes_.front().bound <= least || num_parts >= options.max_parts) break;
      std::pop_heap(boxes_.begin(), boxes_.end(), has_smaller_bound);
      const box b = std::move(boxes_.back());
      boxes_.pop_back();
      const unsigned axis = b.half.x < b.half.y;
      for (const double sign : {-1.0, 1.0}) {
        box part = b;
        part.half[axis] /= 2;
        part.centre[axis] += sign * part.half[axis];
        examine(std::move(part), least);
        ++num_parts;
      }
    }
    upper = std::max({radius, excluded_, boxes_.empty() ? 0 : boxes_.front().bound}) + 4 * rounding;
  }

 private:
  static bool has_smaller_bound(const box& a, const box& b) { return a.bound < b.bound; }

  box box_of_all() const {
    vec3 low = from_[0], high = low;
    for (const vec3& x : from_) {
      low = {std::min(low.x, x.x), std::min(low.y, x.y), 0};
      high = {std::max(high.x, x.x), std::max(high.y, x.y), 0};
    }
    box all{(low + high) / 2, (high - low) / 2, 0, std::vector<index>(from_.size())};
    // In random order, so that the linear programme takes linear time.
    std::iota(all.edges.begin(), all.edges.end(), index{0});
    std::uint64_t random = 1;
    for (std::size_t i = all.edges.size(); i > 1; --i) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      std::swap(all.edges[i - 1], all.edges[(random >> 33) % i]);
    }
    return all;
  }

  /// How far x is from the start of an edge, along it and to its left.
  vec3 place_at_edge(const vec3& x, index e) const {
    const vec3 d = x - from_[e], t = direction_[e];
    return {dot(d, t), t.x * d.y - t.y * d.x, 0};
  }
  double distance_from(const vec3& x, index e) const {
    const vec3 at = place_at_edge(x, e);
    const double over = at.x < 0 ? -at.x : std::max(0.0, at.x - length_[e]);
    return std::sqrt(at.y * at.y + over * over);
  }
  bool is_inside(const vec3& x) const {
    bool inside = false;
    for (std::size_t i = 0, j = from_.size() - 1; i < from_.size(); j = i++) {
      const vec3 &a = from_[i], &b = from_[j];
      if ((a.y > x.y) != (b.y > x.y)) inside ^= x.x < a.x + (x.y - a.y) / (b.y - a.y) * (b.x - a.x);
    }
    return inside;
  }

  /// A linear function above the distance from an edge, at all points of a box; of convex polygons, above the distance
  /// from the line to its left.
  planar_bound bound_at(const box& b, index e) const {
    const vec3 at = place_at_edge(b.centre, e);
    vec3 t = direction_[e], n{-t.y, t.x, 0};
    if (is_convex_) return {at.y, n};
    double p = at.y, over;
    if (at.x >= 0 && at.x <= length_[e]) {
      const double range = b.half.x * std::abs(t.x) + b.half.y * std::abs(t.y);
      over = std::max({0.0, range - at.x, at.x + range - length_[e]});
    } else {  // a corner is nearest to the centre of the box
      const vec3 from = b.centre - (at.x < 0 ? from_[e] : from_[e] + length_[e] * t);
      p = norm(from);
      n = from / p;
      over = b.half.x * std::abs(n.y) + b.half.y * std::abs(n.x);
    }
    // At a distance q from the line, the edge is at most at sqrt(q^2 + over^2), which is convex: below its chord.
    const double range = b.half.x * std::abs(n.x) + b.half.y * std::abs(n.y);
    const auto value = [&](double q) { return std::sqrt(q * q + over * over); };
    const double low = value(p - range), high = value(p + range);
    return {(low + high) / 2, range > 0 ? (high - low) / (2 * range) * n : vec3{}};
  }

  void keep_if_larger(const vec3& x) {
    if (!is_inside(x)) return;
    double r = std::numeric_limits<double>::infinity();
    for (index e = 0; e < from_.size() && r > radius; ++e) r = std::min(r, distance_from(x, e));
    if (r <= radius) return;
    radius = r;
    centre = x.x * along_ + x.y * upward_;
  }

  void examine(box b, double least) {
    const double extent = norm(b.half);
    std::vector<double> distances;
    double nearest = std::numeric_limits<double>::infinity();
    for (const index e : b.edges) {
      distances.push_back(distance_from(b.centre, e));
      nearest = std::min(nearest, distances.back());
    }
    if (nearest > extent * (1 + 1e-12) && !is_inside(b.centre)) return;  // all of it is outside
    std::size_t kept = 0;
    for (std::size_t i = 0; i < b.edges.size(); ++i)
      if (is_convex_ || distances[i] <= (nearest + 2 * extent) * (1 + 1e-12)) b.edges[kept++] = b.edges[i];
    b.edges.resize(kept);
    bounds_.clear();
    for (const index e : b.edges) bounds_.push_back(bound_at(b, e));
    bound_.place = {};
    b.bound = bound_(bounds_, b.half);
    if (b.bound <= least) {
      excluded_ = std::max(excluded_, b.bound);
      return;
    }
    keep_if_larger(b.centre);
    keep_if_larger(b.centre + bound_.place);
    boxes_.push_back(std::move(b));
    std::push_heap(boxes_.begin(), boxes_.end(), has_smaller_bound);
  }
};

CONCINO_INLINE inscribed_circle_result largest_circle_inside(const core::flat_polygon& flat,
                                                             const inscribed_circle_options& options) {
  if (!(options.tolerance >= 1e-12 && options.tolerance < 1))
    core::throw_joined<invalid_argument>(
        {"inscribed_circle_options: tolerance has to be from 1e-12 to 1, as a part of the radius"});
  if (options.max_parts == 0)
    core::throw_joined<invalid_argument>({"inscribed_circle_options: max_parts has to be 1 or more"});
  largest_circle_search search(flat.corners());
  search.run(options);
  return {flat.to_space(search.centre), flat.to_space(search.radius, 1), flat.to_space(search.upper, 1), flat.normal()};
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE inscribed_circle_result inscribed_circle(std::span<const vec3> polygon,
                                                        const inscribed_circle_options& options) {
  return detail::largest_circle_inside(core::checked_simple_polygon(polygon, "inscribed_circle"), options);
}

}  // namespace concino
