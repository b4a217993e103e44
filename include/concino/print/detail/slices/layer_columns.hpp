// Columns over the triangles of layers, as polyhedra that fit together.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/print/detail/regions/layer_cells.hpp>

#include <array>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Builds the columns of one layer after another, from the bottom.
class column_builder {
  /// The common subdivision of the triangles of two layers at the height where they meet.
  struct interface {
    planar_arrangement lines;
    cell_triangles cells;                      // values: the numbers, plus 1, of the triangles below and above
    std::size_t first_segment_above = 0;       // segments of the layer above; those of the layer below come first
    std::vector<std::uint32_t> verts, faces;   // by point and by triangle: their numbers in the volume
  };
  struct wall {
    std::uint32_t from, to, left, right;  // points of a side, and the triangles beside it
  };

  const char* caller_;
  const lattice& lattice_;
  interface below_;

 public:
  polyhedra_arrays arrays;
  std::vector<int> layers, kinds;  // by column

  column_builder(const char* caller, const lattice& l) : caller_(caller), lattice_(l) {}

  /// Begins at the bottom of the first layer.
  void begin(const layer_cells& first, double z) { below_ = between(layer_cells(), first, z); }
  /// Adds the columns of a layer up to z, where the next layer begins.
  void add(const layer_cells& layer, const layer_cells& next, double z, int index);

 private:
  interface between(const layer_cells& below, const layer_cells& above, double z);
  static std::vector<wall> walls_of(const layer_cells& layer);
  void add_face(std::span<const std::uint32_t> verts);
  std::uint32_t num_faces() const { return static_cast<std::uint32_t>(arrays.num_faces()); }
  /// The faces between two chains of verts, counter-clockwise seen from the right.
  void add_wall(const std::vector<std::uint32_t>& low, const std::vector<std::uint32_t>& high);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/slices/layer_columns.ipp>
#endif
