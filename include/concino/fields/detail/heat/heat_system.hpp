// The linear algebra of heat geodesics, on matrices and flat arrays only. It has three steps: heat flows for a short
// time, and its logarithm has a value at any distance; the gradient of the logarithm is normalised; the function with
// this gradient solves Poisson's equation.
#pragma once

#include <concino/core/residual.hpp>
#include <concino/core/vec3.hpp>
#include <concino/fields/detail/heat/heat_equation.hpp>
#include <concino/fields/detail/problems/make_similar_solver.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// For each corner of each poly, grouped by poly: its vert, and the gradient of the vert's hat function times the
/// measure of the poly.
struct corner_fluxes {
  std::vector<std::size_t> begin{0};  // by poly, and the end of the last
  std::vector<int> vert;
  std::vector<vec3> flux;
};

/// The load of Poisson's equation for the function whose gradient is nearest to the unit vectors along the gradient of
/// -log_u, which has the direction of that of -u. Gradients that are very small or large are divided by their largest
/// component before they are squared. Polys where the gradient is zero up to rounding have no direction and do not
/// contribute.
inline Eigen::VectorXd direction_load(const corner_fluxes& corners, const std::vector<double>& log_u) {
  const auto largest_component = [](const vec3& x) {
    return std::max(std::abs(x.x), std::max(std::abs(x.y), std::abs(x.z)));
  };
  Eigen::VectorXd b = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(log_u.size()));
  for (std::size_t p = 0; p + 1 < corners.begin.size(); ++p) {
    const std::size_t first = corners.begin[p], end = corners.begin[p + 1];
    if (first == end) continue;
    const double here = log_u[static_cast<std::size_t>(corners.vert[first])];
    if (here == -std::numeric_limits<double>::infinity()) continue;
    vec3 g;
    double terms = 0;
    for (std::size_t k = first + 1; k < end; ++k) {
      const vec3 term = (here - log_u[static_cast<std::size_t>(corners.vert[k])]) * corners.flux[k];
      g += term;
      terms = std::max(terms, largest_component(term));
    }
    const double largest = largest_component(g);
    if (!(largest > 1e-10 * terms)) continue;
    if (!(largest > 0x1p-400 && largest < 0x1p400)) g = g / largest;
    const vec3 direction = (1 / std::sqrt(dot(g, g))) * g;
    for (std::size_t k = first; k < end; ++k) b[corners.vert[k]] += dot(corners.flux[k], direction);
  }
  return b;
}

template<class Solver>
class heat_system {
  static constexpr double none = -std::numeric_limits<double>::infinity();

  std::vector<heat_equation<Solver>> heats_;  // one, or two whose solutions are added
  Eigen::SparseMatrix<double> poisson_;       // lower triangle
  std::unique_ptr<Solver> poisson_solver_;
  corner_fluxes corners_;
  std::vector<int> component_;  // of polys connected through verts: the number of one vert of each component
  bool is_iterative_ = false;   // a solver may change its method later
  int unit_ = 0;                // 2^unit_ is about the mass of a vert: it makes heat independent of the scale of the
                                // mesh

  void find_components(int size) {
    disjoint_sets sets(static_cast<std::size_t>(size));
    for (std::size_t p = 0; p + 1 < corners_.begin.size(); ++p)
      for (std::size_t k = corners_.begin[p] + 1; k < corners_.begin[p + 1]; ++k)
        sets.unite(static_cast<std::size_t>(corners_.vert[k - 1]), static_cast<std::size_t>(corners_.vert[k]));
    component_.resize(static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < component_.size(); ++i) component_[i] = static_cast<int>(sets.root(i));
  }

