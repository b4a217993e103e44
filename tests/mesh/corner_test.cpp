#include <concino/mesh/corner.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/maps.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("corners: each has a vert and an independent value", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  auto number = make_corner_map<std::size_t>(m);
  static_assert(std::same_as<decltype(number), corner_map<M, std::size_t>> && WritableMap<decltype(number), corner<M>, std::size_t>);
  std::size_t next = 0;
  for (const auto p : polys(m)) {
    std::uint32_t k = 0;
    for (const auto v : adj_p2v(m, p)) {
      const corner<M> c{p, k++};
      CHECK(vert_at(m, c) == v);
      number[c] = next++;
    }
    CHECK(number.of(p).size() == k);
    CHECK(corner<M>{p, 0} == corner<M>{p, 0});
    CHECK_FALSE(corner<M>{p, 0} == corner<M>{p, 1});
  }
  CHECK(number.values().size() == next);
  next = 0;
  const auto& read = number;
  for (const auto p : polys(m))
    for (const std::size_t n : read.of(p)) CHECK(n == next++);
  CHECK(&read.mesh() == &m);
  const auto weak = only_mesh(m);
  const auto same = make_corner_map<double>(weak, 2.5);
  for (const auto p : polys(weak)) CHECK(same[{p, 1}] == 2.5);
}
