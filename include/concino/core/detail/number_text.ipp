// Numbers as text; see number_text.hpp.
#pragma once

#include <concino/core/number_text.hpp>

#include <charconv>
#include <string>

namespace concino::core {

CONCINO_INLINE std::string number_text(double x) {
  char buffer[32];
  char* const end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return std::string(buffer, end);
}
CONCINO_INLINE std::string number_text(float x) {
  char buffer[32];
  char* const end = std::to_chars(buffer, buffer + sizeof buffer, x).ptr;
  return std::string(buffer, end);
}

}  // namespace concino::core
