// Defines what arrows.hpp declares: the choice of vectors, and their arrows.
#pragma once

#include <concino/render/arrows.hpp>
#include <concino/render/detail/shapes/poisson_disk_subset.hpp>
#include <concino/render/detail/shapes/shape_size.hpp>
#include <concino/render/detail/shapes/tube_builder.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE void check_arrow_options(const arrow_options& o) {
  const char* const caller = "make_arrows";
  check_shape_option(o.scale > 0 && std::isfinite(o.scale), caller, "scale must be positive and finite", o.scale);
  check_shape_option(o.radius >= 0 && std::isfinite(o.radius), caller, "the radius must be finite, and positive or 0",
                     o.radius);
  check_shape_option(o.opacity >= 0 && o.opacity <= 1, caller, "the opacity must be in [0, 1]", o.opacity);
  check_shape_option(o.corners == 0 || (o.corners >= 3 && o.corners <= 256), caller, "corners must be 0 or 3 to 256",
                     o.corners);
}

/// The vectors that have a direction, with those that are to be drawn.
struct chosen_vectors {
  std::vector<std::uint32_t> list;
  std::vector<vec3> points;
  double mean = 0;  // norm of all vectors with a direction
  arrow_report report;
};

CONCINO_INLINE chosen_vectors choose_vectors(const flat_vectors& field, std::size_t count, const char* caller) {
  chosen_vectors c;
  for (std::size_t i = 0; i < field.points.size(); ++i) {
    if (!is_finite(field.points[i]))
      core::throw_joined<invalid_mesh>({caller, field.indices[i], " has a coordinate that is not a finite number"});
    const double size = norm(field.vectors[i]);
    if (!std::isfinite(size)) {
      ++c.report.not_finite;
    } else if (size == 0) {
      ++c.report.zero;
    } else {
      c.list.push_back(static_cast<std::uint32_t>(i));
      c.points.push_back(field.points[i]);
      c.mean += (size - c.mean) / static_cast<double>(c.list.size());
    }
  }
  if (count > 0 && c.list.size() > count) {
    const std::vector<std::uint32_t> some = poisson_disk_subset(c.points, count);
    c.report.thinned = c.list.size() - some.size();
    for (std::size_t k = 0; k < some.size(); ++k) {  // some[k] >= k
      c.list[k] = c.list[some[k]];
      c.points[k] = c.points[some[k]];
    }
    c.list.resize(some.size());
    c.points.resize(some.size());
  }
  c.report.drawn = c.list.size();
  return c;
}

/// A rod along a unit vector, with flat ends.
CONCINO_INLINE void add_rod(tube_builder& build, const vec3& tail, const vec3& d, double length, double radius) {
  const double thickness = std::min(radius, length / 10);
  const tube_frame f = frame_along(d);
  const std::uint32_t first = build.ring(tail, thickness, f), second = build.ring(tail + d * length, thickness, f);
  build.close_flat(first, -d);
  build.connect(first, second);
  build.close_flat(second, d, true);
}

/// An arrow along a unit vector: a shaft with a flat end, and a cone of twice its radius or more.
CONCINO_INLINE void add_arrow(tube_builder& build, const vec3& tail, const vec3& d, double length, double radius) {
  const double shaft = std::min(radius, length / 10), head = 2.4 * shaft, head_length = 5 * shaft;
  const tube_frame f = frame_along(d);
  const vec3 neck = tail + d * (length - head_length);
  const std::uint32_t first = build.ring(tail, shaft, f), second = build.ring(neck, shaft, f),
                      third = build.ring(neck, head, f);
  build.close_flat(first, -d);
  build.connect(first, second);
  build.connect_flat(second, third, -d);
  build.add_cone(third, head, head_length, tail + d * length, d);
}

CONCINO_INLINE drawable arrows_of(const flat_vectors& field, const arrow_options& o, const char* caller) {
  check_arrow_options(o);
  const chosen_vectors chosen = choose_vectors(field, o.count, caller);
  if (o.report) *o.report = chosen.report;
  const std::size_t n = chosen.list.size();
  double spacing = mean_distance(chosen.points);
  if (!(spacing > 0)) spacing = field.size > 0 ? field.size / 4 : 1;
  const double typical = 1.5 * o.scale * spacing, radius = o.radius > 0 ? o.radius : 0.07 * typical;

  drawable d;
  d.look.color = o.color;
  d.look.map = o.map;
  d.look.opacity = o.opacity;
  const int corners = o.corners > 0 ? o.corners : n <= 500 ? 16 : n <= 5000 ? 10 : 6;
  const auto s = static_cast<std::size_t>(corners);
  tube_builder build(d, corners, o.color_by_norm);
  build.reserve("make_arrows", n * (3 * s + 1), n * (3 * s + 1), n * 12 * s, n * (6 * s - 2));
  std::vector<double> norms;
  for (std::size_t k = 0; k < n; ++k) {
    const vec3& v = field.vectors[chosen.list[k]];
    const double size = norm(v), length = typical * (o.equal_lengths ? 1 : std::min(4.0, size / chosen.mean));
    build.begin(field.indices[chosen.list[k]]);
    if (o.color_by_norm) {
      norms.push_back(size);
      build.set_value(size);
    }
    const vec3 direction = v / size;
    if (!(length > 0)) continue;  // it is too short for a double
    (o.heads ? add_arrow : add_rod)(build, chosen.points[k] - direction * (o.centered ? length / 2 : 0),
                                    direction / norm(direction), length, radius);
  }
  if (o.color_by_norm) d.look.scale = value_scale::linear(norms);
  return d;
}

}  // namespace concino::detail
