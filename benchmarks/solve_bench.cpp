// Measures how solving scales with the mesh: minus the Laplacian, with one vert constrained, is factorised and solved for one right-hand side. By
// factorisation the meshes have from 10^4 to 10^6.5 triangles and to 10^5.5 tets, by iteration to 10^6.5 of both; by multigrid also to 10^6 hexes. The floor of
// a factorisation is that of Eigen, the floor of an iteration as many products with the matrix as it took. Memory is the peak while solving, without the
// matrix; its floor is the matrix.
#include "support/heap.hpp"
#include "support/kinds.hpp"
#include "support/laplace_system.hpp"

#include <concino/solve/conjugate_gradients.hpp>
#include <concino/solve/ldlt.hpp>
#include <concino/solve/multigrid.hpp>

#include <Eigen/SparseCholesky>

#include <cmath>

namespace {

using sparse = Eigen::SparseMatrix<double>;

/// make(n) returns a mesh of about n polys. Solver: a factorisation without options, or an iteration.
template<class Solver, class Make, class... Options>
void grow(const bench::program& p, const std::string& kind, const char* by, double last, const char* model, const char* memory_model,
          const Make& make, const Options&... options) {
  const std::string work = "scaling.solve." + std::string(by) + "." + kind, memory = "scaling.memory.solve." + std::string(by) + "." + kind;
  if (!p.wants(work) && !p.wants(memory)) return;
  for (double exponent = 4; exponent <= last; exponent += 0.5) {
    if (p.data.tiny && exponent > 4.5) break;
    const auto m = make(std::pow(10.0, p.data.tiny ? exponent - 2 : exponent));
    const auto polys = static_cast<double>(concino::num_polys(m));
    const sparse a = bench::laplace_system(m);
    Eigen::VectorXd b(a.cols()), x;
    for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = static_cast<double>(i * 7919 % 101) - 50;
    int iterations = 0;
    const std::size_t before = bench::heap::live;
    bench::heap::peak = before;
    const auto solve = [&] {
      Solver solver(options...);
      solver.factorize(a);
      x = solver.solve(b);
      if constexpr (requires { solver.iterations(); }) iterations = solver.iterations();
      return 0;
    };
    solve();
    const auto held = static_cast<double>(bench::heap::peak - before);
    const auto floor = [&] {
      if (iterations == 0) {
        const Eigen::SimplicialLDLT<sparse> factors(a);
        x = factors.solve(b);
      } else {
        for (int k = 0; k < iterations; ++k) x = a.selfadjointView<Eigen::Lower>() * b;
      }
      return 0;
    };
    const auto rows = bench::compare(work, exponent > 5 ? 1 : std::min(p.rounds, 3),
                                     {{"floor", [&] { return bench::seconds_of(floor); }}, {"concino", [&] { return bench::seconds_of(solve); }}});
    p.print_point(work, model, polys, rows[1].value, rows[0].value);
    p.print_point(memory, memory_model, polys, held, static_cast<double>(12 * a.nonZeros()));
  }
}

concino::trimesh torus_of(double triangles) {
  const double rows = std::sqrt(triangles / 3);
  return concino::trimesh(bench::torus(static_cast<bench::u32>(rows), static_cast<bench::u32>(1.5 * rows)));
}
concino::tetmesh block_of(double tets) {
  return concino::tetmesh(bench::tet_grid(static_cast<bench::u32>(std::lround(std::cbrt(tets / 6)))));
}
concino::hexmesh hexes_of(double hexes) { return concino::hexmesh(bench::hex_grid(static_cast<bench::u32>(std::lround(std::cbrt(hexes))))); }

}  // namespace

int main(int argc, char** argv) {
  return bench::run_program(argc, argv, [](const bench::program& p) {
    const concino::multigrid_options multigrid{.tolerance = 1e-10};
    grow<concino::conjugate_gradients>(p, "trimesh", "iterative", 6.5, "n^1.5", "n", torus_of);
    grow<concino::conjugate_gradients>(p, "tetmesh", "iterative", 6.5, "n^1.33", "n", block_of);
    grow<concino::multigrid>(p, "trimesh", "multigrid", 6.5, "n", "n", torus_of, multigrid);
    grow<concino::multigrid>(p, "tetmesh", "multigrid", 6.5, "n", "n", block_of, multigrid);
    grow<concino::multigrid>(p, "hexmesh", "multigrid", 6, "n", "n", hexes_of, multigrid);
    grow<concino::ldlt>(p, "trimesh", "direct", 6.5, "n^1.5", "n log n", torus_of);
    grow<concino::ldlt>(p, "tetmesh", "direct", 5.5, "n^2", "n^1.33", block_of);
  });
}
