// Reads real numbers by a stream, for standard libraries without std::from_chars for doubles.
#pragma once

#include <concino/io/detail/digits.hpp>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

namespace concino::detail {

/// As std::from_chars, by a stream: for standard libraries that do not have it for doubles. Slow.
inline std::from_chars_result real_from_stream(const char* first, const char* last, double& x) {
  const char* p = first;
  const bool negative = p != last && *p == '-';
  if (negative) ++p;
  for (const char* const word : {"infinity", "inf", "nan"}) {
    const char *q = p, *letter = word;
    while (q != last && *letter && (*q | 0x20) == *letter) ++q, ++letter;
    if (*letter) continue;
    x = *word == 'i' ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    if (negative) x = -x;
    return {q, std::errc()};
  }
  const char* const digits = p;
  p = skip_digits(p, last);
  std::ptrdiff_t count = p - digits;
  if (p != last && *p == '.') {
    const char* const fraction = p + 1;
    p = skip_digits(fraction, last);
    count += p - fraction;
  }
  if (count == 0) return {first, std::errc::invalid_argument};
  const bool is_zero = std::string_view(digits, p).find_first_of("123456789") == std::string_view::npos;
  p = end_of_exponent(p, last, 'e');
  std::istringstream in(std::string(first, p));
  in.imbue(std::locale::classic());
  double read = 0;
  in >> read;
  const bool is_large = !(std::abs(read) < std::numeric_limits<double>::max()) && in.fail();
  if (is_large || std::isinf(read) || (read == 0 && !is_zero)) return {p, std::errc::result_out_of_range};
  x = read;
  return {p, std::errc()};
}

}  // namespace concino::detail
