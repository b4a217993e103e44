// The logarithm of the heat that flows from some verts, for one matrix: by a factor of the matrix, or by an iterative
// solver band by band.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/residual.hpp>
#include <concino/fields/detail/heat/heat_bands.hpp>
#include <concino/fields/detail/problems/make_similar_solver.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// A vert at which heat starts.
struct heat_source {
  int vert;
  double strength;  // greater than 0
};

/// Heat at each vert, times 2^(2 scale_exponent) for each round of continuation before the one that found it.
struct rescaled_heat {
  /// An exponent e: heat starts from 2^e and is used down to 2^-e, which is a distance of about 1.4 e times the square
  /// root of the time.
  static constexpr int scale_exponent = 900;

  std::vector<double> heat;  // 0 where it is not positive
  std::vector<int> round;    // -1 where no heat was found

  static double log_of(double x, int in_round) {
    return x > 0 ? std::log(x) - in_round * (2 * scale_exponent * std::log(2.0))
                 : -std::numeric_limits<double>::infinity();
  }
  double log(std::size_t i) const { return log_of(heat[i], round[i]); }
};

template<class Solver>
class heat_equation {
  static constexpr int max_rounds = 100;  // of continuing underflowed heat
  static constexpr double band_tolerance = 2e-3;  // distances then differ from those by a factor by about 1e-4 of the
                                                  // largest

  Eigen::SparseMatrix<double> lower_;       // triangle
  mutable std::unique_ptr<Solver> solver_;  // none if solvers are iterative, until a band with all heated verts needs
                                            // one
  std::unique_ptr<std::mutex> adding_solver_ = std::make_unique<std::mutex>();  // locked by the query that adds it

 public:
  /// lower: the lower triangle of the masses minus the time times a Laplacian, with every diagonal entry present.
  explicit heat_equation(Eigen::SparseMatrix<double>&& lower) : lower_(std::move(lower)) {
    for (int i = 0; i < lower_.cols(); ++i)
      if (double& x = lower_.coeffRef(i, i); !(x > 0)) x = 1;  // a vert of no poly
    assert(lower_.isCompressed());
  }

  /// By a solver like `like`. same_pattern: has factorised a matrix with the same pattern.
  void factorize(const Solver& like, const Solver& same_pattern) {
    solver_ = make_similar_solver(like);
    if constexpr (requires(Solver& s) { s.use_order_of(s); }) solver_->use_order_of(same_pattern);
    core::factorize_over_verts(*solver_, lower_, "heat_geodesics", [](Eigen::Index row) { return row; });
  }

  /// By the factorised solver. component: of each vert, the number of one vert of it. 2^unit is about the mass of a
  /// vert.
  ///
  /// Where heat underflows double precision, it is continued from there. Let u be known down to a threshold, and v
  /// equal to u there and 0 beyond. The rest, u - v, solves the same system with the right-hand side b - K v. This is
  /// not 0 on both sides of the frontier only, and can be scaled by any factor.
  rescaled_heat solve_rescaled(const std::vector<heat_source>& sources, std::span<const int> component,
                               int unit) const {
    const std::size_t size = component.size();
    constexpr int up = rescaled_heat::scale_exponent;
    const double least = std::ldexp(1.0, -up);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(lower_.cols()), u;
    std::vector<unsigned char> has_source(size);
    for (const heat_source& s : sources)
      has_source[static_cast<std::size_t>(component[static_cast<std::size_t>(s.vert)])] = 1;
    const auto is_heated = [&](std::size_t i) { return has_source[static_cast<std::size_t>(component[i])] != 0; };
    rescaled_heat found{std::vector<double>(size), std::vector<int>(size, -1)};
    const auto add_sources = [&](int round) {  // those that are still unreached, because they are weaker than others
      bool any = false;
      for (const heat_source& s : sources) {
        if (found.round[static_cast<std::size_t>(s.vert)] >= 0) continue;
        b[s.vert] += std::ldexp(s.strength, up + unit + 2 * up * round);
        any = true;
      }
      return any;
    };
    std::size_t left = 0;
    for (std::size_t i = 0; i < size; ++i) left += is_heated(i);
    for (int round = 0; left > 0 && round < max_rounds; ++round) {
      if (round > 0) continuation_rhs(u, found.round, round - 1, 2 * up, b);
      const bool waits = add_sources(round);
      u = solver_->solve(b);
      const std::size_t before = left;
      for (std::size_t i = 0; i < size; ++i) {
        const double x = u[static_cast<Eigen::Index>(i)];
        if (found.round[i] >= 0 || !(std::abs(x) > least) || !is_heated(i)) continue;
        found.round[i] = round;
        if (x > 0) found.heat[i] = x;
        --left;
      }
      if (left == before && !waits) break;
    }
    return found;
  }

