// The linear algebra of heat geodesics, on matrices and flat arrays only. It has three steps: heat flows for a short time, and its logarithm has a value
// at any distance; the gradient of the logarithm is normalised; the function with this gradient solves Poisson's equation.
#pragma once

#include <concino/core/residual.hpp>
#include <concino/core/vec3.hpp>
#include <concino/fields/detail/heat_sweeps.hpp>
#include <concino/fields/detail/make_similar_solver.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// For each corner of each poly, grouped by poly: its vert, and the gradient of the vert's hat function times the measure of the poly.
struct corner_fluxes {
  std::vector<std::size_t> begin{0};  // by poly, and the end of the last
  std::vector<int> vert;
  std::vector<vec3> flux;
};

/// A vert at which heat starts.
struct heat_source {
  int vert;
  double strength;  // greater than 0
};

template<class Solver>
class heat_system {
  static constexpr double none = -std::numeric_limits<double>::infinity();
  /// An exponent e: heat starts from 2^e and is used down to 2^-e, which is a distance of about 1.4 e times the square root of the time. Direct
  /// solvers use the range of double precision; iterative ones only the range in which values much smaller than the others have correct digits.
  static int scale_exponent(const Solver& solver) { return core::is_iterative(solver) ? 13 : 900; }
  static constexpr int max_rounds = 100;  // of continuing underflowed heat; 70 times more for iterative solvers, whose rounds are short

  // See heat_sweeps. Distances then differ from those by factorisation by about 1e-4 of the largest.
  static constexpr double sweep_tolerance = 2e-3;
  static constexpr int max_sweeps = 100;

  struct factorised {
    Eigen::SparseMatrix<double> lower;  // triangle
    mutable std::unique_ptr<Solver> solver;  // of heat: none if solvers are iterative, until sweeps have failed

    void factorize() { factorize_by(*solver); }
    void factorize_by(Solver& by) const {
      core::factorize_over_verts(by, lower, "heat_geodesics", [](Eigen::Index row) { return row; });
    }
  };

  std::vector<factorised> heats_;  // one, or two whose solutions are added
  factorised poisson_;
  corner_fluxes corners_;
  std::vector<int> component_;  // of polys connected through verts: the number of one vert of each component
  bool is_iterative_ = false;   // a solver may change its method later
  std::unique_ptr<std::mutex> adding_solver_ = std::make_unique<std::mutex>();  // locked by the query that adds a solver of heat
  int unit_ = 0;                // 2^unit_ is about the mass of a vert: it makes heat independent of the scale of the mesh

  void find_components(int size) {
    disjoint_sets sets(static_cast<std::size_t>(size));
    for (std::size_t p = 0; p + 1 < corners_.begin.size(); ++p)
      for (std::size_t k = corners_.begin[p] + 1; k < corners_.begin[p + 1]; ++k)
        sets.unite(static_cast<std::size_t>(corners_.vert[k - 1]), static_cast<std::size_t>(corners_.vert[k]));
    component_.resize(static_cast<std::size_t>(size));
    for (std::size_t i = 0; i < component_.size(); ++i) component_[i] = static_cast<int>(sets.root(i));
  }

  static double& diagonal(Eigen::SparseMatrix<double>& lower, int i) { return lower.coeffRef(i, i); }

 public:
  /// stiffness: minus a Laplacian, the lower triangle with every diagonal entry present. mean_mass: of the verts, 0 if there are none.
  heat_system(Eigen::SparseMatrix<double>&& stiffness, corner_fluxes&& corners, double mean_mass, const Solver& solver)
      : poisson_{std::move(stiffness), make_similar_solver(solver)}, corners_(std::move(corners)) {
    const int n = static_cast<int>(poisson_.lower.cols());
    find_components(n);
    if (mean_mass > 0) unit_ = std::ilogb(mean_mass);
    // Only differences of the solution count, so one vert of each component is constrained. This changes no difference, because the load sums to 0.
    for (int i = 0; i < n; ++i) {
      if (component(i) != i) continue;
      double& constrained = diagonal(poisson_.lower, i);
      constrained = constrained > 0 ? 2 * constrained : 1;
    }
    poisson_.factorize();
    is_iterative_ = core::is_iterative(*poisson_.solver);
  }

  /// lower: the masses minus the time times a Laplacian, with the same pattern.
  void add_heat(Eigen::SparseMatrix<double>&& lower, const Solver& solver) {
    heats_.push_back({std::move(lower), make_similar_solver(solver)});
    for (int i = 0; i < heats_.back().lower.cols(); ++i)
      if (double& x = diagonal(heats_.back().lower, i); !(x > 0)) x = 1;  // a vert of no poly
    if (is_iterative()) {
      heats_.back().solver.reset();
      return;
    }
    if constexpr (requires(Solver& s) { s.use_order_of(s); }) heats_.back().solver->use_order_of(*poisson_.solver);
    heats_.back().factorize();
  }

