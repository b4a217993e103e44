// A SparseSolver for systems that are large, or that several processes solve together: PETSc's iterations, with its
// algebraic multigrid, hypre's, or a factorisation by MUMPS.
// Needs: PETSc 3.18 with MPI (Debian: petsc-dev), and a petsc_session in main.
#pragma once

#include <concino/adapters/detail/mpi/mpi_agreement.hpp>
#include <concino/adapters/detail/petsc/petsc_iteration.hpp>
#include <concino/adapters/detail/petsc/petsc_report.hpp>
#include <concino/adapters/detail/petsc/petsc_rows.hpp>
#include <concino/adapters/petsc_options.hpp>
#include <concino/adapters/petsc_session.hpp>
#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCore>

#include <petscksp.h>

#include <cstddef>
#include <string>
#include <vector>

namespace concino {

/// Solves symmetric positive definite systems by conjugate gradients, or general ones by GMRES, with a preconditioner
/// of PETSc. A SparseSolver. Reads the whole matrix, also both triangles of a symmetric one. The processes of
/// options.communicator call it together, each with the same matrix and right-hand side, and each gets the whole
/// solution; rows are divided among them evenly. Every option can be overridden on the command line, or in PETSc's
/// database: -pc_type, -ksp_rtol and all others that `petsc_session` has read, after options.prefix. residual() is
/// |b - A x| / |b|, of Euclidean norms without preconditioner, computed from the solution; a solution is accepted if it
/// is at most the tolerance. If rounding errors allow no better, at most 1e-6 is accepted as well, where the largest
/// residual is 1e-14 of |A| max|x|. So large entries of some rows, such as penalties, hide the others. iterations(),
/// residual() and has_converged() describe the last solve. So one object must not solve in several threads at once.
/// Scaling the matrix or the right-hand side by a power of two scales the solution exactly.
/// Errors: invalid_argument if PETSc is not running, or an option is out of its range. factorize throws it if vectors
///         of near_null_space do not fit, or an option of the database with the prefix (without prefix, one that begins
///         with ksp_, pc_ or mg_) is misspelt or unused. factorize throws solver_error, with the reason, if the matrix
///         is not square, differs in size between processes, has entries that are not finite, or rows that are 0. For
///         symmetric systems it also does so if the matrix is not symmetric, or has a diagonal entry that is not
///         positive. solve throws it if nothing was factorised, the right-hand side has another size or is not finite,
///         or the tolerance is missed; the message contains iterations, residual, tolerance and PETSc's reason.
///         Singular matrices fail in this way, unless the iteration finds a solution for that right-hand side. What one
///         process finds wrong is thrown on all of the communicator. After a failed factorize there is no factorised
///         matrix.
/// Source: PETSc (Balay et al.); Hestenes, Stiefel 1952; Saad, Schultz 1986; Vanek, Mandel, Brezina 1996 (GAMG);
///         Henson, Yang 2002 (BoomerAMG); Amestoy, Duff, L'Excellent, Koster 2001 (MUMPS).
class petsc {
  detail::petsc_iteration iteration_;
  std::vector<int> counts_, starts_;  // rows of each process
  Eigen::Index rows_ = -1;
  mutable detail::petsc_report report_;

 public:
  static constexpr bool reads_both_triangles = true;

  petsc() : petsc(petsc_options()) {}
  explicit petsc(const petsc_options& options) : iteration_(options) {}

  void factorize(const Eigen::SparseMatrix<double>& matrix) {
    rows_ = -1;
    detail::petsc_rows rows;
    detail::on_all(communicator(), [&] {
      core::check_square("petsc", matrix);
      Eigen::SparseMatrix<double> storage;
      const Eigen::SparseMatrix<double>& a = core::compressed(matrix, storage);
      core::check_entries("petsc", a);
      rows = own_rows(a);
      if (options().system == petsc_system::symmetric_definite) detail::check_symmetric_definite(rows, a);
      else detail::check_no_row_is_zero(rows);
      check_near_null_space(a.rows());
    });
    check_same_size(matrix.rows());
    if (matrix.rows() > 0) iteration_.factorize(rows);
    rows_ = matrix.rows();
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    report_ = {};
    detail::on_all(communicator(), [&] { core::check_right_hand_side("petsc", right, rows_); });
    Eigen::VectorXd x(rows_);
    if (rows_ == 0) return x;
    const auto rank = static_cast<std::size_t>(this->rank());
    const std::vector<double> own = iteration_.solve(right.data() + starts_[rank], report_);
    (MPI_Allgatherv)(own.data(), counts_[rank], MPI_DOUBLE, x.data(), counts_.data(), starts_.data(), MPI_DOUBLE,
                     communicator());
    if (!options().accept_missed_tolerance) report_.check(iteration_.tolerance());
    core::check_solution("petsc", x);
    return x;
  }

  const petsc_options& options() const { return iteration_.options(); }
  /// For functions that solve with the options of this object: iterations(), residual() and has_converged() describe
  /// their solve.
  void record(const detail::petsc_report& report) const { report_ = report; }
  bool is_iterative() const { return options().preconditioner != petsc_preconditioner::mumps; }
  int iterations() const { return report_.iterations; }
  double residual() const { return report_.residual; }
  bool has_converged() const { return report_.has_converged; }
  /// Options of the database that the last factorize did not use, if options.accept_unused_options is set.
  const std::vector<std::string>& unused_options() const { return iteration_.unused_options(); }

 private:
  MPI_Comm communicator() const { return options().communicator; }

  int rank() const {
    int r = 0;
    (MPI_Comm_rank)(communicator(), &r);
    return r;
  }

  detail::petsc_rows own_rows(const Eigen::SparseMatrix<double>& a) {
    int size = 1;
    (MPI_Comm_size)(communicator(), &size);
    const auto n = static_cast<long long>(a.rows());
    counts_.resize(static_cast<std::size_t>(size));
    starts_.resize(counts_.size());
    for (int r = 0; r < size; ++r) {
      starts_[static_cast<std::size_t>(r)] = static_cast<int>(n * r / size);
      counts_[static_cast<std::size_t>(r)] = static_cast<int>(n * (r + 1) / size - n * r / size);
    }
    const auto own = static_cast<std::size_t>(rank());
    return detail::rows_of(a, starts_[own], starts_[own] + counts_[own]);
  }

  void check_near_null_space(Eigen::Index rows) const {
    for (const Eigen::VectorXd& v : options().near_null_space)
      if (v.size() != rows)
        core::throw_joined<invalid_argument>({"petsc: a vector of near_null_space has ",
                                              static_cast<std::size_t>(v.size()), " entries, the matrix ",
                                              static_cast<std::size_t>(rows), " rows"});
  }

  void check_same_size(Eigen::Index rows) const {
    long long smallest_and_negative_largest[] = {rows, -static_cast<long long>(rows)};
    (MPI_Allreduce)(MPI_IN_PLACE, smallest_and_negative_largest, 2, MPI_LONG_LONG, MPI_MIN, communicator());
    if (smallest_and_negative_largest[0] != -smallest_and_negative_largest[1])
      throw solver_error("petsc: the matrices of the processes have different sizes");
  }
};

}  // namespace concino
