// clip and split open scopes in a profiler.
#include <concino/level_sets/clip.hpp>

#include <support/kinds.hpp>
#include <support/profiled.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using names = std::vector<std::string>;

}  // namespace

TEST_CASE("profiler: clip and split open scopes") {
  const auto m = grid<trimesh>(3);
  profiler p;
  clip(m, plane{{1, 0, 0}, 0.4}, {.profiler = &p});
  split(grid<tetmesh>(2), plane{{1, 0, 0}, 0.4}, {.profiler = &p});
  CHECK(names_of(p) == names{"clip", "-clipping", "split", "-clipping"});
}
