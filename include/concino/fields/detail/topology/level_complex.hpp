// The edges and triangles of a mesh on which level sets are followed, as flat arrays, with polygons and polyhedra split
// about their highest verts.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/fields/detail/topology/sorted_graph.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace concino::detail {

/// Ends are ranks, the lower one first. A triangle of verts a < b < c has the edges ac, ab and bc. Level sets of a
/// function that is linear on simplices are connected as they are in the triangles.
struct level_complex {
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 3>> triangles;

  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b) {
    edges.push_back({a < b ? a : b, a < b ? b : a});
    return static_cast<std::uint32_t>(edges.size() - 1);
  }
};

/// Builds a level_complex. The edges of m come first. Polygons become fans of triangles about their highest verts,
/// polyhedra cones over their edges, of which only the triangles count. So each cell is added to {u <= t} with its
/// highest vert, as critical_points has it.
template<AnyMesh M>
class level_complex_builder {
  const M& m_;
  const vert_ranks& ranks_;
  level_complex& to_;
  std::vector<std::uint32_t> edge_number_;  // by index
  std::vector<std::uint32_t> loop_, loop_edges_;

  using spoke = std::pair<std::uint32_t, std::uint32_t>;  // the rank of its lower end, and its number
  std::vector<spoke> spokes_;
  std::vector<std::uint32_t> first_spoke_;  // of the fans of faces, by index, and their numbers of spokes

  std::uint32_t rank(const vert_t<M>& v) const { return ranks_.rank[index_of(m_, v)]; }

  void add_triangle(const spoke& a, const spoke& b, std::uint32_t side) {
    to_.triangles.push_back(a.first < b.first ? std::array{a.second, side, b.second}
                                              : std::array{b.second, side, a.second});
  }

  /// Edge k joins verts k and k + 1. The spokes of the fan are added to spokes_.
  template<class Loop, class Edges>
  void add_polygon(const Loop& loop, const Edges& loop_edges) {
    loop_.clear(), loop_edges_.clear();
    for (const vert_t<M> v : loop) loop_.push_back(rank(v));
    for (const edge_t<M> e : loop_edges) loop_edges_.push_back(edge_number_[index_of(m_, e)]);
    const std::size_t n = loop_.size(), begin = spokes_.size();
    std::size_t top = 0;
    for (std::size_t k = 1; k < n; ++k)
      if (loop_[k] > loop_[top]) top = k;
    for (std::size_t k = 1; k < n; ++k) {
      const std::uint32_t w = loop_[(top + k) % n];
      const std::uint32_t number = k == 1       ? loop_edges_[top]
                                   : k == n - 1 ? loop_edges_[(top + n - 1) % n]
                                                : to_.add_edge(loop_[top], w);
      spokes_.push_back({w, number});
      if (k > 1) add_triangle(spokes_[begin + k - 2], spokes_[begin + k - 1], loop_edges_[(top + k - 1) % n]);
    }
  }

  std::uint32_t highest(const poly_t<M>& p) const {
    std::uint32_t top = 0;
    for (const vert_t<M> v : adj_p2v(m_, p)) top = rank(v) > top ? rank(v) : top;
    return top;
  }

  /// The triangles within polyhedron p that are not in its faces.
  void add_cone(const poly_t<M>& p) {
    const std::uint32_t top = highest(p);
    std::vector<spoke> known;
    const auto number_of = [&](std::uint32_t w) {
      for (const spoke& s : known)
        if (s.first == w) return s;
      return known.emplace_back(w, to_.add_edge(top, w));
    };
    for (const edge_t<M> e : adj_p2e(m_, p)) {
      const std::uint32_t number = edge_number_[index_of(m_, e)];
      if (to_.edges[number][1] == top) known.push_back({to_.edges[number][0], number});
    }
    for (const face_t<M> f : adj_p2f(m_, p))
      for (std::uint32_t k = first_spoke_[2 * index_of(m_, f)], n = first_spoke_[2 * index_of(m_, f) + 1]; n > 0;
           ++k, --n)
        if (to_.edges[spokes_[k].second][1] == top) known.push_back(spokes_[k]);
    for (const edge_t<M> e : adj_p2e(m_, p)) {
      const auto [low, high] = to_.edges[edge_number_[index_of(m_, e)]];
      if (high != top) add_triangle(number_of(low), number_of(high), edge_number_[index_of(m_, e)]);
    }
  }

 public:
  level_complex_builder(const M& m, const vert_ranks& ranks, level_complex& to)
      : m_(m), ranks_(ranks), to_(to), edge_number_(edge_index_bound(m)) {
    for (const edge_t<M> e : edges(m)) {
      const auto ends = end_verts(m, e);
      edge_number_[index_of(m, e)] = to.add_edge(rank(ends.first), rank(ends.second));
    }
    if constexpr (dimension_v<M> == 2) {  // the polygons of a surface are its polys, those of a volume its faces
      for (const poly_t<M> p : polys(m)) {
        spokes_.clear();
        add_polygon(adj_p2v(m, p), adj_p2e(m, p));
      }
    } else {
      first_spoke_.resize(2 * face_index_bound(m));
      for (const face_t<M> f : faces(m)) {
        first_spoke_[2 * index_of(m, f)] = static_cast<std::uint32_t>(spokes_.size());
        add_polygon(adj_f2v(m, f), adj_f2e(m, f));
        first_spoke_[2 * index_of(m, f) + 1] =
            static_cast<std::uint32_t>(spokes_.size()) - first_spoke_[2 * index_of(m, f)];
      }
      if constexpr (!TetMesh<M>)  // the triangles of a tet are its faces
        for (const poly_t<M> p : polys(m)) add_cone(p);
    }
  }
};

template<AnyMesh M>
level_complex make_level_complex(const M& m, const vert_ranks& ranks) {
  level_complex complex;
  level_complex_builder<M>(m, ranks, complex);
  return complex;
}

}  // namespace concino::detail
