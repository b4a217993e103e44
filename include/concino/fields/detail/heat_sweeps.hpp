// Heat of any smallness, by sweeps over the verts from the sources outwards and back. Independent of the mesh type and of solvers.
#pragma once

#include <concino/core/compiled.hpp>

#include <Eigen/SparseCore>

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace concino::detail {

/// Solves A u = b for a heat matrix A. Each vert has a relative accuracy of its own, however small its heat is beside that of others, because each value has
/// an exponent that neither overflows nor underflows. Verts are visited in the order in which heat is expected to decrease, and in the reverse order.
///
/// On the way out, the verts further out, which are not up to date yet, are expected to change by the same factor. Thus the rate at which heat decays
/// converges everywhere at once. With plain Gauss-Seidel, the number of sweeps would increase with the number of edges to the farthest vert. The way back
/// is plain Gauss-Seidel. If the square root of the time is about an edge, 10 to 100 sweeps each way are enough. Sweeps do not converge in time where edges
/// are far shorter, and rarely where fronts meet at obtuse angles of polys on very large meshes.
class heat_sweeps {
  static constexpr int zero = std::numeric_limits<int>::min() / 2;  // exponent of 0
  static constexpr double min_mass = 1e-3;  // of the diagonal entry
  struct value {  // mantissa * 2^exponent
    double mantissa = 0;
    int exponent = zero;
  };
  struct row_sums {  // all times 2^-exponent
    int exponent;
    double before, after;  // contributions of the verts visited before and after this one; `before` includes the load
    double size_before, size_after;  // the same with absolute contributions
    double old;            // the value at this vert
  };

  std::vector<int> order_;  // verts, in the order in which they are visited; all that follows is in this order
  std::vector<int> begin_, column_;
  std::vector<double> entry_;  // off the diagonal, with the sign reversed
  std::vector<double> diagonal_, mass_, load_;  // mass: the sum of a row, at least min_mass of its diagonal entry
  std::vector<value> heat_, last_;              // now, and at the beginning of a sweep
  int num_sweeps_ = 0;

  void permute(const Eigen::SparseMatrix<double>& lower, std::span<const double> load);
  bool sum_row(std::size_t row, row_sums& sums) const;
  value size_before(std::size_t row) const;
  void set(std::size_t row, double x, int exponent);
  void sweep_outwards();
  double sweep_back();

 public:
  /// lower: the lower triangle of A, with positive diagonal entries. load: b, 0 or more. log_guess: approximates the logarithm of u, up to a constant; -inf
  /// where nothing is known.
  heat_sweeps(const Eigen::SparseMatrix<double>& lower, std::span<const double> load, std::span<const double> log_guess);

  /// Sweeps until the heat that the equation of each vert lacks or has in excess is at most the tolerance times its own heat.
  /// Result: false if that is not so after max_sweeps each way.
  bool run(double tolerance, int max_sweeps);

  int num_sweeps() const { return num_sweeps_; }
  /// The logarithm of u at each vert; -inf where u is not positive.
  std::vector<double> log_heat() const;
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/fields/detail/heat_sweeps.ipp>
#endif
