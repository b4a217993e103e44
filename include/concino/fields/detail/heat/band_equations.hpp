// The equations of heat at the verts of a band, and their solution by conjugate gradients. Independent of the mesh type
// and of solvers.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/fields/detail/heat/heat_rows.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <span>
#include <vector>

namespace concino::detail {

/// Solves the equations of the verts [first, end) of heat_rows, as if there were no verts after them.
///
/// The preconditioner is an incomplete factorisation (D - L) D^-1 (D - L^T), where L is that of the matrix and D are
/// pivots. Thus one iteration needs no product with the matrix, and costs one pass over the entries forward and one
/// back. Positive entries off the diagonal, as obtuse angles cause, may make pivots too small or negative. Therefore a
/// pivot is at least the sum of the absolute entries right of it: with an M-matrix it always is, and substitution then
/// does not amplify errors. The preconditioner is positive definite for any signs of the entries, so the iteration
/// cannot diverge.
/// Source: Eisenstat 1981, "Efficient implementation of a class of preconditioned conjugate gradient methods";
///         Axelsson, Lindskog 1986, "On the eigenvalue distribution of a class of preconditioning methods" (the
///         pivots).
class band_equations {
  std::vector<int> begin_, column_;      // of entries left of the diagonal; columns are numbered from 0 in the band
  std::vector<double> entry_;            // with the sign reversed; all that follows is scaled so that pivots are 1
  std::vector<double> diagonal_, load_;
  std::vector<double> scale_;            // of each unknown and equation: 1 / sqrt(pivot)
  std::vector<double> mass_;             // as a fraction of the diagonal entry
  std::vector<double> x_, start_, change_, residual_, direction_, product_, along_;
  std::size_t num_accepted_ = 0;
  double tolerance_ = 0;
  int num_iterations_ = 0;

  void find_pivots(const heat_rows& rows, std::size_t first, std::size_t end);
  void substitute_forward(std::vector<double>& y) const;
  void substitute_back(std::vector<double>& y) const;
  double find_residual(bool measures);
  double iterate_once(double square);
  bool iterate(int max_iterations, bool may_stop_early);

 public:
  /// x is set to an approximate solution of the equations with the matrix `lower`, of which only the lower triangle is
  /// there; false if there is none.
  using fallback_solver =
      function_ref<bool(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& load, Eigen::VectorXd& x)>;

  void assign(const heat_rows& rows, std::size_t first, std::size_t end);

  /// Solves until the heat that each of the first num_accepted equations lacks or has in excess is at most the
  /// tolerance times its own heat. So every value has the same relative accuracy, however small it is in comparison
  /// with others in the band. x: an approximation, set to the solution. fallback: is used once where more than some 100
  /// iterations are expected; they continue where it has no solution.
  /// Result: false if the tolerance was missed; x is then the best approximation.
  bool solve(std::span<const double> load, std::span<double> x, std::size_t num_accepted, double tolerance,
             fallback_solver fallback);

  /// The lower triangle of the matrix, not scaled.
  Eigen::SparseMatrix<double> lower() const;

  /// Of the last solve.
  int num_iterations() const { return num_iterations_; }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/heat/band_equations.ipp>
#endif
