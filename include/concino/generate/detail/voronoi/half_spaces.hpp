// The half-spaces that bound a Voronoi cell, the corners where their planes meet, and exact tests of the side of a
// plane on which a corner lies. They use doubles where these suffice, and integers otherwise.
#pragma once

#include <concino/generate/detail/voronoi/site_lattice.hpp>
#include <concino/generate/detail/voronoi/wide_integer.hpp>

#include <cassert>
#include <span>

namespace concino::detail {

template<class T>
constexpr T det(const std::array<T, 2>& a, const std::array<T, 2>& b) {
  return a[0] * b[1] - a[1] * b[0];
}
template<class T>
constexpr std::array<T, 3> cross_of(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template<class T> constexpr T det(const std::array<T, 3>& a, const std::array<T, 3>& b, const std::array<T, 3>& c) {
  const auto n = cross_of(b, c);
  return a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
}

/// A plane that bounds the domain, in lattice steps: {x : 2 n.x <= c} is inside. |n[k]| <= 2^48.
template<int D>
struct lattice_plane {
  std::array<std::int64_t, D> n;
  int128 c;
};

/// Errors: invalid_argument that names a site outside of the walls of `domain`.
template<int D>
void check_inside(const site_lattice<D>& sites, std::span<const lattice_plane<D>> walls, const char* domain) {
  for (std::uint32_t i = 0; i < sites.size(); ++i)
    for (const lattice_plane<D>& w : walls) {
      int128 c = w.c;
      for (std::size_t k = 0; k < D; ++k) c -= 2 * static_cast<int128>(w.n[k]) * sites[i][k];
      if (c < 0) core::throw_joined<invalid_argument>({"Voronoi diagram: site ", i, " lies outside of the ", domain});
    }
}

/// The half-spaces whose intersection is the cell of one site: {y : 2 n.y <= c}, with the site at the origin, in
/// lattice steps. The first 2 D are the walls of the box (minus before plus in each direction), the others bisectors
/// and further walls. Sites have infinitesimal weights, larger for lower indices, and further walls still smaller
/// displacements, so that none of these planes ever passes through the common point of D others.
/// Source: Edelsbrunner and Muecke 1990, "Simulation of simplicity".
template<int D>
class half_spaces {
 public:
  static constexpr std::uint32_t no_site = ~0u;
  static constexpr double unit = 0x1p-53 * 64;  // more than the rounding errors of any sum here

  /// The common point of D planes.
  struct corner {
    std::array<std::uint32_t, D> planes;
    std::array<double, D> y;  // twice the position times w
    double w;
    double y_size, w_size;  // bounds for the rounding errors of y and w, in multiples of `unit`
    double squared_radius;   // an upper bound of the squared distance from the site
  };

  void begin(const site_lattice<D>& sites, std::uint32_t site) {
    site_ = site;
    num_sites_ = sites.size();
    planes_.clear();
    for (std::size_t k = 0; k < D; ++k) {
      std::array<std::int64_t, D> n{};
      n[k] = -1;
      add(n, 2 * sites[site][k], no_site);
      n[k] = 1;
      add(n, 2 * (sites.length(k) - sites[site][k]), no_site);
    }
  }
  void add_bisector(const site_lattice<D>& sites, std::uint32_t other) {
    std::array<std::int64_t, D> n;
    int128 c = 0;
    for (std::size_t k = 0; k < D; ++k) {
      n[k] = sites[other][k] - sites[site_][k];
      c += static_cast<int128>(n[k]) * n[k];
    }
    add(n, c, other);
  }
  /// A further wall of the domain; its number follows those of the sites and of the walls of the box.
  void add_wall(const site_lattice<D>& sites, const lattice_plane<D>& wall, std::uint32_t number) {
    int128 c = wall.c;
    for (std::size_t k = 0; k < D; ++k) c -= 2 * static_cast<int128>(wall.n[k]) * sites[site_][k];
    add(wall.n, c, number);
  }
  /// A lower bound of twice the distance of the last plane from the site.
  double twice_distance_of_last() const { return planes_.back().rounded_c / planes_.back().length * (1 - 4 * unit); }
  void drop_last() { planes_.pop_back(); }
  std::uint32_t last() const { return static_cast<std::uint32_t>(planes_.size() - 1); }
  /// The site on the other side of a plane; no_site for walls of the box; the number of another wall.
  std::uint32_t beyond(std::uint32_t plane) const { return planes_[plane].other; }

  /// The corner of D planes. They are in an order in which their normals have a positive determinant.
  corner meet(const std::array<std::uint32_t, D>& at) const {
    corner v{at, {}, 0, 0, 1, 0};
    solve<double>(
        at, [](const half_space& p) { return p.rounded_n; }, [](const half_space& p) { return p.rounded_c; }, v.y, v.w);
    for (std::size_t k = 0; k < D; ++k) {
      double product = planes_[at[k]].rounded_c;
      for (std::size_t j = 0; j < D; ++j)
        if (j != k) product *= planes_[at[j]].length;
      v.y_size += product;
      v.w_size *= planes_[at[k]].length;
    }
    if (v.w < 0x1p20 * unit * v.w_size) solve_well(v);  // half of the digits are lost
    const double r = (size_of(v) + unit * v.y_size) / (v.w - unit * v.w_size) / 2 * (1 + unit);
    v.squared_radius = r * r;
    return v;
  }

  /// The position of a corner relative to the site, accurate to a few lattice steps.
  std::array<double, D> position(corner v) const {
    if (unit * (v.y_size + size_of(v) / v.w * v.w_size) > 8 * v.w) solve_well(v);
    for (double& x : v.y) x /= 2 * v.w;
    return v.y;
  }

  /// Whether a corner lies outside half-space m.
  bool is_beyond(const corner& v, std::uint32_t m) const {
    const half_space& p = planes_[m];
    double f = -p.rounded_c * v.w;
    for (std::size_t k = 0; k < D; ++k) f += p.rounded_n[k] * v.y[k];
    const double error = unit * (p.length * v.y_size + p.rounded_c * v.w_size);
    if (f > error) return true;
    if (f < -error) return false;
    return is_beyond_exactly(v, m);
  }

 private:
  struct half_space {
    std::array<std::int64_t, D> n;
    std::array<double, D> rounded_n;  // exact as well
    int128 c;
    double rounded_c, length;  // length: an upper bound of the length of n
    std::uint32_t other;
  };

  std::uint32_t site_ = 0, num_sites_ = 0;
  std::vector<half_space> planes_;

  void add(const std::array<std::int64_t, D>& n, int128 c, std::uint32_t other) {
    half_space p{n, {}, c, static_cast<double>(c), 0, other};
    double squared = 0;
    for (std::size_t k = 0; k < D; ++k) {
      p.rounded_n[k] = static_cast<double>(n[k]);
      squared += p.rounded_n[k] * p.rounded_n[k];
    }
    p.length = std::sqrt(squared) * (1 + unit);
    planes_.push_back(p);
  }

  /// Computes the common point of D planes in homogeneous coordinates, with numbers of type T.
  template<class T, class Normal, class Offset>
  void solve(const std::array<std::uint32_t, D>& at, const Normal& normal, const Offset& offset, std::array<T, D>& y,
             T& w) const {
    const auto a = normal(planes_[at[0]]), b = normal(planes_[at[1]]);
    const T ca = offset(planes_[at[0]]), cb = offset(planes_[at[1]]);
    if constexpr (D == 2) {
      y = {ca * b[1] - cb * a[1], a[0] * cb - b[0] * ca};
      w = det(a, b);
    } else {
      const auto c = normal(planes_[at[2]]);
      const T cc = offset(planes_[at[2]]);
      const auto bc = cross_of(b, c), ca_ = cross_of(c, a), ab = cross_of(a, b);
      for (std::size_t k = 0; k < D; ++k) y[k] = ca * bc[k] + cb * ca_[k] + cc * ab[k];
      w = a[0] * bc[0] + a[1] * bc[1] + a[2] * bc[2];
    }
  }
  static std::array<int256, D> exact_normal(const half_space& p) {
    std::array<int256, D> n;
    for (std::size_t k = 0; k < D; ++k) n[k] = p.n[k];
    return n;
  }
  void solve_exactly(const std::array<std::uint32_t, D>& at, std::array<int256, D>& y, int256& w) const {
    solve<int256>(at, exact_normal, [](const half_space& p) { return int256(p.c); }, y, w);
  }

  /// Computes a corner with all digits correct.
  void solve_well(corner& v) const {
    std::array<int256, D> y;
    int256 w;
    solve_exactly(v.planes, y, w);
    assert(w.sign() > 0);
    for (std::size_t k = 0; k < D; ++k) v.y[k] = y[k].to_double();
    v.w = w.to_double();
    v.y_size = size_of(v);
    v.w_size = v.w;
  }

  static double size_of(const corner& v) {
    double squared = 0;
    for (const double x : v.y) squared += x * x;
    return std::sqrt(squared) * (1 + unit);
  }

  bool is_beyond_exactly(const corner& v, std::uint32_t m) const {
    std::array<int256, D> y;
    int256 w;
    solve_exactly(v.planes, y, w);
    const half_space& p = planes_[m];
    int256 f = -(int256(p.c) * w);
    for (std::size_t k = 0; k < D; ++k) f = f + int256(p.n[k]) * y[k];
    if (f.sign() != 0) return f.sign() > 0;

    // D + 2 sites lie on one sphere: the weights decide, first that of the lowest relevant index. c is |n|^2 + own
    // weight - weight of the other; that of a wall is c + its displacement.
    std::uint32_t lowest = no_site;
    int sign = 0;
    const auto weigh = [&](std::uint32_t site, const int256& weight) {
      const int s = weight.sign();
      if (s == 0 || (sign != 0 && lowest < site)) return;
      lowest = site;
      sign = s;
    };
    const auto is_site = [&](std::uint32_t other) { return other < num_sites_; };
    int256 own = is_site(p.other) ? -w : int256(std::int64_t{0});
    weigh(p.other, is_site(p.other) ? w : -w);
    for (std::size_t k = 0; k < D; ++k) {
      const half_space& q = planes_[v.planes[k]];
      if (q.other == no_site) continue;
      auto planes = v.planes;
      planes[k] = m;
      const int256 slope = [&] {
        const auto a = exact_normal(planes_[planes[0]]), b = exact_normal(planes_[planes[1]]);
        if constexpr (D == 2) return det(a, b);
        else return det(a, b, exact_normal(planes_[planes[2]]));
      }();
      if (is_site(q.other)) own = own + slope;
      weigh(q.other, is_site(q.other) ? -slope : slope);
    }
    weigh(site_, own);
    assert(sign != 0 && "the sum includes the weight of the cutting site, so it is not 0");
    return sign > 0;
  }
};

}  // namespace concino::detail
