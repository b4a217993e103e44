// Checks of matrices common to all solvers; see system_checks.hpp.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/system_checks.hpp>

#include <algorithm>
#include <cmath>

namespace concino::core {

CONCINO_INLINE const Eigen::SparseMatrix<double>& compressed(const Eigen::SparseMatrix<double>& a,
                                                             Eigen::SparseMatrix<double>& storage) {
  if (a.isCompressed()) return a;
  storage = a;
  storage.makeCompressed();
  return storage;
}

CONCINO_INLINE void check_square(const char* caller, const Eigen::SparseMatrix<double>& a) {
  if (a.rows() != a.cols())
    core::throw_joined<solver_error>({caller, ": the matrix has ", static_cast<std::size_t>(a.rows()), " rows and ",
                                      static_cast<std::size_t>(a.cols()), " columns; it must be square"});
}

CONCINO_INLINE void check_entries(const char* caller, const Eigen::SparseMatrix<double>& a) {
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k)
      if (!std::isfinite(a.valuePtr()[k]))
        core::throw_joined<solver_error>({caller, ": the matrix has an entry that is not finite, in row ",
                                          static_cast<std::size_t>(a.innerIndexPtr()[k]), ", column ",
                                          static_cast<std::size_t>(c)});
}

CONCINO_INLINE void check_right_hand_side(const char* caller, const Eigen::VectorXd& b, Eigen::Index rows) {
  if (rows < 0) core::throw_joined<solver_error>({caller, ": solve without a factorised matrix; call factorize first"});
  if (b.size() != rows)
    core::throw_joined<solver_error>({caller, ": the right-hand side has ", static_cast<std::size_t>(b.size()),
                                      " entries, the matrix ", static_cast<std::size_t>(rows), " rows"});
  for (Eigen::Index i = 0; i < b.size(); ++i)
    if (!std::isfinite(b[i]))
      core::throw_joined<solver_error>(
          {caller, ": entry ", static_cast<std::size_t>(i), " of the right-hand side is not finite"});
}

CONCINO_INLINE void check_solution(const char* caller, const Eigen::VectorXd& x) {
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (!std::isfinite(x[i]))
      core::throw_joined<solver_error>(
          {caller, ": entry ", static_cast<std::size_t>(i),
           " of the solution is not finite; the matrix is singular to working precision or the numbers are too large"});
}

[[noreturn, gnu::noinline, gnu::cold]] CONCINO_INLINE void throw_bad_pivot(const char* caller, const char* what,
                                                                           Eigen::Index row, double diagonal,
                                                                           double pivot) {
  throw singular_row(core::joined({caller, ": the matrix is ", what, " in row ", static_cast<std::size_t>(row),
                                   ": elimination turns the diagonal entry ", core::number_text(diagonal), " into ",
                                   core::number_text(pivot)}),
                     row);
}

CONCINO_INLINE void sparsity_pattern::remember(const Eigen::SparseMatrix<double>& a) {
  starts_.assign(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1);
  rows_.assign(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
  height_ = a.rows();
}

CONCINO_INLINE bool sparsity_pattern::is_of(const Eigen::SparseMatrix<double>& a) const {
  return height_ == a.rows() &&
         std::equal(starts_.begin(), starts_.end(), a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1) &&
         std::equal(rows_.begin(), rows_.end(), a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
}

CONCINO_INLINE std::vector<double> diagonal(const Eigen::SparseMatrix<double>& a) {
  std::vector<double> d(static_cast<std::size_t>(a.cols()));
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k)
      if (a.innerIndexPtr()[k] == c) d[static_cast<std::size_t>(c)] += a.valuePtr()[k];
  return d;
}

CONCINO_INLINE double power_of_two_to_scale(double x) {
  if (!(x > 0x1p-1000 && x < 0x1p1000)) return 1;
  return std::ldexp(1.0, -std::ilogb(x));
}

}  // namespace concino::core
