// Reads a mesh and computes a harmonic map with a solver of the user's own, which factorises with Eigen.
#include <concino/fields/harmonic_map.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh/polygonmesh.hpp>

#include <Eigen/SparseCholesky>

#include <cstdio>

namespace cn = concino;

struct own_solver {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors;
  void factorize(const Eigen::SparseMatrix<double>& a) { factors.compute(a); }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return factors.solve(b); }
};

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto m = cn::load<cn::polygonmesh>(argv[1]);
  const auto u = cn::harmonic_map(m, {{cn::vert_id{0}, 0.0}, {cn::vert_id{1}, 1.0}}, {}, own_solver());
  for (const cn::vert_id v : cn::verts(m)) std::printf("%g\n", u[v]);
}