 public:
  /// stiffness: minus a Laplacian, the lower triangle with every diagonal entry present. mean_mass: of the verts, 0 if
  /// there are none.
  heat_system(Eigen::SparseMatrix<double>&& stiffness, corner_fluxes&& corners, double mean_mass, const Solver& solver)
      : poisson_(std::move(stiffness)), poisson_solver_(make_similar_solver(solver)), corners_(std::move(corners)) {
    const int n = static_cast<int>(poisson_.cols());
    find_components(n);
    if (mean_mass > 0) unit_ = std::ilogb(mean_mass);
    // Only differences of the solution count, so one vert of each component is constrained. This changes no difference,
    // because the load sums to 0.
    for (int i = 0; i < n; ++i) {
      if (component(i) != i) continue;
      double& constrained = poisson_.coeffRef(i, i);
      constrained = constrained > 0 ? 2 * constrained : 1;
    }
    core::factorize_over_verts(*poisson_solver_, poisson_, "heat_geodesics", [](Eigen::Index row) { return row; });
    is_iterative_ = core::is_iterative(*poisson_solver_);
    if (is_iterative_) return;
    Eigen::VectorXd b(n);  // any: a factor is as accurate for all right-hand sides, so queries need not check
    for (int i = 0; i < n; ++i) b[i] = i % 2 ? 1 : -1;
    core::solve_and_check(*poisson_solver_, poisson_, b, "heat_geodesics");
  }

  /// lower: the masses minus the time times a Laplacian, with the same pattern.
  void add_heat(Eigen::SparseMatrix<double>&& lower, const Solver& solver) {
    heats_.emplace_back(std::move(lower));
    if (!is_iterative()) heats_.back().factorize(solver, *poisson_solver_);
  }

  /// Whether the solver was iterative when it was factorised. Heat is then found in bands, which need a guess.
  bool is_iterative() const { return is_iterative_; }

  /// The first vert of each component of polys in the order is_before(v, w).
  template<class IsBefore>
  std::vector<heat_source> one_source_per_component(const IsBefore& is_before) const {
    std::vector<heat_source> sources;
    std::vector<int> first(component_.size(), -1);
    for (const int v : corners_.vert)
      if (int& known = first[static_cast<std::size_t>(component(v))]; known < 0 || is_before(v, known)) known = v;
    for (const int v : first)
      if (v >= 0) sources.push_back({v, 1});
    return sources;
  }

  /// Whether heat from these sources is negative at one vert in 500 or more of their components, as with very long and
  /// thin polys. Such heat does not show the direction of its source. log_guess: as for log_heat.
  bool is_heat_negative(const std::vector<heat_source>& sources, std::span<const double> log_guess) const {
    std::vector<unsigned char> is_heated(component_.size());
    for (const heat_source& s : sources) is_heated[static_cast<std::size_t>(component(s.vert))] = 1;
    std::size_t num_negative = 0, all = 0;
    const std::vector<double> log_u = log_heat(sources, log_guess);
    for (std::size_t i = 0; i < component_.size(); ++i) {
      if (!is_heated[static_cast<std::size_t>(component_[i])]) continue;
      ++all;
      num_negative += log_u[i] == none;
    }
    return num_negative > 0 && 500 * num_negative >= all;
  }
  void forget_heat() { heats_.clear(); }

  int component(int vert) const { return component_[static_cast<std::size_t>(vert)]; }

  /// The logarithm of the heat at each vert, up to a constant; -inf in components without a source, and where heat is
  /// not positive, as it may be with Laplacians that have negative weights. log_guess: about what is returned, up to a
  /// constant in each component; read if solvers are iterative.
  ///
  /// Iterative solvers are accurate relative to the largest values only, so heat is found in bands.
  std::vector<double> log_heat(const std::vector<heat_source>& sources, std::span<const double> log_guess) const {
    if (is_iterative()) {
      const std::vector<int> order = heat_bands::order_by_guess(log_guess);
      const auto solve = [&](const heat_equation<Solver>& heat) {
        return heat.solve_in_bands(*poisson_solver_, sources, component_, log_guess, order);
      };
      std::vector<double> sum = solve(heats_.front());
      if (heats_.size() == 1) return sum;
      const std::vector<double> other = solve(heats_.back());
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = log_of_sum(sum[i], other[i]);
      return sum;
    }
    const rescaled_heat a = heats_.front().heat_from(sources, component_, unit_);
    if (heats_.size() == 1) return a.logs();
    return a.logs_of_sum(heats_.back().heat_from(sources, component_, unit_));
  }

  /// The function whose gradient is nearest to the directions of direction_load.
  Eigen::VectorXd integrate_gradient(const std::vector<double>& log_u) const {
    const Eigen::VectorXd b = direction_load(corners_, log_u);
    if (!is_iterative_) return poisson_solver_->solve(b);
    return core::solve_and_check(*poisson_solver_, poisson_, b, "heat_geodesics");
  }
};

}  // namespace concino::detail
