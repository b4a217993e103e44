#include <concino/core/message.hpp>

#include <concino/core/error.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>

using namespace concino::core;

TEST_CASE("message: joins texts and numbers of any kind") {
  const std::string name = "file";
  CHECK(joined({name, ": ", std::string_view("line "), std::size_t{12}, std::string(" of ") + "it", 7u}) == "file: line 12 of it7");
  CHECK(joined({}).empty());
  CHECK(joined({std::string_view(), "", ' ', 'c', -1, std::int64_t{0}, std::int8_t{-7}, std::uint8_t{255}}) == " c-10-7255");
  CHECK(joined({std::numeric_limits<std::int64_t>::min(), ' ', ~std::uint64_t{0}}) == "-9223372036854775808 18446744073709551615");
  CHECK_THROWS_WITH_AS(throw_joined<concino::unsupported>({"no ", 2u}), "no 2", concino::unsupported);
}
