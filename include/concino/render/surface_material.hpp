// Materials: how the light that a surface sends to the viewer depends on its normal.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/render/texture.hpp>

#include <cstdint>

namespace concino {

/// A material in daylight, which is lit by the sky and the light of a picture, or one that has its own light, which
/// moves with the camera and depends on the normal only. The latter shows shapes more clearly; it receives no shadow of
/// the light, but cavities are dark as in daylight.
/// Needs:  nothing.
/// Result: a value that can be copied; copies share a picture.
/// Cost:   O(1) for each point of a surface.
/// Errors: none but those of from.
/// Source: Sloan, Martin, Gooch and Gooch 2001, "The Lit Sphere".
class surface_material {
 public:
  surface_material() = default;

  static surface_material daylight() { return {}; }
  static surface_material matte() { return surface_material(kind::matte); }          // soft light from the upper left
  // the same in a warm tint, with dark contours
  static surface_material clay() { return surface_material(kind::clay); }
  // with a small highlight and bright contours
  static surface_material porcelain() { return surface_material(kind::porcelain); }
  // reflects a bright sky above a dark ground
  static surface_material metal() { return surface_material(kind::metal); }

  /// The light of a picture of a ball: the pixel at which the ball has a normal is the light of this normal. White is
  /// full light.
  /// Errors: invalid_argument if the picture has no pixels.
  static surface_material from(const image& ball) {
    surface_material m(kind::picture);
    m.ball_ = texture::from(ball, texture::outside::clamp);
    return m;
  }

  bool is_daylight() const { return kind_ == kind::daylight; }

  /// The light of a material that is not daylight, by which the colour of the surface is multiplied. The normal has
  /// length 1 in the frame of the viewer: x to the right, y up, z to the eye.
  rgb operator()(const vec3& normal) const;

 private:
  enum class kind : std::uint8_t { daylight, matte, clay, porcelain, metal, picture };
  explicit surface_material(kind k) : kind_(k) {}

  kind kind_ = kind::daylight;
  texture ball_;
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/colors/surface_material.ipp>
#endif
