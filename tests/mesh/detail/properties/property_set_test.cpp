// Columns keep their values when they grow, shrink, are copied or fail to; sets find, replace and remove properties by kind and name.
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/property_set.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

using namespace concino;

namespace {

template<class T>
T& value_of(const detail::column& c, std::size_t i) {
  REQUIRE(i < c.size());
  return static_cast<T*>(c.data())[i];
}

/// Has a mean, and counts how often it was scaled.
struct scaled_number {
  double value = 0;
  int times = 0;
  friend scaled_number operator*(double factor, const scaled_number& x) { return {factor * x.value, x.times + 1}; }
  friend scaled_number operator+(const scaled_number& a, const scaled_number& b) { return {a.value + b.value, a.times + b.times}; }
};

/// Its default is 7. The constructors count `left` down, and throw where it is 0.
struct failing_value {
  static inline int left = 1 << 30, alive = 0;
  int value = 7;
  failing_value() { count(); }
  failing_value(const failing_value& o) : value(o.value) { count(); }
  failing_value& operator=(const failing_value&) = default;
  ~failing_value() { --alive; }

 private:
  static void count() {
    if (left-- == 0) throw 7;
    ++alive;
  }
};

struct default_of_three {
  int value = 3;
};

}  // namespace

TEST_CASE("columns: memory grows to twice the size, and not before it is full") {
  detail::column c(detail::values_of<int>, 4);
  const void* const four = c.data();
  c.resize(4);
  CHECK(c.data() == four);
  c.resize(5);
  const void* const eight = c.data();
  CHECK(eight != four);
  c.resize(8);
  CHECK(c.data() == eight);
  c.resize(9);
  CHECK(c.data() != eight);
  const void* const sixteen = c.data();
  c.resize(0), c.resize(16);
  CHECK(c.data() == sixteen);
  c.resize(100);  // as many as asked for, if that is more than twice
  const void* const hundred = c.data();
  c.resize(101);
  CHECK(c.data() != hundred);
}

TEST_CASE("columns: keep their values, and new ones are default values") {
  for (std::size_t n = 0; n <= 5; ++n) {
    CAPTURE(n);
    detail::column c(detail::values_of<default_of_three>, n);
    CHECK(c.data());
    for (std::size_t i = 0; i < n; ++i) CHECK(value_of<default_of_three>(c, i).value == 3);
    for (std::size_t i = 0; i < n; ++i) value_of<default_of_three>(c, i).value = 10 + static_cast<int>(i);
    const detail::column copy(c);
    c.resize(3000);
    CHECK(copy.size() == n);
    for (std::size_t i = 0; i < 3000; ++i) CHECK(value_of<default_of_three>(c, i).value == (i < n ? 10 + static_cast<int>(i) : 3));
    for (std::size_t i = 0; i < n; ++i) CHECK(value_of<default_of_three>(copy, i).value == 10 + static_cast<int>(i));
  }
  detail::column from_nothing(detail::values_of<std::string>);
  CHECK(from_nothing.size() == 0);
  from_nothing.resize(1);
  value_of<std::string>(from_nothing, 0) = "a text that is too long to be kept inside of the string";
  from_nothing.resize(2);
  CHECK(value_of<std::string>(from_nothing, 0) == "a text that is too long to be kept inside of the string");
  CHECK(value_of<std::string>(from_nothing, 1).empty());
}

TEST_CASE("columns: a copy has the value of its origin unchanged, a mean is scaled once for each origin") {
  detail::column c(detail::values_of<scaled_number>, 3);
  CHECK(c.rule() == property_rule::interpolate);
  for (std::size_t i = 0; i < 3; ++i) value_of<scaled_number>(c, i).value = 12.0 * static_cast<double>(i + 1);
  element_origins from;
  from.add({{2, 0.5}});
  from.add(element_origins::none);
  from.add({{0, 1}, {1, 1}, {2, 4}});
  from.add({{0, 0}, {1, 0}, {2, 0}});
  from.add({{0, 0.125}, {1, 0.375}});
  const detail::column taken(c, from);
  CHECK(taken.size() == 5);
  CHECK(value_of<scaled_number>(taken, 0).value == 36);
  CHECK(value_of<scaled_number>(taken, 0).times == 0);
  CHECK(value_of<scaled_number>(taken, 1).value == 0);
  CHECK(value_of<scaled_number>(taken, 2).value == doctest::Approx((12 + 24 + 4 * 36) / 6.0).epsilon(1e-14));
  CHECK(value_of<scaled_number>(taken, 2).times == 3);
  CHECK(value_of<scaled_number>(taken, 3).value == doctest::Approx(24).epsilon(1e-14));
  CHECK(value_of<scaled_number>(taken, 4).value == 21);
}

