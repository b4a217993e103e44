// Pictures without light and shadow: the colours that the appearance of a drawable gives to its points.
#pragma once

#include <concino/render/render.hpp>

namespace concino::testing {

/// The front of a drawable, the side of large z, seen by an orthographic camera. Its bounding box fills the picture, which is `size` pixels wide and high.
/// Colours are right where the surface is parallel to the picture.
inline image unlit_picture(drawable d, std::size_t size = 40, int samples = 2) {
  render_options o{.samples = samples, .occlusion_rays = 0, .ground = false, .light_size = 0};
  const auto front = [&](drawable shown, std::size_t pixels) {
    shown.look.shine = 0;
    o.width = o.height = pixels;
    o.camera = frame({&shown, 1}, 1, {.towards = {0, 0, 1}, .angle = 0, .margin = 0});
    return render(scene().add(std::move(shown)), o);
  };
  drawable white;
  white.points = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  white.offsets = {0, 3};
  white.corners = {0, 1, 2};
  white.normals.assign(3, {0, 0, 1});
  white.polys = white.polygon_of = {0};
  white.triangles = {{0, 1, 2}};
  white.look.color = {1, 1, 1};
  const float light = front(white, 4)(1, 2).r;
  image picture = front(std::move(d), size);
  for (std::size_t y = 0; y < size; ++y)
    for (std::size_t x = 0; x < size; ++x) picture(x, y) *= 1 / light;
  return picture;
}

inline bool are_close(const rgb& a, const rgb& b, float tolerance = 0.01f) {
  return std::abs(a.r - b.r) <= tolerance && std::abs(a.g - b.g) <= tolerance && std::abs(a.b - b.b) <= tolerance;
}

}  // namespace concino::testing
