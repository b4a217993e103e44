// One cell of a Voronoi diagram: a box cut by the bisectors to other sites, by exact decisions, so that neighbours agree on all they share.
#pragma once

#include <concino/generate/detail/site_lattice.hpp>
#include <concino/generate/detail/wide_integer.hpp>

#include <cassert>

namespace concino::detail {

template<class T> constexpr T det(const std::array<T, 2>& a, const std::array<T, 2>& b) { return a[0] * b[1] - a[1] * b[0]; }
template<class T>
constexpr std::array<T, 3> cross_of(const std::array<T, 3>& a, const std::array<T, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template<class T> constexpr T det(const std::array<T, 3>& a, const std::array<T, 3>& b, const std::array<T, 3>& c) {
  const auto n = cross_of(b, c);
  return a[0] * n[0] + a[1] * n[1] + a[2] * n[2];
}

/// The cell of one site, seen from it, in lattice steps. Planes bound it: {y : 2 n.y <= c}; the first 2 D are the walls of the box, minus before plus in
/// each direction, the others bisectors. Sites carry infinitely small weights, larger ones for lower indices, so that no plane ever passes through a vert
/// of others: each vert has exactly D planes, and what in truth is one vert may come as several in the same place.
/// Source: Edelsbrunner and Muecke 1990, "Simulation of simplicity"; cutting as Ray, Sokolov, Lefebvre and Levy 2018, "Meshless Voronoi on the GPU".
template<int D>
class voronoi_cell {
 public:
  static constexpr std::uint32_t no_site = ~0u;

  struct vert {
    std::array<std::uint32_t, D> planes;  // counter-clockwise: their normals have a positive determinant
    std::array<double, D> y;              // twice the place times w
    double w;
    double y_size, w_size;  // by these the rounding errors of y and w are bounded
    double squared_reach;   // at least the square of the distance from the site
  };

  void begin(const site_lattice<D>& sites, std::uint32_t site) {
    site_ = site;
    planes_.clear();
    verts_.clear();
    for (std::size_t k = 0; k < D; ++k) {
      std::array<std::int64_t, D> n{};
      n[k] = -1;
      add_plane(n, 2 * sites[site][k], no_site);
      n[k] = 1;
      add_plane(n, 2 * (sites.side(k) - sites[site][k]), no_site);
    }
    if constexpr (D == 2) {
      for (const auto& [a, b] : {std::array{2u, 1u}, std::array{1u, 3u}, std::array{3u, 0u}, std::array{0u, 2u}}) add_vert({a, b});
    } else {
      for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const std::uint32_t x = corner & 1, y = 2 + (corner >> 1 & 1), z = 4 + (corner >> 2);
        if (((corner ^ corner >> 1 ^ corner >> 2) & 1) != 0) add_vert({x, y, z});
        else add_vert({x, z, y});
      }
    }
    find_reach();
  }

  /// Takes away what is nearer to the other site.
  void cut(const site_lattice<D>& sites, std::uint32_t other) {
    std::array<std::int64_t, D> n;
    int128 c = 0;
    for (std::size_t k = 0; k < D; ++k) {
      n[k] = sites[other][k] - sites[site_][k];
      c += static_cast<int128>(n[k]) * n[k];
    }
    add_plane(n, c, other);
    const auto m = static_cast<std::uint32_t>(planes_.size() - 1);
    rim_.clear();
    bool any = false;
    for (std::size_t i = 0; i < verts_.size();) {
      if (!is_beyond(verts_[i], m)) {
        ++i;
        continue;
      }
      any = true;
      toggle(verts_[i].planes);
      verts_[i] = verts_.back();
      verts_.pop_back();
    }
    if (!any) {
      planes_.pop_back();
      return;
    }
    assert(!verts_.empty() && rim_.size() >= D);
    if constexpr (D == 2) {
      for (const auto& [k, first] : rim_) first ? add_vert({k, m}) : add_vert({m, k});
    } else {
      for (const auto& [a, b] : rim_) add_vert({a, b, m});
    }
    find_reach();
  }

  /// No site farther away than this can cut.
  double reach() const { return reach_; }
  std::uint32_t site() const { return site_; }
  const std::vector<vert>& verts() const { return verts_; }
  std::size_t num_planes() const { return planes_.size(); }
  /// The site beyond a plane; of walls no_site.
  std::uint32_t beyond(std::uint32_t plane) const { return planes_[plane].other; }
  /// Where a vert is, as seen from the site.
  static double place(const vert& v, std::size_t k) { return v.y[k] / v.w / 2; }

 private:
  struct half_space {
    std::array<std::int64_t, D> n;
    std::array<double, D> rounded_n;  // exact, too
    int128 c;
    double rounded_c, length;  // length: of n, at least
    std::uint32_t other;
  };

  static constexpr double unit = 0x1p-53 * 64;  // more roundings than any of the sums below sees

  std::uint32_t site_ = 0;
  std::vector<half_space> planes_;
  std::vector<vert> verts_;
  std::vector<std::array<std::uint32_t, 2>> rim_;
  double reach_ = 0;

  void add_plane(const std::array<std::int64_t, D>& n, int128 c, std::uint32_t other) {
    half_space p{n, {}, c, static_cast<double>(c), 0, other};
    double squared = 0;
    for (std::size_t k = 0; k < D; ++k) {
      p.rounded_n[k] = static_cast<double>(n[k]);
      squared += p.rounded_n[k] * p.rounded_n[k];
    }
    p.length = std::sqrt(squared) * (1 + unit);
    planes_.push_back(p);
  }

  /// The common point of D planes, homogeneous, in any numbers.
  template<class T, class Normal, class Offset>
  void meet(const std::array<std::uint32_t, D>& at, const Normal& normal, const Offset& offset, std::array<T, D>& y, T& w) const {
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
  void meet_exactly(const std::array<std::uint32_t, D>& at, std::array<int256, D>& y, int256& w) const {
    meet<int256>(at, exact_normal, [](const half_space& p) { return int256(p.c); }, y, w);
  }

  void add_vert(const std::array<std::uint32_t, D>& at) {
    vert v{at, {}, 0, 0, 1, 0};
    meet<double>(at, [](const half_space& p) { return p.rounded_n; }, [](const half_space& p) { return p.rounded_c; }, v.y, v.w);
    for (std::size_t k = 0; k < D; ++k) {
      double product = planes_[at[k]].rounded_c;
      for (std::size_t j = 0; j < D; ++j)
        if (j != k) product *= planes_[at[j]].length;
      v.y_size += product;
      v.w_size *= planes_[at[k]].length;
    }
    if (v.w < 0x1p20 * unit * v.w_size || size_of(v) < 0x1p10 * unit * v.y_size) {  // more than a third of the digits are lost
      std::array<int256, D> y;
      int256 w;
      meet_exactly(at, y, w);
      assert(w.sign() > 0);
      for (std::size_t k = 0; k < D; ++k) v.y[k] = y[k].to_double();
      v.w = w.to_double();
      v.y_size = size_of(v);
      v.w_size = v.w;
    }
    const double r = (size_of(v) + unit * v.y_size) / (v.w - unit * v.w_size) / 2 * (1 + unit);
    v.squared_reach = r * r;
    verts_.push_back(v);
  }

  static double size_of(const vert& v) {
    double squared = 0;
    for (const double x : v.y) squared += x * x;
    return std::sqrt(squared) * (1 + unit);
  }

  void find_reach() {
    double squared = 0;
    for (const vert& v : verts_) squared = std::max(squared, v.squared_reach);
    reach_ = 2 * std::sqrt(squared) * (1 + unit);
  }

  bool is_beyond(const vert& v, std::uint32_t m) const {
    const half_space& p = planes_[m];
    double f = -p.rounded_c * v.w;
    for (std::size_t k = 0; k < D; ++k) f += p.rounded_n[k] * v.y[k];
    const double error = unit * (p.length * v.y_size + p.rounded_c * v.w_size);
    if (f > error) return true;
    if (f < -error) return false;
    return is_beyond_exactly(v, m);
  }

  [[gnu::noinline]] bool is_beyond_exactly(const vert& v, std::uint32_t m) const {
    std::array<int256, D> y;
    int256 w;
    meet_exactly(v.planes, y, w);
    const half_space& p = planes_[m];
    int256 f = -(int256(p.c) * w);
    for (std::size_t k = 0; k < D; ++k) f = f + int256(p.n[k]) * y[k];
    if (f.sign() != 0) return f.sign() > 0;

    // D + 2 sites on one sphere: the weights decide, that of the lowest index that matters. c is |n|^2 + weight here - weight of the other.
    std::array<std::pair<std::uint32_t, int256>, D + 2> weighted;
    std::size_t count = 0;
    int256 own = -w;
    weighted[count++] = {p.other, w};
    for (std::size_t k = 0; k < D; ++k) {
      const half_space& q = planes_[v.planes[k]];
      if (q.other == no_site) continue;
      auto planes = v.planes;
      planes[k] = m;
      const int256 slope = [&] {
        if constexpr (D == 2) return det(exact_normal(planes_[planes[0]]), exact_normal(planes_[planes[1]]));
        else return det(exact_normal(planes_[planes[0]]), exact_normal(planes_[planes[1]]), exact_normal(planes_[planes[2]]));
      }();
      own = own + slope;
      weighted[count++] = {q.other, -slope};
    }
    weighted[count++] = {site_, own};
    std::sort(weighted.begin(), weighted.begin() + static_cast<std::ptrdiff_t>(count), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < count; ++k)
      if (const int s = weighted[k].second.sign()) return s > 0;
    assert(false && "the weight of the site that cuts matters always");
    return false;
  }

  /// Keeps in rim_ what separates the verts that go from those that stay: two planes (D = 2, {plane, whether it comes first}) or edges {plane, plane}.
  void toggle(const std::array<std::uint32_t, D>& at) {
    if constexpr (D == 2) {
      toggle_one({at[0], 1u}, {at[0], 0u});
      toggle_one({at[1], 0u}, {at[1], 1u});
    } else {
      for (std::size_t k = 0; k < D; ++k) toggle_one({at[k], at[(k + 1) % D]}, {at[(k + 1) % D], at[k]});
    }
  }
  void toggle_one(const std::array<std::uint32_t, 2>& x, const std::array<std::uint32_t, 2>& opposite) {
    for (auto& r : rim_)
      if (r == opposite) {
        r = rim_.back();
        rim_.pop_back();
        return;
      }
    rim_.push_back(x);
  }
};

}  // namespace concino::detail
