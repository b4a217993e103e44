#include <concino/core/poly_chunks.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/operators/detail/compressed_columns.hpp>

#include <support/fields.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

namespace {

struct counter {
  int calls = 0;
};

template<class M>
void check_chunks(const M& m) {
  std::vector<std::size_t> expected;
  std::size_t corners = 0;
  const core::poly_chunks<M> chunks(m, [&](const poly_t<M>& p) {
    expected.push_back(corners);
    std::size_t n = 0;
    for ([[maybe_unused]] const auto v : adj_p2v(m, p)) ++n;
    corners += n;
    return n;
  });
  CHECK(chunks.num_corners() == corners);
  auto met = make_poly_map<int>(m, 0);
  auto first = make_poly_map<std::size_t>(m, 0);
  chunks.template for_each<counter>([&](counter& scratch, const poly_t<M>& p, std::size_t corner) {
    ++met[p];
    first[p] = corner;
    if (++scratch.calls > 1024) ++met[p];  // each chunk has its own scratch
    std::size_t n = 0;
    for ([[maybe_unused]] const auto v : adj_p2v(m, p)) ++n;
    return n;
  });
  std::size_t k = 0;
  bool right = true;
  for (const auto p : polys(m)) right = right && met[p] == 1 && first[p] == expected[k++];
  CHECK(right);
  std::vector<poly_t<M>> in_order;
  for (const auto& part : chunks.template results<std::vector<poly_t<M>>>([](auto& to, const poly_t<M>& p) { to.push_back(p); })) {
    CHECK(part.size() <= 1024);
    in_order.insert(in_order.end(), part.begin(), part.end());
  }
  std::vector<poly_t<M>> all;
  for (const auto p : polys(m)) all.push_back(p);
  CHECK(in_order == all);
}

}  // namespace

TEST_CASE_TEMPLATE("poly_chunks: have every poly once, with the number of corners before it", M, CONCINO_KINDS) {
  check_chunks(M());
  check_chunks(grid<M>(1));
  const M m = grid<M>(VolumeMesh<M> ? 9 : 30);
  check_chunks(m);
  check_chunks(only_mesh(m));
}

TEST_CASE("compressed_columns: sizes beyond 32-bit indices throw") {
  CHECK(concino::detail::empty_columns("test", 5, 3).cols() == 3);
  CHECK_THROWS_WITH_AS(concino::detail::empty_columns("test", std::size_t{1} << 31, 3),
                       "test: the matrix would have more rows than its 32-bit indices can count; split the mesh", unsupported);
  CHECK_THROWS_WITH_AS(concino::detail::empty_columns("test", 3, std::size_t{1} << 40), doctest::Contains("more columns"), unsupported);
  const std::size_t largest = std::numeric_limits<int>::max();
  CHECK(concino::detail::empty_columns("test", largest - 1, 3).rows() == static_cast<Eigen::Index>(largest - 1));
  CHECK_THROWS_AS(concino::detail::empty_columns("test", largest, 3), unsupported);
  CHECK_THROWS_AS(concino::detail::empty_columns("test", 3, largest), unsupported);
  auto a = concino::detail::empty_columns("test", 5, 2);
  a.outerIndexPtr()[1] = a.outerIndexPtr()[2] = 1 << 29;
  CHECK_THROWS_WITH_AS(concino::detail::make_room("test", a, 3), doctest::Contains("test: the matrix would have more entries"), unsupported);
  auto b = concino::detail::empty_columns("test", 5, 2);
  b.outerIndexPtr()[1] = 1;
  b.outerIndexPtr()[2] = 2;
  concino::detail::make_room("test", b, 2);
  CHECK(b.outerIndexPtr()[1] == 2);
  CHECK(b.nonZeros() == 6);
}
