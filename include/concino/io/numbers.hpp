// Parses numbers: independent of the locale, and correctly rounded.
#pragma once

#include <concino/io/detail/text/decimals.hpp>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>

namespace concino {

/// Reads a real number at the beginning of a text, in decimal digits with an optional sign, point and exponent; as in
/// Fortran, the exponent may begin with D.
/// Needs:  a text [first, last); nothing beyond `last` is read.
/// Result: the end of the number, or null if there is none. x is the nearest double, infinite if the number is too
///         large. "nan" and "inf" are read too; the caller decides whether to accept them.
/// Cost:   linear in the number of digits.
/// Errors: none; x is unspecified if there is no number.
inline const char* parse_real(const char* first, const char* last, double& x) {
  const char* const from = detail::skip_plus(first, last);
  if (!from) return nullptr;
  const auto [end, problem] = detail::real_from_chars(from, last, x);
  if (problem == std::errc::invalid_argument) return nullptr;
  if (end != last && (*end | 0x20) == 'd' &&
      std::string_view(from, end).find_first_of("eEnN") == std::string_view::npos)
    if (const char* const past = detail::end_of_exponent(end, last, 'd'); past != end) {
      std::string with_e(from, past);
      with_e[static_cast<std::size_t>(end - from)] = 'e';
      return parse_real(with_e.data(), with_e.data() + with_e.size(), x) ? past : nullptr;
    }
  if (problem == std::errc::result_out_of_range) {
    const bool negative = *from == '-';
    x = detail::is_too_large(from + negative, end) ? std::numeric_limits<double>::infinity() : 0.0;
    if (negative) x = -x;
  }
  return end;
}

/// Reads an integer at the beginning of a text, in at most 18 decimal digits (leading zeros do not count) with an
/// optional sign.
/// Needs:  a text [first, last); nothing beyond `last` is read.
/// Result: the end of the number, or null if there is none or it has more digits.
/// Cost:   linear in the number of digits.
/// Errors: none; i is unspecified if there is no number.
inline const char* parse_integer(const char* first, const char* last, std::int64_t& i) {
  constexpr std::int64_t bound = 1'000'000'000'000'000'000;
  const char* const from = detail::skip_plus(first, last);
  if (!from) return nullptr;
  const auto [end, problem] = std::from_chars(from, last, i);
  return problem == std::errc() && -bound < i && i < bound ? end : nullptr;
}

}  // namespace concino