TEST_CASE("columns: a sum is split in proportion to the weights, in equal parts if all are 0, and unsplit values are copied") {
  detail::column c(detail::values_of<scaled_number>, 4);
  CHECK(c.set_rule(property_rule::sum));
  for (std::size_t i = 0; i < 4; ++i) value_of<scaled_number>(c, i).value = 12.0 * static_cast<double>(i + 1);
  element_origins from;
  from.add({{0, 1}});
  from.add({{0, 3}, {3, 0.25}});
  from.add({{1, 0}});
  from.add({{1, 0}, {2, 5}});
  from.add({{1, 0}});
  from.add(std::span<const origin>());
  const detail::column taken(c, from);
  const auto value = [&](std::size_t i) { return value_of<scaled_number>(taken, i).value; };
  CHECK(value(0) == 3);
  CHECK(value(1) == 9 + 48);
  CHECK(value(2) == doctest::Approx(8).epsilon(1e-14));
  CHECK(value(3) == doctest::Approx(8 + 36).epsilon(1e-14));
  CHECK(value(4) == doctest::Approx(8).epsilon(1e-14));
  CHECK(value(5) == 0);
  element_origins whole;
  whole.add({{2, 5}});
  CHECK(value_of<scaled_number>(detail::column(c, whole), 0).times == 0);
}

TEST_CASE("columns: a count goes to the element with the largest weight, to the first of several, and is never counted twice") {
  detail::column c(detail::values_of<int>, 3);
  CHECK(c.set_rule(property_rule::sum));
  value_of<int>(c, 0) = 5, value_of<int>(c, 1) = 70, value_of<int>(c, 2) = 900;
  element_origins from;
  from.add({{0, 1}});
  from.add({{0, 2}, {1, 0}});
  from.add({{0, 2}, {2, 1}, {1, 0}});
  from.add({{2, 3}, {2, 3}});  // the same origin twice
  const detail::column taken(c, from);
  CHECK(value_of<int>(taken, 0) == 0);
  CHECK(value_of<int>(taken, 1) == 75);
  CHECK(value_of<int>(taken, 2) == 0);
  CHECK(value_of<int>(taken, 3) == 900);
}

TEST_CASE("columns: the value with the largest weight is copied, the first of several") {
  detail::column c(detail::values_of<std::string>, 3);
  value_of<std::string>(c, 0) = "a", value_of<std::string>(c, 1) = "b", value_of<std::string>(c, 2) = "c";
  element_origins from;
  from.add({{0, 1}, {1, 3}, {2, 2}});
  from.add({{1, 2}, {2, 2}, {0, 1}});
  from.add(element_origins::none);
  from.add({{2, 0}});
  const detail::column taken(c, from);
  CHECK(value_of<std::string>(taken, 0) == "b");
  CHECK(value_of<std::string>(taken, 1) == "b");
  CHECK(value_of<std::string>(taken, 2).empty());
  CHECK(value_of<std::string>(taken, 3) == "c");
}

TEST_CASE("columns: arrays are averaged in each part") {
  detail::column c(detail::values_of<std::array<float, 3>>, 2);
  value_of<std::array<float, 3>>(c, 0) = {4, 8, 12};
  value_of<std::array<float, 3>>(c, 1) = {8, 4, 16};
  element_origins from;
  from.add({{0, 3}, {1, 1}});
  CHECK(value_of<std::array<float, 3>>(detail::column(c, from), 0) == std::array<float, 3>{5, 7, 13});
}

TEST_CASE("columns: a rule that the type does not allow is refused, and the rule is kept") {
  detail::column number(detail::values_of<double>, 1), count(detail::values_of<int>, 1), name(detail::values_of<std::string>, 1);
  for (const property_rule rule : {property_rule::sum, property_rule::copy, property_rule::interpolate}) {
    CHECK(number.set_rule(rule));
    CHECK(number.rule() == rule);
    CHECK(detail::column(number).rule() == rule);
    CHECK(count.set_rule(rule) == (rule != property_rule::interpolate));
    CHECK(name.set_rule(rule) == (rule == property_rule::copy));
  }
  CHECK(count.rule() == property_rule::copy);
  CHECK(count.set_rule(property_rule::sum));
  CHECK_FALSE(count.set_rule(property_rule::interpolate));
  CHECK(count.rule() == property_rule::sum);
  CHECK(name.rule() == property_rule::copy);
}

