// Colours in linear light, and their conversion to and from sRGB, which screens and files use.
//
// Needs:  numbers in the ranges stated; others are not checked.
// Result: as stated above each function.
// Cost:   O(1).
// Errors: none.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace concino {

/// Red, green and blue in linear light, in which sums and means of colours are physically correct. 1 is the white of
/// paper.
struct rgb {
  float r = 0, g = 0, b = 0;

  constexpr rgb& operator+=(const rgb& o) {
    r += o.r;
    g += o.g;
    b += o.b;
    return *this;
  }
  constexpr rgb& operator*=(float s) {
    r *= s;
    g *= s;
    b *= s;
    return *this;
  }
  friend constexpr rgb operator+(rgb x, const rgb& y) { return x += y; }
  friend constexpr rgb operator*(rgb x, float s) { return x *= s; }
  friend constexpr rgb operator*(const rgb& x, const rgb& y) { return {x.r * y.r, x.g * y.g, x.b * y.b}; }
  friend constexpr bool operator==(const rgb&, const rgb&) = default;
};

/// Interpolates from a (t = 0) to b (t = 1), in linear light.
constexpr rgb mix(const rgb& a, const rgb& b, float t) { return a * (1 - t) + b * t; }

/// Convert between linear light and sRGB (IEC 61966-2-1), both in [0, 1].
inline float srgb_from_linear(float x) {
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}
inline float linear_from_srgb(float x) { return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f); }

/// The colour with sRGB components (r, g, b), each in [0, 1].
inline rgb srgb(float r, float g, float b) { return {linear_from_srgb(r), linear_from_srgb(g), linear_from_srgb(b)}; }

/// Three sRGB bytes for a file. Components above 1 become 255, those that are not a number 0.
inline std::array<std::uint8_t, 3> srgb_bytes(const rgb& c) {
  const auto byte = [](float x) {
    return !(x > 0) ? std::uint8_t{0}
           : x >= 1 ? std::uint8_t{255}
                    : static_cast<std::uint8_t>(srgb_from_linear(x) * 255 + 0.5f);
  };
  return {byte(c.r), byte(c.g), byte(c.b)};
}

/// The byte for an opacity: 0 for 0, 255 for 1 and above. An opacity is no colour, so it is not converted to sRGB.
inline std::uint8_t opacity_byte(float x) {
  return !(x > 0) ? std::uint8_t{0} : x >= 1 ? std::uint8_t{255} : static_cast<std::uint8_t>(x * 255 + 0.5f);
}

/// The perceived lightness of a colour: CIE L*, from 0 (black) to 100 (white).
inline double lightness(const rgb& c) {
  const double y = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
  return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

}  // namespace concino
