// Triangulation of a polygon in space without new points, for drawing, areas and formats with triangles only.
#pragma once

#include <concino/core/lexicographic.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace concino {

/// Three corners of a polygon, counted from 0.
using polygon_triangle = std::array<std::uint32_t, 3>;

/// Triangulates one polygon after another and reuses its memory; use one object per thread.
class polygon_triangulator {
 public:
  /// Triangulates a polygon by diagonals.
  /// Needs:  the corners in cyclic order; concave, non-planar, collinear or repeated corners are allowed.
  /// Result: max(n, 2) - 2 triangles with the orientation of the polygon, valid until the next call. If the projection
  ///         of the polygon along its vector area is simple, none is inverted there and they cover it. If it is not
  ///         simple or has no area, they still join all corners. The triangles depend on the cycle of points alone:
  ///         neither on the corner that comes first nor on the direction.
  ///         Cost: O(n) for most; ears are looked up in a grid if n is large.
  /// Source: ear clipping, Meisters 1975; the plane is that of the vector area.
  std::span<const polygon_triangle> operator()(std::span<const vec3> corners) {
    exact_ = false;
    triangles_.clear();
    const std::size_t n = corners.size();
    if (n < 3) return {};
    if (n == 3) {
      triangles_.push_back({0, 1, 2});
      return triangles_;
    }
    const cycle by_points = order_by_points(corners);
    if (!flatten(ordered_)) fan(n);
    else cut(n);
    for (polygon_triangle& t : triangles_) {
      for (index& k : t) k = by_points.corner(k);
      if (by_points.backward) std::swap(t[1], t[2]);
    }
    return triangles_;
  }

  /// Triangulates the projection of a polygon along z, by exact tests.
  /// Needs:  the corners in counter-clockwise order seen from above. Corners may be collinear, and edges may touch one
  ///         another, as at bridges to holes, which are passed twice; no two edges cross. Coordinates x and y as
  ///         orient2d needs them.
  /// Result: as operator(). All triangles are counter-clockwise seen from above, none is degenerate.      Cost: as
  ///         operator().
  /// Errors: none.
  /// Source: as operator(); Shewchuk 1997 for the tests.
  std::span<const polygon_triangle> from_above(std::span<const vec3> corners) {
    exact_ = true;
    triangles_.clear();
    if (corners.size() < 3) return {};
    q_.clear();
    for (const vec3& p : corners) q_.push_back({p.x, p.y});
    cut(corners.size());
    return triangles_;
  }

 private:
  struct point2 { double x, y; };
  using index = std::uint32_t;
  // The corners in turn from `first`.
  struct cycle {
    index first, size;
    bool backward;
    index corner(index k) const {
      return backward ? (first >= k ? first - k : first + size - k) : first + k < size ? first + k : first + k - size;
    }
  };
  // The condition for an ear. The later ones are for polygons that touch or intersect themselves, if no better ear is
  // left.
  enum class ear { clear, touched, flat, any };

  std::vector<polygon_triangle> triangles_;
  std::vector<vec3> ordered_;
  std::vector<point2> q_;
  std::vector<index> next_, prev_, now_, later_, grid_offsets_, grid_;
  std::vector<std::uint8_t> reflex_, removed_, wait_;
  index cells_ = 0;  // per axis; 0: no grid
  point2 low_ = {0, 0}, cell_ = {0, 0};
  index left_ = 0;
  bool exact_ = false;

  // Negative if a comes before b, positive if after.
  static int compare(const vec3& a, const vec3& b) {
    return core::is_lexicographically_less(a, b) ? -1 : core::is_lexicographically_less(b, a) ? 1 : 0;
  }

  // The first of the lexicographically smallest rotations. Source: Shiloach 1981, "Fast canonization of circular
  // strings".
  static cycle smallest_rotation(std::span<const vec3> corners, bool backward) {
    const auto n = static_cast<index>(corners.size());
    index i = 0, j = 1, k = 0;
    while (i < n && j < n && k < n) {
      const cycle a{backward ? n - 1 - i : i, n, backward}, b{backward ? n - 1 - j : j, n, backward};
      const int order = compare(corners[a.corner(k)], corners[b.corner(k)]);
      if (order == 0) {
        ++k;
        continue;
      }
      (order < 0 ? j : i) += k + 1;
      if (i == j) ++j;
      k = 0;
    }
    const index first = std::min(i, j);
    return {backward ? n - 1 - first : first, n, backward};
  }

  // Copies the corners to ordered_, in an order that follows from the points.
  cycle order_by_points(std::span<const vec3> corners) {
    const cycle a = smallest_rotation(corners, false), b = smallest_rotation(corners, true);
    int order = 0;
    for (index k = 0; k < a.size && order == 0; ++k) order = compare(corners[a.corner(k)], corners[b.corner(k)]);
    const cycle& smaller = order > 0 ? b : a;
    ordered_.clear();
    for (index k = 0; k < a.size; ++k) ordered_.push_back(corners[smaller.corner(k)]);
    return smaller;
  }

