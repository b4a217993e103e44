// solve_qp opens scopes in a profiler.
#include <concino/optimize/qp.hpp>

#include <support/profiled.hpp>

#include <doctest/doctest.h>

#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using names = std::vector<std::string>;

}  // namespace

TEST_CASE("profiler: solve_qp opens a scope, and one for its iterations") {
  Eigen::SparseMatrix<double> one(2, 2);
  one.setIdentity();
  const Eigen::VectorXd at = Eigen::VectorXd::Constant(2, 5.0), low = Eigen::VectorXd::Constant(2, -1.0);
  profiler p;
  const auto r = solve_qp(one, at, one, low, Eigen::VectorXd::Ones(2), {.profiler = &p});
  CHECK(r.status == qp_status::solved);
  CHECK(names_of(p) == names{"solve_qp", "-quadratic program"});
}
