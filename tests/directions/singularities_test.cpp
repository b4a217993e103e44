// singularities and boundary_turns: their sums on generated surfaces of any genus and on all surfaces of the corpus.
#include <concino/directions/singularities.hpp>

#include <concino/generate/torus.hpp>

#include <support/closed_surfaces.hpp>
#include <support/corpus_meshes.hpp>
#include <support/generated.hpp>
#include <support/uv_disks.hpp>

#include <doctest/doctest.h>

#include <filesystem>
#include <string>
#include <variant>

using namespace concino;
using namespace concino::testing;

namespace {

/// The sum of the law of Poincare and Hopf.
template<class F>
int sum_of_indices(const F& f) {
  int sum = 0;
  for (const auto& s : singularities(f)) {
    CHECK(s.index != 0);
    sum += s.index;
  }
  for (const auto& b : boundary_turns(f)) {
    CHECK(is_boundary(f.mesh(), b.edge));
    sum += b.index;
  }
  return sum;
}

}  // namespace

TEST_CASE_TEMPLATE("singularities: indices sum to n chi on surfaces of genus 0 to 8", M, CONCINO_ALL_SURFACE_KINDS) {
  for (int genus = 0; genus <= 8; ++genus)
    for (const int n : {1, 4}) {
      CAPTURE(genus);
      const M m = from_quads<M>(holed_board(genus));
      const auto f = direction_field(m, {.symmetry = n});
      CHECK(sum_of_indices(f) == n * (2 - 2 * genus));
      CHECK(boundary_turns(f).empty());
    }
}

TEST_CASE_TEMPLATE("singularities: a torus has none", M, CONCINO_ALL_SURFACE_KINDS) {
  // Around a thick tube the smoothest field of many directions is small somewhere, with pairs of singularities.
  for (const double radius : {3.0, 12.0}) {
    const M m = make_torus<M>({.cells = {24, 8}, .radius = radius, .tube_radius = 1});
    for (const int n : {1, 2, 4}) {
      const auto f = direction_field(m, {.symmetry = n});
      CHECK(sum_of_indices(f) == 0);
      if (n < radius) CHECK(singularities(f).empty());
    }
  }
}

TEST_CASE_TEMPLATE("singularities: with boundary", M, CONCINO_ALL_SURFACE_KINDS) {
  auto board = holed_board(2);
  board.verts.resize(board.verts.size() - 4);  // one hole
  const M open = from_quads<M>(board);
  for (const int n : {1, 2, 4}) {
    CHECK(sum_of_indices(direction_field(open, {.symmetry = n})) == -3 * n);
    CHECK(sum_of_indices(direction_field(open, {.symmetry = n, .align_with_boundary = true})) == -3 * n);
    const M hill = grid_on<M>(5, on_hill);
    CHECK(sum_of_indices(direction_field(hill, {.symmetry = n})) == n);
    CHECK(sum_of_indices(direction_field(hill, {.symmetry = n, .hard = {{vert_id{3}, {1, 2, 0}}, {vert_id{16}, {-1, 1, 0}}}})) == n);
  }
}

TEST_CASE("singularities: of random polygons") {
  for (unsigned seed = 0; seed < 10; ++seed) {
    CAPTURE(seed);
    const auto m = random_polygons(seed, 5 + 20 * seed);
    CHECK(sum_of_indices(direction_field(m, {.symmetry = 4, .align_with_boundary = true})) == 4);
  }
}

TEST_CASE("singularities: all surfaces of the corpus") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  for (const corpus_row& row : rows) {
    CAPTURE(row.name);
    if (!long_run() && std::filesystem::file_size(row.file) > 100'000) continue;
    const auto column = [&](const char* name) { return row.column.count(name) ? row.column.at(name) : std::string(); };
    const auto any = load_any(row.file.string());
    std::visit(
        [&](const auto& m) {
          if constexpr (dimension_v<decltype(m)> == 2) {
            if (column("manifold") != "yes" || column("orientable") != "True") {
              CHECK_THROWS_AS((void)direction_field(m), error);
              return;
            }
            const int chi = std::stoi(column("euler_chi"));
            for (const int n : {1, 4}) CHECK(sum_of_indices(direction_field(m, {.symmetry = n})) == n * chi);
          }
        },
        any);
  }
}
