// The smallest eigenpairs of a large sparse matrix by LOBPCG, preconditioned by a cycle of multigrid.
#pragma once

#include <concino/core/error.hpp>
#include <concino/solve/detail/eigen/random_vectors.hpp>
#include <concino/solve/detail/eigen/vector_block.hpp>
#include <concino/solve/detail/multigrid/multigrid_levels.hpp>
#include <concino/solve/detail/multigrid/multigrid_panels.hpp>

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

/// The smallest eigenvalues mu of A x = mu M x, for A and M positive definite. The basis holds the approximations X,
/// the directions P of the last iteration, and the preconditioned residuals W of the pairs that have not converged. It
/// is orthonormal with respect to M: the coefficients of P are made orthogonal to those of X (Hetmaniuk, Lehoucq 2006;
/// Duersch et al. 2018), and W is made so by singular value decompositions of its Gram matrix, which drop what depends
/// on the rest (Stathopoulos, Wu 2002). Pairs that have converged remain in X, so that others stay orthogonal to them
/// (soft locking).
class lobpcg_iteration {
  const multigrid_levels& levels_;
  const Eigen::SparseMatrix<double>& mass_;
  Eigen::Index n_, size_, old_ = 0;  // size_: number of vectors in X; old_: in P
  double tolerance_;
  vector_block basis_, product_;
  multigrid_panels preconditioner_;
  std::vector<double> row_sum_;  // of absolute values of A
  Eigen::MatrixXd energy_;       // P^T A P
  Eigen::MatrixXd images_;       // [X P]^T A X

 public:
  Eigen::VectorXd values, residuals, allowed;  // of all vectors of X; residuals and their bounds are |A x - mu M x| /
                                               // |M x|
  std::size_t iterations = 0, cycles = 0;

  lobpcg_iteration(const multigrid_levels& levels, const Eigen::SparseMatrix<double>& mass, Eigen::Index size,
                   double tolerance)
      : levels_(levels), mass_(mass), n_(mass.cols()), size_(size), tolerance_(tolerance), basis_(n_, 3 * size),
        product_(n_, size), preconditioner_(levels, size), row_sum_(static_cast<std::size_t>(n_)) {
    const lower_entries a(levels.finest());
    for (int c = 0; c < a.n; ++c)
      for (int k = a.starts[c]; k < a.starts[c + 1]; ++k) {
        row_sum_[static_cast<std::size_t>(c)] += std::abs(a.a[k]);
        if (k > a.starts[c]) row_sum_[static_cast<std::size_t>(a.rows[k])] += std::abs(a.a[k]);
      }
  }

  /// Starts with random vectors, smoothed by one cycle, always the same.
  void start() {
    std::vector<Eigen::Index> all(static_cast<std::size_t>(size_));
    for (std::size_t j = 0; j < all.size(); ++j) all[j] = static_cast<Eigen::Index>(j);
    const column_range b = product_.columns(0, size_), x = basis_.columns(0, size_);
    fill_with_noise(b, n_, 0);
    const lower_entries m(mass_);
    for (int i = 0; i < m.n; ++i)
      for (Eigen::Index j = 0; j < size_; ++j) b.row(i)[j] *= m.a[m.starts[i]];
    apply_cycles(b, all, x);
    for (Eigen::Index found = 0, attempt = 0; (found += orthonormalize(found, size_ - found)) < size_;) {
      if (++attempt == 4)
        throw solver_error(
            "eigenpairs: no basis of independent vectors was found; is the mass matrix positive definite?");
      fill_with_noise(basis_.columns(found, size_ - found), n_, static_cast<std::uint64_t>(attempt));
    }
    rotate();
  }

  /// Replaces X by the approximations of eigenvectors in its span, anew from X alone.
  void restart() {
    if (orthonormalize(0, size_) < size_)
      throw solver_error("eigenpairs: the iteration broke down; is the mass matrix positive definite?");
    rotate();
  }

