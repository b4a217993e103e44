// One cell of a Voronoi diagram: a box cut by the bisectors to other sites. All decisions are exact, so neighbouring
// cells agree on shared elements.
#pragma once

#include <concino/generate/detail/voronoi/half_spaces.hpp>

namespace concino::detail {

/// The cell of one site, with the site as origin. Each vert has exactly D planes, counter-clockwise. A vert where more
/// planes meet is represented by several verts at the same position.
/// Source: cutting as Ray, Sokolov, Lefebvre and Levy 2018, "Meshless Voronoi on the GPU".
template<int D>
class voronoi_cell {
 public:
  using vert = typename half_spaces<D>::corner;

  void begin(const site_lattice<D>& sites, std::uint32_t site) {
    planes_.begin(sites, site);
    verts_.clear();
    if constexpr (D == 2) {
      for (const auto& [a, b] : {std::array{2u, 1u}, std::array{1u, 3u}, std::array{3u, 0u}, std::array{0u, 2u}})
        add_vert({a, b});
    } else {
      for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const std::uint32_t x = corner & 1, y = 2 + (corner >> 1 & 1), z = 4 + (corner >> 2);
        if (((corner ^ corner >> 1 ^ corner >> 2) & 1) != 0) add_vert({x, y, z});
        else add_vert({x, z, y});
      }
    }
    find_security_radius();
  }

  /// Removes the part that is nearer to the other site.
  void cut(const site_lattice<D>& sites, std::uint32_t other) {
    planes_.add_bisector(sites, other);
    cut_last();
  }

  /// Removes the part outside of a wall of the domain.
  void cut(const site_lattice<D>& sites, const lattice_plane<D>& wall, std::uint32_t number) {
    planes_.add_wall(sites, wall, number);
    if (planes_.twice_distance_of_last() > security_radius_) planes_.drop_last();
    else cut_last();
  }

  /// The distance beyond which no site can cut the cell.
  double security_radius() const { return security_radius_; }
  const std::vector<vert>& verts() const { return verts_; }
  /// The site on the other side of a plane; none for walls of the box, which are the first 2 D planes; the number of
  /// another wall.
  std::uint32_t beyond(std::uint32_t plane) const { return planes_.beyond(plane); }
  /// The position of a vert relative to the site.
  std::array<double, D> position(const vert& v) const { return planes_.position(v); }

 private:
  half_spaces<D> planes_;
  std::vector<vert> verts_;
  std::vector<std::array<std::uint32_t, 2>> horizon_;
  double security_radius_ = 0;

  void cut_last() {
    const std::uint32_t m = planes_.last();
    horizon_.clear();
    bool any = false;
    for (std::size_t i = 0; i < verts_.size();) {
      if (!planes_.is_beyond(verts_[i], m)) {
        ++i;
        continue;
      }
      any = true;
      toggle(verts_[i].planes);
      verts_[i] = verts_.back();
      verts_.pop_back();
    }
    if (!any) {
      planes_.drop_last();
      return;
    }
    assert(!verts_.empty() && horizon_.size() >= D);
    if constexpr (D == 2) {
      for (const auto& [k, first] : horizon_) first ? add_vert({k, m}) : add_vert({m, k});
    } else {
      for (const auto& [a, b] : horizon_) add_vert({a, b, m});
    }
    find_security_radius();
  }

  void add_vert(const std::array<std::uint32_t, D>& at) { verts_.push_back(planes_.meet(at)); }

  void find_security_radius() {
    double squared = 0;
    for (const vert& v : verts_) squared = std::max(squared, v.squared_radius);
    security_radius_ = 2 * std::sqrt(squared) * (1 + planes_.unit);
  }

  /// Updates horizon_ for a vert that is removed. It separates removed verts from the others: two planes (D = 2,
  /// {plane, whether it comes first}) or edges {plane, plane}.
  void toggle(const std::array<std::uint32_t, D>& at) {
    if constexpr (D == 2) {
      toggle_one({at[0], 1u}, {at[0], 0u});
      toggle_one({at[1], 0u}, {at[1], 1u});
    } else {
      for (std::size_t k = 0; k < D; ++k) toggle_one({at[k], at[(k + 1) % D]}, {at[(k + 1) % D], at[k]});
    }
  }
  void toggle_one(const std::array<std::uint32_t, 2>& x, const std::array<std::uint32_t, 2>& opposite) {
    for (auto& r : horizon_)
      if (r == opposite) {
        r = horizon_.back();
        horizon_.pop_back();
        return;
      }
    horizon_.push_back(x);
  }
};

}  // namespace concino::detail