  /// Whether the solver was iterative when it was factorised. Heat is then found by sweeps, which need a guess.
  bool is_iterative() const { return is_iterative_; }

  /// One vert of each component of polys.
  std::vector<heat_source> one_source_per_component() const {
    std::vector<heat_source> sources;
    std::vector<unsigned char> is_heated(component_.size());
    for (const int v : corners_.vert)
      if (unsigned char& known = is_heated[static_cast<std::size_t>(component(v))]; !known) {
        known = 1;
        sources.push_back({component(v), 1});
      }
    return sources;
  }

  /// Whether heat from these sources is negative at one vert in 500 or more of their components, as with very long and thin polys. Such heat does not show
  /// the direction of its source. log_guess: as for log_heat.
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

  /// The logarithm of the heat at each vert, up to a constant; -inf in components without a source, and where heat is not positive,
  /// as it may be with Laplacians that have negative weights. log_guess: about what is returned, up to a constant in each component; read if
  /// solvers are iterative.
  ///
  /// Iterative solvers are accurate relative to the largest values only, so heat is found by sweeps; by such a solver where they converge slowly.
  ///
  /// Where heat underflows double precision, it is continued from there. Let u be known down to a threshold, and v equal to u there and 0
  /// beyond. The rest, u - v, solves the same system with the right-hand side b - K v. This is not 0 on both sides of the frontier only,
  /// and can be scaled by any factor.
  std::vector<double> log_heat(const std::vector<heat_source>& sources, std::span<const double> log_guess) const {
    if (is_iterative()) {
      std::vector<double> sum = log_by_sweeps(heats_.front(), sources, log_guess);
      if (heats_.size() == 1) return sum;
      const std::vector<double> other = log_by_sweeps(heats_.back(), sources, log_guess);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = log_of_sum(sum[i], other[i]);
      return sum;
    }
    const rescaled_heat a = solve_rescaled(heats_.front(), sources);
    std::vector<double> sum(a.heat.size());
    if (heats_.size() == 1) {
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = a.log(i);
      return sum;
    }
    const rescaled_heat b = solve_rescaled(heats_.back(), sources);
    for (std::size_t i = 0; i < sum.size(); ++i) {
      if (a.round[i] == b.round[i]) sum[i] = a.log_of(a.heat[i] + b.heat[i], a.round[i]);
      else sum[i] = log_of_sum(a.log(i), b.log(i));
    }
    return sum;
  }

  /// The function whose gradient is nearest to the unit vectors along the gradient of -log_u, which has the direction of that of -u. Gradients
  /// that are very small or large are divided by their largest component before they are squared. Polys with zero gradient do not contribute.
  Eigen::VectorXd integrate_gradient(const std::vector<double>& log_u) const {
    Eigen::VectorXd b = Eigen::VectorXd::Zero(poisson_.lower.cols());
    for (std::size_t p = 0; p + 1 < corners_.begin.size(); ++p) {
      const std::size_t first = corners_.begin[p], end = corners_.begin[p + 1];
      if (first == end) continue;
      const double here = log_u[static_cast<std::size_t>(corners_.vert[first])];
      if (here == none) continue;
      vec3 g;
      for (std::size_t k = first + 1; k < end; ++k) g += (here - log_u[static_cast<std::size_t>(corners_.vert[k])]) * corners_.flux[k];
      const double largest = std::max({std::abs(g.x), std::abs(g.y), std::abs(g.z)});
      if (!(largest > 0)) continue;
      if (!(largest > 0x1p-400 && largest < 0x1p400)) g = g / largest;
      const vec3 direction = (1 / std::sqrt(dot(g, g))) * g;
      for (std::size_t k = first; k < end; ++k) b[corners_.vert[k]] += dot(corners_.flux[k], direction);
    }
    return core::solve_and_check(*poisson_.solver, poisson_.lower, b, "heat_geodesics");
  }

 private:
  /// The logarithm of the sum of two numbers that are given by theirs.
  static double log_of_sum(double x, double y) {
    const double large = std::max(x, y), small = std::min(x, y);
    return small == none ? large : large + std::log1p(std::exp(small - large));
  }

