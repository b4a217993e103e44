// Building blocks of parse_real.
#pragma once

#include <concino/io/detail/text/digits.hpp>

#include <charconv>
#include <version>

#ifndef __cpp_lib_to_chars
#include <concino/io/detail/text/real_by_strtod.hpp>
#endif

namespace concino::detail {

inline std::from_chars_result real_from_chars(const char* first, const char* last, double& x) {
#ifdef __cpp_lib_to_chars
  return std::from_chars(first, last, x);
#else
  return real_by_strtod(first, last, x);
#endif
}

/// Whether a decimal number that is out of the range of doubles is too large, not too small. Needs: no sign.
inline bool is_too_large(const char* p, const char* end) {
  long magnitude = 0;  // the power of ten of the leading digit, from its position before or after the point
  bool point = false, leading = true;
  for (; p != end && (*p == '.' || is_digit(*p)); ++p) {
    if (*p == '.') point = true;
    else if (leading && *p == '0') magnitude -= point ? 1 : 0;
    else {
      leading = false;
      if (point) break;
      ++magnitude;
    }
  }
  while (p != end && (*p | 0x20) != 'e') ++p;
  if (p == end) return magnitude > 0;
  ++p;
  const bool minus = *p == '-';
  if (*p == '-' || *p == '+') ++p;
  long exponent = 0;
  for (; p != end && is_digit(*p); ++p) exponent = exponent < 100000000 ? exponent * 10 + (*p - '0') : exponent;
  return magnitude + (minus ? -exponent : exponent) > 0;
}

/// The first character behind a leading '+'; null if a '-' follows it.
inline const char* skip_plus(const char* first, const char* last) {
  if (first == last || *first != '+') return first;
  return first + 1 != last && first[1] == '-' ? nullptr : first + 1;
}

}  // namespace concino::detail
