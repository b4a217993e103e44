// Measures the library's own factorisation, and a harmonic map with it, against Eigen's factorisation alone.
#include <concino/solve/ldlt.hpp>

#include "support/harmonic.hpp"

#include <concino/operators/laplacian.hpp>

#include <Eigen/SparseCholesky>

namespace {

/// Minus the Laplacian with one constrained vert.
template<class M>
void compare_factorisations(const bench::program& p, const std::string& work, const M& m) {
  Eigen::SparseMatrix<double> a = -concino::laplacian(m);
  a.coeffRef(0, 0) *= 2;
  const auto by_eigen = [&] { return std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(a); };
  const auto by_ldlt = [&] {
    auto solver = std::make_unique<concino::ldlt>();
    solver->factorize(a);
    return solver;
  };
  p.print(bench::compare(work, std::min(p.rounds, 3),
                         {{"eigen", [&] { return bench::seconds_of(by_eigen); }}, {"concino", [&] { return bench::seconds_of(by_ldlt); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("ldlt.bunny16")) compare_factorisations(p, "ldlt.bunny16", concino::trimesh(p.data.bunny16()));
    if (p.wants("ldlt.tet105k")) compare_factorisations(p, "ldlt.tet105k", concino::tetmesh(bench::tet_grid(p.data.tiny ? 3 : 26)));
    if (p.wants("ldlt.hex27k")) compare_factorisations(p, "ldlt.hex27k", concino::hexmesh(bench::hex_grid(p.data.tiny ? 4 : 30)));
    bench::compare_harmonic<concino::ldlt>(p, "", [](const Eigen::SparseMatrix<double>& a) {
      return std::make_unique<Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>>(a);
    });
  });
}
