// The smallest eigenpairs of K u = lambda M u by Spectra, for prepared matrices.
#pragma once

#include <concino/core/eigenproblem.hpp>
#include <concino/core/error.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/core/message.hpp>
#include <concino/core/number_text.hpp>

#include <Eigen/Dense>
#include <Eigen/SparseCore>
#include <Spectra/SymEigsBase.h>
#include <Spectra/Util/SimpleRandom.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <utility>
#include <new>
#include <vector>

namespace concino::detail {

using core::eigen_residual;
using core::eigenbasis;
using core::eigenpairs_within;
using core::symmetric_product;

/// The operator shift (K + shift M)^-1 M on the space orthogonal to `found`. Its largest eigenvalues shift / (lambda +
/// shift) have the smallest lambda.
struct shifted_inverse {
  using Scalar = double;

  const Eigen::SparseMatrix<double>& mass;
  function_ref<Eigen::VectorXd(const Eigen::VectorXd&)> solve;
  double shift;
  const Eigen::MatrixXd& found;

  Eigen::Index rows() const { return mass.cols(); }
  Eigen::Index cols() const { return mass.cols(); }
  void project(Eigen::VectorXd& x) const {
    if (found.cols() > 0) x -= found * (found.transpose() * symmetric_product(mass, x)).eval();
  }
  void perform_op(const double* in, double* out) const {
    Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(in, rows());
    project(x);
    x = shift * solve(symmetric_product(mass, x));
    project(x);
    Eigen::Map<Eigen::VectorXd>(out, rows()) = x;
  }
};

struct mass_product {
  using Scalar = double;

  const Eigen::SparseMatrix<double>& mass;

  Eigen::Index rows() const { return mass.cols(); }
  Eigen::Index cols() const { return mass.cols(); }
  void perform_op(const double* in, double* out) const {
    Eigen::Map<Eigen::VectorXd>(out, rows()) =
        symmetric_product(mass, Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(in, rows())));
  }
};

/// Spectra's restarted Lanczos iteration, with access to its residual.
class restarted_lanczos : public Spectra::SymEigsBase<shifted_inverse, mass_product> {
  using base = Spectra::SymEigsBase<shifted_inverse, mass_product>;

 public:
  restarted_lanczos(shifted_inverse& op, const mass_product& mass, Eigen::Index count, Eigen::Index basis)
      : base(op, mass, count, basis) {}

  /// The largest residual of the wanted pairs, relative to their eigenvalues.
  double residual() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(Eigen::MatrixXd(this->m_fac.matrix_H()));
    const Eigen::Index n = ritz.eigenvalues().size();
    double worst = 0;
    for (Eigen::Index i = std::max<Eigen::Index>(0, n - this->m_nev); i < n; ++i)
      worst = std::max(
          worst, std::abs(ritz.eigenvectors()(n - 1, i)) * this->m_fac.f_norm() / std::abs(ritz.eigenvalues()[i]));
    return worst;
  }
};

