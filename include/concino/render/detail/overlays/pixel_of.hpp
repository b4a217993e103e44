// Where points in space lie in a picture.
#pragma once

#include <concino/render/camera.hpp>
#include <concino/render/image.hpp>

#include <cmath>
#include <cstddef>
#include <optional>

namespace concino::detail {

/// The place of a point in a picture of this size, which may be outside; nothing if the camera does not have it before
/// its eye.
inline std::optional<pixel_position> pixel_of(const camera& c, std::size_t width, std::size_t height, const vec3& p) {
  if (!is_finite(p)) return {};
  if (!c.parallel && !(dot(c.eye - p, c.back) > 0)) return {};
  const image_point film = c.project(p);
  const double unit = static_cast<double>(height) / 2;
  const pixel_position at{static_cast<double>(width) / 2 + film.x * unit, unit - film.y * unit};
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return {};
  return at;
}

}  // namespace concino::detail
