// A surface as triangles that are laid into the plane one beside the other, for walks and paths over it. Other polygons
// are triangulated.
#pragma once

#include <concino/concepts/surface_mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/unfolded_triangles.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::core {

/// The triangles of a surface. Edges have their index in the mesh; the diagonals of triangulated polygons are numbered
/// from num_mesh_edges on.
struct unfolded_surface {
  unfolded_triangles triangles;
  std::vector<int> triangle_of;  // the first triangle of a poly, by index; -1 if it has none
  std::vector<int> poly_of;      // the index of the poly of a triangle; the triangles of a poly are consecutive
  int num_mesh_edges = 0;

  bool is_diagonal(int side) const { return triangles.edge[static_cast<std::size_t>(side)] >= num_mesh_edges; }
};

/// 2^-k is the unit of length of the triangles of m; then the largest coordinate is near 1.
template<SurfaceMesh M>
int unfolding_exponent(const M& m) {
  double largest = 0;
  for (const poly_t<M> p : polys(m))
    for (const vert_t<M> v : adj_p2v(m, p)) {
      const vec3 x = to_vec3(point(m, v));
      largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    }
  return largest > 0 && std::isfinite(largest) ? std::clamp(std::ilogb(largest), -1000, 1000) : 0;
}

/// Adds the triangles of one polygon after another.
template<SurfaceMesh M>
class surface_unfolder {
  const M& m_;
  const char* caller_;
  unfolded_surface& r_;
  double unit_;
  int num_edges_;
  polygon_triangulator triangulate_;
  std::vector<vec3> x_;
  std::vector<int> vert_, edge_;  // edge_[k]: from corner k to the next, -1 if the mesh has none
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, int>> diagonals_;

  [[noreturn, gnu::noinline, gnu::cold]] void throw_no_area(const poly_t<M>& p) const {
    throw_joined<invalid_mesh>({caller_, ": poly ", index_of(m_, p),
                                " has no area, or points that are not finite; remove it or move its verts"});
  }

  void read(const poly_t<M>& p) {
    x_.clear();
    vert_.clear();
    for (const vert_t<M> v : adj_p2v(m_, p)) {
      vert_.push_back(static_cast<int>(index_of(m_, v)));
      x_.push_back(unit_ * to_vec3(point(m_, v)));
      if (!is_finite(x_.back())) throw_no_area(p);
    }
    edge_.assign(vert_.size(), -1);
    std::size_t k = 0;
    for (const edge_t<M> e : adj_p2e(m_, p))
      if (k < edge_.size()) edge_[k++] = static_cast<int>(index_of(m_, e));
  }

  int edge_between(std::uint32_t a, std::uint32_t b) {
    const auto n = static_cast<std::uint32_t>(vert_.size());
    if (b == (a + 1 < n ? a + 1 : 0)) return edge_[a];
    if (a == (b + 1 < n ? b + 1 : 0)) return edge_[b];
    const std::pair key(std::min(a, b), std::max(a, b));
    for (const auto& [ends, number] : diagonals_)
      if (ends == key) return number;
    diagonals_.emplace_back(key, num_edges_);
    return num_edges_++;
  }

 public:
  surface_unfolder(const M& m, const char* caller, unfolded_surface& r)
      : m_(m), caller_(caller), r_(r), unit_(std::ldexp(1.0, -r.triangles.exponent)), num_edges_(r.num_mesh_edges) {}

  void add(const poly_t<M>& p, std::vector<int>& edge_of) {
    read(p);
    diagonals_.clear();
    const auto number = index_of(m_, p);
    r_.triangle_of[number] = static_cast<int>(r_.poly_of.size());
    if (x_.size() < 3) throw_no_area(p);
    for (const polygon_triangle& t : triangulate_(x_)) {
      if (!r_.triangles.add({vert_[t[0]], vert_[t[1]], vert_[t[2]]}, {x_[t[0]], x_[t[1]], x_[t[2]]})) throw_no_area(p);
      r_.poly_of.push_back(static_cast<int>(number));
      for (std::size_t k = 0; k < 3; ++k) edge_of.push_back(edge_between(t[k], t[(k + 1) % 3]));
    }
  }

  int num_edges() const { return num_edges_; }
};

/// The triangles of all polys of m, in the order of polys(m), each joined to its neighbours.
/// Errors: invalid_mesh that names a poly without area, or with points that are not finite.
template<SurfaceMesh M>
unfolded_surface unfold_surface(const M& m, const char* caller) {
  unfolded_surface r;
  r.triangle_of.assign(poly_index_bound(m), -1);
  r.num_mesh_edges = static_cast<int>(edge_index_bound(m));
  r.triangles.exponent = unfolding_exponent(m);
  surface_unfolder<M> unfolder(m, caller, r);
  std::vector<int> edge_of;
  r.triangles.reserve(num_polys(m));  // more where polygons are triangulated
  r.poly_of.reserve(num_polys(m));
  edge_of.reserve(3 * num_polys(m));
  for (const poly_t<M> p : polys(m)) unfolder.add(p, edge_of);
  r.triangles.join(std::move(edge_of), static_cast<std::size_t>(unfolder.num_edges()), vert_index_bound(m));
  return r;
}

}  // namespace concino::core