  /// The logarithm of heat, by iterations; see heat_bands. like: a solver of the type that bands with many small polys
  /// need. log_guess: about what is returned, up to a constant in each component. order:
  /// heat_bands::order_by_guess(log_guess).
  std::vector<double> solve_in_bands(const Solver& like, const std::vector<heat_source>& sources,
                                     std::span<const int> component, std::span<const double> log_guess,
                                     std::span<const int> order) const {
    const auto component_of = [&](std::size_t vert) { return static_cast<std::size_t>(component[vert]); };
    std::vector<double> load(component.size());
    std::vector<int> unit(component.size());  // of each component: heat starts from about 1, whatever the masses of its
                                              // verts
    std::vector<unsigned char> has_source(component.size());
    for (const heat_source& s : sources)
      if (const std::size_t c = component_of(static_cast<std::size_t>(s.vert)); !has_source[c] || s.strength == 1) {
        unit[c] = std::ilogb(lower_.coeff(s.vert, s.vert));
        has_source[c] = 1;
      }
    for (const heat_source& s : sources) {
      const auto v = static_cast<std::size_t>(s.vert);
      load[v] += std::ldexp(s.strength, unit[component_of(v)]);
    }
    heat_bands bands(lower_, load, log_guess, order);
    bands.run(band_tolerance, [&](std::span<const int> verts, const auto& lower, const auto& b, auto& x) {
      return solve_band(like, log_guess, verts, lower, b, x);
    });
    std::vector<double> log_u = bands.log_heat();
    for (std::size_t i = 0; i < log_u.size(); ++i) log_u[i] -= unit[component_of(i)] * std::log(2.0);
    return log_u;
  }

 private:
  /// Where the band has all verts with a guess, as after a long time, queries share one solver of the whole matrix.
  bool solve_band(const Solver& like, std::span<const double> log_guess, std::span<const int> verts,
                  const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& b, Eigen::VectorXd& x) const {
    const auto num_known = std::count_if(log_guess.begin(), log_guess.end(),
                                         [](double g) { return g > -std::numeric_limits<double>::infinity(); });
    try {
      if (verts.size() < static_cast<std::size_t>(num_known)) {
        const auto own = make_similar_solver(like);
        core::factorize_symmetric(*own, lower);
        x = own->solve(b);
        return true;
      }
      {
        const std::lock_guard<std::mutex> lock(*adding_solver_);
        if (!solver_) {
          auto own = make_similar_solver(like);
          core::factorize_symmetric(*own, lower_);
          solver_ = std::move(own);
        }
      }
      Eigen::VectorXd all = Eigen::VectorXd::Zero(lower_.cols());
      for (std::size_t i = 0; i < verts.size(); ++i) all[verts[i]] = b[static_cast<Eigen::Index>(i)];
      all = solver_->solve(all).eval();
      for (std::size_t i = 0; i < verts.size(); ++i) x[static_cast<Eigen::Index>(i)] = all[verts[i]];
      return true;
    } catch (const solver_error&) {
      return false;  // iterations in the band continue
    }
  }

  /// b = -K v where v is 0, and the corresponding correction where v is u, times 2^up. v is u at the verts settled in
  /// `round`, else 0.
  void continuation_rhs(const Eigen::VectorXd& u, const std::vector<int>& round_of, int round, int up,
                        Eigen::VectorXd& b) const {
    b.setZero();
    for (int c = 0; c < lower_.cols(); ++c)
      for (int k = lower_.outerIndexPtr()[c]; k < lower_.outerIndexPtr()[c + 1]; ++k) {
        const int r = lower_.innerIndexPtr()[k];
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
        b[beyond] -= std::ldexp(lower_.valuePtr()[k] * u[known], up);
        b[known] += std::ldexp(lower_.valuePtr()[k] * u[beyond], up);
      }
  }
};

}  // namespace concino::detail
