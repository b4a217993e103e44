// What is no map and no solver is told what it lacks. Compiled by the list in CMakeLists.txt.
#include <concino/concepts/maps.hpp>
#include <concino/concepts/sparse_solver.hpp>

struct element {};
struct matrix {};
struct vector {};

struct closed {};
struct read_only { double operator[](const element&) const; };
struct writable { double& operator[](const element&); };

struct factorizes { void factorize(const matrix&); };
struct solves : factorizes { vector solve(const vector&) const; };

int main() {
#if defined CASE_explain_readable_map
  concino::explain_readable_map<closed, element>();
#elif defined CASE_explain_writable_map
  concino::explain_writable_map<read_only, element, double>();
#elif defined CASE_explain_factorize
  concino::explain_sparse_solver<closed, matrix, vector>();
#elif defined CASE_explain_solve
  concino::explain_sparse_solver<factorizes, matrix, vector>();
#else
  concino::explain_readable_map<read_only, element>();
  concino::explain_writable_map<writable, element, double>();
  concino::explain_sparse_solver<solves, matrix, vector>();
#endif
}
