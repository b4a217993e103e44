// The colour of a point of a drawable without light: of its values, labels, iso-bands, iso-lines and edges.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/detail/colors/interpolation.hpp>
#include <concino/render/drawable.hpp>

namespace concino::detail {

/// What is known of a sample on polygon p of a drawable.
struct colored_sample {
  std::uint32_t polygon = 0;
  const sampled_interpolation& mean;
  double samples_per_pixel = 1;  // along each axis
  double picture_height = 1;     // in samples
};

/// Whether the colour depends on how fast values change, so that the interpolation beside the sample is needed.
bool needs_steps(const drawable& d);

/// The colour without edges.
rgb unlit_color(const drawable& d, const colored_sample& s);

/// The colour of the edge from a corner to the next one.
rgb edge_color(const drawable& d, std::uint32_t corner);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/colors/unlit_color.ipp>
#endif
