// Colours of elements, as files hold them and pictures show them.
#pragma once

namespace concino {

/// Red, green, blue and opacity, each usually from 0 to 1; opaque white unless said otherwise. Files may hold larger values: they are kept.
struct rgba {
  float r = 1, g = 1, b = 1, a = 1;

  friend bool operator==(const rgba&, const rgba&) = default;
};

/// The colour of four integers.
/// Needs:  each from 0 to 255, which is not checked.      Result: each part divided by 255.      Cost: O(1).      Errors: none.
constexpr rgba rgba_of_bytes(unsigned r, unsigned g, unsigned b, unsigned a = 255) {
  const auto part = [](unsigned x) { return static_cast<float>(static_cast<double>(x) / 255); };
  return {part(r), part(g), part(b), part(a)};
}

}  // namespace concino
