// Builds the graph for upper bounds of distances from a mesh: its edges, and the triangles or tets in its polys.
#pragma once

#include <concino/core/lexicographic.hpp>
#include <concino/core/poly_chunks.hpp>
#include <concino/fields/detail/heat/distance_bounds.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/operators/simplex_gradients.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// Collects triangles or tets in poly p as indices of its verts. Polygons are triangulated. Tets of a polyhedron are
/// the cones from verts that see all triangles of its faces from inside. Those of several
/// verts overlap, but the edges of those of one vert have too few directions. Up to 16 verts are tried, first in the
/// lexicographic order of their points.
template<AnyMesh M>
class simplex_collector {
  polygon_triangulator triangulate_;
  std::vector<vec3> x_;
  std::vector<int> number_;
  std::vector<vert_t<M>> apexes_;
  std::vector<std::array<int, 4>> cones_;

  void read(const M& m, const auto& verts) {
    x_.clear();
    number_.clear();
    for (const vert_t<M> v : verts) {
      x_.push_back(to_vec3(point(m, v)));
      number_.push_back(static_cast<int>(index_of(m, v)));
    }
  }

  /// Adds the tets between vert `apex` and the triangles, if it sees them all.
  void add_cone(const M& m, const poly_t<M>& p, const vert_t<M>& apex) {
    const int apex_index = static_cast<int>(index_of(m, apex));
    const vec3 from = to_vec3(point(m, apex));
    const std::size_t before = cones_.size();
    for (const face_t<M> f : adj_p2f(m, p)) {
      read(m, adj_f2v(m, f));
      if (std::find(number_.begin(), number_.end(), apex_index) != number_.end()) continue;
      const double sign = face_is_outward(m, p, f) ? 1 : -1;
      for (const auto& [i, j, k] : triangulate_(x_)) {
        const vec3 a = x_[i] - from, b = x_[j] - from, c = x_[k] - from;
        const double volume6 = sign * dot(a, cross(b, c)), scale = norm(a) * norm(b) * norm(c);
        if (volume6 < -0.05 * scale) return cones_.resize(before);  // a tolerance: faces need not be quite planar
        if (!(volume6 > 1e-9 * scale)) continue;
        std::array<int, 4>& tet =
            cones_.emplace_back(std::array<int, 4>{apex_index, number_[i], number_[j], number_[k]});
        std::sort(tet.begin(), tet.end());
      }
    }
  }

  void add_cones(const M& m, const poly_t<M>& p, std::vector<int>& simplices) {
    apexes_.clear();
    cones_.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) apexes_.push_back(v);
    const auto end = apexes_.begin() + std::min(std::ptrdiff_t{16}, std::ssize(apexes_));
    std::partial_sort(apexes_.begin(), end, apexes_.end(), [&](const vert_t<M>& v, const vert_t<M>& w) {
      return core::is_lexicographically_less(to_vec3(point(m, v)), to_vec3(point(m, w)));
    });
    for (auto v = apexes_.begin(); v != end; ++v) add_cone(m, p, *v);
    std::sort(cones_.begin(), cones_.end());
    const auto last = std::unique(cones_.begin(), cones_.end());
    for (auto tet = cones_.begin(); tet != last; ++tet) simplices.insert(simplices.end(), tet->begin(), tet->end());
  }

 public:
  void add(const M& m, const poly_t<M>& p, std::vector<int>& simplices) {
    if constexpr (TriMesh<M> || TetMesh<M>) {  // the poly is a simplex already
      for (const vert_t<M> v : adj_p2v(m, p)) simplices.push_back(static_cast<int>(index_of(m, v)));
    } else if constexpr (SurfaceMesh<M>) {  // polygons are split into triangles, polyhedra into tets
      read(m, adj_p2v(m, p));
      for (const polygon_triangle& t : triangulate_(x_))
        for (const std::uint32_t k : t) simplices.push_back(number_[k]);
    } else {
      add_cones(m, p, simplices);
    }
  }
};

/// Adds the edges of simplices that are not in `edges` yet, two verts each.
inline void add_diagonals(const std::vector<int>& simplices, std::size_t corners, std::vector<int>& edges) {
  using line = std::pair<int, int>;
  std::vector<line> lines, known;
  for (std::size_t i = 0; i < simplices.size(); i += corners)
    for (std::size_t a = i; a < i + corners; ++a)
      for (std::size_t b = a + 1; b < i + corners; ++b) lines.emplace_back(std::minmax(simplices[a], simplices[b]));
  for (std::size_t i = 0; i < edges.size(); i += 2) known.emplace_back(std::minmax(edges[i], edges[i + 1]));
  std::sort(lines.begin(), lines.end());
  lines.erase(std::unique(lines.begin(), lines.end()), lines.end());
  std::sort(known.begin(), known.end());
  auto next = known.begin();
  for (const line& l : lines) {
    while (next != known.end() && *next < l) ++next;
    if (next == known.end() || l < *next) edges.insert(edges.end(), {l.first, l.second});
  }
}

template<AnyMesh M>
distance_graph distance_graph_of(const M& m) {
  std::vector<vec3> points(vert_index_bound(m));
  std::vector<int> edge, simplices;
  for (const vert_t<M> v : verts(m)) points[index_of(m, v)] = to_vec3(point(m, v));
  for (const edge_t<M> e : edges(m))
    for (const vert_t<M> v : adj_e2v(m, e)) edge.push_back(static_cast<int>(index_of(m, v)));
  simplex_collector<M> collector;
  for (const poly_t<M> p : polys(m)) collector.add(m, p, simplices);
  constexpr std::size_t corners = static_cast<std::size_t>(dimension_v<M>) + 1;
  if constexpr (!(TriMesh<M> || TetMesh<M>)) add_diagonals(simplices, corners, edge);  // simplices have no diagonals
  return {std::move(points), edge, std::move(simplices), corners};
}

}  // namespace concino::detail
