// validate opens scopes in a profiler.
#include <concino/validate/validate.hpp>

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

TEST_CASE("profiler: validate opens scopes, and finds the same") {
  const auto m = grid<tetmesh>(1);
  profiler p;
  CHECK(validate(m, {.profiler = &p}).defects.size() == validate(m).defects.size());
  CHECK(names_of(p) == names{"validate", "-validate"});
}
