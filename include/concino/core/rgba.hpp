// Colours of elements, in files and pictures.
#pragma once

namespace concino {

/// Red, green, blue and opacity, each usually from 0 to 1; opaque white by default. Files may contain larger values:
/// they are kept.
struct rgba {
  float r = 1, g = 1, b = 1, a = 1;

  friend bool operator==(const rgba&, const rgba&) = default;
  // Operators for interpolation.
  friend constexpr rgba operator+(const rgba& x, const rgba& y) { return {x.r + y.r, x.g + y.g, x.b + y.b, x.a + y.a}; }
  friend constexpr rgba operator*(double t, const rgba& x) {
    const auto f = static_cast<float>(t);
    return {f * x.r, f * x.g, f * x.b, f * x.a};
  }
};

/// The colour of four integers.
/// Needs:  each from 0 to 255, which is not checked.      Result: each part divided by 255.      Cost: O(1).     
///         Errors: none.
constexpr rgba rgba_of_bytes(unsigned r, unsigned g, unsigned b, unsigned a = 255) {
  const auto part = [](unsigned x) { return static_cast<float>(static_cast<double>(x) / 255); };
  return {part(r), part(g), part(b), part(a)};
}

}  // namespace concino
