// A table of the types of elements in Gmsh files, by their numbers.
#pragma once

#include <concino/mesh/support/standard_cells.hpp>

#include <array>
#include <cstdint>
#include <string_view>

namespace concino::detail {

enum class gmsh_shape : std::uint8_t { none, point, line, triangle, quad, tet, hex, prism, pyramid };

inline constexpr std::string_view gmsh_shape_names[] = {"none", "point", "line",  "triangle", "quad",
                                                        "tet",  "hex",   "prism", "pyramid"};

/// The corners of an element are its first nodes, in the standard order.
struct gmsh_type {
  gmsh_shape shape = gmsh_shape::none;  // none: an unknown type
  std::uint16_t nodes = 0;

  constexpr int dimension() const {
    return shape <= gmsh_shape::point ? 0 : shape == gmsh_shape::line ? 1 : shape <= gmsh_shape::quad ? 2 : 3;
  }
  constexpr unsigned corners() const {
    constexpr unsigned n[] = {0, 1, 2, 3, 4, 4, 8, 6, 5};
    return n[static_cast<unsigned>(shape)];
  }
  /// Whether it is an element of second or higher order, with nodes besides its corners.
  constexpr bool is_high_order() const { return nodes > corners(); }
  constexpr std::string_view name() const { return gmsh_shape_names[static_cast<unsigned>(shape)]; }

  /// Needs: an element of a volume.
  constexpr cell_shape cell() const {
    constexpr cell_shape shapes[] = {cell_shape::tet, cell_shape::hex, cell_shape::prism, cell_shape::pyramid};
    return shapes[static_cast<unsigned>(shape) - static_cast<unsigned>(gmsh_shape::tet)];
  }
};

/// The types whose elements have a fixed number of nodes; those for the use of Gmsh alone are left out.
inline constexpr std::array<gmsh_type, 138> gmsh_types = [] {
  std::array<gmsh_type, 138> all{};
  const auto add = [&](unsigned first, gmsh_shape shape, std::initializer_list<std::uint16_t> nodes) {
    for (const std::uint16_t n : nodes) all[first++] = {shape, n};
  };
  add(15, gmsh_shape::point, {1});
  add(1, gmsh_shape::line, {2});
  add(8, gmsh_shape::line, {3});
  add(26, gmsh_shape::line, {4, 5, 6});
  add(62, gmsh_shape::line, {7, 8, 9, 10, 11});
  add(2, gmsh_shape::triangle, {3});
  add(9, gmsh_shape::triangle, {6});
  add(20, gmsh_shape::triangle, {9, 10, 12, 15, 15, 21});
  add(42, gmsh_shape::triangle, {28, 36, 45, 55, 66});
  add(52, gmsh_shape::triangle, {18, 21, 24, 27, 30});
  add(3, gmsh_shape::quad, {4});
  add(10, gmsh_shape::quad, {9});
  add(16, gmsh_shape::quad, {8});
  add(36, gmsh_shape::quad, {16, 25, 36, 12, 16, 20});
  add(47, gmsh_shape::quad, {49, 64, 81, 100, 121});
  add(57, gmsh_shape::quad, {24, 28, 32, 36, 40});
  add(4, gmsh_shape::tet, {4});
  add(11, gmsh_shape::tet, {10});
  add(29, gmsh_shape::tet, {20, 35, 56, 22, 28});
  add(71, gmsh_shape::tet, {84, 120, 165, 220, 286});
  add(79, gmsh_shape::tet, {34, 40, 46, 52, 58});
  add(137, gmsh_shape::tet, {16});
  add(5, gmsh_shape::hex, {8});
  add(12, gmsh_shape::hex, {27});
  add(17, gmsh_shape::hex, {20});
  add(92, gmsh_shape::hex, {64, 125, 216, 343, 512, 729, 1000, 32, 44, 56, 68, 80, 92, 104});
  add(6, gmsh_shape::prism, {6});
  add(13, gmsh_shape::prism, {18});
  add(18, gmsh_shape::prism, {15});
  add(90, gmsh_shape::prism, {40, 75});
  add(106, gmsh_shape::prism, {126, 196, 288, 405, 550, 24, 33, 42, 51, 60, 69, 78});
  add(7, gmsh_shape::pyramid, {5});
  add(14, gmsh_shape::pyramid, {14});
  add(19, gmsh_shape::pyramid, {13});
  add(118, gmsh_shape::pyramid, {30, 55, 91, 140, 204, 285, 385, 21, 29, 37, 45, 53, 61, 69});
  return all;
}();

inline constexpr gmsh_type gmsh_type_of(std::int64_t number) {
  return number < 0 || number >= static_cast<std::int64_t>(gmsh_types.size())
             ? gmsh_type{}
             : gmsh_types[static_cast<std::size_t>(number)];
}

/// The number of the type of linear elements of a shape.
inline constexpr std::uint8_t linear_gmsh_type(gmsh_shape shape) {
  constexpr std::uint8_t numbers[] = {0, 15, 1, 2, 3, 4, 5, 6, 7};
  return numbers[static_cast<unsigned>(shape)];
}

}  // namespace concino::detail
