// The sites of a Voronoi diagram, rounded to an integer lattice so that distances are compared exactly, and sorted into
// a grid of bins.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/bounding_box.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Sites in a box of D dimensions, each coordinate an integer from 0 to at most 2^49: the lattice divides the longest
/// side of the box by 2^48 or more.
template<int D>
class site_lattice {
 public:
  using grid_corner = std::array<std::int64_t, D>;
  static constexpr int bits = 49;  // so that the determinants of D + 1 bisectors fit into 256 bits

  template<class Sites>
  site_lattice(const Sites& sites, const box& domain) : domain_(domain) {
    double longest = 0;
    for (std::size_t k = 0; k < D; ++k) {
      const double length = domain.max[k] - domain.min[k];
      if (!(length > 0) || !std::isfinite(length))
        core::throw_joined<invalid_argument>(
            {"Voronoi diagram: the box must have finite corners, max above min, and a finite size"});
      longest = std::max(longest, length);
    }
    std::frexp(longest, &exponent_);
    exponent_ -= bits;
    for (std::size_t k = 0; k < D; ++k) {
      size_[k] = to_lattice(domain.max[k], k);
      if (size_[k] < 1 << 16)
        core::throw_joined<invalid_argument>(
            {"Voronoi diagram: the box is more than 2^32 times as long as it is wide"});
    }
    std::size_t i = 0;
    for (const auto& site : sites) {
      const vec3 x = to_vec3(site);
      grid_corner p{};
      for (std::size_t k = 0; k < D; ++k) {
        if (!(x[k] >= domain.min[k] && x[k] <= domain.max[k]))
          core::throw_joined<invalid_argument>({"Voronoi diagram: site ", i, " is not finite or lies outside the box"});
        p[k] = to_lattice(x[k], k);
      }
      points_.push_back(p);
      ++i;
    }
    if (points_.empty()) core::throw_joined<invalid_argument>({"Voronoi diagram: there must be at least one site"});
    if (points_.size() >= 0xffffff00u)
      core::throw_joined<invalid_argument>(
          {"Voronoi diagram: there are ", points_.size(), " sites; 32 bits cannot number them"});
    sort_into_bins();
  }

  std::uint32_t size() const { return static_cast<std::uint32_t>(points_.size()); }
  const grid_corner& operator[](std::size_t i) const { return points_[i]; }
  std::int64_t length(std::size_t k) const { return size_[k]; }

  /// Converts a coordinate from lattice steps back to the box. Walls of the box are exact.
  double from_lattice(double x, std::size_t k) const {
    if (x >= static_cast<double>(size_[k])) return domain_.max[k];
    return std::clamp(domain_.min[k] + std::ldexp(x, exponent_), domain_.min[k], domain_.max[k]);
  }
  /// The lattice point next to x, which may lie outside of the box.
  grid_corner rounded(const vec3& x) const {
    grid_corner p{};
    for (std::size_t k = 0; k < D; ++k) p[k] = to_lattice(x[k], k);
    return p;
  }
  const box& domain() const { return domain_; }

