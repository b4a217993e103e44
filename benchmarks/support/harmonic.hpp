// Measures a harmonic map with two prescribed values, with any solver, against the factorisation that the solver needs for it.
#pragma once

#include "kinds.hpp"

#include <concino/fields.hpp>
#include <concino/solve/ldlt.hpp>

namespace bench {

/// A solver that stores the matrix that it is asked to factorise.
struct matrix_keeper {
  Eigen::SparseMatrix<double> matrix;
  concino::ldlt inner;
  void factorize(const Eigen::SparseMatrix<double>& a) { inner.factorize(matrix = a); }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const { return inner.solve(b); }
};

/// Solver is a SparseSolver. factorise(matrix) only factorises.
template<class Solver, class F>
void compare_harmonic(const program& p, const std::string& suffix, F factorise) {
  const auto compare_by = [&](const auto& which, const char* name) {
    const std::string work = "harmonic." + std::string(name) + ".bunny16" + suffix;
    if (!p.wants(work)) return;
    const concino::trimesh m(p.data.bunny16());
    const std::vector<std::pair<concino::vert_id, double>> given = {{concino::vert_id{0}, 0.0}, {concino::vert_id{concino::num_verts(m) - 1}, 1.0}};
    matrix_keeper keeper;
    const auto u = concino::harmonic_map(m, given, which, {}, keeper);
    const auto v = concino::harmonic_map(m, given, which, {}, Solver{});
    for (std::size_t i = 0; i < u.values().size(); ++i)
      if (!(std::abs(u.values()[i] - v.values()[i]) <= 1e-8)) throw std::runtime_error(work + ": two solvers return different maps");
    p.print(compare(work, std::min(p.rounds, 3),
                    {{"factorisation", [&] { return seconds_of([&] { return factorise(keeper.matrix); }); }},
                     {"concino", [&] { return seconds_of([&] { return concino::harmonic_map(m, given, which, {}, Solver{}); }); }}}));
  };
  compare_by(concino::uniform, "uniform");
  compare_by(concino::cotangent, "cotangent");
}

}  // namespace bench