  /// Computes values and residuals from the vectors. Afterwards product_ holds the residual vectors.
  void measure() {
    const column_range x = basis_.columns(0, size_), mx = basis_.columns(size_ + old_, size_),
                       r = product_.columns(0, size_);
    multiply_columns(levels_.finest(), x, r);
    images_ = gram_matrix(n_, basis_.columns(0, size_ + old_), r);
    multiply_columns(mass_, x, mx);
    values = images_.topRows(size_).diagonal();
    if (!values.allFinite()) throw_not_finite();
    if (!(values.minCoeff() > 0)) throw_indefinite();
    const Eigen::MatrixXd squares = row_blocks(n_).sum(3, size_, [&](Eigen::Index first, Eigen::Index last) {
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(3, size_);
      for (Eigen::Index i = first; i < last; ++i) {
        const double bound = row_sum_[static_cast<std::size_t>(i)];
        for (Eigen::Index j = 0; j < size_; ++j) {
          const double mass = mx.row(i)[j], residual = r.row(i)[j] -= values[j] * mass, terms = bound * x.row(i)[j];
          sum(0, j) += residual * residual;
          sum(1, j) += mass * mass;
          sum(2, j) += terms * terms;
        }
      }
      return sum;
    });
    residuals.resize(size_);
    allowed.resize(size_);
    for (Eigen::Index j = 0; j < size_; ++j) {
      const double rounding = 8 * std::numeric_limits<double>::epsilon() * std::sqrt(squares(2, j) / squares(1, j));
      residuals[j] = std::sqrt(squares(0, j) / squares(1, j));
      allowed[j] = std::max(tolerance_ * values[j], rounding);
    }
  }

  /// One iteration, after measure(). Returns false if there is no new direction.
  bool improve() {
    std::vector<Eigen::Index> active;
    for (Eigen::Index j = 0; j < size_; ++j)
      if (!(residuals[j] <= allowed[j])) active.push_back(j);
    const Eigen::Index known = size_ + old_;
    apply_cycles(product_.columns(0, size_), active, basis_.columns(known, static_cast<Eigen::Index>(active.size())));
    const Eigen::Index added = orthonormalize(known, static_cast<Eigen::Index>(active.size()));
    if (added == 0) return false;
    ++iterations;
    multiply_columns(levels_.finest(), basis_.columns(known, added), product_.columns(0, added));
    const Eigen::Index all = known + added;
    const Eigen::MatrixXd last = gram_matrix(n_, basis_.columns(0, all), product_.columns(0, added));
    Eigen::MatrixXd h = Eigen::MatrixXd::Zero(all, all);  // only the lower triangle is read
    h.block(0, 0, known, size_) = images_;
    h.block(size_, size_, old_, old_) = energy_;
    h.block(known, 0, added, known) = last.topRows(known).transpose();
    h.block(known, known, added, added) = last.bottomRows(added);
    h = h.selfadjointView<Eigen::Lower>().toDenseMatrix().eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(h);
    if (ritz.info() != Eigen::Success || !ritz.eigenvalues().allFinite()) throw_not_finite();
    const Eigen::MatrixXd next = ritz.eigenvectors().leftCols(size_), directions = new_directions(next, active);
    Eigen::MatrixXd both(all, size_ + directions.cols());
    both << next, directions;
    combine(n_, basis_.columns(0, all), both);
    old_ = directions.cols();
    energy_ = directions.transpose() * h * directions;
    return true;
  }

  Eigen::MatrixXd vectors(const std::vector<Eigen::Index>& column) {
    Eigen::MatrixXd r(n_, static_cast<Eigen::Index>(column.size()));
    const column_range x = basis_.columns(0, size_);
    for (std::size_t j = 0; j < column.size(); ++j)
      for (Eigen::Index i = 0; i < n_; ++i) r(i, static_cast<Eigen::Index>(j)) = x.row(i)[column[j]];
    return r;
  }

 private:
  [[noreturn, gnu::noinline, gnu::cold]] static void throw_not_finite() {
    throw solver_error(
        "eigenpairs: the iteration left the range of numbers: entries of the matrices differ too much in size, or are not those of a positive"
        " semidefinite matrix and a positive definite mass");
  }
  [[noreturn, gnu::noinline, gnu::cold]] static void throw_indefinite() {
    throw solver_error(
        "eigenpairs: the matrix is not positive semidefinite: it has an eigenvalue below minus the shift; choose a larger shift, or give it the"
        " other sign if it is a Laplacian");
  }

