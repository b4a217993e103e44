// Reads real numbers by std::strtod, for standard libraries without std::from_chars for doubles.
#pragma once

#include <concino/io/detail/text/digits.hpp>

#include <charconv>
#include <clocale>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace concino::detail {

/// As std::from_chars. Slow. Needs: no other thread changes the locale.
inline std::from_chars_result real_by_strtod(const char* first, const char* last, double& x) {
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
  std::string text(first, p);  // which the locale may require to have another point
  if (const std::size_t point = text.find('.'); point != std::string::npos)
    text.replace(point, 1, std::localeconv()->decimal_point);
  const double read = std::strtod(text.c_str(), nullptr);
  if (std::isinf(read) || (read == 0 && !is_zero)) return {p, std::errc::result_out_of_range};
  x = read;
  return {p, std::errc()};
}

}  // namespace concino::detail