  // Up to this many corners, the fan whose smallest triangle is largest is taken, so that corners on a common line make
  // no flat triangle if another fan has none.
  static constexpr std::size_t max_compared = 16;

  void cut(std::size_t n) {
    if (n == 4) return cut_quad();
    index apex = 0;
    double largest = smallest_of_fan(0, 0);
    for (index k = 1; k < n && n <= max_compared; ++k)
      if (const double smallest = smallest_of_fan(k, largest); smallest > largest) apex = k, largest = smallest;
    if (largest > 0) fan(n, apex);
    else clip_ears();
  }

  index size() const { return static_cast<index>(q_.size()); }

  double turn(index a, index b, index c) const {
    const point2 &p = q_[a], &q = q_[b], &r = q_[c];
    const double doubled_area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (!exact_) return doubled_area;
    const int sign = orient2d({p.x, p.y, 0}, {q.x, q.y, 0}, {r.x, r.y, 0});
    return sign == 0 ? 0 : std::copysign(std::max(std::abs(doubled_area), std::numeric_limits<double>::min()), sign);
  }

  // Projects to the plane of the vector area, scaled to about 1 to avoid overflow and underflow. False if there is no
  // such plane.
  bool flatten(std::span<const vec3> corners) {
    const vec3 o = corners[0];
    double size = 0;
    for (const vec3& p : corners)
      size = std::max({size, std::abs(p.x - o.x), std::abs(p.y - o.y), std::abs(p.z - o.z)});
    if (!(size > 0) || !std::isfinite(size)) return false;
    vec3 n;
    for (std::size_t i = 2; i < corners.size(); ++i) n += cross((corners[i - 1] - o) / size, (corners[i] - o) / size);
    const double length = norm(n);
    if (!(length > 0)) return false;
    n /= length;
    vec3 t = cross(n, std::abs(n.x) < 0.6 ? vec3{1, 0, 0} : vec3{0, 1, 0});
    t /= norm(t);
    const vec3 b = cross(n, t);
    q_.clear();
    for (const vec3& p : corners) {
      const vec3 d = (p - o) / size;
      q_.push_back({dot(d, t), dot(d, b)});
    }
    return true;
  }

  // The corner that comes i after the apex of a fan.
  static index after(index apex, std::size_t i, std::size_t n) { return static_cast<index>((apex + i) % n); }
  void fan(std::size_t n, index apex = 0) {
    for (std::size_t i = 2; i < n; ++i) triangles_.push_back({apex, after(apex, i - 1, n), after(apex, i, n)});
  }
  // Twice the area of the smallest triangle of the fan from a corner; 0 or less if that is not more than `bound`, which
  // is at least 0.
  double smallest_of_fan(index apex, double bound) const {
    double smallest = std::numeric_limits<double>::infinity();
    for (index i = 2; i < size(); ++i) {
      smallest = std::min(smallest, turn(apex, after(apex, i - 1, size()), after(apex, i, size())));
      if (!(smallest > bound)) return 0;
    }
    return smallest;
  }

  // Takes the diagonal that maximises the smaller triangle; in a concave quad it is the inner one.
  void cut_quad() {
    const double from0 = std::min(turn(0, 1, 2), turn(0, 2, 3)), from1 = std::min(turn(1, 2, 3), turn(1, 3, 0));
    if (from1 > from0) triangles_.insert(triangles_.end(), {{1, 2, 3}, {1, 3, 0}});
    else triangles_.insert(triangles_.end(), {{0, 1, 2}, {0, 2, 3}});
  }

  bool same(index a, index b) const { return q_[a].x == q_[b].x && q_[a].y == q_[b].y; }

  bool blocks(index v, index a, index b, index c, ear kind) const {
    if (!reflex_[v] || v == a || v == b || v == c || same(v, a) || same(v, b) || same(v, c)) return false;
    const double ab = turn(a, b, v), bc = turn(b, c, v), ca = turn(c, a, v);
    return kind == ear::clear ? ab >= 0 && bc >= 0 && ca >= 0 : ab > 0 && bc > 0 && ca > 0;
  }

  index cell_of(double x, double low, double size) const {
    const double c = (x - low) / size;
    return !(c > 0) ? 0 : c >= cells_ ? cells_ - 1 : static_cast<index>(c);
  }

