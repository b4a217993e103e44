// skeleton_of opens scopes in a profiler.
#include <concino/generate/torus.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/skeleton/skeleton_of.hpp>

#include <support/profiled.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using names = std::vector<std::string>;

}  // namespace

TEST_CASE("profiler: skeleton_of opens a scope, and one for each step") {
  profiler p;
  skeleton_of(make_torus<trimesh>(), {.max_steps = 1, .profiler = &p});
  CHECK(names_of(p) == names{"skeleton_of", "-contracting", "-collapsing edges"});
}
