// The orders in which a list gives the corners of a hex or tet: the standard one and those of other libraries.
//
//   auto hexes = cn::view_hex(points, cells, cn::hex_order::lexicographic);      // also hexmesh(points, cells, order),
//   hex_tables(n, cells, order)
//
// If a hex is the unit cube with corner 0 at the origin, the corners are at (x, y, z):
//
//   standard        000 100 110 010 001 101 111 011    the bottom face, then the top face, both counter-clockwise seen
//   from above lexicographic   000 100 010 110 001 101 011 111    x fastest, as in deal.II and the voxels of VTK
//   mirrored ...    the same for a mirrored hex: read as standard, its volume is negative
//
// Corners 0, 1, 2 of a standard tet are counter-clockwise seen from corner 3.
#pragma once

#include <concino/concepts/descriptors.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino {

/// The order of the eight corners of a hex. `standard` is the order of this library, of the paper, of VTK, Abaqus, Gmsh
/// and MEDIT.
enum class hex_order : std::uint8_t {
  standard,
  vtk = standard,
  abaqus = standard,
  gmsh = standard,
  medit = standard,
  lexicographic,
  mirrored,
  mirrored_lexicographic
};

/// The order of the four corners of a tet. `standard` is the order of this library, of VTK, Abaqus, Gmsh and MEDIT:
/// volumes are positive.
enum class tet_order : std::uint8_t {
  standard,
  vtk = standard,
  abaqus = standard,
  gmsh = standard,
  medit = standard,
  mirrored
};

namespace detail {

inline constexpr std::uint8_t hex_permutations[4][8] = {
    {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 3, 2, 4, 5, 7, 6}, {0, 3, 2, 1, 4, 7, 6, 5}, {0, 2, 3, 1, 4, 6, 7, 5}};
inline constexpr std::uint8_t tet_permutations[2][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}};

/// A table: entry k is the position, in a list of the other order, of the k-th corner of the standard order.
constexpr const std::uint8_t* permutation_of(hex_order order) { return hex_permutations[static_cast<unsigned>(order)]; }
constexpr const std::uint8_t* permutation_of(tet_order order) { return tet_permutations[static_cast<unsigned>(order)]; }

constexpr unsigned corners_in(hex_order) { return 8; }
constexpr unsigned corners_in(tet_order) { return 4; }

/// Reorders consecutive lists to the standard order. An incomplete list at the end is not changed.
template<class Order>
std::vector<vert_id> to_standard_order(std::vector<vert_id> lists, Order order) {
  constexpr unsigned n = corners_in(Order{});
  if (order == Order::standard) return lists;
  const std::uint8_t* const permutation = permutation_of(order);
  vert_id was[n];
  for (std::size_t first = 0; first + n <= lists.size(); first += n) {
    std::copy_n(lists.data() + first, n, was);
    for (unsigned k = 0; k < n; ++k) lists[first + k] = was[permutation[k]];
  }
  return lists;
}

/// One list of numbers, read in the standard order.
template<class Numbers>
class reordered {
  Numbers numbers_;
  const std::uint8_t* permutation_ = nullptr;

 public:
  using number = typename Numbers::number;
  reordered() = default;
  reordered(Numbers numbers, const std::uint8_t* permutation) : numbers_(numbers), permutation_(permutation) {}
  decltype(auto) operator[](std::size_t k) const { return numbers_[permutation_[k]]; }
};

/// The rows of an array, each read in the standard order.
template<class Rows>
class reordered_rows {
  Rows rows_;
  const std::uint8_t* permutation_;

 public:
  static constexpr auto columns = Rows::columns;
  reordered_rows(Rows r, const std::uint8_t* permutation) : rows_(r), permutation_(permutation) {}
  std::size_t size() const { return rows_.size(); }
  auto row(std::size_t i) const { return reordered(rows_.row(i), permutation_); }
};

}  // namespace detail

}  // namespace concino
