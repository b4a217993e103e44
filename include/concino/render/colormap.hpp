// Colour maps from [0, 1] to colours. All are perceptually uniform: lightness increases evenly, so equal steps look equal, in print too.
#pragma once

#include <concino/render/color.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace concino {

/// A colour map defined by 17 sRGB colours at equal steps, with linear interpolation.
class colormap {
 public:
  using table = std::array<std::array<float, 3>, 17>;

  constexpr explicit colormap(const table& colors) : colors_(&colors) {}
  colormap(const table&&) = delete;  // the address of the table is stored

  /// The sRGB components for t. Values below 0, above 1 and NaN become 0, 1 and 0.
  constexpr std::array<float, 3> srgb_at(double t) const {
    const double x = t > 0 ? std::min(t, 1.0) * 16 : 0;
    const std::size_t i = std::min<std::size_t>(static_cast<std::size_t>(x), 15);
    const float f = static_cast<float>(x - static_cast<double>(i));
    const auto &a = (*colors_)[i], &b = (*colors_)[i + 1];
    return {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1]), a[2] + f * (b[2] - a[2])};
  }

  /// The colour for t in linear light.
  rgb operator()(double t) const {
    const auto [r, g, b] = srgb_at(t);
    return srgb(r, g, b);
  }

 private:
  const table* colors_;
};

namespace detail {

inline constexpr colormap::table viridis_table = {{
    {0.267004f, 0.004874f, 0.329415f},
    {0.282327f, 0.094955f, 0.417331f},
    {0.278826f, 0.175490f, 0.483397f},
    {0.258965f, 0.251537f, 0.524736f},
    {0.229739f, 0.322361f, 0.545706f},
    {0.199430f, 0.387607f, 0.554642f},
    {0.172719f, 0.448791f, 0.557885f},
    {0.149039f, 0.508051f, 0.557250f},
    {0.128149f, 0.565107f, 0.550893f},
    {0.120081f, 0.622161f, 0.534946f},
    {0.153894f, 0.680203f, 0.504172f},
    {0.239374f, 0.735588f, 0.455688f},
    {0.360741f, 0.785964f, 0.387814f},
    {0.506271f, 0.828786f, 0.300362f},
    {0.668054f, 0.861999f, 0.196293f},
    {0.835270f, 0.886029f, 0.102646f},
    {0.993248f, 0.906157f, 0.143936f},
}};

inline constexpr colormap::table cividis_table = {{
    {0.000000f, 0.135112f, 0.304751f},
    {0.000000f, 0.178802f, 0.414764f},
    {0.103401f, 0.220406f, 0.435790f},
    {0.195057f, 0.264372f, 0.425924f},
    {0.263738f, 0.307831f, 0.422789f},
    {0.324250f, 0.351289f, 0.426250f},
    {0.380830f, 0.395164f, 0.435653f},
    {0.435168f, 0.439763f, 0.451134f},
    {0.486919f, 0.483885f, 0.470696f},
    {0.544069f, 0.528948f, 0.471947f},
    {0.605211f, 0.576777f, 0.464441f},
    {0.668008f, 0.626171f, 0.449270f},
    {0.732422f, 0.677364f, 0.425717f},
    {0.798480f, 0.730580f, 0.392597f},
    {0.866421f, 0.786028f, 0.346571f},
    {0.936660f, 0.843841f, 0.280876f},
    {0.995737f, 0.909344f, 0.217772f},
}};

inline constexpr colormap::table blue_to_yellow_table = {{
    {0.197f, 0.174f, 0.601f},
    {0.182f, 0.230f, 0.651f},
    {0.154f, 0.285f, 0.698f},
    {0.103f, 0.344f, 0.732f},
    {0.037f, 0.403f, 0.750f},
    {0.022f, 0.463f, 0.742f},
    {0.030f, 0.522f, 0.723f},
    {0.026f, 0.579f, 0.705f},
    {0.028f, 0.635f, 0.686f},
    {0.050f, 0.692f, 0.655f},
    {0.155f, 0.745f, 0.600f},
    {0.343f, 0.787f, 0.520f},
    {0.520f, 0.816f, 0.424f},
    {0.683f, 0.835f, 0.323f},
    {0.816f, 0.853f, 0.260f},
    {0.923f, 0.874f, 0.253f},
    {0.990f, 0.890f, 0.270f},
}};

}  // namespace detail

/// From dark violet over green to yellow.      Source: van der Walt and Smith 2015, matplotlib (CC0), every 16th of its 256 colours.
inline constexpr colormap viridis{detail::viridis_table};
/// From dark blue over grey to yellow; looks the same to colour-blind viewers.      Source: Nunez, Anderton and Renslow 2018, every 16th colour.
inline constexpr colormap cividis{detail::cividis_table};
/// From blue over teal to yellow, similar to Parula; brighter than viridis, so that shading is visible.      Source: a curve in OKLCh
/// (Ottosson 2020) with equal steps of lightness and the largest chroma within sRGB.
inline constexpr colormap blue_to_yellow{detail::blue_to_yellow_table};

}  // namespace concino
