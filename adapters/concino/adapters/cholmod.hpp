// A SparseSolver for symmetric positive definite systems: CHOLMOD's supernodal factorisation, with dense blocks on
// BLAS. It is the fastest for large systems.
// Needs: CHOLMOD of SuiteSparse (Debian: libsuitesparse-dev); for full speed also a fast BLAS (Debian:
//        libopenblas0-serial).
#pragma once

#include <concino/solve/checked_solver.hpp>
#include <concino/solve/direct_solver_options.hpp>

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
      core::throw_joined<solver_error>({"cholmod: ", during,
                                        status == CHOLMOD_OUT_OF_MEMORY ? " ran out of memory"
                                        : status == CHOLMOD_TOO_LARGE ? " needs more entries than 32-bit indices count"
                                                                      : " failed"});
  }

  /// Finds the elimination order, by approximate minimum degree or, if that gives a costly factorisation, by nested
  /// dissection. On grids the factors of the latter take 1/3 to 1/2 as many operations, but finding it takes as long as
  /// some 4e5 operations per unknown. Or takes a given one.
  void analyse(const Eigen::SparseMatrix<double>& a, elimination_ordering ordering) {
    cholmod_common& c = cholmod();
    if (ordering) {
      analyse_in_order(a, ordering(a));
      return check_status("the analysis");
    }
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

  void analyse_in_order(const Eigen::SparseMatrix<double>& a, std::vector<int> order) {
    if (order.size() != static_cast<std::size_t>(a.cols()))
      throw invalid_argument("the elimination ordering of a solver returned no permutation of its rows");
    cholmod_common& c = cholmod();
    c.method[0].ordering = CHOLMOD_GIVEN;
    c.nmethods = 1;
    if (m_cholmodFactor) cholmod_free_factor(&m_cholmodFactor, &c);
    cholmod_sparse view = Eigen::viewAsCholmod(a.selfadjointView<Eigen::Lower>());
    m_cholmodFactor = cholmod_analyze_p(&view, order.data(), nullptr, 0, &c);
    m_isInitialized = true;
    m_analysisIsOk = true;
    m_factorizationIsOk = false;
    m_info = Eigen::Success;
  }

  /// The row of the matrix where elimination found a pivot that is not positive, or -1.
  Eigen::Index failed_row() const {
    const std::size_t pivot = m_cholmodFactor->minor;
    return pivot < m_cholmodFactor->n ? static_cast<const int*>(m_cholmodFactor->Perm)[pivot] : -1;
  }

  /// Calls f(row of the matrix, its pivot) for all rows.
  template<class F>
  void for_each_pivot(F f) const {
    const auto *const first = static_cast<const int*>(m_cholmodFactor->super),
                      *const rows = static_cast<const int*>(m_cholmodFactor->pi),
                      *const values = static_cast<const int*>(m_cholmodFactor->px),
                      *const row = static_cast<const int*>(m_cholmodFactor->Perm);
    for (std::size_t s = 0; s < m_cholmodFactor->nsuper; ++s) {
      const std::ptrdiff_t height = rows[s + 1] - rows[s];
      const double* x = static_cast<const double*>(m_cholmodFactor->x) + values[s];
      for (int k = first[s]; k < first[s + 1]; ++k, x += height + 1) f(row[k], *x * *x);
    }
  }
};

}  // namespace detail

/// A SparseSolver that factorises a symmetric positive definite matrix as L L^T by dense blocks.
/// Only the lower triangle of the matrix is read. The order is chosen as it factorises faster, or by options.ordering.
/// If a matrix has the pattern of the previous one, explicit zeros included, the elimination order is reused. The speed
/// depends on the BLAS: with OpenBLAS (Debian: libopenblas0-serial) some 6 times Eigen's speed at 200,000 unknowns,
/// with the reference BLAS far less.
/// Errors: factorize throws solver_error, with the reason, if the matrix is not square, has entries that are not finite
///         or is not positive definite (the row is named), or if the factor is too large. invalid_argument or
///         solver_error if options.ordering returns no permutation. solve throws solver_error if there is no factorised
///         matrix, the right-hand side has another size, or an entry of it or of the solution is not finite. After a
///         failed factorize there is no factorised matrix.
/// Source: Chen, Davis, Hager, Rajamanickam, Algorithm 887, 2008, through Eigen's CholmodSupport; nested dissection:
///         Karypis, Kumar 1998, METIS. The supernodal module is under the GPL.
class cholmod {
  direct_solver_options options_;
  detail::supernodal_factors factors_;
  checked_solver checks_{"cholmod"};

 public:
  cholmod() = default;
  explicit cholmod(const direct_solver_options& options) : options_(options) {}

  void factorize(const Eigen::SparseMatrix<double>& matrix) {
    Eigen::SparseMatrix<double> storage;
    const Eigen::SparseMatrix<double>& a = checks_.begin_square(matrix, storage);
    if (a.cols() > 0) {
      checks_.analyse_once(a, [&](const auto& m) { factors_.analyse(m, options_.ordering); });
      factors_.factorize(a);
      factors_.check_status("the factorisation");
      check_pivots(a);
    }
    checks_.accept(a.rows());
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    return checks_.solve(right, [&](const Eigen::VectorXd& b) { return Eigen::VectorXd(factors_.solve(b)); });
  }

  const direct_solver_options& options() const { return options_; }

 private:
  void check_pivots(const Eigen::SparseMatrix<double>& a) const {
    const std::vector<double> input_diagonal = core::diagonal(a);
    if (const Eigen::Index row = factors_.failed_row(); row >= 0)
      core::throw_joined<solver_error>({"cholmod: the matrix is not positive definite in row ",
                                        static_cast<std::size_t>(row), ": elimination turns the diagonal entry ",
                                        core::number_text(input_diagonal[static_cast<std::size_t>(row)]),
                                        " into one that is not positive"});
    factors_.for_each_pivot([&](Eigen::Index row, double pivot) {
      const double diagonal = input_diagonal[static_cast<std::size_t>(row)];
      if (!(pivot > 1e-15 * diagonal && pivot < std::numeric_limits<double>::infinity()))
        core::throw_bad_pivot("cholmod", "not positive definite to working precision", row, diagonal, pivot);
    });
  }
};

}  // namespace concino
