// Measures the 20 smallest eigenpairs of Laplacians by LOBPCG with multigrid against Spectra's Lanczos iteration with a factorisation by ldlt.
#include "../support/kinds.hpp"

#include <concino/adapters/spectra.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/solve/eigenpairs.hpp>

#include <algorithm>

namespace {

template<class M>
void compare_with_spectra(const bench::program& p, const std::string& work, const M& m) {
  const Eigen::SparseMatrix<double> k = -concino::laplacian(m), mass = concino::mass_matrix(m);
  p.print(bench::compare(work, std::min(p.rounds, 3),
                         {{"spectra", [&] { return bench::seconds_of([&] { return concino::eigenpairs(k, mass, 20, {.tolerance = 1e-8}); }); }},
                          {"concino", [&] { return bench::seconds_of([&] { return concino::eigenpairs(k, mass, 20, concino::lobpcg); }); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("eigenpairs.bunny16.spectra")) compare_with_spectra(p, "eigenpairs.bunny16.spectra", concino::trimesh(p.data.bunny16()));
    if (p.wants("eigenpairs.tet105k.spectra")) compare_with_spectra(p, "eigenpairs.tet105k.spectra", concino::tetmesh(bench::tet_grid(p.data.tiny ? 7 : 26)));
  });
}
