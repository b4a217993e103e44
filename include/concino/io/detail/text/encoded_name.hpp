// Names in files whose words contain no blanks: other characters are written as %XX.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

namespace concino::detail {

/// Appends a character as %XX.
inline void append_encoded(std::string& name, char c) {
  ((name += '%') += "0123456789ABCDEF"[static_cast<unsigned char>(c) >> 4]) += "0123456789ABCDEF"[c & 15];
}

/// Whether a character of a name can be written as it is.
inline bool is_plain_in_name(char c) { return c > 32 && c < 127 && c != '"' && c != '%'; }

/// The name that a word stands for.
inline std::string decoded_name(std::string_view w) {
  std::string name;
  for (std::size_t i = 0; i < w.size(); ++i) {
    unsigned code = 0;
    if (w[i] == '%' && i + 2 < w.size() && std::from_chars(&w[i + 1], &w[i + 1] + 2, code, 16).ptr == &w[i + 1] + 2) {
      name += static_cast<char>(code);
      i += 2;
    } else {
      name += w[i];
    }
  }
  return name;
}

}  // namespace concino::detail
