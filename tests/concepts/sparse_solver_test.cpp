#include <concino/concepts/sparse_solver.hpp>

#include <doctest/doctest.h>

namespace {

struct matrix { double d; };
struct halves {  // the weakest model: factorize may return any type
  double d = 1;
  int factorize(const matrix& a) { d = a.d; return 0; }
  double solve(double b) const { return b / d; }
};
struct forgets { double solve(double b) const { return b; } };
struct changes_itself : halves { double solve(double b) { return b; } };

static_assert(concino::SparseSolver<halves, matrix, double> && concino::SparseSolver<halves&, matrix, double> && !concino::SparseSolver<const halves, matrix, double>);
static_assert(!concino::SparseSolver<forgets, matrix, double> && !concino::SparseSolver<changes_itself, matrix, double> && !concino::SparseSolver<int, matrix, double>);

}  // namespace

TEST_CASE("sparse solver: a factorisation serves many right-hand sides") {
  halves s;
  s.factorize({4});
  CHECK(s.solve(2) == 0.5);
  CHECK(s.solve(8) == 2);
}
