#include <concino/io/detail/text/real_by_strtod.hpp>
#include <concino/io/numbers.hpp>

#include <doctest/doctest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <version>

using namespace concino;
using namespace concino::detail;

namespace {

double parsed(const std::string& s) {
  double x = -77;
  const char* end = parse_real(s.data(), s.data() + s.size(), x);
  REQUIRE_MESSAGE(end == s.data() + s.size(), s);
  return x;
}

double reference(const std::string& s) {
#ifdef __cpp_lib_to_chars
  double x = 0;
  std::from_chars(s.data(), s.data() + s.size(), x);
  return x;
#else
  return std::strtod(s.c_str(), nullptr);
#endif
}

/// The number of characters of the number; -1 if there is none.
std::ptrdiff_t extent(const std::string& s) {
  double x = 0;
  const char* end = parse_real(s.data(), s.data() + s.size(), x);
  return end ? end - s.data() : -1;
}

}  // namespace

TEST_CASE("numbers: reals equal those of from_chars to the last bit") {
  std::mt19937_64 random(7);
  std::size_t wrong = 0;
  for (int i = 0; i < 200000; ++i) {
    // numbers of any length, with the point anywhere; some are near a tie
    std::string s = std::to_string(random() >> (random() % 64));
    s.insert(random() % (s.size() + 1), ".");
    if (s == ".") continue;
    for (std::uint64_t zeros = random() % 8; zeros > 4; --zeros) s.insert(0, s[0] == '.' ? "0" : "");
    if (random() % 4 == 0) s += (random() % 2 ? "e" : "E") + std::to_string(static_cast<int>(random() % 60) - 30);
    if (random() % 2) s.insert(0, "-");
    wrong += std::bit_cast<std::uint64_t>(parsed(s)) != std::bit_cast<std::uint64_t>(reference(s));
  }
  CHECK(wrong == 0);
}

TEST_CASE("numbers: shortest and full decimals of any double read back as the same double") {
  std::mt19937_64 random(3);
  std::size_t wrong = 0;
  char buffer[64];
  for (int i = 0; i < 200000; ++i) {
    const double x =
        i % 2 ? std::ldexp(static_cast<double>(random() >> 11), static_cast<int>(random() % 80) - 90) : std::bit_cast<double>(random());
    if (!std::isfinite(x)) continue;
    const auto short_end = std::to_chars(buffer, buffer + 64, x).ptr;
    wrong += parsed(std::string(buffer, short_end)) != x;
    const auto full_end = std::to_chars(buffer, buffer + 64, x, std::chars_format::scientific, 16).ptr;
    wrong += parsed(std::string(buffer, full_end)) != x;
  }
  CHECK(wrong == 0);
}

TEST_CASE("numbers: ties round to even, and even a distant digit breaks them") {
  CHECK(parsed("9007199254740993") == 9007199254740992.0);
  CHECK(parsed("9007199254740995") == 9007199254740996.0);
  CHECK(parsed("9007199254740993.00000000000000000000000000001") == 9007199254740994.0);
  CHECK(parsed("900719925474099.3") == reference("900719925474099.3"));
  CHECK(parsed("0.50000000000000011102230246251565") == reference("0.50000000000000011102230246251565"));
  CHECK(parsed("18446744073709551615") == 18446744073709551616.0);
}

TEST_CASE("numbers: reals may have more digits than fit in 64 bits") {
  std::mt19937_64 random(11);
  std::size_t wrong = 0;
  const auto check = [&](const std::string& s) { wrong += std::bit_cast<std::uint64_t>(parsed(s)) != std::bit_cast<std::uint64_t>(reference(s)); };
  for (int i = 0; i < 20000; ++i) {
    std::string s;
    for (std::uint64_t n = 17 + random() % 9; n > 0; --n) s += static_cast<char>('0' + (random() % 3 ? 9 - random() % 2 : random() % 10));
    s.insert(0, random() % 4, '0');
    s.insert(random() % (s.size() + 1), ".");
    check(s);
  }
  std::string every_other;
  for (int i = 0; i < 30; ++i) check(every_other += "01");
  for (std::size_t n = 15; n < 25; ++n) check(std::string(n, '9')), check("." + std::string(n, '9')), check("0." + std::string(n, '9'));
  CHECK(wrong == 0);
  CHECK(parsed("1e18446744073709551617") == std::numeric_limits<double>::infinity());
  CHECK(extent("1.5d3") == 5);  // Fortran's exponent
  CHECK(extent("1.5d") == 3);
  CHECK(extent("1.5e3d2") == 5);
  CHECK(extent("1.5D+300x") == 8);
}

