// Measures the 20 smallest eigenpairs of Laplacians by LOBPCG, on a surface, in a volume of tets and of Voronoi polyhedra. The floor is as many solves by
// multigrid, to the same tolerance, with levels built once.
#include "support/kinds.hpp"

#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/operators/mass_matrix.hpp>
#include <concino/solve/eigenpairs.hpp>
#include <concino/solve/multigrid.hpp>

#include <algorithm>

namespace {

template<class M>
void compare_eigenpairs(const bench::program& p, const std::string& work, const M& m) {
  constexpr int count = 20;
  const Eigen::SparseMatrix<double> k = -concino::laplacian(m), mass = concino::mass_matrix(m);
  const auto solves = [&] {
    Eigen::SparseMatrix<double> a = k;
    a.coeffRef(0, 0) *= 2;
    concino::multigrid solver({.tolerance = 1e-8});
    solver.factorize(a);
    Eigen::VectorXd b(a.cols()), x;
    for (int j = 0; j < count; ++j) {
      for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = static_cast<double>((i + j) * 7919 % 101) - 50;
      x = solver.solve(b);
    }
    return x;
  };
  p.print(bench::compare(work, std::min(p.rounds, 3),
                         {{"floor", [&] { return bench::seconds_of(solves); }},
                          {"concino", [&] { return bench::seconds_of([&] { return concino::eigenpairs(k, mass, count, concino::lobpcg); }); }}}));
}

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    if (p.wants("eigenpairs.bunny16")) compare_eigenpairs(p, "eigenpairs.bunny16", concino::trimesh(p.data.bunny16()));
    if (p.wants("eigenpairs.tet105k")) compare_eigenpairs(p, "eigenpairs.tet105k", concino::tetmesh(bench::tet_grid(p.data.tiny ? 7 : 26)));
    if (p.wants("eigenpairs.voronoi20k")) {
      const concino::box domain{{0, 0, 0}, {1, 1, 1}};
      compare_eigenpairs(p, "eigenpairs.voronoi20k", concino::voronoi_polyhedra(concino::random_points(p.data.tiny ? 80 : 20000, domain), domain));
    }
  });
}