  std::vector<double> log_by_sweeps(const factorised& heat, const std::vector<heat_source>& sources, std::span<const double> log_guess) const {
    std::vector<double> load(component_.size());
    for (const heat_source& s : sources) load[static_cast<std::size_t>(s.vert)] += s.strength;
    heat_sweeps sweeps(heat.lower, load, log_guess);
    if (sweeps.run(sweep_tolerance, max_sweeps)) return sweeps.log_heat();
    {
      const std::lock_guard<std::mutex> lock(*adding_solver_);
      if (!heat.solver) {
        auto solver = make_similar_solver(*poisson_.solver);
        heat.factorize_by(*solver);
        heat.solver = std::move(solver);
      }
    }
    const double unit = (scale_exponent(*heat.solver) + unit_) * std::log(2.0);  // to the scale of sweeps
    const rescaled_heat rescaled = solve_rescaled(heat, sources);
    for (std::size_t i = 0; i < load.size(); ++i) load[i] = rescaled.log(i) - unit;
    return load;
  }

  /// Heat at each vert, times 2^(2 e) for each round of continuation before the one that found it, where e is scale_exponent.
  struct rescaled_heat {
    std::vector<double> heat;  // 0 where it is not positive
    std::vector<int> round;    // -1 where no heat was found
    double per_round;          // logarithm of this factor

    double log_of(double x, int in_round) const { return x > 0 ? std::log(x) - in_round * per_round : none; }
    double log(std::size_t i) const { return log_of(heat[i], round[i]); }
  };

  rescaled_heat solve_rescaled(const factorised& heat, const std::vector<heat_source>& sources) const {
    const int n = static_cast<int>(heat.lower.cols());
    const auto size = static_cast<std::size_t>(n);
    const int up = scale_exponent(*heat.solver), rounds = up < 900 ? 70 * max_rounds : max_rounds;
    const double least = std::ldexp(1.0, -up);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n), u;
    std::vector<unsigned char> has_source(size);
    std::vector<int> unit(size, unit_);  // of each component; with iterative solvers its heat starts from near 2^e, whatever the masses of its verts
    for (const heat_source& s : sources) {
      const auto c = static_cast<std::size_t>(component(s.vert));
      if (core::is_iterative(*heat.solver) && (!has_source[c] || s.strength == 1)) unit[c] = std::ilogb(heat.lower.coeff(s.vert, s.vert));
      has_source[c] = 1;
    }
    rescaled_heat found{std::vector<double>(size), std::vector<int>(size, -1), 2 * up * std::log(2.0)};
    std::vector<int>& round_of = found.round;
    const auto add_sources = [&](int round) {  // those that are still unreached, because they are weaker than others
      bool any = false;
      for (const heat_source& s : sources) {
        if (round_of[static_cast<std::size_t>(s.vert)] >= 0) continue;
        b[s.vert] += std::ldexp(s.strength, up + unit[static_cast<std::size_t>(component(s.vert))] + 2 * up * round);
        any = true;
      }
      return any;
    };
    std::size_t left = 0;
    for (int i = 0; i < n; ++i) left += has_source[static_cast<std::size_t>(component(i))];
    for (int round = 0; left > 0 && round < rounds; ++round) {
      if (round > 0) continuation_rhs(heat.lower, u, round_of, round - 1, 2 * up, b);
      const bool waits = add_sources(round);
      u = heat.solver->solve(b);
      const std::size_t before = left;
      for (std::size_t i = 0; i < size; ++i) {
        const double x = u[static_cast<Eigen::Index>(i)];
        if (round_of[i] >= 0 || !(std::abs(x) > least) || !has_source[static_cast<std::size_t>(component_[i])]) continue;
        round_of[i] = round;
        const int scale = unit_ - unit[static_cast<std::size_t>(component_[i])];
        if (x > 0) found.heat[i] = scale == 0 ? x : std::ldexp(x, scale);
        --left;
      }
      if (left == before && !waits) break;
    }
    return found;
  }

  /// b = -K v where v is 0, and the corresponding correction where v is u, times 2^up. v is u at the verts settled in `round`, else 0.
  static void continuation_rhs(const Eigen::SparseMatrix<double>& heat, const Eigen::VectorXd& u, const std::vector<int>& round_of, int round, int up,
                          Eigen::VectorXd& b) {
    b.setZero();
    for (int c = 0; c < heat.cols(); ++c)
      for (int k = heat.outerIndexPtr()[c]; k < heat.outerIndexPtr()[c + 1]; ++k) {
        const int r = heat.innerIndexPtr()[k];
        const int of_r = round_of[static_cast<std::size_t>(r)], of_c = round_of[static_cast<std::size_t>(c)];
        int known = -1, beyond = -1;
        if (of_r == round && of_c < 0) {
          known = r;
          beyond = c;
        } else if (of_c == round && of_r < 0) {
          known = c;
          beyond = r;
        } else {
          continue;
        }
        b[beyond] -= std::ldexp(heat.valuePtr()[k] * u[known], up);
        b[known] += std::ldexp(heat.valuePtr()[k] * u[beyond], up);
      }
  }
};

}  // namespace concino::detail
