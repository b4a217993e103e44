// expect in 10 lines: solve is there, but is not const
#include <concino/concepts/sparse_solver.hpp>

struct matrix {};
struct vector {};
struct solver {
  void factorize(const matrix&);
  vector solve(const vector&);
};

int main() { concino::explain_sparse_solver<solver, matrix, vector>(); }
