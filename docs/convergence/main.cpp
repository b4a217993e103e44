// Computes docs/convergence.tsv anew and writes it to the file that is named on the command line. Takes minutes.
#include <concino/solve/ldlt.hpp>

#include <support/agglomeration_table.hpp>
#include <support/convergence.hpp>
#include <support/geodesic_table.hpp>

#include <Eigen/IterativeLinearSolvers>

#include <fmt/core.h>

#include <fstream>

using namespace concino;
using namespace concino::testing;

namespace {

/// Conjugate gradients with an incomplete factorisation: large volumes fill the factors of a complete one.
class iterative_solver {
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::IncompleteCholesky<double>> solver_;
  Eigen::SparseMatrix<double> a_;
  double tolerance_;

 public:
  explicit iterative_solver(double tolerance) : tolerance_(tolerance) {}
  void factorize(const Eigen::SparseMatrix<double>& a) {
    a_ = a;
    solver_.setTolerance(tolerance_);
    solver_.compute(a_);
  }
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    Eigen::VectorXd x = solver_.solve(b);
    if (solver_.info() != Eigen::Success) throw solver_error("conjugate gradients did not converge");
    return x;
  }
};

template<class M>
auto make_solver(double tolerance) {
  if constexpr (dimension_v<M> == 2) return static_cast<void>(tolerance), ldlt();
  else return iterative_solver(tolerance);
}

void add(std::string& table, const std::vector<convergence_row>& rows) {
  for (const convergence_row& row : rows) {
    std::string line = fmt::format("{}\t{}\t{}\t{}", row.what, row.discretisation, row.kind, row.family);
    for (const double error : row.errors) line += std::isnan(error) ? "\t-" : row.discretisation == "cells" ? fmt::format("\t{}", error) : fmt::format("\t{:.4g}", error);
    line += '\n';
    fmt::print(stderr, "{}", line);
    table += line;
  }
}

template<class M>
void add_rows(std::string& table) {
  for (const family f : families<M>()) add(table, measure_convergence<M>(f, 4, make_solver<M>));
}

template<class M>
void add_merged_cells(std::string& table) { add(table, measure_merged_cells<M>(4, make_solver<M>)); }

template<class M>
void add_geodesics(std::string& table) {
  const auto coarse = measure_geodesics<M>(coarse_geodesic_mesh), fine = measure_geodesics<M>(fine_geodesic_mesh);
  for (std::size_t i = 0; i < coarse.size(); ++i) {
    std::string line = fmt::format("{}\t{}\t{}\t{}", coarse[i].what, coarse[i].discretisation, coarse[i].kind, coarse[i].family);
    for (const auto& row : {coarse[i], fine[i]})
      for (const double error : row.errors) line += fmt::format("\t{:.4f}", error);
    line += '\n';
    fmt::print(stderr, "{}", line);
    table += line;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  std::string table;
  add_rows<trimesh>(table);
  add_rows<quadmesh>(table);
  add_rows<polygonmesh>(table);
  add_rows<tetmesh>(table);
  add_rows<hexmesh>(table);
  add_rows<polyhedralmesh>(table);
  add_geodesics<trimesh>(table);
  add_geodesics<quadmesh>(table);
  add_geodesics<polygonmesh>(table);
  add_geodesics<tetmesh>(table);
  add_geodesics<hexmesh>(table);
  add_geodesics<polyhedralmesh>(table);
  add_merged_cells<polygonmesh>(table);
  add_merged_cells<polyhedralmesh>(table);
  std::ofstream(argv[1]) << table;
}
