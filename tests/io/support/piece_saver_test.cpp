// Pieces of a mesh that are saved one by one, as processes of a parallel program do.
#include <concino/io/pvtu.hpp>
#include <concino/io/support/piece_saver.hpp>
#include <concino/mesh/property_set.hpp>

#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("piece_saver: pieces get their names together, and are the mesh", M, CONCINO_ALL_KINDS) {
  const M m = two_grids<M>(2);
  property_set numbers;
  auto* const of_verts = static_cast<std::int64_t*>(numbers.get(element_kind::vert, "global_id", concino::detail::values_of<std::int64_t>, num_verts(m))->data());
  auto* const of_polys = static_cast<std::int64_t*>(numbers.get(element_kind::poly, "global_id", concino::detail::values_of<std::int64_t>, num_polys(m))->data());
  for (std::size_t i = 0; i < num_verts(m); ++i) of_verts[i] = static_cast<std::int64_t>(i);
  for (std::size_t i = 0; i < num_polys(m); ++i) of_polys[i] = static_cast<std::int64_t>(i);
  std::vector<std::uint32_t> polys_of[3], loose;  // every second poly, none, the others
  for (std::uint32_t p = 0; p < num_polys(m); ++p) polys_of[p % 2 == 0 ? 0 : 2].push_back(p);
  for (const auto v : verts(m))
    if (num_elements(adj_v2p(m, v)) == 0) loose.push_back(static_cast<std::uint32_t>(index_of(m, v)));
  const temporary_folder folder;
  {
    core::piece_saver forgotten(folder / "m.pvtu", 0, 1, false);
    forgotten.write(m, polys_of[0], loose, numbers, {});
  }
  CHECK(folder.num_files() == 0);
  std::deque<core::piece_saver> savers;
  for (std::size_t k = 0; k < 3; ++k) {
    savers.emplace_back(folder / "m.pvtu", k, 3, false);
    savers.back().write(m, polys_of[k], k == 1 ? loose : std::vector<std::uint32_t>(), numbers, {.binary = k == 2});
  }
  CHECK(folder.num_files() == 0);
  for (core::piece_saver& s : savers) s.commit();
  CHECK(folder.num_files() == 4);
  const M r = load_pvtu<M>(folder / "m.pvtu");
  REQUIRE(num_verts(r) == num_verts(m));
  REQUIRE(num_polys(r) == num_polys(m));
  auto v = verts(m).begin();
  for (const auto w : verts(r)) CHECK(point(r, w) == point(m, *v++));
  auto p = polys(m).begin();
  for (const auto q : polys(r)) {
    std::size_t sum = 0, expected = 0;
    for (const auto w : adj_p2v(r, q)) sum += index_of(r, w) * index_of(r, w);
    for (const auto w : adj_p2v(m, *p)) expected += index_of(m, w) * index_of(m, w);
    CHECK(sum == expected);
    ++p;
  }
}

TEST_CASE("piece_saver: what cannot be written") {
  const temporary_folder folder;
  const trimesh m = grid<trimesh>(1);
  core::piece_saver s(folder / "m.pvtu", 0, 1, false);
  CHECK_THROWS_AS(s.write(m, {}, {}, {}, {.as_boundary = true}), invalid_argument);
  write_file(folder / "file", "");
  CHECK_THROWS_AS(core::piece_saver(folder / "file/m.pvtu", 0, 1, false), io_error);
}
