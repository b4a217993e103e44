// Bodies of point_clusters.hpp: equal points by hashing, close ones by a grid.
#pragma once

#include <concino/core/index_table.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/repair/detail/point_clusters.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace concino::detail {

/// The chains of numbers that were added with the same three integers.
class chains_by_cell {
 public:
  using cell = std::array<std::int64_t, 3>;
  static constexpr std::uint32_t none = core::index_table::none;

 private:
  core::index_table table_;
  std::vector<cell> cells_;              // by chain
  std::vector<std::uint32_t> last_;      // by chain
  std::vector<std::uint32_t> previous_;  // by number

  static std::uint32_t hash(const cell& key) {
    std::uint32_t h = 0;
    for (const std::int64_t x : key) h = core::index_table::hash(static_cast<std::uint64_t>(x), h);
    return h;
  }
  std::uint32_t chain_of(const cell& key) const {
    return table_.find(hash(key), [&](std::uint32_t chain) { return cells_[chain] == key; });
  }

 public:
  /// Numbers below n.
  explicit chains_by_cell(std::size_t n) : previous_(n, none) {}

  std::uint32_t last(const cell& key) const {
    const std::uint32_t chain = chain_of(key);
    return chain == none ? none : last_[chain];
  }
  std::uint32_t previous(std::uint32_t number) const { return previous_[number]; }
  void add(const cell& key, std::uint32_t number) {
    const std::uint32_t chain = chain_of(key);
    if (chain == none) {
      table_.add(hash(key), static_cast<std::uint32_t>(cells_.size()));
      cells_.push_back(key);
      last_.push_back(number);
    } else {
      previous_[number] = last_[chain];
      last_[chain] = number;
    }
  }
};

/// For each point, the first one that equals it.
inline std::vector<std::uint32_t> first_equal_points(const std::vector<vec3>& points) {
  std::vector<std::uint32_t> first(points.size());
  core::index_table table;                                                           // the first one of equal points
  const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x + 0.0); };  // -0 is 0
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    first[i] = i;
    const vec3& x = points[i];
    if (!is_finite(x)) continue;
    std::uint32_t h = 0;
    for (std::size_t k = 0; k < 3; ++k) h = core::index_table::hash(bits(x[k]), h);
    const std::uint32_t found = table.find(h, [&](std::uint32_t n) { return points[n] == x; });
    if (found == core::index_table::none) table.add(h, i);
    else first[i] = found;
  }
  return first;
}

/// Points in small cells, all of whose points are close to each other, and the cells in blocks.
class cells_of_points {
  using cell = chains_by_cell::cell;
  const std::vector<vec3>& points_;
  double tolerance_, size_;  // of a cell, a quarter of it, as differences of large coordinates overflow
  bool connects_cells_;      // a cell is so small that its points are close
  vec3 low_;
  std::vector<std::uint32_t> all_;    // the points, by cell
  std::vector<std::uint32_t> first_;  // by cell: where its points begin
  std::vector<cell> cells_;

  std::int64_t position(double x, double low) const {
    return static_cast<std::int64_t>(std::floor((0.25 * x - 0.25 * low) / size_));
  }
  cell cell_of(const vec3& x) const { return {position(x.x, low_.x), position(x.y, low_.y), position(x.z, low_.z)}; }
  static cell block_of(const cell& c, std::int64_t by = 0) {
    return {(c[0] + by) >> 2, (c[1] + by) >> 2, (c[2] + by) >> 2};
  }
  std::span<const std::uint32_t> points_in(std::uint32_t c) const {
    return {all_.data() + first_[c], all_.data() + first_[c + 1]};
  }
  bool are_close(std::uint32_t i, std::uint32_t j) const { return distance(points_[i], points_[j]) <= tolerance_; }

  void unite_cells(std::uint32_t a, std::uint32_t b, disjoint_sets& sets) const {
    if (connects_cells_ && sets.are_united(points_in(a)[0], points_in(b)[0])) return;
    for (const std::uint32_t i : points_in(a))
      for (const std::uint32_t j : points_in(b))
        if (are_close(i, j)) {
          sets.unite(i, j);
          if (connects_cells_) return;
        }
  }

