// eigenfunctions and eigenpairs open scopes in a profiler.
#include <concino/fields/eigenfunctions.hpp>

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

TEST_CASE("profiler: eigenfunctions and eigenpairs open scopes") {
  const auto m = grid<trimesh>(3);
  profiler p;
  eigenfunctions(m, 3, lobpcg, {.profiler = &p});
  CHECK(names_of(p) == names{"eigenfunctions", "-eigenpairs"});
  Eigen::SparseMatrix<double> one(5, 5);
  one.setIdentity();
  profiler q;
  eigenpairs(one, one, 2, lobpcg, {.profiler = &q});
  CHECK(names_of(q) == names{"eigenpairs", "-eigenpairs"});
}
