// slices_to_mesh and slices_to_volume open scopes in a profiler.
#include <concino/adapters/clipper.hpp>
#include <concino/io/slices.hpp>
#include <concino/print/slices_to_mesh.hpp>
#include <concino/print/slices_to_volume.hpp>

#include <support/profiled.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using names = std::vector<std::string>;

}  // namespace

TEST_CASE("profiler: slices_to_mesh and slices_to_volume open scopes") {
  slices s;
  s.layers.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    s.layers[i].z = static_cast<double>(i);
    s.layers[i].outer.push_back(std::vector<slice_point>{{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  }
  profiler p;
  slices_to_mesh(s, clipper, {.profiler = &p});
  slices_to_volume(s, clipper, {.profiler = &p});
  CHECK(names_of(p) == names{"slices_to_mesh", "-slices_to_mesh", "slices_to_volume", "-slices_to_volume"});
}
