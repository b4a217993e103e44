// Formats numbers for the writers of all formats.
#pragma once

#include <concino/core/rgba.hpp>
#include <concino/core/vec3.hpp>
#include <concino/io/flat_mesh.hpp>
#include <concino/io/numbers.hpp>
#include <concino/io/write_context.hpp>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace concino::detail {

inline void write_point(text_sink& out, const vec3& p) { out << p.x << ' ' << p.y << ' ' << p.z; }

/// Writes the shortest decimal number that becomes the same float when it is read as a double. If is_real, it has a
/// decimal point.
inline void write_float(text_sink& out, float x, bool is_real) {
  char digits[32];
  const char* end = std::to_chars(digits, digits + 32, x).ptr;
  double back = 0;
  parse_real(digits, end, back);
  // rounding twice gave another float
  if (static_cast<float>(back) != x) end = std::to_chars(digits, digits + 32, static_cast<double>(x)).ptr;
  const std::string_view text(digits, static_cast<std::size_t>(end - digits));
  out << text;
  if (is_real && text.find_first_of(".e") == text.npos) out << ".0";
}

/// Finds the integers from 0 to 255 from which a reader obtains this colour. Returns false if there are none.
inline bool bytes_of(const rgba& c, int (&bytes)[4]) {
  const float parts[] = {c.r, c.g, c.b, c.a};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(parts[i] >= 0 && parts[i] <= 1)) return false;
    bytes[i] = static_cast<int>(std::lround(static_cast<double>(parts[i]) * 255));
    if (static_cast<float>(bytes[i] / 255.0) != parts[i]) return false;
  }
  return true;
}

}  // namespace concino::detail
