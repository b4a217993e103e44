// Property maps of Boost of all categories are maps of concino.
#include <concino/graph/property_map.hpp>

#include <boost/property_map/function_property_map.hpp>

#include <doctest/doctest.h>

#include <map>
#include <string>
#include <vector>

using namespace concino;

namespace {

/// A map that is only accessed by get and put, as maps over foreign containers are.
struct in_bits {
  using key_type = int;
  using value_type = bool;
  using reference = bool;
  using category = boost::read_write_property_map_tag;
  std::vector<bool>* bits;
  friend bool get(const in_bits& m, int i) { return (*m.bits)[std::size_t(i)]; }
  friend void put(in_bits& m, int i, bool b) { (*m.bits)[std::size_t(i)] = b; }
};

/// A write-only map.
struct sum {
  using key_type = int;
  using value_type = int;
  using reference = void;
  using category = boost::writable_property_map_tag;
  int* total;
  friend void put(const sum& m, int, int x) { *m.total += x; }
};

}  // namespace

static_assert(requirement::is_property_map<in_bits> && requirement::is_property_map<int*> && !requirement::is_property_map<std::map<int, int>> &&
              !requirement::is_property_map<int>);

TEST_CASE("property maps: readable and writable maps of Boost are maps") {
  std::vector<bool> bits(3);
  const auto m = as_map(in_bits{&bits});
  static_assert(ReadableMap<decltype(m), int> && WritableMap<decltype(m), int, bool>);
  m[1] = true;
  CHECK(bits == std::vector<bool>{false, true, false});
  CHECK(m[1]);
  CHECK(!m[2]);
}

TEST_CASE("property maps: lvalue maps and arrays can be read and written") {
  std::map<std::string, double> values;
  const auto m = as_map(boost::make_assoc_property_map(values));
  m["a"] = 2;
  m["a"] += 0.5;
  CHECK(values["a"] == 2.5);
  int array[] = {3, 4};
  const auto a = as_map(&array[0]);
  static_assert(std::same_as<decltype(a[1]), int&>);
  a[1] = 5;
  CHECK(array[1] == 5);
}

TEST_CASE("property maps: read-only maps of Boost are readable, write-only ones writable") {
  const auto square = as_map(boost::make_function_property_map<int>([](int i) { return i * i; }));
  static_assert(ReadableMap<decltype(square), int> && !WritableMap<decltype(square), int, int>);
  CHECK(square[7] == 49);
  int total = 0;
  const auto s = as_map(sum{&total});
  static_assert(WritableMap<decltype(s), int, int>);
  s[0] = 4;
  s[1] = 5;
  CHECK(total == 9);
}
