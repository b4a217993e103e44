// Meshes of which each process reads a slice, compared with those that the first process divides.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_files.hpp>
#include <concino/adapters/distributed_load.hpp>

#include <concino/geometry/measure.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/medit.hpp>
#include <concino/io/pvtu.hpp>
#include <concino/io/vtu.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/corpus_meshes.hpp>
#include <support/distributed.hpp>
#include <support/distributed_comparison.hpp>
#include <support/kinds.hpp>
#include <support/temporary.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

using namespace concino;
using namespace concino::testing;
using namespace distributed_tests;

namespace {

template<class M>
void save_binary(const M& m, const std::string& path) {
  if (is_first()) save_vtu(m, path, {.binary = true});
  MPI_Barrier(MPI_COMM_WORLD);
}

}  // namespace

TEST_CASE_TEMPLATE("load_distributed: the same as the whole mesh divided in the same way", M, CONCINO_ALL_KINDS) {
  const shared_folder folder;
  for (const unsigned n : {1u, 4u}) {
    M m = two_grids<M>(n);
    add_values(m);
    save_binary(m, folder / "m.vtu");
    check_same(load_distributed<M>(MPI_COMM_WORLD, folder / "m.vtu"), load_vtu<M>(folder / "m.vtu"));
    MPI_Barrier(MPI_COMM_WORLD);
  }
}

TEST_CASE_TEMPLATE("load_distributed: MEDIT files", M, trimesh, quadmesh, tetmesh, hexmesh) {
  const shared_folder folder;
  M m = two_grids<M>(2);
  add_values(m);
  auto corner = vert_property<int>(m, "corner"), of_verts = vert_property<int>(m, "label");
  for (const auto v : verts(m)) corner[v] = index_of(m, v) < 5, of_verts[v] = static_cast<int>(index_of(m, v));
  if (is_first()) save_medit(m, folder / "m.meshb", {.binary = true});
  MPI_Barrier(MPI_COMM_WORLD);
  const M of_file = load_medit<M>(folder / "m.meshb");
  CHECK(property_list(of_file).size() >= 4);
  check_same(load_distributed<M>(MPI_COMM_WORLD, folder / "m.meshb"), of_file);
}

TEST_CASE("load_distributed: parts are nearly equal, and have few facets between them") {
  const shared_folder folder;
  const auto m = grid<hexmesh>(8);
  if (is_first()) save_medit(m, folder / "m.meshb", {.binary = true});
  MPI_Barrier(MPI_COMM_WORLD);
  const auto d = load_distributed<hexmesh>(MPI_COMM_WORLD, folder / "m.meshb");
  check_same(d, m);
  const double average = static_cast<double>(num_polys(m)) / number_of_processes();
  std::size_t own = 0;
  for (const auto p : polys(d)) own += !d.is_ghost(p);
  CHECK(static_cast<double>(own) < 1.1 * average + 1);
  CHECK(static_cast<double>(own) > 0.9 * average - 1);
  const std::vector<int> owner = owners(d);
  std::size_t cut = 0;
  for (const auto f : faces(m)) {
    int first = -1;
    for (const auto p : adj_f2p(m, f)) {
      cut += first >= 0 && first != owner[number(m, p)];
      first = owner[number(m, p)];
    }
  }
  concino::detail::partition_pieces pieces(concino::detail::partition_graph_of(m), owner);
  CHECK(pieces.sizes.size() == static_cast<std::size_t>(number_of_processes()));
  // slabs of whole layers have 64 faces between two of them
  CHECK(static_cast<double>(cut) <= 1.3 * 64 * (number_of_processes() - 1));
}

