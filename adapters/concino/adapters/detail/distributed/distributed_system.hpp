// A system over the unknown verts of a distributed mesh: assembled by parts, summed and solved by PETSc.
#pragma once

#include <concino/adapters/detail/distributed/distributed_problem.hpp>
#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/petsc/petsc_calls.hpp>
#include <concino/adapters/detail/petsc/petsc_iteration.hpp>
#include <concino/adapters/detail/petsc/petsc_matrices.hpp>
#include <concino/adapters/detail/petsc/petsc_report.hpp>
#include <concino/adapters/detail/petsc/petsc_rows.hpp>
#include <concino/adapters/distributed.hpp>
#include <concino/adapters/petsc.hpp>
#include <concino/core/message.hpp>
#include <concino/fields/support/linear_problem_parts.hpp>
#include <concino/mesh/element_map.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace concino::detail {

/// A solver whose options distributed problems use.
template<class S> concept solver_for_distributed = std::is_same_v<std::remove_cvref_t<S>, petsc>;

/// Factorised once, for any number of right-hand sides. Every function is collective.
template<class M, field_value T = double>
class distributed_system {
  const distributed_problem<M, T>* problem_;
  petsc_matrix whole_;                        // of all verts that have polys
  std::optional<petsc_iteration> iteration_;  // of the unknown ones; none if no process has any

  const ghost_exchange& exchange() const { return problem_->mesh().exchange(static_cast<const vert_t<M>*>(nullptr)); }
  std::size_t index(const vert_t<M>& v) const { return index_of(problem_->mesh().base(), v); }

  petsc_options options_with(petsc_options options) const {
    options.communicator = problem_->mesh().communicator();
    on_all(options.communicator, [&] {
      if (!options.near_null_space.empty())
        core::throw_joined<unsupported>({problem_->caller(), ": near_null_space is not for distributed meshes"});
    });
    return options;
  }

  petsc_entries entries_of(const Eigen::SparseMatrix<double>& a) const {
    petsc_entries r;
    r.first = problem_->first_row();
    r.size = static_cast<PetscInt>(problem_->own().size());
    for (int c = 0; c < a.outerSize(); ++c)
      for (Eigen::SparseMatrix<double>::InnerIterator e(a, c); e; ++e) {
        const PetscInt row = problem_->matrix_row(static_cast<std::size_t>(e.row())),
                       column = problem_->matrix_row(static_cast<std::size_t>(c));
        if (row < 0 || column < 0) continue;
        r.rows.push_back(row);
        r.columns.push_back(column);
        r.values.push_back(e.value());
      }
    return r;
  }

  std::vector<PetscInt> unknown_rows() const {
    std::vector<PetscInt> r;
    for (const vert_t<M> v : problem_->own())
      if (problem_->is_unknown(index(v))) r.push_back(problem_->matrix_row(index(v)));
    return r;
  }

  /// Component k of the unknown values of u.
  void solve_component(std::size_t k, const std::vector<T>& load, vert_map<distributed<M>, T>& u,
                       petsc_report& report) const {
    std::vector<double> known;
    for (const vert_t<M> v : problem_->own())
      known.push_back(problem_->is_unknown(index(v)) ? 0 : field_component(u[v], k));
    const std::vector<double> of_known = product(whole_, known);
    std::vector<double> right;
    for (std::size_t i = 0; i < known.size(); ++i)
      if (const std::size_t at = index(problem_->own()[i]); problem_->is_unknown(at))
        right.push_back(field_component(load[at], k) - of_known[i]);
    const std::vector<double> x = iteration_->solve(right.data(), report);
    auto next = x.begin();
    for (const vert_t<M> v : problem_->own())
      if (problem_->is_unknown(index(v))) field_component(u[v], k) = *next++;
  }

 public:
  /// a: computed from the polys of this process; the matrix A is the sum of those of all processes. By index of the
  /// local verts, both triangles. The system is A (D A)^(exponent-1) u = load; D is diagonal, with these entries by row
  /// of this process.
  distributed_system(const distributed_problem<M, T>& problem, const Eigen::SparseMatrix<double>& a,
                     const petsc_options& options, int exponent = 1, const std::vector<double>& diagonal = {})
      : problem_(&problem) {
    const petsc_options own_options = options_with(options);
    const std::vector<PetscInt> unknown = unknown_rows();
    int has_unknowns = !unknown.empty();
    (MPI_Allreduce)(MPI_IN_PLACE, &has_unknowns, 1, MPI_INT, MPI_MAX, own_options.communicator);
    if (!has_unknowns) return;
    iteration_.emplace(own_options);
    petsc_entries entries = entries_of(a);
    whole_ = power(matrix_of(own_options.communicator, entries), diagonal, exponent);
    iteration_->factorize(submatrix(own_options.communicator, whole_, unknown));
  }

  bool is_factorised() const { return !iteration_ || iteration_->is_factorised(); }
  double tolerance() const { return iteration_ ? iteration_->tolerance() : 0; }

  /// Computes the unknown values of u. load: that of the polys of this process, which are summed too. Ghosts of u are
  /// up to date before and after.
  void solve(std::vector<T> load, vert_map<distributed<M>, T>& u, const petsc& solver) const {
    petsc_report report;
    if (iteration_) {
      exchange().to_owners(load.data(), [](T& sum, const T& x) { sum += x; });
      for (std::size_t k = 0; k < component_count<T>; ++k) {
        solve_component(k, load, u, report);
        solver.record(report);
        if (!solver.options().accept_missed_tolerance) report.check(iteration_->tolerance());
      }
    }
    solver.record(report);
    exchange_ghosts(u);
  }
};

}  // namespace concino::detail