  /// Calls visit(j, squared distance) for the other sites near site i, one ring of bins after the other, until no site
  /// within radius() is left. radius() is a distance in lattice steps, and is called again after each ring.
  template<class Radius, class Visit>
  void for_each_near(std::uint32_t i, const Radius& radius, std::vector<std::pair<double, std::uint32_t>>& ring,
                     const Visit& visit) const {
    const grid_corner& x = points_[i];
    grid_corner centre;
    for (std::size_t k = 0; k < D; ++k) centre[k] = bin_of(x[k], k);
    for (std::int64_t s = 0;; ++s) {
      ring.clear();
      collect(i, centre, s, radius(), ring);
      std::sort(ring.begin(), ring.end());
      for (const auto& [squared, j] : ring) visit(j, squared);
      // The remaining sites lie outside the block of bins up to ring s.
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < D; ++k) {
        if (centre[k] - s > 0) nearest = std::min(nearest, static_cast<double>(x[k] - (centre[k] - s) * width_[k]));
        if (centre[k] + s + 1 < bins_[k])
          nearest = std::min(nearest, static_cast<double>((centre[k] + s + 1) * width_[k] - x[k]));
      }
      if (nearest > radius()) return;
    }
  }

 private:
  box domain_;
  int exponent_ = 0;  // the lattice step is 2^exponent_
  grid_corner size_{};      // of the box, in lattice steps
  std::vector<grid_corner> points_;
  grid_corner bins_{}, width_{};
  std::vector<std::uint32_t> first_, sites_;  // the sites of each bin

  std::int64_t to_lattice(double x, std::size_t k) const {
    return std::llround(std::ldexp(x - domain_.min[k], -exponent_));
  }
  std::int64_t bin_of(std::int64_t x, std::size_t k) const { return std::min(x / width_[k], bins_[k] - 1); }

  std::size_t bin_of(const grid_corner& x) const {
    std::int64_t b = 0;
    for (std::size_t k = D; k-- > 0;) b = b * bins_[k] + bin_of(x[k], k);
    return static_cast<std::size_t>(b);
  }

  /// Sorts the sites into bins that are as close to cubes as the box allows, with two sites in each on average.
  void sort_into_bins() {
    bins_.fill(0);
    for (std::size_t again = 0; again < D; ++again) {  // a side shorter than a bin gets one bin; the numbers along the
                                                       // other sides are then computed again
      double content = 2 / static_cast<double>(points_.size());
      int free = 0;
      for (std::size_t k = 0; k < D; ++k)
        if (bins_[k] != 1) content *= static_cast<double>(size_[k]), ++free;
      if (free == 0) break;
      const double edge = std::pow(content, 1.0 / free);
      for (std::size_t k = 0; k < D; ++k)
        if (bins_[k] != 1)
          bins_[k] = std::max<std::int64_t>(1, static_cast<std::int64_t>(static_cast<double>(size_[k]) / edge));
    }
    std::size_t total = 1;
    for (std::size_t k = 0; k < D; ++k) {
      width_[k] = size_[k] / bins_[k] + 1;
      total *= static_cast<std::size_t>(bins_[k]);
    }
    first_.assign(total + 1, 0);
    for (const grid_corner& x : points_) ++first_[bin_of(x) + 1];
    for (std::size_t b = 0; b < total; ++b) first_[b + 1] += first_[b];
    auto next = first_;
    sites_.resize(points_.size());
    for (std::uint32_t i = 0; i < size(); ++i) sites_[next[bin_of(points_[i])]++] = i;
  }

  /// Collects the sites within `radius` of site i in the bins at Chebyshev distance s from the bin `centre`, counted in
  /// bins.
  void collect(std::uint32_t i, const grid_corner& centre, std::int64_t s, double radius,
               std::vector<std::pair<double, std::uint32_t>>& out) const {
    grid_corner low, high, at;
    for (std::size_t k = 0; k < D; ++k) {
      low[k] = std::max<std::int64_t>(0, centre[k] - s);
      high[k] = std::min(bins_[k] - 1, centre[k] + s);
    }
    at = low;
    for (;;) {
      bool edge = s == 0;
      for (std::size_t k = 1; k < D; ++k) edge = edge || std::abs(at[k] - centre[k]) == s;
      // Along the first axis: all bins, or only those at the two ends.
      const std::int64_t step = edge ? 1 : 2 * s;
      for (at[0] = edge ? low[0] : centre[0] - s; at[0] <= high[0]; at[0] += step)
        if (at[0] >= low[0]) take(i, at, radius, out);
      std::size_t k = 1;
      while (k < D && ++at[k] > high[k]) at[k] = low[k], ++k;
      if (k == D) return;
    }
  }

  void take(std::uint32_t i, const grid_corner& at, double radius,
            std::vector<std::pair<double, std::uint32_t>>& out) const {
    const grid_corner& x = points_[i];
    std::int64_t b = 0;
    for (std::size_t k = D; k-- > 0;) b = b * bins_[k] + at[k];
    for (std::uint32_t n = first_[static_cast<std::size_t>(b)]; n < first_[static_cast<std::size_t>(b) + 1]; ++n) {
      const std::uint32_t j = sites_[n];
      if (j == i) continue;
      double squared = 0;
      for (std::size_t k = 0; k < D; ++k) {
        const auto d = static_cast<double>(points_[j][k] - x[k]);
        squared += d * d;
      }
      if (squared == 0)
        core::throw_joined<invalid_argument>(
            {"Voronoi diagram: sites ", std::min(i, j), " and ", std::max(i, j),
             " are the same point, up to rounding errors of the box's size; remove one of them"});
      if (squared <= radius * radius) out.push_back({squared, j});
    }
  }
};

}  // namespace concino::detail