TEST_CASE("numbers: signs, points and exponents are parsed or rejected") {
  CHECK(parsed("+1.5") == 1.5);
  CHECK(parsed("1.") == 1);
  CHECK(parsed(".5") == 0.5);
  CHECK(parsed("+.5e1") == 5);
  CHECK(std::signbit(parsed("-0.0")));
  CHECK(parsed("0.000000000000000000000000001") == 1e-27);
  CHECK(parsed("123456789012345678901234567890") == 123456789012345678901234567890.0);
  CHECK(parsed("5e-324") == 5e-324);
  CHECK(parsed("1e-999") == 0);
  CHECK(parsed("-0." + std::string(400, '0') + "1") == 0);
  CHECK(parsed("1e-99999999999999999999") == 0);
  CHECK(std::isinf(parsed("1e999")));
  CHECK(parsed("-1" + std::string(400, '0')) == -std::numeric_limits<double>::infinity());
  CHECK(parsed("1" + std::string(400, '0') + "e-400") == reference("1" + std::string(400, '0') + "e-400"));
  const std::string zeros(500, '0');
  CHECK(parsed("0." + zeros + "1e150") == 0);
  CHECK(parsed("0." + zeros + "1e900") == std::numeric_limits<double>::infinity());
  CHECK(parsed("0." + zeros + "1e+900") == std::numeric_limits<double>::infinity());
  CHECK(parsed("0." + std::string(5000, '0') + "1e4600") == 0);
  CHECK(parsed("0." + std::string(4000, '0') + "1e4400") == std::numeric_limits<double>::infinity());
  CHECK(parsed("1e9223372036854775809") == std::numeric_limits<double>::infinity());
  CHECK(parsed(zeros + "1E400") == std::numeric_limits<double>::infinity());
  CHECK(parsed("1" + zeros + "e-850") == 0);
  CHECK(parsed("1" + zeros + "e-100") == std::numeric_limits<double>::infinity());
  CHECK(parsed("-1" + zeros + ".5e-100") == -std::numeric_limits<double>::infinity());
  CHECK(parsed("+123456789012345678901234567890") == 123456789012345678901234567890.0);
  CHECK(parsed("+inf") == std::numeric_limits<double>::infinity());
  CHECK(std::isnan(parsed("nan")));
  CHECK(std::isinf(parsed("-inf")));
  CHECK(extent("1.5x") == 3);
  CHECK(extent("1e") == 1);
  CHECK(extent("1.2.3") == 3);
  for (const std::string none : {"", "+", "-", ".", "e5", "+-1", "--1", "O", "x", "+ 1"}) CHECK_MESSAGE(extent(none) == -1, none);
}

TEST_CASE("numbers: nothing beyond the end of the text is read") {
  for (int i = 0; i < 256; ++i) CHECK(is_digit(static_cast<char>(i)) == (i >= '0' && i <= '9'));
  for (const std::string& text : {"7" + std::string(29, '3'), "-0." + std::string(40, '4'), "1" + std::string(420, '0'), "." + std::string(420, '0') + "7",
                                  std::string("12.75e3"), std::string("1.25e-12345678"), std::string("+12.5e+30000"), "0." + std::string(500, '0') + "1e1500", "0." + std::string(320, '0') + "1e-1234"})
    for (std::size_t n = 0; n <= text.size(); ++n) {
      const std::string alone = text.substr(0, n);
      double x = -77, y = -77;
      const char *const end = parse_real(text.data(), text.data() + n, x), *const end_alone = parse_real(alone.data(), alone.data() + n, y);
      REQUIRE((end ? end - text.data() : -1) == (end_alone ? end_alone - alone.data() : -1));
      REQUIRE(std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y));
      if (n > 18) continue;
      std::int64_t i = -77, k = -77;
      REQUIRE((parse_integer(text.data(), text.data() + n, i) != nullptr) == (parse_integer(alone.data(), alone.data() + n, k) != nullptr));
      REQUIRE(i == k);
    }
}