TEST_CASE_TEMPLATE("load_distributed: pieces of parts join neighbours as in the whole mesh", M, CONCINO_ALL_KINDS) {
  const shared_folder folder;
  const auto n = static_cast<std::size_t>(number_of_processes());
  const M m = two_grids<M>(3);
  save_binary(m, folder / "m.vtu");
  concino::detail::slice_graph g;
  for (const std::size_t k : {0u, 1u}) concino::detail::append_slice(g, load_slice<M>(folder / "m.vtu", 2 * static_cast<std::size_t>(rank()) + k, 2 * n));
  concino::detail::join_slices(MPI_COMM_WORLD, g);
  std::mt19937 random(7);
  std::size_t num_joined = 0;
  for (int trial = 0; trial < 12; ++trial) {
    std::vector<int> whole(num_polys(m));
    for (std::size_t p = 0; p < whole.size(); ++p)
      whole[p] = static_cast<int>(trial < 4 ? (p >> trial) % n : trial < 8 && p > 0 && random() % 4 ? static_cast<unsigned>(whole[p - 1]) : random() % n);
    std::vector<int> part(whole.begin() + static_cast<std::ptrdiff_t>(g.first), whole.begin() + static_cast<std::ptrdiff_t>(g.first + g.size()));
    concino::detail::join_pieces_of_slices(MPI_COMM_WORLD, g, part);
    num_joined += concino::detail::join_pieces(concino::detail::partition_graph_of(m), whole, n);
    std::size_t num_wrong = 0;
    for (std::size_t i = 0; i < part.size(); ++i) num_wrong += part[i] != whole[static_cast<std::size_t>(g.first) + i];
    CHECK(num_wrong == 0);
  }
  CHECK((num_joined > 12 || n == 1));
}

TEST_CASE("load_distributed: verts of no poly, non-manifold meshes and empty ones") {
  const shared_folder folder;
  save_binary(trimesh(), folder / "empty.vtu");
  check_same(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "empty.vtu"), trimesh());
  save_binary(trimesh({{0, 0, 0}, {1, 0, 0}}, {}), folder / "loose.vtu");
  check_same(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "loose.vtu"), trimesh({{0, 0, 0}, {1, 0, 0}}, {}));
  // three triangles at one edge, one that touches at a vert; with verts of no poly before, between and after theirs
  trimesh fan({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 8, 8}, {0, -1, 0}, {0, 0, 1}, {2, 0, 0}, {2, 1, 0}, {7, 7, 7}},
              {{1, 2, 3}, {1, 2, 5}, {1, 2, 6}, {2, 7, 8}});
  add_values(fan);
  save_binary(fan, folder / "fan.vtu");
  check_same(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "fan.vtu"), load_vtu<trimesh>(folder / "fan.vtu"));
}

TEST_CASE("load_distributed: files of the corpus, saved in pieces and read again") {
  for (const corpus_row& row : corpus_meshes()) {
    if (std::filesystem::file_size(row.file) > (long_run() ? 1000000 : 20000)) continue;
    CAPTURE(row.name);
    std::visit(
        [&]<class M>(const M& whole) {
          const shared_folder folder;
          save_binary(whole, folder / "m.vtu");
          const auto d = load_distributed<M>(MPI_COMM_WORLD, folder / "m.vtu");
          const M m = load_vtu<M>(folder / "m.vtu");
          check_same(d, m);
          save_pvtu(d, folder / "d.pvtu");
          if (is_first()) {
            const M r = load_pvtu<M>(folder / "d.pvtu");
            CHECK(num_verts(r) == num_verts(m));
            CHECK(num_polys(r) == num_polys(m));
            CHECK(std::abs(total_measure(r) - total_measure(m)) <= 1e-12 * std::abs(total_measure(m)));
          }
        },
        load_any(row.file.string()));
  }
}

TEST_CASE("load_distributed: the report is that of all slices, with each sentence once") {
  load_report all;
  concino::detail::add_report(all, {1, {"an array"}, {"a note"}});
  concino::detail::add_report(all, {2, {"an array", "another"}, {}});
  CHECK(all.reoriented_polys == 3);
  CHECK(all.skipped == std::vector<std::string>{"an array", "another"});
  CHECK(all.notes == std::vector<std::string>{"a note"});
}

TEST_CASE("load_distributed: errors are thrown on all processes") {
  const shared_folder folder;
  CHECK_THROWS_AS(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "none.vtu"), io_error);
  if (is_first()) save_vtu(grid<trimesh>(2), folder / "text.vtu");
  save_binary(grid<quadmesh>(2), folder / "quads.vtu");
  CHECK_THROWS_AS(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "text.vtu"), unsupported);
  CHECK_THROWS_AS(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "quads.vtu"), error);
  // the quad is in the slice of the last process alone
  save_binary(polygonmesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}, {4, 5, 2}, {0, 1, 2, 3}}),
              folder / "last.vtu");
  CHECK_THROWS_WITH_AS(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "last.vtu"), doctest::Contains("last.vtu"), error);
}
