// A picture in memory, in linear colours.
#pragma once

#include <concino/core/error.hpp>
#include <concino/render/color.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace concino {

/// A position in a picture, in pixels from its upper left corner, x to the right and y down. Pixel (i, j) extends from
/// (i, j) to (i + 1, j + 1).
struct pixel_position {
  double x = 0, y = 0;
};

/// A rectangle in a picture.
struct pixel_box {
  double left = 0, top = 0, right = 0, bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

/// width x height colours in linear light, row by row from the top left; and opacities, from 0 to 1, if add_opacity()
/// was called.
class image {
  std::size_t width_ = 0, height_ = 0;
  std::vector<rgb> pixels_;
  std::vector<float> opacities_;

 public:
  image() = default;
  /// Errors: invalid_argument if width or height is 0 or above 65,535.
  image(std::size_t width, std::size_t height, const rgb& color = {}) : width_(width), height_(height) {
    if (width == 0 || height == 0 || width > 65535 || height > 65535)
      core::throw_joined<invalid_argument>(
          {"image: ", width, " x ", height, " pixels; width and height must be 1 to 65535"});
    pixels_.assign(width * height, color);
  }

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }
  rgb& operator()(std::size_t x, std::size_t y) { return pixels_[y * width_ + x]; }
  const rgb& operator()(std::size_t x, std::size_t y) const { return pixels_[y * width_ + x]; }

  /// Gives each pixel an opacity. Colours are not multiplied by it: a pixel with opacity 0.25 and colour {1, 0, 0} is
  /// red glass, not dark red.
  void add_opacity(float value = 1) { opacities_.assign(pixels_.size(), value); }
  bool has_opacity() const { return !opacities_.empty(); }
  /// Needs: has_opacity().
  float& opacity(std::size_t x, std::size_t y) { return opacities_[y * width_ + x]; }
  /// 1 for a picture without opacities.
  float opacity(std::size_t x, std::size_t y) const { return has_opacity() ? opacities_[y * width_ + x] : 1; }

  friend bool operator==(const image&, const image&) = default;
};

/// The pixels as image files store them: three sRGB bytes each, row by row from the top left; with opacities four, the
/// last one from 0 to
/// 255. Needs:  any picture.      Result: as srgb_bytes of each colour; empty for a picture without pixels.      Cost:
///      O(pixels). Errors:
/// none.
inline std::vector<std::uint8_t> srgb_bytes(const image& picture) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(picture.width() * picture.height() * (picture.has_opacity() ? 4 : 3));
  for (std::size_t y = 0; y < picture.height(); ++y)
    for (std::size_t x = 0; x < picture.width(); ++x) {
      for (const std::uint8_t b : srgb_bytes(picture(x, y))) bytes.push_back(b);
      if (picture.has_opacity()) bytes.push_back(opacity_byte(picture.opacity(x, y)));
    }
  return bytes;
}

}  // namespace concino