  void apply_cycles(const column_range& x, const std::vector<Eigen::Index>& column, const column_range& y) {
    preconditioner_.apply(x, column, y);
    cycles += column.size();
  }

  /// Makes the columns after the first `known` orthonormal, also to those, which are so already. Returns how many
  /// remain.
  Eigen::Index orthonormalize(Eigen::Index known, Eigen::Index added) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    for (int round = 0; round < 4 && added > 0; ++round) {
      const column_range v = basis_.columns(0, known), w = basis_.columns(known, added);
      multiply_columns(mass_, w, product_.columns(0, added));
      const Eigen::MatrixXd products = gram_matrix(n_, basis_.columns(0, known + added), product_.columns(0, added));
      if (!products.allFinite()) throw_not_finite();
      const Eigen::MatrixXd along = products.topRows(known);
      Eigen::MatrixXd rest = products.bottomRows(added) - along.transpose() * along;
      Eigen::VectorXd scale(added);
      double error = epsilon;  // of the scaled matrix
      for (Eigen::Index j = 0; j < added; ++j) {
        const double before = products(known + j, j);
        if (before < 0) throw solver_error("eigenpairs: the mass matrix is not positive definite");
        const bool is_new = rest(j, j) > 1e-13 * before && before > 0;
        scale[j] = is_new ? 1 / std::sqrt(rest(j, j)) : 0;
        if (is_new) error = std::max(error, epsilon * before / rest(j, j));
      }
      rest = (scale.asDiagonal() * rest * scale.asDiagonal()).eval();
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(rest);
      const double smallest = 100 * static_cast<double>(added) * error;
      Eigen::Index dropped = 0;
      while (dropped < added && !(parts.eigenvalues()[dropped] > smallest)) ++dropped;
      const Eigen::Index kept = added - dropped;
      const Eigen::MatrixXd factor = scale.asDiagonal() * parts.eigenvectors().rightCols(kept) *
                                     parts.eigenvalues().tail(kept).cwiseSqrt().cwiseInverse().asDiagonal();
      combine(n_, w, factor, v, along * factor);
      if (kept == 0) return 0;
      const double worst = error / parts.eigenvalues()[dropped];
      added = kept;
      if (worst < 1e-12) break;
    }
    return added;
  }

  /// Rayleigh-Ritz within X.
  void rotate() {
    const column_range x = basis_.columns(0, size_), ax = product_.columns(0, size_);
    multiply_columns(levels_.finest(), x, ax);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(gram_matrix(n_, x, ax));
    if (ritz.info() != Eigen::Success || !ritz.eigenvalues().allFinite()) throw_not_finite();
    combine(n_, x, ritz.eigenvectors());
    old_ = 0;
    energy_.resize(0, 0);
  }

  /// Coefficients of the directions in which the active vectors moved out of X, orthonormal and orthogonal to those of
  /// the new X.
  Eigen::MatrixXd new_directions(const Eigen::MatrixXd& next, const std::vector<Eigen::Index>& active) const {
    Eigen::MatrixXd r(next.rows(), static_cast<Eigen::Index>(active.size()));
    Eigen::Index number = 0;
    for (const Eigen::Index j : active) {
      Eigen::VectorXd z = next.col(j);
      z.head(size_).setZero();
      if (!(z.norm() > 0)) continue;
      z /= z.norm();
      for (int round = 0; round < 2; ++round) {
        z -= (next * (next.transpose() * z)).eval();
        z -= (r.leftCols(number) * (r.leftCols(number).transpose() * z)).eval();
        if (round == 0 && z.norm() > 1e-8) z /= z.norm();
      }
      if (!(z.norm() > 0.5)) continue;
      r.col(number++) = z / z.norm();
    }
    return r.leftCols(number);
  }
};

}  // namespace concino::detail
