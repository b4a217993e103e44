// Level sets on every mesh of the corpus, of functions whose values are few integers.
#include <concino/level_sets.hpp>

#include <concino/geometry/bounding_box.hpp>

#include <support/corpus_meshes.hpp>
#include <support/level_sets.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <variant>

using namespace concino;
using namespace concino::testing;

namespace {

/// Checks the level sets of one mesh; returns whether its cells can be cut.
template<class M>
bool check_level_sets(const M& m) {
  std::mt19937 random(1);
  const auto u = random_values(m, random, true);
  if constexpr (dimension_v<M> == 2) {
    check_level_lines(m, isolines(m, u, 1.0));
  } else {
    try {
      check_level_surface(m, isosurface(m, u, 1.0));
    } catch (const unsupported&) {
      return false;
    }
    const double whole = total_measure(m);
    CHECK(std::abs(total_measure(split(m, u, 1.0).mesh) - whole) <= 1e-12 * std::abs(whole));
    const auto between = measure_between(m, u, {0.0, 1.0, 2.0});
    CHECK(std::abs(between[0] + between[1] - whole) <= 1e-12 * std::abs(whole));
  }
  return true;
}

}  // namespace

TEST_CASE("level sets: on every mesh of the corpus") {
  const auto rows = corpus_meshes();
  if (rows.empty()) return skip("no corpus");
  std::size_t cut = 0, refused = 0;
  for (const auto& row : rows) {
    if (!long_run() && std::filesystem::file_size(row.file) > 150'000) continue;
    INFO(row.name);
    const auto any = load_any(row.file.string());
    const bool can_be_cut = std::visit([](const auto& m) { return check_level_sets(m); }, any);
    ++(can_be_cut ? cut : refused);
  }
  CHECK(cut > 20);
  CHECK(refused == 0);
}