TEST_CASE("columns: what fails while values are made, moved or copied leaves the values before, and none too many alive") {
  {
    detail::column c(detail::values_of<failing_value>, 3);
    for (std::size_t i = 0; i < 3; ++i) value_of<failing_value>(c, i).value = static_cast<int>(i);
    for (const int allowed : {0, 1, 2}) {  // while the values are moved
      failing_value::left = allowed;
      CHECK_THROWS_AS(c.resize(5), int);
      failing_value::left = allowed;
      CHECK_THROWS_AS(detail::column{c}, int);
      failing_value::left = allowed;
      CHECK_THROWS_AS(detail::column(c, element_origins({0, 1, 2})), int);
      failing_value::left = allowed;
      CHECK_THROWS_AS(detail::column(c, element_origins({0, element_origins::none, element_origins::none})), int);
      failing_value::left = 1 << 30;
      CHECK(failing_value::alive == 3);
      CHECK(c.size() == 3);
      for (std::size_t i = 0; i < 3; ++i) CHECK(value_of<failing_value>(c, i).value == static_cast<int>(i));
    }
    failing_value::left = 4;  // while new values are made
    CHECK_THROWS_AS(c.resize(6), int);
    failing_value::left = 1 << 30;
    CHECK(failing_value::alive == static_cast<int>(c.size()));
    c.resize(2);
    CHECK(failing_value::alive == 2);
    for (std::size_t i = 0; i < 2; ++i) CHECK(value_of<failing_value>(c, i).value == static_cast<int>(i));
  }
  CHECK(failing_value::alive == 0);
}

TEST_CASE("property sets: find and remove by kind and name") {
  property_set all;
  constexpr element_kind kinds[] = {element_kind::vert, element_kind::edge, element_kind::face, element_kind::poly, element_kind::corner};
  for (const element_kind kind : kinds) CHECK_FALSE(all.has(kind));
  for (const element_kind kind : kinds)
    for (const char* name : {"a", "b", "c"}) all.get(kind, name, detail::values_of<double>, 2);
  CHECK(all.size() == 15);
  CHECK(all.get(element_kind::edge, "b", detail::values_of<double>, 5)->size() == 2);  // it exists
  CHECK(all.size() == 15);
  for (const element_kind kind : kinds) CHECK(all.has(kind));
  CHECK_FALSE(all.has(element_kind::mesh));
  CHECK(all.remove(element_kind::edge, "b"));
  CHECK_FALSE(all.remove(element_kind::edge, "b"));
  CHECK_FALSE(all.remove(element_kind::mesh, "a"));
  CHECK_FALSE(all.remove(element_kind::edge, "d"));
  CHECK(all.size() == 14);
  for (const element_kind kind : kinds)
    for (const char* name : {"a", "b", "c"}) {
      const bool is_removed = kind == element_kind::edge && std::string(name) == "b";
      CHECK((all.find(kind, name, detail::values_of<double>) == nullptr) == is_removed);
    }
  CHECK(all.info(3).name == "a");
  CHECK(all.info(4).name == "c");
  CHECK(all.info(4).kind == element_kind::edge);
  CHECK(all.remove(element_kind::edge, "a"));
  CHECK(all.has(element_kind::edge));
  CHECK(all.remove(element_kind::edge, "c"));
  CHECK_FALSE(all.has(element_kind::edge));
  CHECK(all.has(element_kind::corner));
}

TEST_CASE("property sets: values are given only for the right kind, name and type") {
  property_set all;
  const auto heat = all.get(element_kind::vert, "heat", detail::values_of<double>, 2);
  const auto label = all.get(element_kind::poly, "heat", detail::values_of<int>, 2);
  const auto cold = all.get(element_kind::vert, "cold", detail::values_of<double>, 2);
  CHECK(all.values_if_any(element_kind::vert, "heat", typeid(double)) == heat->data());
  CHECK(all.values_if_any(element_kind::poly, "heat", typeid(int)) == label->data());
  CHECK(all.values_if_any(element_kind::vert, "cold", typeid(double)) == cold->data());
  CHECK(all.values_if_any(element_kind::vert, "heat", typeid(int)) == nullptr);
  CHECK(all.values_if_any(element_kind::poly, "heat", typeid(double)) == nullptr);
  CHECK(all.values_if_any(element_kind::poly, "cold", typeid(double)) == nullptr);
  CHECK(all.values_if_any(element_kind::edge, "heat", typeid(double)) == nullptr);
  CHECK(all.values_if_any(element_kind::vert, "warm", typeid(double)) == nullptr);
}

