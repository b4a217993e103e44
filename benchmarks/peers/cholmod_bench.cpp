// Measures CHOLMOD's supernodal factorisation against Eigen's, on a surface and in a volume, a harmonic map with CHOLMOD against its factorisation
// alone, multigrid to 1e-10 against CHOLMOD's factorisation with one solve, and a harmonic map as it is by default against the same with both. The speed depends on the BLAS that CHOLMOD uses.
#include "../support/harmonic.hpp"
#include "../support/laplace_system.hpp"

#include <concino/adapters/cholmod.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/solve/multigrid.hpp>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace {

struct eigen_solver {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
  void factorize(const Eigen::SparseMatrix<double>& a) { factors.compute(a); }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return factors.solve(b); }
};

void compare_factorisations(const bench::program& p, const std::string& work, const Eigen::SparseMatrix<double>& a) {
  const auto by_eigen = [&] { return std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(a); };
  const auto by_cholmod = [&] {
    auto solver = std::make_unique<concino::cholmod>();
    solver->factorize(a);
    return solver;
  };
  p.print(bench::compare(work, std::min(p.rounds, 3),
                         {{"eigen", [&] { return bench::seconds_of(by_eigen); }}, {"concino", [&] { return bench::seconds_of(by_cholmod); }}}));
}

/// Solves for one right-hand side, by both.
template<class M>
void compare_with_multigrid(const bench::program& p, const std::string& work, const M& m) {
  Eigen::SparseMatrix<double> a = -concino::laplacian(m);
  a.coeffRef(0, 0) *= 2;
  const Eigen::SparseMatrix<double> lower = a.triangularView<Eigen::Lower>();
  Eigen::VectorXd b(a.cols());
  for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = static_cast<double>(i * 7919 % 101) - 50;
  const auto solve = [&](auto&& solver) {
    solver.factorize(lower);
    return solver.solve(b);
  };
  p.print(bench::compare(work, std::min(p.rounds, 3),
                         {{"cholmod", [&] { return bench::seconds_of([&] { return solve(concino::cholmod()); }); }},
                          {"concino", [&] { return bench::seconds_of([&] { return solve(concino::multigrid({.tolerance = 1e-10})); }); }}}));
}

/// One harmonic map with two prescribed values.
template<class M>
void compare_harmonic_maps(const bench::program& p, const std::string& work, const M& m) {
  const std::vector<std::pair<concino::vert_id, double>> given = {{concino::vert_id{0}, 0.0}, {concino::vert_id{concino::num_verts(m) - 1}, 1.0}};
  const auto u = concino::harmonic_map(m, given), v = concino::harmonic_map(m, given, {}, concino::cholmod());
  for (std::size_t i = 0; i < u.values().size(); ++i)
    if (!(std::abs(u.values()[i] - v.values()[i]) <= 1e-8)) throw std::runtime_error(work + ": two solvers return different maps");
  p.print(bench::compare(work, std::min(p.rounds, 3),
                         {{"cholmod", [&] { return bench::seconds_of([&] { return concino::harmonic_map(m, given, {}, concino::cholmod()); }); }},
                          {"eigen", [&] { return bench::seconds_of([&] { return concino::harmonic_map(m, given, {}, eigen_solver()); }); }},
                          {"concino", [&] { return bench::seconds_of([&] { return concino::harmonic_map(m, given); }); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("factorise.bunny16")) compare_factorisations(p, "factorise.bunny16", bench::laplace_system(concino::trimesh(p.data.bunny16()), concino::uniform));
    if (p.wants("factorise.hex27k"))
      compare_factorisations(p, "factorise.hex27k", bench::laplace_system(concino::hexmesh(bench::hex_grid(p.data.tiny ? 4 : 30)), concino::uniform));
    if (p.wants("solve.bunny16")) compare_with_multigrid(p, "solve.bunny16", concino::trimesh(p.data.bunny16()));
    if (p.wants("solve.tri1m")) compare_with_multigrid(p, "solve.tri1m", concino::trimesh(p.data.tri1m()));
    if (p.wants("solve.tet105k")) compare_with_multigrid(p, "solve.tet105k", concino::tetmesh(bench::tet_grid(p.data.tiny ? 3 : 26)));
    if (p.wants("one-shot.bunny16")) compare_harmonic_maps(p, "one-shot.bunny16", concino::trimesh(p.data.bunny16()));
    if (p.wants("one-shot.tri1m")) compare_harmonic_maps(p, "one-shot.tri1m", concino::trimesh(p.data.tri1m()));
    if (p.wants("one-shot.tet105k")) compare_harmonic_maps(p, "one-shot.tet105k", concino::tetmesh(bench::tet_grid(p.data.tiny ? 3 : 26)));
    bench::compare_harmonic<concino::cholmod>(p, ".cholmod", [](const Eigen::SparseMatrix<double>& a) {
      auto factors = std::make_unique<Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>>>();
      factors->cholmod().nmethods = 1;  // as in the adapter, where this is fastest
      factors->cholmod().method[0].ordering = CHOLMOD_AMD;
      factors->compute(a);
      return factors;
    });
  });
}