 public:
  /// The points are first points of sets, finite and different.
  cells_of_points(const std::vector<vec3>& points, const std::vector<std::uint32_t>& chosen, double tolerance)
      : points_(points), tolerance_(tolerance) {
    vec3 high = low_ = points[chosen[0]];
    for (const std::uint32_t i : chosen)
      for (const std::size_t k : {0u, 1u, 2u})
        low_[k] = std::min(low_[k], points[i][k]), high[k] = std::max(high[k], points[i][k]);
    const vec3 extent = 0.25 * high - 0.25 * low_;
    const double smallest = 0x1p-40 * std::max({extent.x, extent.y, extent.z}), wanted = 0.57 * (0.25 * tolerance);
    size_ = std::max(wanted, smallest);
    connects_cells_ = wanted > smallest;
    if (!(size_ > 0)) size_ = 1;
    chains_by_cell by_cell(chosen.size());
    std::vector<std::uint32_t> cell_of_point(chosen.size());
    first_.assign(1, 0);
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const cell c = cell_of(points[chosen[i]]);
      std::uint32_t number = by_cell.last(c);
      if (number == chains_by_cell::none) {
        number = static_cast<std::uint32_t>(cells_.size());
        by_cell.add(c, number);
        cells_.push_back(c);
        first_.push_back(0);
      }
      cell_of_point[i] = number;
      ++first_[number + 1];
    }
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    all_.resize(chosen.size());
    std::vector<std::uint32_t> end(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < chosen.size(); ++i) all_[end[cell_of_point[i]]++] = chosen[i];
  }

  /// Points that are close are at most two cells apart, so they are in blocks of four cells that a box of five meets.
  void unite(disjoint_sets& sets) const {
    chains_by_cell by_block(cells_.size());
    for (std::uint32_t c = 0; c < cells_.size(); ++c) {
      const auto here = points_in(c);
      for (std::size_t i = 1; i < here.size(); ++i)
        for (std::size_t j = connects_cells_ ? i - 1 : 0; j < i; ++j)
          if (connects_cells_ || are_close(here[i], here[j])) sets.unite(here[i], here[j]);
      const cell from = block_of(cells_[c], -2), to = block_of(cells_[c], 2);
      cell b;
      for (b[0] = from[0]; b[0] <= to[0]; ++b[0])
        for (b[1] = from[1]; b[1] <= to[1]; ++b[1])
          for (b[2] = from[2]; b[2] <= to[2]; ++b[2])
            for (std::uint32_t d = by_block.last(b); d != chains_by_cell::none; d = by_block.previous(d))
              if (are_neighbours(c, d)) unite_cells(c, d, sets);
      by_block.add(block_of(cells_[c]), c);
    }
  }

 private:
  bool are_neighbours(std::uint32_t c, std::uint32_t d) const {
    for (const std::size_t k : {0u, 1u, 2u})
      if (std::abs(cells_[c][k] - cells_[d][k]) > 2) return false;
    return true;
  }
};

/// The mean of points, which does not depend on their order; exact if they are equal.
inline vec3 mean_of(std::vector<vec3>& points) {
  std::sort(points.begin(), points.end(), [](const vec3& a, const vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  });
  vec3 mean = points[0];
  for (const vec3& x : points) mean += (x - points[0]) / static_cast<double>(points.size());
  return mean;
}

CONCINO_INLINE point_clusters find_clusters(std::vector<vec3> points, double tolerance) {
  point_clusters result{first_equal_points(points), {}};
  std::vector<std::uint32_t> different;
  if (tolerance > 0)
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (result.first[i] == i && is_finite(points[i])) different.push_back(i);
  if (different.empty()) {
    result.mean = std::move(points);
    return result;
  }
  disjoint_sets sets(points.size());
  cells_of_points(points, different, tolerance).unite(sets);
  std::vector<std::uint32_t> next(points.size(), ~0u);  // the points of a cluster, in a ring
  std::vector<std::uint32_t> mixed;                     // clusters of different points
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto root = static_cast<std::uint32_t>(sets.root(result.first[i]));
    if (root == i) continue;
    if (next[root] == ~0u) next[i] = root, mixed.push_back(root);
    else next[i] = next[root];
    next[root] = i;
    result.first[i] = root;
  }
  result.mean = std::move(points);
  std::vector<vec3> members;
  for (const std::uint32_t root : mixed) {
    members.assign(1, result.mean[root]);
    bool differs = false;
    for (std::uint32_t i = next[root]; i != root; i = next[i]) {
      members.push_back(result.mean[i]);
      differs = differs || !(result.mean[i] == result.mean[root]);
    }
    if (differs) result.mean[root] = mean_of(members);
  }
  return result;
}

}  // namespace concino::detail
