// Runs of decimal digits in a text.
#pragma once

namespace concino::detail {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

inline const char* skip_digits(const char* p, const char* last) {
  while (p != last && is_digit(*p)) ++p;
  return p;
}

/// The end of the exponent that begins at p with one of two letters; p if there is none.
inline const char* end_of_exponent(const char* p, const char* last, char small) {
  if (p == last || (*p | 0x20) != small) return p;
  const char* digits = p + 1;
  if (digits != last && (*digits == '-' || *digits == '+')) ++digits;
  const char* const end = skip_digits(digits, last);
  return end == digits ? p : end;
}

}  // namespace concino::detail
