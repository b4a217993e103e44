// A system over the unknown verts of a distributed mesh: assembled by parts, summed and solved by PETSc.
#pragma once

#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/petsc/petsc_iteration.hpp>
#include <concino/adapters/detail/petsc/petsc_report.hpp>
#include <concino/adapters/detail/petsc/petsc_rows.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// A solver whose options distributed problems use.
template<class S> concept solver_for_distributed = std::is_same_v<std::remove_cvref_t<S>, petsc>;

/// Factorised once, for any number of right-hand sides. Every function is collective.
template<class M>
class distributed_system {
  const distributed_problem<M>* problem_;
  Eigen::SparseMatrix<double> a_;
  std::optional<petsc_iteration> iteration_;  // none if no process has unknowns

  const ghost_exchange& exchange() const { return problem_->mesh().exchange(static_cast<const vert_t<M>*>(nullptr)); }

  petsc_options options_with(petsc_options options) const {
    options.communicator = problem_->mesh().communicator();
    on_all(options.communicator, [&] {
      if (!options.near_null_space.empty())
        core::throw_joined<unsupported>({problem_->caller(), ": near_null_space is not for distributed meshes"});
    });
    return options;
  }

  petsc_entries entries() const {
    petsc_entries r;
    r.first = problem_->first_row();
    r.size = static_cast<PetscInt>(problem_->own().size());
    for (int c = 0; c < a_.outerSize(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator e(a_, c); e; ++e) {
        const PetscInt row = problem_->row(static_cast<std::size_t>(e.row())),
                       column = problem_->row(static_cast<std::size_t>(c));
        if (row < 0 || column < 0) continue;
        r.rows.push_back(row);
        r.columns.push_back(column);
        r.values.push_back(e.value());
      }
    return r;
  }

 public:
  /// a: computed from the polys of this process; the matrix is the sum of those of all processes. By index of the local
  /// verts, both triangles.
  distributed_system(const distributed_problem<M>& problem, Eigen::SparseMatrix<double> a, const petsc_options& options)
      : problem_(&problem), a_(std::move(a)) {
    const petsc_options own_options = options_with(options);
    int has_unknowns = !problem.own().empty();
    (MPI_Allreduce)(MPI_IN_PLACE, &has_unknowns, 1, MPI_INT, MPI_MAX, own_options.communicator);
    if (!has_unknowns) return;
    iteration_.emplace(own_options);
    petsc_entries all = entries();
    iteration_->factorize(all);
  }

  bool is_factorised() const { return !iteration_ || iteration_->is_factorised(); }
  double tolerance() const { return iteration_ ? iteration_->tolerance() : 0; }

  /// Computes the unknown values of u, so that a u = load in their rows. load: that of the polys of this process, which
  /// are summed too. Ghosts of u are up to date before and after.
  void solve(std::vector<double> load, vert_map<distributed<M>, double>& u, const petsc& solver) const {
    petsc_report report;
    if (iteration_) {
      for (int c = 0; c < a_.outerSize(); ++c) {
        if (problem_->row(static_cast<std::size_t>(c)) >= 0) continue;
        for (Eigen::SparseMatrix<double>::InnerIterator e(a_, c); e; ++e)
          load[static_cast<std::size_t>(e.row())] -= e.value() * u.data()[c];
      }
      exchange().to_owners(load.data(), [](double& sum, double x) { sum += x; });
      std::vector<double> right;
      for (const vert_t<M> v : problem_->own()) right.push_back(load[index_of(problem_->mesh().base(), v)]);
      const std::vector<double> x = iteration_->solve(right.data(), report);
      solver.record(report);
      if (!solver.options().accept_missed_tolerance) report.check(iteration_->tolerance());
      for (std::size_t k = 0; k < x.size(); ++k) u[problem_->own()[k]] = x[k];
    }
    solver.record(report);
    exchange_ghosts(u);
  }
};

}  // namespace concino::detail