  void make_grid() {
    cells_ = 0;
    const index n = size();
    if (n <= 64) return;
    point2 high = low_ = q_[0];
    for (const point2& p : q_) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    cells_ = static_cast<index>(std::sqrt(static_cast<double>(n)));
    cell_ = {(high.x - low_.x) / cells_, (high.y - low_.y) / cells_};
    if (!(cell_.x > 0)) cell_.x = 1;
    if (!(cell_.y > 0)) cell_.y = 1;
    const auto cell = [&](index v) {
      return cell_of(q_[v].y, low_.y, cell_.y) * cells_ + cell_of(q_[v].x, low_.x, cell_.x);
    };
    grid_offsets_.assign(std::size_t{cells_} * cells_ + 1, 0);
    for (index v = 0; v < n; ++v) ++grid_offsets_[cell(v) + 1];
    for (std::size_t c = 1; c < grid_offsets_.size(); ++c) grid_offsets_[c] += grid_offsets_[c - 1];
    grid_.resize(n);
    // fills each cell from its end, so offsets move one position down
    for (index v = n; v-- > 0;) grid_[--grid_offsets_[cell(v) + 1]] = v;
    for (std::size_t c = 0; c + 1 < grid_offsets_.size(); ++c) grid_offsets_[c] = grid_offsets_[c + 1];
    grid_offsets_.back() = n;
  }

  bool is_ear(index b, ear kind) const {
    const index a = prev_[b], c = next_[b];
    if (kind == ear::any) return true;
    const double size = turn(a, b, c);
    if (!(kind == ear::flat ? size >= 0 : size > 0)) return false;
    if (cells_ == 0) {
      for (index v = next_[c]; v != a; v = next_[v])
        if (blocks(v, a, b, c, kind)) return false;
      return true;
    }
    const point2 &p = q_[a], &q = q_[b], &r = q_[c];
    const index x0 = cell_of(std::min({p.x, q.x, r.x}), low_.x, cell_.x),
                x1 = cell_of(std::max({p.x, q.x, r.x}), low_.x, cell_.x);
    const index y0 = cell_of(std::min({p.y, q.y, r.y}), low_.y, cell_.y),
                y1 = cell_of(std::max({p.y, q.y, r.y}), low_.y, cell_.y);
    for (index y = y0; y <= y1; ++y)
      for (index i = grid_offsets_[y * cells_ + x0]; i < grid_offsets_[y * cells_ + x1 + 1]; ++i)
        if (blocks(grid_[i], a, b, c, kind)) return false;
    return true;
  }

  void clip(index b) {
    const index a = prev_[b], c = next_[b];
    triangles_.push_back({a, b, c});
    next_[a] = c;
    prev_[c] = a;
    removed_[b] = 1;
    reflex_[b] = 0;
    --left_;
    for (const index v : {a, c}) {
      reflex_[v] = !(turn(prev_[v], v, next_[v]) > 0);
      if (!wait_[v]) later_.push_back(v);
      wait_[v] = 1;
    }
  }

  // Clips ears in rounds; no two neighbours are clipped in one round, because that would give a fan of slivers.
  void clip_ears() {
    const index n = left_ = size();
    next_.resize(n);
    prev_.resize(n);
    for (index i = 0; i < n; ++i) {
      next_[i] = i + 1 < n ? i + 1 : 0;
      prev_[i] = i > 0 ? i - 1 : n - 1;
    }
    reflex_.resize(n);
    for (index i = 0; i < n; ++i) reflex_[i] = !(turn(prev_[i], i, next_[i]) > 0);
    removed_.assign(n, 0);
    wait_.assign(n, 0);
    make_grid();
    ear kind = ear::clear;
    int retreats = 0;
    index alive = 0;
    const auto restart = [&] {
      while (removed_[alive]) ++alive;
      now_.clear();
      index v = alive;
      do now_.push_back(v);
      while ((v = next_[v]) != alive);
    };
    restart();
    while (left_ > 3) {
      later_.clear();
      for (const index v : now_) {
        if (left_ == 3) break;
        if (removed_[v] || wait_[v] || !is_ear(v, kind)) continue;
        clip(v);
        if (kind == ear::clear) continue;
        if (++retreats <= 16) kind = ear::clear;  // one bad corner should not spoil the rest; the number of retries is
                                                  // bounded for speed
      }
      for (const index v : later_) wait_[v] = 0;
      now_.swap(later_);
      if (!now_.empty()) continue;
      kind = static_cast<ear>(static_cast<int>(kind) + 1);
      restart();
    }
    while (removed_[alive]) ++alive;
    triangles_.push_back({prev_[alive], alive, next_[alive]});
  }
};

/// The triangles of one polygon. For many polygons use a polygon_triangulator.
/// Needs:  as polygon_triangulator.
/// Result: as polygon_triangulator, as a vector of its own.
/// Cost:   as polygon_triangulator, and its working memory.
/// Errors: none.
/// Source: as polygon_triangulator.
inline std::vector<polygon_triangle> triangulate_polygon(std::span<const vec3> corners) {
  polygon_triangulator cut;
  const auto triangles = cut(corners);
  return {triangles.begin(), triangles.end()};
}

}  // namespace concino
