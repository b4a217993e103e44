// The concept iterable: models and non-models.
#include <concino/core/iterable.hpp>

#include <doctest/doctest.h>

#include <initializer_list>
#include <map>
#include <span>
#include <vector>

namespace {

using concino::core::iterable;

struct endless {
  int* begin() const;
};
struct only_if_not_const {
  int* begin();
  int* end();
};

}  // namespace

TEST_CASE("iterable: containers, views and braces are iterable") {
  CHECK(iterable<std::vector<int>>);
  CHECK(iterable<std::map<int, double>>);
  CHECK(iterable<std::span<const int>>);
  CHECK(iterable<std::initializer_list<int>>);
}

TEST_CASE("iterable: requires begin and end of a const object") {
  CHECK_FALSE(iterable<int>);
  CHECK_FALSE(iterable<endless>);
  CHECK_FALSE(iterable<only_if_not_const>);
}
