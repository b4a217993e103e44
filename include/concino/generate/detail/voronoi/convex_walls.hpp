// The planes of the faces of a convex closed surface, as walls of a Voronoi diagram.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/generate/detail/voronoi/half_spaces.hpp>
#include <concino/geometry/polygon.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace concino::detail {

/// A box around the surface, with a margin, so that all its walls are outside.
template<class S>
box box_around(const S& surface) {
  box b;
  for (const auto p : polys(surface))
    for (const auto v : adj_p2v(surface, p)) {
      const vec3 x = to_vec3(point(surface, v));
      if (!is_finite(x))
        core::throw_joined<invalid_mesh>(
            {"Voronoi diagram: vert ", index_of(surface, v), " of the surface is not finite"});
      b.add(x);
    }
  if (!(num_polys(surface) > 0)) core::throw_joined<invalid_mesh>({"Voronoi diagram: the surface has no polys"});
  const vec3 size = b.max - b.min;
  const double margin = (size.x + size.y + size.z) / 64;
  b.min -= vec3{margin, margin, margin};
  b.max += vec3{margin, margin, margin};
  return b;
}

/// The planes of a surface. Polys in one plane are one wall.
template<class S>
class convex_walls {
  using lattice = site_lattice<3>;

  const S& m_;
  const lattice& lattice_;
  std::vector<vec3> area_;  // by poly
  disjoint_sets plane_of_;
  double volume_ = 0;
  double slack_;  // twice the rounding of a vert and more: 2^-39 of the longest side of the box

  [[noreturn]] void fail(const poly_t<S>& p, const char* what) const {
    core::throw_joined<invalid_mesh>({"Voronoi diagram: poly ", index_of(m_, p), " of the surface ", what});
  }
  vec3 unit(std::size_t i) const { return area_[i] / norm(area_[i]); }

  /// The least and the greatest height of a vert of poly p above the plane through x with the unit normal n.
  std::array<double, 2> heights(const vec3& n, const vec3& x, const poly_t<S>& p) const {
    std::array<double, 2> h = {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const vert_t<S> v : adj_p2v(m_, p)) {
      const double above = dot(n, to_vec3(point(m_, v)) - x);
      h = {std::min(h[0], above), std::max(h[1], above)};
    }
    return h;
  }

  void find_areas() {
    area_.resize(poly_index_bound(m_));
    double volume = 0;
    vec3 origin;
    bool any = false;
    for (const poly_t<S> p : polys(m_)) {
      const polygon_shape s = shape_of(m_, adj_p2v(m_, p));
      if (!any) origin = s.mean;
      any = true;
      if (!(norm(s.area) > 0)) fail(p, "has no area");
      area_[index_of(m_, p)] = s.area;
      volume += dot(s.area, s.mean - origin);
      const auto h = heights(unit(index_of(m_, p)), s.mean, p);
      if (h[1] - h[0] > slack_) fail(p, "is not planar");
    }
    if (volume < 0)
      for (vec3& a : area_) a = -a;
    volume_ = std::abs(volume) / 3;
  }

  /// Convex at each edge, and in one piece: then it is convex.
  void check_edges() {
    disjoint_sets pieces(poly_index_bound(m_));
    std::size_t left = num_polys(m_);
    for (const edge_t<S> e : edges(m_)) {
      std::array<poly_t<S>, 2> at = {poly_t<S>(), poly_t<S>()};
      std::size_t n = 0;
      for (const poly_t<S> p : adj_e2p(m_, e)) {
        if (n < 2) at[n] = p;
        ++n;
      }
      if (n == 0) continue;
      if (n != 2)
        fail(at[0],
             n == 1 ? "is at a boundary edge; the surface must be closed" : "is at an edge with more than two polys");
      const std::size_t i = index_of(m_, at[0]), j = index_of(m_, at[1]);
      const vec3 x = to_vec3(point(m_, end_verts(m_, e).first));
      const auto first = heights(unit(i), x, at[1]), second = heights(unit(j), x, at[0]);
      if (first[1] > slack_ || second[1] > slack_)
        fail(at[0], "is at a reflex edge, or not oriented as a neighbour; the surface must be convex");
      if (first[0] >= -slack_ && second[0] >= -slack_) plane_of_.unite(i, j);
      left -= pieces.unite(i, j);
    }
    if (left != 1)
      core::throw_joined<invalid_mesh>({"Voronoi diagram: the surface has ", left, " pieces; it must have one"});
  }

 public:
  convex_walls(const S& m, const lattice& sites) : m_(m), lattice_(sites), plane_of_(poly_index_bound(m)) {
    const vec3 size = sites.domain().max - sites.domain().min;
    slack_ = 0x1p-39 * std::max({size.x, size.y, size.z});
    find_areas();
    check_edges();
  }

  double enclosed_volume() const { return volume_; }

  std::vector<lattice_plane<3>> planes() const {
    disjoint_sets sets = plane_of_;
    std::vector<vec3> normals(area_.size());
    std::vector<std::uint32_t> number(area_.size(), ~0u);
    for (const poly_t<S> p : polys(m_)) normals[sets.root(index_of(m_, p))] += area_[index_of(m_, p)];
    std::vector<lattice_plane<3>> walls;
    for (const poly_t<S> p : polys(m_)) {
      const std::size_t r = sets.root(index_of(m_, p));
      if (number[r] == ~0u) {
        number[r] = static_cast<std::uint32_t>(walls.size());
        const vec3 n = normals[r] / norm(normals[r]);
        lattice_plane<3>& w = walls.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) w.n[k] = std::llround(std::ldexp(n[k], 47));
        w.c = -(int128{1} << 110);
      }
      lattice_plane<3>& w = walls[number[r]];
      for (const vert_t<S> v : adj_p2v(m_, p)) {
        const auto x = lattice_.rounded(to_vec3(point(m_, v)));
        int128 c = int128{1} << 50;  // four steps outwards, so that rounded sites on the boundary are inside
        for (std::size_t k = 0; k < 3; ++k) c += 2 * static_cast<int128>(w.n[k]) * x[k];
        w.c = std::max(w.c, c);
      }
      const auto h = heights(normals[r] / norm(normals[r]), to_vec3(point(m_, *adj_p2v(m_, p).begin())), p);
      if (h[1] - h[0] > 8 * slack_) fail(p, "is not planar");
    }
    return walls;
  }
};

}  // namespace concino::detail
