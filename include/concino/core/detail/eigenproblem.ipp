// Generalised eigenproblems; see eigenproblem.hpp.
#pragma once

#include <concino/core/eigenproblem.hpp>
#include <concino/core/error.hpp>
#include <concino/core/message.hpp>
#include <concino/core/system_checks.hpp>

#include <Eigen/Eigenvalues>

#include <cmath>
#include <limits>
#include <utility>

namespace concino::core {

CONCINO_INLINE Eigen::VectorXd symmetric_product(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& x) {
  Eigen::VectorXd y = Eigen::VectorXd::Zero(lower.cols());
  for (int c = 0; c < lower.cols(); ++c)
    for (int k = lower.outerIndexPtr()[c]; k < lower.outerIndexPtr()[c + 1]; ++k) {
      const int row = lower.innerIndexPtr()[k];
      y[row] += lower.valuePtr()[k] * x[c];
      if (row != c) y[c] += lower.valuePtr()[k] * x[row];
    }
  return y;
}

CONCINO_INLINE eigenbasis eigenpairs_within(const Eigen::SparseMatrix<double>& stiffness,
                                            const Eigen::SparseMatrix<double>& mass, Eigen::MatrixXd v) {
  const Eigen::Index n = v.cols();
  for (Eigen::Index j = 0; j < n; ++j) {  // Gram-Schmidt, twice for accuracy
    Eigen::VectorXd u = v.col(j), mu = symmetric_product(mass, u);
    const double mass_before = u.dot(mu);
    for (int round = 0; round < 2; ++round) {
      for (Eigen::Index i = 0; i < j; ++i) u -= v.col(i).dot(mu) * v.col(i);
      mu = symmetric_product(mass, u);
    }
    const double left = u.dot(mu);
    if (!(mass_before > 0 && left > 1e-15 * mass_before))
      throw solver_error("eigenpairs: the mass matrix is not positive definite");
    v.col(j) = u / std::sqrt(left);
  }
  Eigen::MatrixXd k(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::VectorXd kv = symmetric_product(stiffness, v.col(j));
    for (Eigen::Index i = 0; i < n; ++i) k(i, j) = v.col(i).dot(kv);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> all(k);
  return {all.eigenvalues(), v * all.eigenvectors()};
}

CONCINO_INLINE eigen_residual::eigen_residual(const Eigen::SparseMatrix<double>& stiffness,
                                              const Eigen::SparseMatrix<double>& mass, double value,
                                              const Eigen::VectorXd& u) {
  Eigen::VectorXd r = Eigen::VectorXd::Zero(u.size()), mu = r, terms = r;
  const auto add = [&](const Eigen::SparseMatrix<double>& lower, double factor, Eigen::VectorXd* product) {
    const auto add_entry = [&](int row, int column, double a) {
      const double x = a * u[column];
      r[row] += factor * x;
      terms[row] += std::abs(factor * x);
      if (product) (*product)[row] += x;
    };
    for (int c = 0; c < lower.cols(); ++c)
      for (int k = lower.outerIndexPtr()[c]; k < lower.outerIndexPtr()[c + 1]; ++k) {
        const int row = lower.innerIndexPtr()[k];
        add_entry(row, c, lower.valuePtr()[k]);
        if (row != c) add_entry(c, row, lower.valuePtr()[k]);
      }
  };
  add(stiffness, 1, nullptr);
  add(mass, -value, &mu);
  const double of_mass = mu.norm();
  size = r.norm() / of_mass;
  rounding = 8 * std::numeric_limits<double>::epsilon() * terms.norm() / of_mass;
}

CONCINO_INLINE void throw_bad_eigenpair_count(std::size_t count, std::size_t rows) {
  throw_joined<invalid_argument>({"eigenpairs: ", count, " eigenpairs are requested; the problem has ", rows,
                                  " rows with entries, so request 1 to ", rows});
}

CONCINO_INLINE eigenproblem::eigenproblem(const Eigen::SparseMatrix<double>& k, const Eigen::SparseMatrix<double>& m) {
  if (k.rows() != m.rows() || k.cols() != m.cols())
    throw_joined<invalid_argument>({"eigenpairs: the mass has ", static_cast<std::size_t>(m.rows()),
                                    " rows, the other matrix ", static_cast<std::size_t>(k.rows()),
                                    "; they must be of the same size"});
  check_square("eigenpairs", k);
  Eigen::SparseMatrix<double> k_storage, m_storage;
  const auto &whole_k = compressed(k, k_storage), &whole_m = compressed(m, m_storage);
  check_entries("eigenpairs", whole_k);
  check_entries("eigenpairs, mass", whole_m);
  const std::vector<int> new_row = number_rows(whole_k, whole_m);
  choose_scales(diagonal(whole_k), diagonal(whole_m));
  part(whole_k, new_row, stiffness_exponent).swap(stiffness);
  part(whole_m, new_row, mass_exponent).swap(mass);
}

/// Lists the rows that have entries.   Result: the position of each row in that list, or -1.
CONCINO_INLINE std::vector<int> eigenproblem::number_rows(const Eigen::SparseMatrix<double>& k,
                                                          const Eigen::SparseMatrix<double>& m) {
  std::vector<int> new_row(static_cast<std::size_t>(k.cols()), -1);
  for (const auto* a : {&k, &m})
    for (int c = 0; c < a->cols(); ++c)
      for (int e = a->outerIndexPtr()[c]; e < a->outerIndexPtr()[c + 1]; ++e)
        if (a->valuePtr()[e] != 0)
          new_row[static_cast<std::size_t>(c)] = new_row[static_cast<std::size_t>(a->innerIndexPtr()[e])] = 0;
  for (int c = 0; c < k.cols(); ++c)
    if (new_row[static_cast<std::size_t>(c)] == 0) {
      new_row[static_cast<std::size_t>(c)] = static_cast<int>(row.size());
      row.push_back(c);
    }
  return new_row;
}

/// Chooses the powers of 2 by which both matrices are divided, from the means of their diagonals.
/// Errors: solver_error if a row has no mass.
CONCINO_INLINE void eigenproblem::choose_scales(const std::vector<double>& k_diagonal,
                                                const std::vector<double>& m_diagonal) {
  double k_mean = 0, m_mean = 0;
  const double n = static_cast<double>(row.size());
  for (const int c : row) {
    if (!(m_diagonal[static_cast<std::size_t>(c)] > 0))
      throw_joined<solver_error>({"eigenpairs: row ", static_cast<std::size_t>(c),
                                  " has no positive mass, so it has no finite eigenvalue; leave it out"});
    k_mean += std::abs(k_diagonal[static_cast<std::size_t>(c)]) / n;
    m_mean += m_diagonal[static_cast<std::size_t>(c)] / n;
  }
  if (m_mean > 0) mass_exponent = std::ilogb(m_mean);
  if (k_mean > 0) stiffness_exponent = std::ilogb(k_mean);
  mean_stiffness = std::ldexp(k_mean, -stiffness_exponent);
  mean_mass = std::ldexp(m_mean, -mass_exponent);
}

CONCINO_INLINE Eigen::SparseMatrix<double> eigenproblem::part(const Eigen::SparseMatrix<double>& a,
                                                              const std::vector<int>& new_row, int exponent) const {
  const auto n = static_cast<Eigen::Index>(row.size());
  Eigen::SparseMatrix<double> r(n, n);
  const auto for_each_entry = [&](auto visit) {
    for (int c = 0; c < n; ++c) {
      const int column = row[static_cast<std::size_t>(c)];
      for (int e = a.outerIndexPtr()[column]; e < a.outerIndexPtr()[column + 1]; ++e) {
        const int to = new_row[static_cast<std::size_t>(a.innerIndexPtr()[e])];
        if (to >= c) visit(c, to, a.valuePtr()[e]);
      }
    }
  };
  for_each_entry([&](int c, int, double) { ++r.outerIndexPtr()[c + 1]; });
  for (int c = 0; c < n; ++c) r.outerIndexPtr()[c + 1] += r.outerIndexPtr()[c];
  r.resizeNonZeros(r.outerIndexPtr()[n]);
  int at = 0;
  for_each_entry([&](int, int to, double x) {
    r.innerIndexPtr()[at] = to;
    r.valuePtr()[at++] = std::ldexp(x, -exponent);
  });
  return r;
}

CONCINO_INLINE double eigenproblem::scaled(double value) const {
  return std::ldexp(value, mass_exponent - stiffness_exponent);
}

CONCINO_INLINE eigenpairs_result eigenproblem::result(const eigenbasis& found, const Eigen::VectorXd& residuals,
                                                      Eigen::Index rows, const std::vector<int>& of_row) const {
  eigenpairs_result r;
  const Eigen::Index count = found.values.size();
  r.values.resize(count);
  r.residuals.resize(count);
  r.vectors = Eigen::MatrixXd::Zero(rows, count);
  r.solves = found.solves;
  r.isolated = static_cast<std::size_t>(rows) - row.size();
  const auto place = [&](std::size_t i) {
    return of_row.empty() ? static_cast<Eigen::Index>(i) : static_cast<Eigen::Index>(of_row[i]);
  };
  const int unit = stiffness_exponent - mass_exponent, halved = mass_exponent >> 1;
  for (Eigen::Index i = 0; i < count; ++i) {
    double largest = 0;
    for (std::size_t k = 0; k < row.size(); ++k) {
      const double x = found.vectors(place(k), i);
      if (k == 0 || std::abs(x) > std::abs(largest) * (1 + 1e-6)) largest = x;
    }
    r.values[i] = std::ldexp(found.values[i], unit);
    r.residuals[i] = std::ldexp(residuals[i], unit);
    const double factor =
        std::ldexp(largest < 0 ? -1.0 : 1.0, -halved) * (mass_exponent == 2 * halved ? 1 : std::sqrt(0.5));
    for (std::size_t k = 0; k < row.size(); ++k) r.vectors(row[k], i) = factor * found.vectors(place(k), i);
  }
  return r;
}

CONCINO_INLINE Eigen::VectorXd eigen_residuals(const eigenproblem& problem, const eigenbasis& found) {
  Eigen::VectorXd r(found.values.size());
  for (Eigen::Index i = 0; i < r.size(); ++i)
    r[i] = eigen_residual(problem.stiffness, problem.mass, found.values[i], found.vectors.col(i)).size;
  return r;
}

CONCINO_INLINE eigenbasis dense_eigenpairs(const eigenproblem& problem, std::size_t count) {
  const auto n = static_cast<Eigen::Index>(problem.row.size()), wanted = static_cast<Eigen::Index>(count);
  eigenbasis all = eigenpairs_within(problem.stiffness, problem.mass, Eigen::MatrixXd::Identity(n, n));
  all.values.conservativeResize(wanted);
  all.vectors.conservativeResize(Eigen::NoChange, wanted);
  return all;
}

}  // namespace concino::core
