// Meshes of which each process reads a slice, compared with those that the first process divides.
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/distributed_files.hpp>
#include <concino/adapters/distributed_load.hpp>

#include <concino/convert/convert.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/io/load_any.hpp>
#include <concino/io/medit.hpp>
#include <concino/io/pvtu.hpp>
#include <concino/io/vtu.hpp>
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
    save_binary(two_grids<M>(n), folder / "m.vtu");
    auto arrays = two_grids_arrays<M>(n);
    arrays.points.pop_back();  // no poly has it
    const M m(std::move(arrays));
    const auto d = load_distributed<M>(MPI_COMM_WORLD, folder / "m.vtu");
    check_same(d, m);
    MPI_Barrier(MPI_COMM_WORLD);
  }
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
  // slabs of whole layers have 64 faces between two of them
  CHECK(static_cast<double>(cut) <= 1.3 * 64 * (number_of_processes() - 1));
}

TEST_CASE("load_distributed: verts of no poly, non-manifold meshes and empty ones") {
  const shared_folder folder;
  save_binary(trimesh(), folder / "empty.vtu");
  check_same(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "empty.vtu"), trimesh());
  save_binary(trimesh({{0, 0, 0}, {1, 0, 0}}, {}), folder / "loose.vtu");
  check_same(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "loose.vtu"), trimesh());
  // three triangles at one edge, one that touches at a vert; with verts of no poly before, between and after theirs
  save_binary(trimesh({{9, 9, 9}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {8, 8, 8}, {0, -1, 0}, {0, 0, 1}, {2, 0, 0}, {2, 1, 0}, {7, 7, 7}},
                      {{1, 2, 3}, {1, 2, 5}, {1, 2, 6}, {2, 7, 8}}),
              folder / "fan.vtu");
  const trimesh fan({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {2, 0, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}, {1, 5, 6}});
  check_same(load_distributed<trimesh>(MPI_COMM_WORLD, folder / "fan.vtu"), fan);
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
          const M of_file = load_vtu<M>(folder / "m.vtu");
          const M m = convert<M>(submesh(of_file, [](const poly_t<M>&) { return true; }));  // without verts of no poly
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
