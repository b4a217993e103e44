// Bodies of unlit_color.hpp: the colour of a point of a drawable without light: of its values, labels, iso-bands,
// iso-lines and edges.
#pragma once

#include <concino/render/detail/colors/unlit_color.hpp>
#include <concino/render/label_colors.hpp>

namespace concino::detail {

/// The number of the value of a corner in `values` or `colors`.
CONCINO_INLINE std::size_t value_index(const drawable& d, value_place place, std::uint32_t polygon,
                                       std::uint32_t corner) {
  return place == value_place::polygons ? polygon : place == value_place::points ? d.corners[corner] : corner;
}

/// The colour of a value without bands and lines.
CONCINO_INLINE rgb mapped_color(const appearance& look, double value) {
  if (!std::isfinite(value)) return look.no_value;
  if (!look.labels) return look.map(look.scale(value));
  const auto label = label_of(value);
  return label ? label_color(*label) : look.no_value;
}

CONCINO_INLINE rgb with_bands(const appearance& look, rgb color, double value, const sample_step& step,
                              const colored_sample& s) {
  const double x = look.scale(value), slope = look.scale.slope(value);
  if (!(slope > 0)) return color;
  if (look.isobands > 0) {
    const double band_step = step.larger() * slope * look.isobands;  // from one sample to the next, in distances
                                                                     // between bands
    const double limit = look.band_limit * s.picture_height * band_step;
    const double width = std::min({1.0, std::max(0.0, look.band_width), limit});
    color = mix(color, {1, 1, 1}, static_cast<float>(band_coverage(x * look.isobands, 1.5 * band_step, width)));
  }
  if (look.isolines > 0) {
    const double covered =
        line_coverage(x * look.isolines, step * (slope * look.isolines), look.isoline_width * s.samples_per_pixel);
    color = mix(color, look.isoline_color, static_cast<float>(covered));
  }
  return color;
}

CONCINO_INLINE bool has_texture(const drawable& d) { return d.look.texture && !d.texture_coordinates.empty(); }

CONCINO_INLINE bool has_lines(const drawable& d) {
  return !d.values.empty() && d.values_at != value_place::polygons && !d.look.labels &&
         (d.look.isobands > 0 || d.look.isolines > 0);
}

CONCINO_INLINE bool needs_steps(const drawable& d) { return has_texture(d) || has_lines(d); }

CONCINO_INLINE rgb value_color(const drawable& d, const colored_sample& s) {
  const auto value = [&](std::uint32_t c) { return d.values[value_index(d, d.values_at, s.polygon, c)]; };
  if (d.look.labels || d.values_at == value_place::polygons) return mapped_color(d.look, value(s.mean.at.nearest()));
  const double x = s.mean.at(value, 0.0);
  const rgb color = mapped_color(d.look, x);
  return has_lines(d) && std::isfinite(x) ? with_bands(d.look, color, x, s.mean.step(value), s) : color;
}

/// The colour below the texture.
CONCINO_INLINE rgb color_below(const drawable& d, const colored_sample& s) {
  if (!d.colors.empty()) {
    if (d.colors_at == value_place::polygons) return d.colors[s.polygon];
    const auto color = [&](std::uint32_t c) {
      const rgb& x = d.colors[value_index(d, d.colors_at, s.polygon, c)];
      return vec3{x.r, x.g, x.b};
    };
    const vec3 mean = s.mean.at(color, vec3{});
    // weights may be negative in concave polygons
    const auto part = [](double x) { return static_cast<float>(std::max(0.0, x)); };
    return {part(mean.x), part(mean.y), part(mean.z)};
  }
  if (!d.values.empty()) return value_color(d, s);
  return !d.exposed.empty() && d.exposed[s.polygon] ? d.look.exposed_color : d.look.color;
}

CONCINO_INLINE rgb unlit_color(const drawable& d, const colored_sample& s) {
  const rgb below = color_below(d, s);
  if (!has_texture(d)) return below;
  const auto u = [&](std::uint32_t c) { return static_cast<double>(d.texture_coordinates[c][0]); };
  const auto v = [&](std::uint32_t c) { return static_cast<double>(d.texture_coordinates[c][1]); };
  const double x = s.mean.at(u, 0.0), y = s.mean.at(v, 0.0);
  if (!std::isfinite(x) || !std::isfinite(y)) return d.look.no_value;
  const sample_step du = s.mean.step(u), dv = s.mean.step(v);
  const texture_color t = d.look.texture(x, y, {du.right, dv.right, du.up, dv.up, s.samples_per_pixel});
  return below * (1 - t.cover) + t.color;
}

CONCINO_INLINE rgb edge_color(const drawable& d, std::uint32_t corner) {
  return d.edge_values.empty() ? d.look.edge_color : mapped_color(d.look, d.edge_values[corner]);
}

}  // namespace concino::detail
