// Small pieces of error messages: numbers as text, independent of any locale.
#pragma once

#include <charconv>
#include <string>

namespace concino::core {

/// The shortest text that reads back as the same number.
template<class T>
std::string number_text(T x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return std::string(buffer, end);
}

}  // namespace concino::core