TEST_CASE("numbers: integers may have up to 18 digits") {
  const auto read = [](const std::string& s) {
    std::int64_t i = -77;
    const char* end = parse_integer(s.data(), s.data() + s.size(), i);
    return end == s.data() + s.size() ? i : -77;
  };
  CHECK(read("0") == 0);
  CHECK(read("+12") == 12);
  CHECK(read("-999999999999999999") == -999999999999999999);
  CHECK(read("000000000000000000000000000007") == 7);
  CHECK(read("0000000000000000000000000000000") == 0);
  CHECK(read("0999999999999999999") == 999999999999999999);
  CHECK(read("010101010101010101010101010101") == -77);
  const std::string behind_a_digit = "7x";
  std::int64_t unread = 0;
  for (const std::size_t n : {1u, 2u}) CHECK(parse_integer(behind_a_digit.data() + 1, behind_a_digit.data() + n, unread) == nullptr);
  for (const std::string none : {"", "-", "+", "1000000000000000000", "99999999999999999999", "a"}) CHECK_MESSAGE(read(none) == -77, none);
}

TEST_CASE("numbers: integers of any length end correctly before any character") {
  for (unsigned length = 1; length <= 18; ++length)
    for (int after = 0; after < 256; ++after) {
      if (after >= '0' && after <= '9') continue;
      std::string s = "7";
      for (unsigned i = 1; i < length; ++i) s += static_cast<char>('0' + (i * 7 + static_cast<unsigned>(after)) % 10);
      const std::int64_t expected = std::stoll(s);
      for (const std::string& tail : {std::string(1, static_cast<char>(after)), std::string(1, static_cast<char>(after)) + "12345678"}) {
        const std::string text = s + tail;
        std::int64_t i = 0;
        const char* const end = parse_integer(text.data(), text.data() + text.size(), i);
        REQUIRE(end == text.data() + length);
        REQUIRE(i == expected);
      }
    }
}

#ifdef __cpp_lib_to_chars
TEST_CASE("numbers: where the standard library does not read doubles, strtod gives the same") {
  std::mt19937_64 random(19);
  const auto check = [](const std::string& s) {
    double x = -77, y = -77;
    const auto a = std::from_chars(s.data(), s.data() + s.size(), x), b = real_by_strtod(s.data(), s.data() + s.size(), y);
    REQUIRE_MESSAGE(a.ec == b.ec, s);
    REQUIRE_MESSAGE(a.ptr == b.ptr, s);
    if (!std::isnan(x)) REQUIRE_MESSAGE(std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y), s);
    CHECK(std::isnan(x) == std::isnan(y));
  };
  for (int i = 0; i < 5000; ++i) {
    std::string s = std::to_string(random() >> (random() % 64));
    s.insert(random() % (s.size() + 1), ".");
    if (random() % 2) s += "e" + std::to_string(static_cast<int>(random() % 660) - 330);
    if (random() % 2) s.insert(0, "-");
    check(s);
  }
  for (const char* const s : {"", "-", ".", "-.", "+1", "e5", "1e", "1e+", "1.2.3", "5e-324", "2e-324", "1e-999", "0e-999", "0e999", "1e999", "-1e999", "1.7976931348623157e308",
                              "1.7976931348623159e308", "nan", "-nan", "NaN", "inf", "-INF", "infinity", "infin", "in", "1d5", "7x", "--1"})
    check(s);
}
#endif
