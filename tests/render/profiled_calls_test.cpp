// Ambient occlusion opens scopes in a profiler.
#include <concino/render/ambient_occlusion.hpp>

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

TEST_CASE("profiler: ambient_occlusion opens scopes") {
  const auto m = grid<trimesh>(2);
  profiler p;
  ambient_occlusion(m, {.rays = 2, .profiler = &p});
  ambient_occlusion_at_verts(m, {.rays = 2, .profiler = &p});
  CHECK(names_of(p) == names{"ambient_occlusion", "-ambient occlusion", "ambient_occlusion_at_verts", "-ambient occlusion"});
}
