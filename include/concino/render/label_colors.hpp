// Colours for labels: numbers that name regions, materials or parts, and have no order.
#pragma once

#include <concino/render/color.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace concino {

/// The number of different label colours.
inline constexpr std::size_t num_label_colors = 20;

namespace detail {

/// sRGB colours, the first ones the most different. They maximise the smallest distance in OKLab (Ottosson 2020)
/// between two of them, and to white, grey and black, among colours of medium chroma and lightness.
inline constexpr std::array<std::array<std::uint8_t, 3>, num_label_colors> label_color_table = {{
    {1, 113, 159},  {136, 0, 107},  {255, 138, 5},   {37, 143, 0},   {133, 244, 129}, {79, 45, 169},  {0, 184, 252},
    {208, 64, 107}, {255, 211, 0},  {172, 82, 194},  {149, 0, 0},    {104, 121, 245}, {0, 93, 53},    {171, 162, 5},
    {12, 245, 248}, {255, 141, 168}, {202, 156, 255}, {105, 77, 88}, {4, 187, 151},   {173, 97, 1},
}};

}  // namespace detail

/// The colour of a label. Colours repeat: labels that differ by a multiple of 20 have the same colour.
/// Needs:  any number.
/// Result: colours of two labels below 20 differ by at least 0.14 in OKLab, and as much from white and from the grey of
///         points without a value.
/// Cost:   O(1).
/// Errors: none.
inline rgb label_color(std::size_t label) {
  const auto& c = detail::label_color_table[label % num_label_colors];
  return srgb(static_cast<float>(c[0]) / 255, static_cast<float>(c[1]) / 255, static_cast<float>(c[2]) / 255);
}

/// The label that a value stands for.
/// Needs:  any number.
/// Result: the value if it is a whole number in [0, 2^53), else nothing.
/// Cost:   O(1).
/// Errors: none.
inline std::optional<std::size_t> label_of(double value) {
  if (!(value >= 0 && value < 0x1p53) || value != std::floor(value)) return {};
  return static_cast<std::size_t>(value);
}

}  // namespace concino
