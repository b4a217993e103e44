// What every solver asks of matrices, right-hand sides and solutions, and whether a matrix has the pattern of the one before.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace concino::core {

/// The matrix itself if it is compressed, or a compressed copy in `storage`.
inline const Eigen::SparseMatrix<double>& compressed(const Eigen::SparseMatrix<double>& a, Eigen::SparseMatrix<double>& storage) {
  if (a.isCompressed()) return a;
  storage = a;
  storage.makeCompressed();
  return storage;
}

inline void check_square(const char* who, const Eigen::SparseMatrix<double>& a) {
  if (a.rows() != a.cols())
    core::throw_joined<solver_error>({who, ": the matrix has ", static_cast<std::size_t>(a.rows()), " rows and ", static_cast<std::size_t>(a.cols()),
                                " columns; it must be square"});
}

/// a: compressed.
inline void check_entries(const char* who, const Eigen::SparseMatrix<double>& a) {
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k)
      if (!std::isfinite(a.valuePtr()[k]))
        core::throw_joined<solver_error>({who, ": the matrix has an entry that is not finite, in row ", static_cast<std::size_t>(a.innerIndexPtr()[k]),
                                    ", column ", static_cast<std::size_t>(c)});
}

/// rows: of the matrix factorised last; -1: none.
inline void check_right_hand_side(const char* who, const Eigen::VectorXd& b, Eigen::Index rows) {
  if (rows < 0) core::throw_joined<solver_error>({who, ": solve without a factorised matrix; call factorize first"});
  if (b.size() != rows)
    core::throw_joined<solver_error>({who, ": the right-hand side has ", static_cast<std::size_t>(b.size()), " entries, the matrix ",
                                static_cast<std::size_t>(rows), " rows"});
  for (Eigen::Index i = 0; i < b.size(); ++i)
    if (!std::isfinite(b[i])) core::throw_joined<solver_error>({who, ": entry ", static_cast<std::size_t>(i), " of the right-hand side is not finite"});
}

inline void check_solution(const char* who, const Eigen::VectorXd& x) {
  for (Eigen::Index i = 0; i < x.size(); ++i)
    if (!std::isfinite(x[i]))
      core::throw_joined<solver_error>({who, ": entry ", static_cast<std::size_t>(i),
                                  " of the solution is not finite; the matrix is singular to working precision or the numbers are too large"});
}

/// A solver_error that says in which row elimination stopped, for those who know what stands there.
struct singular_row : solver_error {
  Eigen::Index row;
  singular_row(const std::string& what, Eigen::Index in_row) : solver_error(what), row(in_row) {}
};

/// `given`: the diagonal entry, or what else the pivot would be compared with.
[[noreturn, gnu::noinline, gnu::cold]] inline void throw_bad_pivot(const char* who, const char* what, Eigen::Index row, double given, double pivot) {
  throw singular_row(core::joined({who, ": the matrix is ", what, " in row ", static_cast<std::size_t>(row), ": of the diagonal entry ",
                             core::number_text(given), " elimination leaves ", core::number_text(pivot)}),
                     row);
}

/// The diagonal of a compressed matrix; 0 where it has no entry.
inline std::vector<double> diagonal(const Eigen::SparseMatrix<double>& a) {
  std::vector<double> d(static_cast<std::size_t>(a.cols()));
  for (int c = 0; c < a.cols(); ++c)
    for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k)
      if (a.innerIndexPtr()[k] == c) d[static_cast<std::size_t>(c)] += a.valuePtr()[k];
  return d;
}

/// Where a matrix has entries: that alone decides the order of elimination, and whether it can be kept. Comparing costs far less than ordering.
class sparsity_pattern {
  std::vector<int> starts_, rows_;
  Eigen::Index height_ = -1;

 public:
  void forget() { height_ = -1; }

  /// a: compressed, as below.
  void remember(const Eigen::SparseMatrix<double>& a) {
    starts_.assign(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1);
    rows_.assign(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
    height_ = a.rows();
  }

  bool is_of(const Eigen::SparseMatrix<double>& a) const {
    return height_ == a.rows() && std::equal(starts_.begin(), starts_.end(), a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1) &&
           std::equal(rows_.begin(), rows_.end(), a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros());
  }

  /// Analyses a by `analyse(a)` unless it has this pattern already.
  template<class F>
  void update(const Eigen::SparseMatrix<double>& a, F analyse) {
    if (is_of(a)) return;
    forget();  // in case that analyse throws
    analyse(a);
    remember(a);
  }
};

/// 2^k with 2^k x in [1, 2), for scaling that rounds nothing; 1 for 0 and where 2^k would be no normal number.
inline double power_of_two_to_scale(double x) {
  if (!(x > 0x1p-1000 && x < 0x1p1000)) return 1;
  return std::ldexp(1.0, -std::ilogb(x));
}

}  // namespace concino::core
