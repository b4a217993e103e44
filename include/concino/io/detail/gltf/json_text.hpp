// Strings of JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace concino::detail {

/// The number of bytes of the UTF-8 character at the beginning of a text; 0 if there is none.
inline std::size_t utf8_length(std::string_view s) {
  const auto byte = [&](std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0u; };
  const unsigned a = byte(0);
  if (s.empty()) return 0;
  if (a < 0x80) return 1;
  const std::size_t n = a >= 0xC2 && a < 0xE0 ? 2 : a >= 0xE0 && a < 0xF0 ? 3 : a >= 0xF0 && a < 0xF5 ? 4 : 0;
  for (std::size_t i = 1; i < n; ++i)
    if (byte(i) < 0x80 || byte(i) > 0xBF) return 0;
  // no character has a longer form than it needs, is a surrogate, or is beyond U+10FFFF
  if ((a == 0xE0 && byte(1) < 0xA0) || (a == 0xED && byte(1) > 0x9F) || (a == 0xF0 && byte(1) < 0x90) ||
      (a == 0xF4 && byte(1) > 0x8F))
    return 0;
  return n;
}

/// A text between quotation marks. Bytes that are not UTF-8 become U+FFFD.
inline std::string json_string(std::string_view s) {
  std::string r = "\"";
  while (!s.empty()) {
    const std::size_t n = utf8_length(s);
    const char c = s[0];
    if (n == 0) {
      r += "\xEF\xBF\xBD";
    } else if (c == '"' || c == '\\') {
      (r += '\\') += c;
    } else if (n == 1 && (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)) {
      ((r += "\\u00") += "0123456789abcdef"[c >> 4]) += "0123456789abcdef"[c & 15];
    } else {
      r += s.substr(0, n);
    }
    s.remove_prefix(n ? n : 1);
  }
  return r += '"';
}

}  // namespace concino::detail
