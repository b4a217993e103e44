// The heat that flows from some verts of a distributed mesh, for one matrix.
#pragma once

#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/distributed/distributed_system.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/fields/support/heat_geodesics_parts.hpp>

#include <Eigen/SparseCore>

#include <mpi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

inline bool is_any_over_processes(MPI_Comm communicator, bool x) {
  int any = x;
  (MPI_Allreduce)(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, communicator);
  return any != 0;
}

inline Eigen::SparseMatrix<double> both_triangles(const Eigen::SparseMatrix<double>& lower) {
  return lower.selfadjointView<Eigen::Lower>();
}

/// The solution for a load, which is summed over the processes; by local index, ghosts included. Collective.
template<class M>
Eigen::VectorXd solve_over_processes(const distributed<M>& m, const distributed_system<M>& system,
                                     const Eigen::VectorXd& load, const petsc& solver) {
  auto u = make_vert_map<double>(m, 0.0);
  system.solve(std::vector<double>(load.data(), load.data() + load.size()), u, solver);
  return Eigen::Map<const Eigen::VectorXd>(u.data(), load.size());
}

template<class M>
class distributed_heat {
  const distributed<M>* mesh_;
  const petsc* solver_;
  Eigen::SparseMatrix<double> lower_;
  distributed_system<M> system_;

  /// A factor gives each value with its own relative accuracy, an iteration only relative to the largest one: of these
  /// the smaller half of the digits is not used.
  int scale_exponent() const {
    if (system_.is_factorised()) return 450;
    return std::max(1, static_cast<int>(-std::log2(system_.tolerance()) / 4));
  }

 public:
  /// lower: the lower triangle of the masses and a time times the stiffness of the polys of this process.
  distributed_heat(const distributed_problem<M>& problem, Eigen::SparseMatrix<double> lower, const petsc& solver)
      : mesh_(&problem.mesh()), solver_(&solver), lower_(std::move(lower)),
        system_(problem, both_triangles(lower_), solver.options()) {}

  /// sources: those at verts that belong to this process. is_heated, unit: as for solve_rescaled. Collective.
  rescaled_heat heat_from(const std::vector<heat_source>& sources, const std::vector<unsigned char>& is_heated,
                          int unit) const {
    return solve_rescaled(
        lower_, sources, is_heated, unit, scale_exponent(),
        [&](const Eigen::VectorXd& b) { return solve_over_processes(*mesh_, system_, b, *solver_); },
        [&](bool x) { return is_any_over_processes(mesh_->communicator(), x); });
  }
};

}  // namespace concino::detail
