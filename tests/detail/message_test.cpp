#include <concino/detail/message.hpp>

#include <concino/error.hpp>

#include <doctest/doctest.h>

using namespace concino::detail;

TEST_CASE("message: texts and numbers of any kind, joined") {
  const std::string name = "file";
  CHECK(joined({name, ": ", std::string_view("line "), std::size_t{12}, std::string(" of ") + "it", 7u}) == "file: line 12 of it7");
  CHECK(joined({}).empty());
  CHECK_THROWS_WITH_AS(throw_joined<concino::unsupported>({"no ", 2u}), "no 2", concino::unsupported);
}
