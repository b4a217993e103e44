// Solves heat equations for values of any order of magnitude, band by band, from the sources outwards. Independent of
// the mesh type and of solvers.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/fields/detail/heat/band_equations.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace concino::detail {

/// Solves A u = b for a heat matrix A. The relative accuracy is the same at each vert, however small its heat is in
/// comparison with that of others.
///
/// An iterative solver is accurate relative to the largest values only, and heat decreases by many orders of magnitude.
/// But at one vert it hardly depends on the verts further out: heat decreases on the way there, and again on the way
/// back. So verts are ordered by expected heat and solved in bands, in which heat decreases by a factor of about e^12.
/// The equations of a band get the heat of the verts before it, which is known, and end where heat is e^-8 of that at
/// its end, as if there were none beyond; the next band solves this overlap again. This is one pass of Schwarz'
/// alternating method, with subdomains that overlap in the direction in which heat flows. Each band is scaled
/// separately, so that no value underflows.
///
/// Equations are symmetric and positive definite, and conjugate gradients solve them whatever the signs of the entries:
/// neither obtuse angles nor negative heat can make this diverge, as they made Gauss-Seidel sweeps in the same order.
/// If the square root of the time is about an edge, 10 to 30 iterations are enough. They are fast, because a band fits
/// into the cache of the processor.
/// Source: Schwarz 1870; Dryja, Widlund 1990, "Towards a unified theory of domain decomposition algorithms for elliptic
///         problems".
class heat_bands {
  static constexpr int no_heat = std::numeric_limits<int>::min() / 2;  // the exponent of 0
  static constexpr double width = 12, overlap = 8;  // of bands, in units of log_guess

  std::span<const int> order_;
  heat_rows rows_;
  std::vector<double> guess_, load_;          // in this order
  std::vector<double> heat_;                  // times 2^exponent_
  std::vector<int> exponent_;
  std::vector<double> band_load_, band_heat_;
  double iterations_ = 0;  // summed over verts

  int find_load(std::size_t first, std::size_t end);

 public:
  /// x is set to an approximate solution of the equations of these verts, with the matrix `lower`, of which only the
  /// lower triangle is there; false if there is none. Rows are in the order of verts.
  using fallback_solver = function_ref<bool(std::span<const int> verts, const Eigen::SparseMatrix<double>& lower,
                                            const Eigen::VectorXd& load, Eigen::VectorXd& x)>;

  /// The verts in the order of decreasing log_guess, which has no NaN; equal ones in the order of their numbers.
  static std::vector<int> order_by_guess(std::span<const double> log_guess);

  /// lower: the lower triangle of A, with positive diagonal entries. load: b, 0 or more. log_guess: approximates the
  /// logarithm of u, up to a constant; -inf where nothing is known, and no heat is found there. order:
  /// order_by_guess(log_guess), which must outlive this object.
  heat_bands(const Eigen::SparseMatrix<double>& lower, std::span<const double> load, std::span<const double> log_guess,
             std::span<const int> order);

  /// Solves until the heat that the equation of each vert lacks or has in excess is at most the tolerance times its own
  /// heat. fallback: is used for bands in which more than some 100 iterations are expected, as where edges are far
  /// shorter than the square root of the time.
  /// Result: false if the tolerance was missed somewhere.
  bool run(double tolerance, fallback_solver fallback);

  /// Iterations, as a mean over the verts.
  double num_iterations() const { return order_.empty() ? 0 : iterations_ / static_cast<double>(order_.size()); }
  /// The logarithm of u at each vert; -inf where u is not positive.
  std::vector<double> log_heat() const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/heat/heat_bands.ipp>
#endif
