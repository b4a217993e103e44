// A SparseSolver for symmetric positive definite systems: CHOLMOD's supernodal factorisation, with dense blocks on BLAS. It is the fastest for large systems.
// Needs: CHOLMOD of SuiteSparse (Debian: libsuitesparse-dev); for full speed also a fast BLAS (Debian: libopenblas0-serial).
#pragma once

#include <concino/core/system_checks.hpp>

#include <Eigen/CholmodSupport>

#include <cstddef>
#include <limits>
#include <vector>

namespace concino {

namespace detail {

/// Eigen's wrapper, with access to more data of CHOLMOD.
struct supernodal_factors : Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<double>> {
  supernodal_factors() { cholmod().print = 0; }  // errors are reported by exceptions

  void check_status(const char* during) {
    const int status = cholmod().status;
    if (!m_cholmodFactor || status < 0)
      core::throw_joined<solver_error>({"cholmod: ", during, status == CHOLMOD_OUT_OF_MEMORY ? " ran out of memory" :
                                  status == CHOLMOD_TOO_LARGE ? " needs more entries than 32-bit indices count" : " failed"});
  }

  /// Finds the elimination order, by approximate minimum degree or, if that gives a costly factorisation, by nested dissection. On grids the factors of
  /// the latter take 1/3 to 1/2 as many operations, but finding it takes as long as some 4e5 operations per unknown.
  void analyse(const Eigen::SparseMatrix<double>& a) {
    cholmod_common& c = cholmod();
    c.method[0].ordering = CHOLMOD_AMD;
    c.method[1].ordering = CHOLMOD_METIS;
    c.nmethods = 1;
    analyzePattern(a);
    check_status("the analysis");
    if (!(c.fl > 4e5 * static_cast<double>(a.cols()))) return;
    c.nmethods = 2;
    analyzePattern(a);
    check_status("the analysis");
  }

  /// The row of the matrix where elimination found a pivot that is not positive, or -1.
  Eigen::Index failed_row() const {
    const std::size_t pivot = m_cholmodFactor->minor;
    return pivot < m_cholmodFactor->n ? static_cast<const int*>(m_cholmodFactor->Perm)[pivot] : -1;
  }

  /// Calls f(row of the matrix, its pivot) for all rows.
  template<class F>
  void for_each_pivot(F f) const {
    const auto *const first = static_cast<const int*>(m_cholmodFactor->super), *const rows = static_cast<const int*>(m_cholmodFactor->pi),
               *const values = static_cast<const int*>(m_cholmodFactor->px), *const row = static_cast<const int*>(m_cholmodFactor->Perm);
    for (std::size_t s = 0; s < m_cholmodFactor->nsuper; ++s) {
      const std::ptrdiff_t height = rows[s + 1] - rows[s];
      const double* x = static_cast<const double*>(m_cholmodFactor->x) + values[s];
      for (int k = first[s]; k < first[s + 1]; ++k, x += height + 1) f(row[k], *x * *x);
    }
  }
};

}  // namespace detail

/// A SparseSolver that factorises a symmetric positive definite matrix as L L^T by dense blocks.
/// Only the lower triangle of the matrix is read. If a matrix has the pattern of the previous one, explicit zeros included, the elimination order
/// is reused. The speed depends on the BLAS: with OpenBLAS (Debian: libopenblas0-serial) some 6 times
/// Eigen's speed at 200,000 unknowns, with the reference BLAS far less.
/// Errors: factorize throws solver_error, with the reason, if the matrix is not square, has entries that are not finite or is not positive
///         definite (the row is named), or if the factor is too large. solve throws it if there is no factorised matrix, the right-hand side has
///         another size, or an entry of it or of the solution is not finite. After a failed factorize there is no factorised matrix.
/// Source: Chen, Davis, Hager, Rajamanickam, Algorithm 887, 2008, through Eigen's CholmodSupport; nested dissection: Karypis, Kumar 1998, METIS. The
///         supernodal module is under the GPL.
class cholmod {
  detail::supernodal_factors factors_;
  core::sparsity_pattern pattern_;
  Eigen::Index size_ = -1;

 public:
  void factorize(const Eigen::SparseMatrix<double>& matrix) {
    size_ = -1;
    Eigen::SparseMatrix<double> storage;
    const Eigen::SparseMatrix<double>& a = core::compressed(matrix, storage);
    core::check_square("cholmod", a);
    core::check_entries("cholmod", a);
    if (a.cols() > 0) {
      pattern_.update(a, [&](const auto& m) { factors_.analyse(m); });
      factors_.factorize(a);
      factors_.check_status("the factorisation");
      check_pivots(a);
    }
    size_ = a.rows();
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& b) const {
    core::check_right_hand_side("cholmod", b, size_);
    if (size_ == 0) return Eigen::VectorXd(0);
    Eigen::VectorXd x = factors_.solve(b);
    core::check_solution("cholmod", x);
    return x;
  }

 private:
  void check_pivots(const Eigen::SparseMatrix<double>& a) const {
    const std::vector<double> input_diagonal = core::diagonal(a);
    if (const Eigen::Index row = factors_.failed_row(); row >= 0)
      core::throw_joined<solver_error>({"cholmod: the matrix is not positive definite in row ", static_cast<std::size_t>(row),
                                          ": elimination turns the diagonal entry ",
                                          core::number_text(input_diagonal[static_cast<std::size_t>(row)]), " into one that is not positive"});
    factors_.for_each_pivot([&](Eigen::Index row, double pivot) {
      const double diagonal = input_diagonal[static_cast<std::size_t>(row)];
      if (!(pivot > 1e-15 * diagonal && pivot < std::numeric_limits<double>::infinity()))
        core::throw_bad_pivot("cholmod", "not positive definite to working precision", row, diagonal, pivot);
    });
  }
};

}  // namespace concino
