// Which faces connect the new polys of a cavity of tets or hexes, and whether those around an edge are connected.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/mesh/detail/cells/shapes.hpp>
#include <concino/mesh/detail/edits/cavity_edges.hpp>

#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// Uses of faces are numbered: those of new poly k from k times the faces of a poly on.
template<class Shape>
class new_poly_links {
  static constexpr const auto& shape = shape_v<Shape>;
  core::small_array<std::uint32_t, 16 * Shape::faces> mates_;
  unsigned shortest_ring_ = Shape::verts == 4 ? 3 : 2;  // of new polys around an edge

  /// The other face at edge e of a new poly with these edges.
  static std::uint32_t other_face_at(unsigned e, const std::uint32_t* at, std::uint32_t j) {
    unsigned i = 0;
    for (unsigned l = 1; l < Shape::edges; ++l) i = at[l] == e ? l : i;
    const std::uint8_t* const two = shape.edge_face[i];
    return two[two[0] == j];
  }

 public:
  static constexpr std::uint32_t no_mate = ~0u, has_others = ~0u - 1;

  explicit new_poly_links(std::size_t num_new) : mates_(Shape::faces * num_new, has_others) {}

  /// The other use of a face; no_mate if it has one new poly only, has_others if it has any others.
  std::uint32_t mate(std::size_t use) const { return mates_[use]; }
  void join(std::uint32_t a, std::uint32_t b) { mates_[a] = b, mates_[b] = a; }
  void set_alone(std::uint32_t use) { mates_[use] = no_mate; }
  /// Two tets have two faces in common, and so all their verts.
  void allow_rings_of_two() { shortest_ring_ = 2; }

  /// Whether the new polys at edge e, which is x, are connected by faces at e, of which `joints` have two new polys.
  /// edges_of_new: the edges of each new poly.
  bool connect(unsigned e, const cavity_edge& x, std::uint32_t joints, const std::uint32_t* edges_of_new) const {
    const std::uint32_t n = x.new_polys, first = x.first_new;
    if (joints + 1 < n) return false;
    // too few for a ring and others
    if (n <= (joints < n ? shortest_ring_ : 2 * shortest_ring_ - 1)) return true;
    const bool is_ring = joints == n;  // or some, so that the others are too few for another one after a part of
                                       // the walk
    std::uint32_t visited = 1;
    for (const unsigned side : {0u, 1u}) {
      std::uint32_t use = first / Shape::edges * Shape::faces + shape.edge_face[first % Shape::edges][side];
      while ((use = mates_[use]) < has_others) {
        const std::uint32_t k = use / Shape::faces;
        if (k == first / Shape::edges) return visited == n;
        if (++visited + shortest_ring_ > n && is_ring) return true;
        use = k * Shape::faces + other_face_at(e, edges_of_new + k * Shape::edges, use % Shape::faces);
      }
    }
    return visited == n;
  }
};

}  // namespace concino::detail