/// The `count` largest eigenpairs of op. Errors: solver_error.
inline eigenbasis largest_of(shifted_inverse op, Eigen::Index count, double tolerance, int max_restarts,
                             unsigned seed) {
  const Eigen::Index n = op.rows() - op.found.cols();
  const mass_product mass{op.mass};
  eigenbasis r;
  try {
    restarted_lanczos lanczos(op, mass, count, std::min(n, std::max<Eigen::Index>(2 * count + 1, 20)));
    Eigen::VectorXd start = Spectra::SimpleRandom<double>(seed).random_vec(op.rows());
    op.project(start);
    lanczos.init(start.data());
    const Eigen::Index converged =
        lanczos.compute(Spectra::SortRule::LargestAlge, max_restarts, tolerance, Spectra::SortRule::LargestAlge);
    if (converged < count)
      core::throw_joined<solver_error>(
          {"eigenpairs: ", static_cast<std::size_t>(converged), " of ", static_cast<std::size_t>(count),
           " have converged after ", static_cast<std::size_t>(max_restarts), " restarts and ",
           static_cast<std::size_t>(lanczos.num_operations()), " solves; the largest relative residual is ",
           core::number_text(lanczos.residual()), ", the tolerance ", core::number_text(tolerance),
           ": allow more restarts or a larger tolerance"});
    r.values = lanczos.eigenvalues();
    r.vectors = lanczos.eigenvectors();
    r.solves = static_cast<std::size_t>(lanczos.num_operations());
  } catch (const error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {  // from Spectra, if numbers are not finite
    core::throw_joined<solver_error>(
        {"eigenpairs: the iteration broke down; is the mass matrix positive definite? (", e.what(), ")"});
  }
  return r;
}

/// The eigenpairs within the span of the columns of `found`, improved until the residuals of the first `count` are
/// small enough. Spectra measures residuals of the inverse, in which high frequencies have little weight: one more
/// solve per pair removes them.
/// Errors: solver_error if a residual is more than the tolerance times its eigenvalue plus the shift, and more than
///         rounding errors.
inline eigenbasis refine(const Eigen::SparseMatrix<double>& stiffness, const Eigen::SparseMatrix<double>& mass,
                         function_ref<Eigen::VectorXd(const Eigen::VectorXd&)> solve, double shift, Eigen::Index count,
                         double tolerance, Eigen::MatrixXd found) {
  std::size_t solves = 0;
  for (double before = std::numeric_limits<double>::infinity();;) {
    eigenbasis r = eigenpairs_within(stiffness, mass, std::move(found));
    r.solves = solves;
    double worst = 0;
    std::vector<Eigen::Index> above;
    for (Eigen::Index i = 0; i < count; ++i) {
      const eigen_residual left(stiffness, mass, r.values[i], r.vectors.col(i));
      if (left.size <= std::max(tolerance * (r.values[i] + shift), left.rounding)) continue;
      above.push_back(i);
      worst = std::max(worst, left.size / (r.values[i] + shift));
    }
    if (above.empty()) return r;
    if (!(worst < before / 2))
      core::throw_joined<solver_error>(
          {"eigenpairs: not converged: ", above.size(), " of ", static_cast<std::size_t>(count),
           " residuals are up to ", core::number_text(worst), " of the eigenvalue plus the shift, the tolerance is ",
           core::number_text(tolerance), ": allow a larger one, or use another solver"});
    before = worst;
    found = std::move(r.vectors);
    for (const Eigen::Index i : above) {
      found.col(i) = (r.values[i] + shift) * solve(symmetric_product(mass, found.col(i)));
      ++solves;
    }
  }
}

/// The smallest eigenpairs. One start vector spans only one direction of each eigenspace, and finds others by chance.
/// So the space orthogonal to the vectors found is searched again, until it has no smaller eigenvalue.
inline eigenbasis smallest_eigenpairs(const Eigen::SparseMatrix<double>& stiffness,
                                      const Eigen::SparseMatrix<double>& mass,
                                      function_ref<Eigen::VectorXd(const Eigen::VectorXd&)> solve, double shift,
                                      Eigen::Index count, double tolerance, int max_restarts) {
  const Eigen::Index n = mass.cols();
  Eigen::MatrixXd found(n, 0);
  eigenbasis first = largest_of({mass, solve, shift, found}, count, tolerance, max_restarts, 0);
  std::size_t solves = first.solves;
  found = first.vectors;
  std::vector<double> best(first.values.data(), first.values.data() + count);  // largest first
  for (unsigned seed = 1; n - found.cols() > 2; ++seed) {
    const eigenbasis more = largest_of({mass, solve, shift, found}, 1, tolerance, max_restarts, seed);
    solves += more.solves;
    if (!(more.values[0] > best.back() * (1 + 10 * tolerance))) break;
    best.back() = more.values[0];
    std::sort(best.begin(), best.end(), [](double x, double y) { return x > y; });
    found.conservativeResize(Eigen::NoChange, found.cols() + 1);
    found.col(found.cols() - 1) = more.vectors.col(0);
  }
  eigenbasis r = refine(stiffness, mass, solve, shift, count, tolerance, std::move(found));
  r.solves += solves;
  r.values.conservativeResize(count);
  r.vectors.conservativeResize(Eigen::NoChange, count);
  return r;
}

}  // namespace concino::detail
