// The element types of Abaqus that are polys: their shapes and numbers of nodes, corners first, in the order of MEDIT.
#pragma once

#include <concino/mesh/support/standard_cells.hpp>

#include <cstdint>
#include <string_view>

namespace concino::detail {

struct abaqus_element {
  /// `other`: no poly, such as a beam or a spring. `unknown`: named like a poly, but with an unknown number of nodes.
  enum class family : std::uint8_t { other, surface, volume, unknown };

  family kind = family::other;
  cell_shape shape = cell_shape::general;  // of volumes
  std::uint32_t corners = 0, nodes = 0;

  bool is_poly() const { return kind == family::surface || kind == family::volume; }
  bool is_second_order() const { return nodes > corners; }
};

/// The number after a prefix, as in C3D10M. 0 if `type` does not begin with the prefix and a digit.
inline std::uint32_t number_in_type(std::string_view type, std::string_view prefix, std::string_view& suffix) {
  if (!type.starts_with(prefix)) return 0;
  std::uint32_t number = 0;
  std::size_t i = prefix.size();
  const std::size_t end = prefix == "STRI" ? i + 1 : i + 2;  // STRI65 has 6 nodes, with 5 degrees of freedom
  for (; i < type.size() && i < end && type[i] >= '0' && type[i] <= '9'; ++i)
    number = 10 * number + static_cast<std::uint32_t>(type[i] - '0');
  suffix = type.substr(i);
  return number;
}

inline abaqus_element abaqus_volume(std::uint32_t nodes) {
  constexpr auto volume = abaqus_element::family::volume;
  switch (nodes) {
    case 4:
    case 10:
      return {volume, cell_shape::tet, 4, nodes};
    case 5:
      return {volume, cell_shape::pyramid, 5, nodes};
    case 6:
    case 15:
      return {volume, cell_shape::prism, 6, nodes};
    case 8:
    case 20:
      return {volume, cell_shape::hex, 8, nodes};
    default:
      return {abaqus_element::family::unknown};
  }
}

inline abaqus_element abaqus_surface(std::uint32_t nodes) {
  constexpr auto surface = abaqus_element::family::surface;
  switch (nodes) {
    case 3:
    case 6:
      return {surface, cell_shape::general, 3, nodes};
    case 4:
    case 8:
    case 9:
      return {surface, cell_shape::general, 4, nodes};
    case 1:
    case 2:
      return {};  // lines, such as SFMAX1 and DCCAX2
    default:
      return {abaqus_element::family::unknown};
  }
}

/// The element of a type; `type` is in upper case. Letters after the number say how it is integrated and what else it
/// computes; they do not change its nodes, but those of variable elements (V) and of cohesive ones with pores (P).
inline abaqus_element abaqus_element_of(std::string_view type) {
  constexpr std::string_view volumes[] = {"C3D",  "DC3D",  "AC3D", "DCC3D", "Q3D",  "EC3D",
                                          "FC3D", "EMC3D", "SC",   "CSS",   "COH3D"};
  constexpr std::string_view surfaces[] = {"S",    "STRI",  "CPS",   "CPE",   "CPEG",   "CAX",  "CGAX", "DC2D",
                                           "DCAX", "DCC2D", "DCCAX", "AC2D",  "ACAX",   "M3D",  "R3D",  "SFM3D",
                                           "DS",   "F3D",   "COH2D", "COHAX", "WARP2D", "EMC2D"};
  std::string_view suffix;
  const auto is_variable = [&] {
    return suffix.starts_with('V') || (type.starts_with("COH") && suffix.find('P') != suffix.npos);
  };
  for (const std::string_view prefix : volumes)
    if (const std::uint32_t n = number_in_type(type, prefix, suffix); n != 0)
      return is_variable() ? abaqus_element{abaqus_element::family::unknown} : abaqus_volume(n);
  for (const std::string_view prefix : surfaces)
    if (const std::uint32_t n = number_in_type(type, prefix, suffix); n != 0)
      return is_variable() ? abaqus_element{abaqus_element::family::unknown} : abaqus_surface(n);
  return {};
}

}  // namespace concino::detail
