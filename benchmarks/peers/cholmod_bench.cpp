// Measures CHOLMOD's supernodal factorisation against Eigen's, on a surface and in a volume, and a harmonic map with CHOLMOD against its factorisation
// alone. The speed depends on the BLAS that CHOLMOD uses.
#include "../support/harmonic.hpp"

#include <concino/adapters/cholmod.hpp>
#include <concino/operators/laplacian.hpp>

#include <Eigen/SparseCholesky>

namespace {

/// The lower triangle of minus the Laplacian of a mesh with one constrained vert.
template<class M>
Eigen::SparseMatrix<double> system_of(const M& m) {
  Eigen::SparseMatrix<double> a = -concino::laplacian(m, concino::uniform);
  a.coeffRef(0, 0) *= 2;
  return a.triangularView<Eigen::Lower>();
}

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

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("factorise.bunny16")) compare_factorisations(p, "factorise.bunny16", system_of(concino::trimesh(p.data.bunny16())));
    if (p.wants("factorise.hex27k"))
      compare_factorisations(p, "factorise.hex27k", system_of(concino::hexmesh(bench::hex_grid(p.data.tiny ? 4 : 30))));
    bench::compare_harmonic<concino::cholmod>(p, ".cholmod", [](const Eigen::SparseMatrix<double>& a) {
      auto factors = std::make_unique<Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>>>();
      factors->cholmod().nmethods = 1;  // as in the adapter, where this is fastest
      factors->cholmod().method[0].ordering = CHOLMOD_AMD;
      factors->compute(a);
      return factors;
    });
  });
}
