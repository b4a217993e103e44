// Finds self-intersections of the boundary of a polygon in the plane.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

using plane_point = std::array<double, 2>;

/// Finds self-intersections of polygons. It reuses its memory from polygon to polygon.
class self_intersection_finder {
 public:
  self_intersection_finder() = default;
  /// patience: with how many others each edge is compared, on average, before edges are kept sorted.
  explicit self_intersection_finder(std::size_t patience) : patience_(patience) {}

  /// Two edges that intersect, other than consecutive edges in their common corner; none if the polygon is simple. Edge
  /// i runs from corner i to the next. Edges without length are skipped. A point counts as on a line if it is so up to
  /// rounding.
  /// Cost: O(n log n).
  /// Source: sweep over the edges sorted along an axis; if many overlap along it, Shamos and Hoey 1976; orientation
  ///         with the error bound of Shewchuk 1997.
  std::optional<std::pair<std::uint32_t, std::uint32_t>> operator()(std::span<const plane_point> corners) {
    edges_.clear();
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const plane_point &a = corners[i], &b = corners[(i + 1) % n];
      if (a != b) edges_.push_back({a, b, static_cast<std::uint32_t>(i), 0});
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) edges_[i].rank = static_cast<std::uint32_t>(i);
    if (edges_.size() < 3) return std::nullopt;
    return edges_.size() <= 8 ? all_pairs() : sweep();
  }

 private:
  struct polygon_edge {
    plane_point a, b;
    std::uint32_t number, rank;  // position in the polygon, and position among edges with length
    double low(std::size_t k) const { return std::min(a[k], b[k]); }
    double high(std::size_t k) const { return std::max(a[k], b[k]); }
    const plane_point& first() const { return std::min(a, b); }
    const plane_point& last() const { return std::max(a, b); }
  };
  using found = std::optional<std::pair<std::uint32_t, std::uint32_t>>;

  std::size_t patience_ = 64;
  std::vector<polygon_edge> edges_;
  std::vector<std::uint32_t> active_;

  static found pair_of(const polygon_edge& s, const polygon_edge& t) {
    return std::pair{std::min(s.number, t.number), std::max(s.number, t.number)};
  }

  found all_pairs() const {
    for (std::size_t j = 0; j < edges_.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        if (meet(edges_[i], edges_[j])) return pair_of(edges_[i], edges_[j]);
    return std::nullopt;
  }

  found sweep() {
    // along the axis in which edges are short: then few edges overlap at a time
    std::array<double, 2> total{0, 0}, low{edges_[0].a}, high{edges_[0].a};
    for (const polygon_edge& s : edges_)
      for (std::size_t k = 0; k < 2; ++k) {
        total[k] += s.high(k) - s.low(k);
        low[k] = std::min(low[k], s.low(k));
        high[k] = std::max(high[k], s.high(k));
      }
    const std::size_t sweep_axis = total[0] * (high[1] - low[1]) <= total[1] * (high[0] - low[0]) ? 0 : 1,
                      other_axis = 1 - sweep_axis;
    const std::uint32_t count = static_cast<std::uint32_t>(edges_.size());
    std::sort(edges_.begin(), edges_.end(), [sweep_axis](const polygon_edge& s, const polygon_edge& t) {
      return s.low(sweep_axis) != t.low(sweep_axis) ? s.low(sweep_axis) < t.low(sweep_axis) : s.rank < t.rank;
    });
    active_.clear();
    std::size_t steps = 0;
    for (std::uint32_t j = 0; j < count; ++j) {
      if ((steps += active_.size()) > patience_ * count) return sweep_in_order();
      const polygon_edge& t = edges_[j];
      std::size_t kept = 0;
      for (std::size_t k = 0; k < active_.size(); ++k) {
        const polygon_edge& s = edges_[active_[k]];
        if (s.high(sweep_axis) < t.low(sweep_axis)) continue;
        if (s.high(other_axis) >= t.low(other_axis) && t.high(other_axis) >= s.low(other_axis) && meet(s, t))
          return pair_of(s, t);
        active_[kept++] = active_[k];
      }
      active_.resize(kept);
      active_.push_back(j);
    }
    return std::nullopt;
  }

  /// Compares edges that cross the sweep line, from low to high. Points are swept in lexicographic order of their
  /// coordinates, so no edge is parallel to the line.
  struct is_below {
    const std::vector<polygon_edge>* edges;

    bool operator()(std::uint32_t i, std::uint32_t j) const {
      const polygon_edge &s = (*edges)[i], &t = (*edges)[j];
      if (i == j) return false;
      if (s.first() == t.first()) return left_of(s.first(), s.last(), t.last()) > 0;
      return s.first() < t.first() ? left_of(s.first(), s.last(), t.first()) > 0
                                   : left_of(t.first(), t.last(), s.first()) < 0;
    }
  };

  /// Sweeps with sorted edges. Edges that intersect become neighbours in this order before the sweep reaches the
  /// intersection; so only neighbours are compared.
  found sweep_in_order() {
    std::sort(edges_.begin(), edges_.end(),
              [](const polygon_edge& s, const polygon_edge& t) { return s.rank < t.rank; });
    const std::uint32_t count = static_cast<std::uint32_t>(edges_.size());
    std::vector<std::uint32_t> corners(count);  // corner i: the start of edge i
    for (std::uint32_t i = 0; i < count; ++i) corners[i] = i;
    std::sort(corners.begin(), corners.end(),
              [this](std::uint32_t i, std::uint32_t j) { return edges_[i].a < edges_[j].a; });
    for (std::uint32_t k = 1; k < count; ++k)
      if (edges_[corners[k - 1]].a == edges_[corners[k]].a) return pair_of(edges_[corners[k - 1]], edges_[corners[k]]);

    using order = std::set<std::uint32_t, is_below>;
    order crossed(is_below{&edges_});
    std::vector<order::iterator> position(count, crossed.end());
    found touch;
    const auto compare = [&](order::iterator lower, order::iterator upper) {
      if (!touch && meet(edges_[*lower], edges_[*upper])) touch = pair_of(edges_[*lower], edges_[*upper]);
    };
    for (const std::uint32_t i : corners) {
      const std::uint32_t two[] = {i == 0 ? count - 1 : i - 1, i};
      for (const std::uint32_t s : two) {
        if (edges_[s].last() != edges_[i].a) continue;
        const auto after = crossed.erase(position[s]);
        if (after != crossed.begin() && after != crossed.end()) compare(std::prev(after), after);
      }
      for (const std::uint32_t s : two) {
        if (edges_[s].first() != edges_[i].a) continue;
        const auto [at, fresh] = crossed.insert(s);
        if (!fresh) return pair_of(edges_[s], edges_[*at]);  // collinear with another edge
        position[s] = at;
        if (at != crossed.begin()) compare(std::prev(at), at);
        if (std::next(at) != crossed.end()) compare(at, std::next(at));
      }
      if (touch) return touch;
    }
    return std::nullopt;
  }

  // 1: c is left of ab, -1: right of it, 0: on its line, up to rounding
  static int turn(const plane_point& a, const plane_point& b, const plane_point& c) {
    const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]), t = left - right;
    const double bound = 4 * std::numeric_limits<double>::epsilon() * (std::abs(left) + std::abs(right));
    return t > bound ? 1 : t < -bound ? -1 : 0;
  }

  static double left_of(const plane_point& a, const plane_point& b, const plane_point& c) {
    return (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0]);
  }

  bool meet(const polygon_edge& s, const polygon_edge& t) const {
    const std::uint32_t n = static_cast<std::uint32_t>(edges_.size());
    if ((s.rank + 1) % n == t.rank) return folds_back(s, t);
    if ((t.rank + 1) % n == s.rank) return folds_back(t, s);
    const int sa = turn(t.a, t.b, s.a), sb = turn(t.a, t.b, s.b), ta = turn(s.a, s.b, t.a), tb = turn(s.a, s.b, t.b);
    if (sa * sb > 0 || ta * tb > 0) return false;
    // parallel, or one edge lies on the line of the other: the bounding boxes decide
    return s.high(0) >= t.low(0) && t.high(0) >= s.low(0) && s.high(1) >= t.low(1) && t.high(1) >= s.low(1);
  }
  // whether t, which begins where s ends, runs back along s
  static bool folds_back(const polygon_edge& s, const polygon_edge& t) {
    if (turn(s.a, s.b, t.b) != 0) return false;
    return (s.a[0] - s.b[0]) * (t.b[0] - t.a[0]) + (s.a[1] - s.b[1]) * (t.b[1] - t.a[1]) > 0;
  }
};

}  // namespace concino::detail
