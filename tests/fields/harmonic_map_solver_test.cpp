// harmonic_map uses the solver argument, and passes positive definite matrices to it.
#include <concino/fields/harmonic_map.hpp>
#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace concino;
using namespace concino::testing;

namespace {

using values = std::map<vert_id, double>;

}  // namespace

TEST_CASE("harmonic_map: uses the solver argument, which keeps its factorisation") {
  struct counting : ldlt {
    int factorised = 0;
    void factorize(const Eigen::SparseMatrix<double>& a) {
      ++factorised;
      ldlt::factorize(a);
    }
  };
  const auto m = grid<hexmesh>(2);
  counting solver;
  const auto u = harmonic_map(m, {{vert_id{0}, 0.0}, {vert_id{26}, 1.0}}, {}, solver);
  CHECK(solver.factorised == 1);
  CHECK(u[vert_id{13}] == doctest::Approx(0.5));

  struct wrong : ldlt {
    Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return 0.5 * ldlt::solve(b) + Eigen::VectorXd::Ones(b.size()); }
  };
  CHECK_THROWS_WITH_AS(harmonic_map(m, {{vert_id{0}, 0.0}, {vert_id{26}, 1.0}}, {}, wrong{}), doctest::Contains("too badly conditioned"), solver_error);
}

TEST_CASE_TEMPLATE("harmonic_map: the solver gets positive definite matrices of the unknowns, if there are any", M, CONCINO_KINDS) {
  struct watching : ldlt {
    Eigen::Index unknowns = 0;
    bool is_positive = true;
    void factorize(const Eigen::SparseMatrix<double>& a) {
      unknowns = a.rows();
      is_positive = a.diagonal().minCoeff() > 0;
      ldlt::factorize(a);
    }
  };
  const M m = grid<M>(2);
  values given;
  for (const auto v : verts(m)) {
    for (const int n : {1, 2, 3, 4}) {
      watching solver;
      const auto u = harmonic_map(m, given.empty() ? values{{v, 1}} : given, {.exponent = n}, solver);
      CHECK(solver.unknowns == static_cast<Eigen::Index>(num_verts(m) - std::max<std::size_t>(given.size(), 1)));
      CHECK(solver.is_positive);
      for (const auto w : verts(m)) CHECK(u[w] == doctest::Approx(1));
    }
    given[v] = 1;
  }
  watching solver;
  harmonic_map(m, given, {}, solver);
  CHECK(solver.unknowns == 0);
  struct refusing : ldlt {
    void factorize(const Eigen::SparseMatrix<double>&) { FAIL("there is nothing to solve"); }
  };
  harmonic_map(m, given, {}, refusing{});
}
