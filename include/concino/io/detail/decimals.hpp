// Building blocks of parse_real and parse_integer: reading digits, and dividing by powers of ten.
#pragma once

#include <concino/core/uint128.hpp>

#include <array>
#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <system_error>

namespace concino::detail {

inline constexpr std::array<double, 23> exact_powers_of_ten = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                                               1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// 1 / 5^k as a 64-bit fraction with its top bit set, rounded down: reciprocal[k] / 2^shift[k] <= 5^-k.
struct inverse_powers_of_five {
  std::array<std::uint64_t, 28> reciprocal{};
  std::array<int, 28> shift{};
};
inline constexpr inverse_powers_of_five inverse_fives = [] {
  inverse_powers_of_five t;
  std::uint64_t five = 1;  // 5^27 is the largest below 2^64
  for (std::size_t k = 0; k < 28; ++k, five *= k < 28 ? 5 : 1) {
    const int bits = 64 - std::countl_zero(five);
    // floor(2^(63 + bits) / 5^k) has its top bit set, except for 5^0, a power of two; long division, one bit at a time
    const int shift = 63 + bits - (k == 0 ? 1 : 0);
    std::uint64_t quotient = 0;
    core::uint128 rest = 0;
    for (int i = shift; i >= 0; --i) {
      rest = (rest << 1) | (i == shift ? 1u : 0u);
      quotient <<= 1;
      if (rest >= five) {
        rest -= five;
        quotient |= 1;
      }
    }
    t.reciprocal[k] = quotient;
    t.shift[k] = shift;
  }
  return t;
}();

inline bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

inline constexpr std::uint64_t small_powers_of_ten[8] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000};

/// Reads eight characters at once: the number of leading digits, and their value.
struct eight_characters {
  unsigned digits;
  std::uint32_t value;

  explicit eight_characters(const char* p) {
    std::uint64_t c;
    std::memcpy(&c, p, 8);
    c ^= 0x3030303030303030u;                                                       // digits become 0 to 9
    const std::uint64_t other = ((c + 0x7676767676767676u) | c) & 0x8080808080808080u;  // the lowest set bit is right, as no digit carries
    digits = static_cast<unsigned>(std::countr_zero(other)) / 8;
    c = digits == 0 ? 0 : c << (64 - 8 * digits);  // moves the last digit to the top; the digits in front become 0
    // combines digits to pairs, pairs to fours, fours to the result: three multiplications instead of eight
    c = c * 10 + (c >> 8);
    value = static_cast<std::uint32_t>((((c & 0x000000FF000000FFu) * 0x000F424000000064u) + (((c >> 16) & 0x000000FF000000FFu) * 0x0000271000000001u)) >> 32);
  }
};

/// Appends the decimal digits at p to w, up to eight at a time. Overflow wraps: the caller counts the digits.
inline const char* read_digits(const char* p, const char* last, std::uint64_t& w) {
  if constexpr (std::endian::native == std::endian::little) {
    while (last - p >= 8) {
      const eight_characters c(p);
      p += c.digits;
      if (c.digits < 8) {
        w = w * small_powers_of_ten[c.digits] + c.value;
        return p;
      }
      w = w * 100000000 + c.value;
    }
  }
  while (p != last && is_digit(*p)) w = w * 10 + static_cast<std::uint64_t>(*p++ - '0');
  return p;
}

/// Computes w / 10^k, correctly rounded, if 64 bits of 10^-k determine it. Returns false (rarely) if they do not.
/// Source: Lemire, Number Parsing at a Gigabyte per Second, 2021; the doubtful cases are left to the caller.
inline bool divide_by_power_of_ten(std::uint64_t w, unsigned k, double& x) {
  const int lead = std::countl_zero(w);
  const core::uint128 product = static_cast<core::uint128>(w << lead) * inverse_fives.reciprocal[k];
  // The reciprocal is too small by less than one unit, so the true product is in [product, product + 2^64).
  std::uint64_t high = static_cast<std::uint64_t>(product >> 64);
  const std::uint64_t low = static_cast<std::uint64_t>(product);
  const int down = (high >> 63) ? 10 : 9;  // the number of bits of `high` below the 53 bits of the mantissa and the rounding bit
  const std::uint64_t mask = (std::uint64_t{1} << down) - 1, rest = high & mask;
  if (rest == mask || (rest == 0 && low == 0)) return false;
  std::uint64_t mantissa = high >> down;  // 54 bits
  mantissa = (mantissa + 1) >> 1;         // never a tie here: a bit after the rounding bit is set
  const int exponent = 64 + down + 1 - lead - inverse_fives.shift[k] - static_cast<int>(k);
  const std::uint64_t scale = static_cast<std::uint64_t>(1023 + exponent) << 52;
  x = static_cast<double>(mantissa) * std::bit_cast<double>(scale);  // exact: mantissa <= 2^53, and the scale is a power of two
  return true;
}

/// The end of an exponent that begins with d or D after the digits [first, end) of a number without an exponent; null if there is none.
inline const char* end_of_fortran_exponent(const char* first, const char* end, const char* last) {
  if (end == last || (*end | 0x20) != 'd' || !(is_digit(end[-1]) || end[-1] == '.')) return nullptr;
  for (const char* q = first; q != end; ++q)
    if ((*q | 0x20) == 'e') return nullptr;
  const char* p = end + 1;
  if (p != last && (*p == '-' || *p == '+')) ++p;
  if (p == last || !is_digit(*p)) return nullptr;
  while (p != last && is_digit(*p)) ++p;
  return p;
}

/// As std::from_chars, but accepts a leading '+', and exponents that begin with d or D.
/// A number too small for a double becomes 0, a number too large becomes infinite.
inline const char* parse_real_slowly(const char* first, const char* last, double& x) {
  const char* p = first;
  if (p != last && *p == '+') {
    ++p;
    if (p != last && *p == '-') return nullptr;
  }
  const auto [end, problem] = std::from_chars(p, last, x);
  if (problem == std::errc::invalid_argument) return nullptr;
  if (const char* const past = end_of_fortran_exponent(p, end, last)) {
    std::string with_e(p, past);
    with_e[static_cast<std::size_t>(end - p)] = 'e';
    return parse_real_slowly(with_e.data(), with_e.data() + with_e.size(), x) ? past : nullptr;
  }
  if (problem == std::errc::result_out_of_range) {
    const bool negative = *p == '-';
    if (negative) ++p;
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
    if (p != end) {
      ++p;
      const bool minus = *p == '-';
      if (*p == '-' || *p == '+') ++p;
      long e = 0;
      for (; p != end && is_digit(*p); ++p) e = e < 100000000 ? e * 10 + (*p - '0') : e;
      magnitude += minus ? -e : e;
    }
    x = magnitude > 0 ? std::numeric_limits<double>::infinity() : 0.0;
    if (negative) x = -x;
  }
  return end;
}

}  // namespace concino::detail
