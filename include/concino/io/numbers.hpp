// Parses numbers: independent of the locale, correctly rounded, and fast on the decimals of mesh files.
#pragma once

#include <concino/io/detail/decimals.hpp>

#include <cstddef>
#include <cstdint>

namespace concino {

/// Reads a real number at the beginning of a text, in decimal digits with an optional sign, point and exponent; as in Fortran, the exponent may begin with D.
/// Needs:  a text [first, last); nothing beyond `last` is read.
/// Result: the end of the number, or null if there is none. x is the nearest double, infinite if the number is too large. "nan" and "inf"
///         are read too; the caller decides whether to accept them.
/// Cost:   linear in the number of digits.
/// Errors: none; x is unspecified if there is no number.
inline const char* parse_real(const char* first, const char* last, double& x) {
  const char* p = first;
  const bool negative = p != last && *p == '-';
  if (p != last && (*p == '-' || *p == '+')) ++p;
  std::uint64_t w = 0;
  const char* digits = p;
  p = detail::read_digits(p, last, w);
  std::ptrdiff_t count = p - digits, decimals = 0;
  if (p != last && *p == '.') {
    const char* fraction = ++p;
    p = detail::read_digits(p, last, w);
    decimals = p - fraction;
    count += decimals;
  }
  if (count > 19)  // leading zeros do not count
    for (; digits != p && (*digits == '0' || *digits == '.'); ++digits) count -= *digits == '0';
  if (count == 0 || count > 19) return detail::parse_real_slowly(first, last, x);
  std::ptrdiff_t exponent = -decimals;
  if (p != last && ((*p | 0x20) == 'e' || (*p | 0x20) == 'd')) {
    ++p;
    const bool minus = p != last && *p == '-';
    if (p != last && (*p == '-' || *p == '+')) ++p;
    std::uint64_t e = 0;
    const char* from = p;
    p = detail::read_digits(p, last, e);
    if (p == from || p - from > 4) return detail::parse_real_slowly(first, last, x);
    exponent += minus ? -static_cast<std::ptrdiff_t>(e) : static_cast<std::ptrdiff_t>(e);
  }
  if (w < (std::uint64_t{1} << 53) && exponent >= -22 && exponent <= 22) {  // both are exact, so only the result is rounded
    x = static_cast<double>(w);
    if (exponent < 0) x /= detail::exact_powers_of_ten[static_cast<std::size_t>(-exponent)];
    else x *= detail::exact_powers_of_ten[static_cast<std::size_t>(exponent)];
  } else if (w == 0) {
    x = 0;
  } else if (exponent > 0 || exponent < -27 || !detail::divide_by_power_of_ten(w, static_cast<unsigned>(-exponent), x)) {
    return detail::parse_real_slowly(first, last, x);
  }
  if (negative) x = -x;
  return p;
}

/// Reads an integer at the beginning of a text, in at most 18 decimal digits (leading zeros do not count) with an optional sign.
/// Needs:  a text [first, last); nothing beyond `last` is read.
/// Result: the end of the number, or null if there is none or it has more digits.
/// Cost:   linear in the number of digits.
/// Errors: none; i is unspecified if there is no number.
inline const char* parse_integer(const char* first, const char* last, std::int64_t& i) {
  const char* p = first;
  const bool negative = p != last && *p == '-';
  if (p != last && (*p == '-' || *p == '+')) ++p;
  const char* from = p;
  std::uint64_t n = 0;
  p = detail::read_digits(p, last, n);
  if (p - from > 18)  // leading zeros do not count
    while (from != p && *from == '0') ++from;
  if (p == first || !detail::is_digit(p[-1]) || p - from > 18) return nullptr;
  i = negative ? -static_cast<std::int64_t>(n) : static_cast<std::int64_t>(n);
  return p;
}

}  // namespace concino
