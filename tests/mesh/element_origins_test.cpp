// Elements have no origin, one or several, added in any order.
#include <concino/mesh/element_origins.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace concino;

namespace {

std::vector<origin> listed(const element_origins::range& origins) {
  std::vector<origin> r;
  for (const origin x : origins) r.push_back(x);
  CHECK(r.size() == origins.size());
  CHECK(r.empty() == origins.empty());
  return r;
}

}  // namespace

TEST_CASE("element_origins: store at most one origin each") {
  element_origins o(std::vector<std::uint32_t>{4, element_origins::none, 4});
  CHECK(o.size() == 3);
  CHECK(listed(o[0]) == std::vector<origin>{{4, 1}});
  CHECK(listed(o[1]).empty());
  CHECK(o.only(2) == 4);
  CHECK(o.only(1) == element_origins::none);
  o.add(7);
  CHECK(o.size() == 4);
  CHECK(o.only(3) == 7);
  CHECK(element_origins().size() == 0);
}

TEST_CASE("element_origins: origins are kept when an element gets several") {
  element_origins o;
  o.add(3);
  o.add(element_origins::none);
  o.add({{5, 0.25}, {6, 0.75}});
  o.add(8);
  o.add(element_origins::none);
  o.add({{2, 0.5}});
  CHECK(o.size() == 6);
  CHECK(listed(o[0]) == std::vector<origin>{{3, 1}});
  CHECK(listed(o[1]).empty());
  CHECK(listed(o[2]) == std::vector<origin>{{5, 0.25}, {6, 0.75}});
  CHECK(o.only(2) == element_origins::none);
  CHECK(o.only(3) == 8);
  CHECK(listed(o[4]).empty());
  CHECK(listed(o[5]) == std::vector<origin>{{2, 0.5}});
  CHECK(o.only(5) == 2);
  const element_origins copy = o;
  CHECK(listed(copy[2]) == listed(o[2]));
}

TEST_CASE("element_origins: several can be set for elements in any order") {
  element_origins o(std::vector<std::uint32_t>(200, element_origins::none));
  const std::vector<origin> late{{5, 0.25}, {6, 0.75}}, early{{2, 0.5}};
  o.set(190, late);
  o.set(3, early);
  o.add(9);
  CHECK(o.size() == 201);
  CHECK(listed(o[190]) == late);
  CHECK(listed(o[3]) == early);
  CHECK(listed(o[191]).empty());
  CHECK(o.only(200) == 9);
}
