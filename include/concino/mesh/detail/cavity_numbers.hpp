// The numbers of the edges and faces of many tets or hexes at once, which takes less time than to look for each of them.
#pragma once

#include <concino/core/temporary_array.hpp>
#include <concino/mesh/detail/cavity_edges.hpp>
#include <concino/mesh/detail/cavity_faces.hpp>
#include <concino/mesh/detail/pair_numbers.hpp>
#include <concino/mesh/detail/shapes.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// The key of face j of a poly with corners v, of which the edges have these numbers.
template<class Shape>
[[gnu::always_inline]] inline auto key_of_face(const unsigned* v, const std::uint32_t* edges, unsigned j) {
  unsigned w[Shape::face_verts], e[Shape::face_verts];
  for (unsigned i = 0; i < Shape::face_verts; ++i) w[i] = v[Shape::face_vert[j][i]], e[i] = edges[shape_v<Shape>.face_edge[j][i]];
  return cavity_faces<Shape::face_verts>::key(w, e);
}

/// Numbers the edges of n polys with corners(k), and adds them to `edges`, which is empty, in the order of their numbers.
template<class Shape, class Corners>
void number_edges(std::size_t n, const Corners& corners, unsigned num_verts, std::uint32_t* edges_of_polys, cavity_edges& edges, pair_numbers& numbers) {
  core::temporary_array<std::uint32_t> larger(Shape::edges * n);
  for (std::size_t k = 0, use = 0; k < n; ++k) {
    const unsigned* const v = corners(k);
    for (const auto& e : Shape::edge_vert) edges_of_polys[use] = std::min(v[e[0]], v[e[1]]), larger[use++] = std::max(v[e[0]], v[e[1]]);
  }
  numbers.number(edges_of_polys, larger.data(), Shape::edges * n, num_verts, num_verts);
  edges.reserve(numbers.size());
  for (const std::uint32_t use : numbers) {
    const unsigned* const v = corners(use / Shape::edges);
    const auto& e = Shape::edge_vert[use % Shape::edges];
    edges.add(v[e[0]], v[e[1]]);
  }
}

/// The same for faces, after the edges: they are pairs of an edge and one more vert or, if there are two more, pairs of the number of such a pair and a vert.
template<class Shape, class Corners>
void number_faces(std::size_t n, const Corners& corners, unsigned num_verts, const std::uint32_t* edges_of_polys, std::size_t num_edges, std::uint32_t* faces_of_polys,
                  cavity_faces<Shape::face_verts>& faces, pair_numbers& numbers) {
  constexpr unsigned others = Shape::face_verts - 2;
  const std::size_t uses = Shape::faces * n;
  core::temporary_array<std::uint32_t> other(others * uses);
  for (std::size_t k = 0, use = 0; k < n; ++k)
    for (unsigned j = 0; j < Shape::faces; ++j, ++use) {
      const auto x = key_of_face<Shape>(corners(k), edges_of_polys + k * Shape::edges, j);
      faces_of_polys[use] = x.edge;
      for (unsigned i = 0; i < others; ++i) other[i * uses + use] = x.other[i];
    }
  std::size_t bound = num_edges;
  for (unsigned i = 0; i < others; ++i) {
    numbers.number(faces_of_polys, other.data() + i * uses, uses, bound, num_verts);
    bound = numbers.size();
  }
  faces.reserve(bound);
  for (const std::uint32_t use : numbers) faces.add(use);
}

}  // namespace concino::detail