TEST_CASE("property sets: a rule is set for one property, or the message says why not") {
  property_set all;
  all.get(element_kind::vert, "x", detail::values_of<double>, 1);
  all.get(element_kind::poly, "x", detail::values_of<double>, 1);
  all.get(element_kind::vert, "n", detail::values_of<int>, 1);
  all.get(element_kind::vert, "s", detail::values_of<std::string>, 1);
  all.set_rule(element_kind::poly, "x", property_rule::sum);
  CHECK(all.info(0).rule == property_rule::interpolate);
  CHECK(all.info(1).rule == property_rule::sum);
  CHECK(all.info(2).rule == property_rule::copy);
  CHECK_THROWS_WITH_AS(all.set_rule(element_kind::vert, "n", property_rule::interpolate),
                       "set_property_rule: vert property \"n\" cannot be transferred by the rule \"interpolate\": its values, of type int, have no mean", invalid_argument);
  CHECK_THROWS_WITH_AS(all.set_rule(element_kind::vert, "s", property_rule::sum),
                       "set_property_rule: vert property \"s\" cannot be transferred by the rule \"sum\": its values, of type std::string, cannot be added", invalid_argument);
  CHECK_THROWS_WITH_AS(all.set_rule(element_kind::corner, "x", property_rule::sum), "set_property_rule: the mesh has no corner property \"x\"", invalid_argument);
}

TEST_CASE("property sets: copies are independent, moves and assignments keep the values") {
  property_set all;
  const auto one = all.get(element_kind::mesh, "scale", detail::values_of<double>, 1);
  value_of<double>(*one, 0) = 2.5;
  property_set copy(all);
  value_of<double>(*one, 0) = 4;
  CHECK(value_of<double>(*copy.find(element_kind::mesh, "scale", detail::values_of<double>), 0) == 2.5);
  property_set moved(std::move(all));
  CHECK(moved.find(element_kind::mesh, "scale", detail::values_of<double>) == one);
  copy = std::move(moved);
  CHECK(copy.size() == 1);
  CHECK(copy.find(element_kind::mesh, "scale", detail::values_of<double>) == one);
}

TEST_CASE("property sets: grow with the elements of each kind, and the mesh as a whole keeps one value") {
  property_set all;
  const detail::index_bounds before{1, 2, 3, 4, 5}, after{11, 12, 13, 14, 15};
  constexpr element_kind kinds[] = {element_kind::vert, element_kind::edge, element_kind::face, element_kind::poly, element_kind::mesh, element_kind::corner};
  for (const element_kind kind : kinds) all.get(kind, "u", detail::values_of<double>, 0);
  const auto check_sizes = [&](const std::vector<std::size_t>& sizes) {
    for (std::size_t i = 0; i < sizes.size(); ++i) CHECK(all.find(kinds[i], "u", detail::values_of<double>)->size() == sizes[i]);
  };
  all.grow(before, before);
  check_sizes({1, 2, 3, 4, 1, 5});
  all.grow(before, after);
  check_sizes({11, 12, 13, 14, 1, 15});
  all.get(element_kind::poly, "fails", detail::values_of<failing_value>, 14);
  failing_value::left = 0;
  CHECK_THROWS_AS(all.grow(after, {21, 22, 23, 24, 25}), int);
  failing_value::left = 1 << 30;
  check_sizes({11, 12, 13, 14, 1, 15});
}

TEST_CASE("property sets: a transfer replaces properties of the same kind and name, adds the others and keeps the rest") {
  property_set source, target;
  const auto set = [](property_set& s, element_kind kind, const char* name, double value) {
    value_of<double>(*s.get(kind, name, detail::values_of<double>, 1), 0) = value;
  };
  set(source, element_kind::vert, "a", 1), set(source, element_kind::vert, "b", 2), set(source, element_kind::poly, "c", 3), set(source, element_kind::mesh, "m", 4);
  set(target, element_kind::poly, "b", -1), set(target, element_kind::vert, "b", -2), set(target, element_kind::vert, "c", -3), set(target, element_kind::mesh, "m", -4);
  correspondence c;
  c.verts = c.polys = element_origins({0});
  target.transfer(source, c);
  CHECK(target.size() == 6);
  const auto value = [&](element_kind kind, const char* name) { return value_of<double>(*target.find(kind, name, detail::values_of<double>), 0); };
  CHECK(value(element_kind::poly, "b") == -1);
  CHECK(value(element_kind::vert, "b") == 2);
  CHECK(value(element_kind::vert, "c") == -3);
  CHECK(value(element_kind::mesh, "m") == 4);
  CHECK(value(element_kind::vert, "a") == 1);
  CHECK(value(element_kind::poly, "c") == 3);
  CHECK(target.info(4).name == "a");
}
