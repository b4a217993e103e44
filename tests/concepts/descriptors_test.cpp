// The library's own descriptors: regular, ordered, explicit from a number, unrelated to each other.
#include <concino/concepts/descriptors.hpp>

#include <doctest/doctest.h>

#include <sstream>

namespace cn = concino;

TEST_CASE("an id has a number and says whether it is valid") {
  static_assert(std::regular<cn::vert_id> && std::totally_ordered<cn::vert_id>);
  static_assert(!std::convertible_to<cn::vert_id, unsigned> && !std::convertible_to<unsigned, cn::vert_id> &&
                !std::convertible_to<cn::vert_id, cn::poly_id>);
  static_assert(std::constructible_from<cn::vert_id, long> && std::constructible_from<cn::poly_id, unsigned char>);
  static_assert(!std::constructible_from<cn::vert_id, double> && !std::constructible_from<cn::poly_id, float>);
  CHECK(cn::vert_id{}.is_none());
  CHECK(cn::vert_id{3}.raw() == 3);
  CHECK(cn::vert_id{3} < cn::vert_id{4});
  CHECK(cn::vert_id{std::size_t{3}} == cn::vert_id{3});
}

TEST_CASE("an id is printed as its letter and number") {
  std::ostringstream s;
  s << cn::vert_id{7} << cn::edge_id{0} << cn::face_id{1} << cn::poly_id{2};
  CHECK(s.str() == "v7e0f1p2");
}
