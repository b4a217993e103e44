// Textures: colours that depend on two coordinates, such as a checkerboard, lines, or a picture.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/image.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace concino {

namespace detail {
struct texture_page;
}

/// How texture coordinates change from one sample of a picture to the next one to the right, and to the next one above.
struct texture_steps {
  double u_right = 0, v_right = 0, u_up = 0, v_up = 0;
  double samples_per_pixel = 1;  // along each axis
};

/// A colour and how much of what is below it is covered, in [0, 1]. The colour is that of the covering part, times the
/// part covered.
struct texture_color {
  rgb color;
  float cover = 0;
};

/// A colour for each pair (u, v) of texture coordinates. Copies share the picture. A default-constructed texture is
/// empty and covers nothing.
class texture {
 public:
  enum class outside : std::uint8_t { repeat, clamp };

  texture() = default;

  /// Squares of two colours: `squares` of them in a unit of u, and as many in one of v. The first one begins at (0, 0).
  /// Needs:  squares above 0.      Result: a checkerboard.      Cost: O(1).
  /// Errors: invalid_argument if squares is not positive and finite.
  static texture checkerboard(double squares = 10, const rgb& first = {1, 1, 1},
                              const rgb& second = srgb(0.30f, 0.36f, 0.46f));

  /// Lines of constant width where u or v is a multiple of 1 / lines. Between them what is below can be seen.
  /// Needs:  lines above 0; width in pixels, above 0.      Result: lines at equal steps of u and of v.      Cost: O(1).
  /// Errors: invalid_argument if lines or width is not positive and finite.
  static texture isolines(double lines = 10, const rgb& color = srgb(0.1f, 0.1f, 0.12f), double width = 1.5);

  /// A picture over [0, 1] x [0, 1]: u goes to the right, v up, as in OBJ files. Outside it is repeated, or its border
  /// is continued. Opacities are kept.
  /// Needs:  a picture of at least one pixel.      Result: a texture that is filtered where it is small or seen at an
  ///         angle.      Cost: O(pixels).
  /// Errors: invalid_argument if the picture has no pixels.
  /// Source: smaller pictures as Williams 1983, "Pyramidal Parametrics", averaged along the longer axis of a sample.
  static texture from(const image& picture, outside border = outside::repeat);

  explicit operator bool() const { return kind_ != kind::none; }

  /// The mean colour over a sample.
  /// Needs:  any numbers.      Result: covers nothing if u or v is not finite.      Cost: O(1).      Errors: none.
  texture_color operator()(double u, double v, const texture_steps& steps = {}) const;

 private:
  friend struct detail::texture_page;
  enum class kind : std::uint8_t { none, checkerboard, isolines, picture };

  texture_color of_picture(double u, double v, const texture_steps& steps) const;

  kind kind_ = kind::none;
  outside border_ = outside::repeat;
  double count_ = 1, width_ = 1;
  rgb first_, second_;
  std::shared_ptr<const std::vector<image>> levels_;  // colours times opacities; each has half the size of the one
                                                      // before
};

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/colors/texture.ipp>
#endif
