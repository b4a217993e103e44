// Triangulation of a polygon in the plane by ear clipping; of small ones by fans.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/geometry/orientation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

/// One polygon after another, which reuses its memory: start(), the corners, then cut().
class ear_clipper {
  struct point2 { double x, y; };
  using index = std::uint32_t;
  // The condition for an ear. The later ones are for polygons that touch or intersect themselves, if no better ear is
  // left.
  enum class ear { clear, touched, flat, any };

  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<point2> q_;
  std::vector<index> next_, prev_, now_, later_, grid_offsets_, grid_;
  std::vector<std::uint8_t> reflex_, removed_, wait_;
  index cells_ = 0;  // per axis; 0: no grid
  point2 low_ = {0, 0}, cell_ = {0, 0};
  index left_ = 0;
  bool exact_ = false;

  // Up to this many corners, the fan whose smallest triangle is largest is taken, so that corners on a common line make
  // no flat triangle if another fan has none.
  static constexpr std::size_t max_compared = 16;

  index size() const { return static_cast<index>(q_.size()); }

  double turn(index a, index b, index c) const {
    const point2 &p = q_[a], &q = q_[b], &r = q_[c];
    const double doubled_area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    if (!exact_) return doubled_area;
    const int sign = orient2d({p.x, p.y, 0}, {q.x, q.y, 0}, {r.x, r.y, 0});
    return sign == 0 ? 0 : std::copysign(std::max(std::abs(doubled_area), std::numeric_limits<double>::min()), sign);
  }

  // The corner that comes i after the apex of a fan.
  static index after(index apex, std::size_t i, std::size_t n) { return static_cast<index>((apex + i) % n); }

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

 public:
  /// exact: whether turns are found by exact tests.
  void start(bool exact) {
    exact_ = exact;
    triangles_.clear();
    q_.clear();
  }
  void add(double x, double y) { q_.push_back({x, y}); }

  /// The triangles, as numbers of corners.
  std::vector<std::array<std::uint32_t, 3>>& triangles() { return triangles_; }

  /// The triangles of a fan of n corners, which need not be added.
  void fan(std::size_t n, index apex = 0) {
    for (std::size_t i = 2; i < n; ++i) triangles_.push_back({apex, after(apex, i - 1, n), after(apex, i, n)});
  }

  /// Cuts the polygon into triangles along its diagonals.
  void cut() {
    const std::size_t n = q_.size();
    if (n == 4) return cut_quad();
    index apex = 0;
    double largest = smallest_of_fan(0, 0);
    for (index k = 1; k < n && n <= max_compared; ++k)
      if (const double smallest = smallest_of_fan(k, largest); smallest > largest) apex = k, largest = smallest;
    if (largest > 0) fan(n, apex);
    else clip_ears();
  }
};

}  // namespace concino::detail
