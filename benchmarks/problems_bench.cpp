// Measures Poisson's equation, smoothing and heat flow with the library's own solver against the one factorisation that each needs, and one step of heat
// flow against its two back-substitutions.
#include "support/kinds.hpp"

#include <concino/fields.hpp>
#include <concino/solve/ldlt.hpp>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace {

using sparse = Eigen::SparseMatrix<double>;
using factors = Eigen::SimplicialLDLT<sparse>;

/// A solver that stores the matrix that it is asked to factorise.
struct matrix_keeper {
  sparse matrix;
  concino::ldlt inner;
  void factorize(const sparse& a) { inner.factorize(matrix = a); }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return inner.solve(b); }
};

/// Measures `solve(solver)` against the factorisation of the matrix that it passes to its solver.
template<class F>
void compare_with_factorisation(const bench::program& p, const std::string& work, const F& solve) {
  if (!p.wants(work)) return;
  matrix_keeper keeper;
  solve(keeper);
  p.print(bench::compare(work, std::min(p.rounds, 5),
                         {{"factorisation", [&] { return bench::seconds_of([&] { return std::make_unique<factors>(keeper.matrix); }); }},
                          {"concino", [&] {
                             return bench::seconds_of([&] {
                               concino::ldlt solver;
                               return solve(solver);
                             });
                           }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const concino::trimesh m(p.data.bunny());
    const concino::vert_id a{0};
    auto f = concino::make_vert_map<double>(m);
    double size = 0;  // the largest area of a poly
    for (const auto v : concino::verts(m)) f[v] = std::sin(static_cast<double>(v.raw()));
    for (const auto t : concino::polys(m)) size = std::max(size, concino::area(m, t));

    compare_with_factorisation(p, "poisson.bunny", [&](auto& solver) { return concino::poisson(m, f, {.values = {{a, 0.0}}}, solver); });
    compare_with_factorisation(p, "smooth.bunny", [&](auto& solver) { return concino::smooth(m, f, size, {}, solver); });
    compare_with_factorisation(p, "heat_flow.prepare.bunny", [&](auto& solver) { return concino::heat_flow(m, f, size, {.steps = 1}, solver); });

    const std::string step = "heat_flow.step.bunny";
    if (!p.wants(step)) return;
    matrix_keeper keeper;
    concino::heat_flow(m, f, size, {.steps = 1}, keeper);
    const factors both(keeper.matrix);
    const auto flow = concino::prepare_heat_flow(m, size, {.steps = 1}, concino::ldlt{});
    if (const auto u = flow.advance(f); !std::isfinite(u[a])) throw std::runtime_error(step + ": the heat is not finite");
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(keeper.matrix.cols());
    p.print(bench::compare(step, p.rounds,
                           {{"substitutions", [&] {
                               return bench::seconds_of([&] {
                                 const Eigen::VectorXd u = both.solve(load);
                                 return Eigen::VectorXd(both.solve(u));
                               });
                             }},
                            {"concino", [&] { return bench::seconds_of([&] { return flow.advance(f); }); }}}));
  });
}
