// Eliminates conditions x_i = v_i from a linear system: keeps the columns of the other unknowns and corrects the
// right-hand side.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace concino::detail {

struct known_values {
  Eigen::VectorXd x;          // known values; 0 elsewhere
  std::vector<int> unknown;   // its number among the other unknowns, -1 if known
  int unknowns = 0;

  /// Errors: invalid_argument if an index is out of range or given two different values, or a value is not finite.
  template<class D>
  known_values(const char* caller, Eigen::Index size, const D& known)
      : x(Eigen::VectorXd::Zero(size)), unknown(static_cast<std::size_t>(size), 0) {
    for (const auto& [index, value] : known) {
      const auto i = static_cast<Eigen::Index>(index);
      const auto v = static_cast<double>(value);
      if (i < 0 || i >= size)
        core::throw_joined<invalid_argument>({caller, ": a value is given for unknown ", core::number_text(i),
                                              ", but there are ", static_cast<std::size_t>(size), ", numbered from 0"});
      if (!std::isfinite(v))
        core::throw_joined<invalid_argument>(
            {caller, ": the value given for unknown ", core::number_text(i), " is not finite"});
      int& u = unknown[static_cast<std::size_t>(i)];
      if (u < 0 && x[i] != v)
        core::throw_joined<invalid_argument>({caller, ": unknown ", core::number_text(i), " is given two values, ",
                                              core::number_text(x[i]), " and ", core::number_text(v)});
      x[i] = v;
      u = -1;
    }
    for (int& u : unknown)
      if (u == 0) u = unknowns++;
  }

  /// The columns of the unknowns, in their order. a: compressed.
  Eigen::SparseMatrix<double> columns_of_unknowns(const Eigen::SparseMatrix<double>& a) const {
    Eigen::SparseMatrix<double> r(a.rows(), unknowns);
    std::size_t entries = 0;
    for (int c = 0; c < a.cols(); ++c)
      if (unknown[static_cast<std::size_t>(c)] >= 0)
        entries += static_cast<std::size_t>(a.outerIndexPtr()[c + 1] - a.outerIndexPtr()[c]);
    r.resizeNonZeros(static_cast<Eigen::Index>(entries));
    int at = 0;
    for (int c = 0; c < a.cols(); ++c) {
      const int u = unknown[static_cast<std::size_t>(c)];
      if (u < 0) continue;
      for (int k = a.outerIndexPtr()[c]; k < a.outerIndexPtr()[c + 1]; ++k, ++at) {
        r.innerIndexPtr()[at] = a.innerIndexPtr()[k];
        r.valuePtr()[at] = a.valuePtr()[k];
      }
      r.outerIndexPtr()[u + 1] = at;
    }
    return r;
  }

  /// Combines computed and known values; known values are exact to the last bit.
  Eigen::VectorXd with(const Eigen::VectorXd& found) const {
    Eigen::VectorXd r = x;
    for (std::size_t i = 0; i < unknown.size(); ++i)
      if (unknown[i] >= 0) r[static_cast<Eigen::Index>(i)] = found[unknown[i]];
    return r;
  }
};

}  // namespace concino::detail
