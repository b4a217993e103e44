// What ldlt and llt share: Eigen's factors of a matrix in an elimination order that is kept.
#pragma once

#include <concino/core/error.hpp>
#include <concino/solve/checked_solver.hpp>
#include <concino/solve/detail/direct/ordered.hpp>

#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

using simplicial_ldlt = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>;
using simplicial_llt = Eigen::SimplicialLLT<Eigen::SparseMatrix<double>, Eigen::Upper, Eigen::NaturalOrdering<int>>;

/// The number of entries of the factor below the diagonal, or -1 if there are more than `most`. upper: the upper
/// triangle of the matrix.
/// Cost:   as many steps as entries counted, a small part of a factorisation, and memory for two numbers per row.
inline std::int64_t count_factor_entries(const Eigen::SparseMatrix<double>& upper, std::int64_t most) {
  const auto n = static_cast<std::size_t>(upper.cols());
  std::vector<int> parent(n, -1), seen(n, -1);  // in the elimination tree
  std::int64_t entries = 0;
  for (int c = 0; c < upper.cols(); ++c) {
    seen[static_cast<std::size_t>(c)] = c;
    for (int k = upper.outerIndexPtr()[c]; k < upper.outerIndexPtr()[c + 1]; ++k)
      for (auto i = static_cast<std::size_t>(upper.innerIndexPtr()[k]); seen[i] != c;
           i = static_cast<std::size_t>(parent[i])) {
        if (parent[i] < 0) parent[i] = c;
        seen[i] = c;
        ++entries;
      }
    if (entries > most) return -1;
  }
  return entries;
}

template<class Factors>
struct ordered_factors {
  checked_solver checks;
  direct_solver_options options;
  elimination_order order;
  Factors factors;            // of the reordered matrix
  std::int64_t entries = -1;  // below the diagonal; -1 if the factors are not yet analysed

  ordered_factors(const char* name, const direct_solver_options& given) : checks(name), options(given) {}

  /// Factorises, and calls check_pivots(a, upper), where upper is the reordered matrix. Returns false, and factorises
  /// nothing, if the factor would have more than `most` entries below the diagonal, or more than 32-bit indices can
  /// count.
  template<class F>
  bool factorize(const Eigen::SparseMatrix<double>& matrix, std::int64_t most, F check_pivots) {
    Eigen::SparseMatrix<double> storage;
    const Eigen::SparseMatrix<double>& a = checks.begin_square(matrix, storage);
    if (a.cols() > 0) {
      checks.analyse_once(a, [&](const auto& m) {
        entries = -1;
        order.find(m, options.ordering);
      });
      const Eigen::SparseMatrix<double> upper = order(a);
      if (entries < 0) {
        const std::int64_t counted =
            count_factor_entries(upper, std::min<std::int64_t>(most, std::numeric_limits<int>::max() - a.cols()));
        if (counted < 0) return false;
        factors.analyzePattern(upper);
        entries = counted;
      }
      if (entries > most) return false;
      factors.factorize(upper);
      check_pivots(a, upper);
    }
    checks.accept(a.rows());
    return true;
  }

  [[noreturn]] void throw_too_large() const {
    core::throw_joined<unsupported>(
        {checks.name(), ": the factor would have more entries than 32-bit indices can count; use multigrid"});
  }

  void use_order_of(const ordered_factors& other) {
    if (this == &other) return checks.accept(-1);
    checks.forget_pattern();  // in case that memory for the order runs out
    entries = -1;
    order = elimination_order(other.order);
    checks.use_pattern_of(other.checks);
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const {
    return checks.solve(right, [&](const Eigen::VectorXd& b) {
      Eigen::VectorXd x(b.size()), y(b.size());
      for (Eigen::Index i = 0; i < b.size(); ++i) y[i] = b[order.row[static_cast<std::size_t>(i)]];
      y = factors.solve(y).eval();
      for (Eigen::Index i = 0; i < b.size(); ++i) x[order.row[static_cast<std::size_t>(i)]] = y[i];
      return x;
    });
  }
};

}  // namespace concino::detail
