// Colour maps from [0, 1] to colours. In perceptually uniform maps lightness increases evenly, so that equal steps look
// equal, in print too.
#pragma once

#include <concino/render/color.hpp>
#include <concino/render/detail/colors/colormap_tables.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace concino {

/// A colour map defined by two or more sRGB colours at equal steps, with linear interpolation.
/// Needs:  a table of your own outlives the map, which stores its address.
/// Result: each map below has a table of its own and may be copied freely.
/// Cost:   O(1).
/// Errors: none.
class colormap {
 public:
  template<std::size_t N>
    requires(N >= 2)
  constexpr explicit colormap(const std::array<std::array<float, 3>, N>& colors)
      : colors_(colors.data()), steps_(N - 1) {}
  template<std::size_t N>
  colormap(const std::array<std::array<float, 3>, N>&&) = delete;  // the address of the table is stored

  /// Dark violet over green to yellow; perceptually uniform.      Source: van der Walt and Smith 2015.
  static const colormap viridis;
  /// Dark blue over grey to yellow; perceptually uniform, and the same to colour-blind viewers.      Source: Nunez,
  /// Anderton and Renslow 2018.
  static const colormap cividis;
  /// Blue over teal to yellow, similar to Parula; perceptually uniform, and brighter than viridis, so that shading is
  /// visible.
  static const colormap blue_to_yellow;
  /// All hues from dark blue over green to dark red. It tells many values apart, but lightness is largest in the
  /// middle.      Source: Mikhailov 2019.
  static const colormap turbo;
  /// Blue over white to red, for values on two sides of a middle. Lightness increases to the middle and decreases
  /// behind it.      Source: Moreland 2009.
  static const colormap cool_warm;
  /// The hues of full saturation, red over green and blue back to red: for angles and other periodic values. Lightness
  /// varies.
  static const colormap hsv;

  /// The sRGB components for t. Values below 0, above 1 and NaN become 0, 1 and 0.
  constexpr std::array<float, 3> srgb_at(double t) const {
    const double x = t > 0 ? std::min(t, 1.0) * static_cast<double>(steps_) : 0;
    const std::size_t i = std::min(static_cast<std::size_t>(x), steps_ - 1);
    const float f = static_cast<float>(x - static_cast<double>(i));
    const auto &a = colors_[i], &b = colors_[i + 1];
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
  }

  /// The colour for t in linear light.
  rgb operator()(double t) const {
    const auto [r, g, b] = srgb_at(t);
    return srgb(r, g, b);
  }

 private:
  const std::array<float, 3>* colors_;
  std::size_t steps_;
};

inline constexpr colormap colormap::viridis{detail::viridis_table};
inline constexpr colormap colormap::cividis{detail::cividis_table};
inline constexpr colormap colormap::blue_to_yellow{detail::blue_to_yellow_table};
inline constexpr colormap colormap::turbo{detail::turbo_table};
inline constexpr colormap colormap::cool_warm{detail::cool_warm_table};
inline constexpr colormap colormap::hsv{detail::hsv_table};

}  // namespace concino
