// best_build_direction opens scopes in a profiler.
#include <concino/print/best_build_direction.hpp>

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

TEST_CASE("profiler: best_build_direction opens scopes") {
  profiler p;
  best_build_direction(grid<tetmesh>(1), {.samples = 1, .profiler = &p});
  CHECK(names_of(p) == names{"best_build_direction", "-best build direction"});
}
