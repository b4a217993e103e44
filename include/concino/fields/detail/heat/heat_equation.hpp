// The logarithm of the heat that flows from some verts, for one matrix: by a factor of the matrix, or by an iterative
// solver band by band.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/residual.hpp>
#include <concino/fields/detail/heat/heat_bands.hpp>
#include <concino/fields/detail/heat/rescaled_heat.hpp>
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

template<class Solver>
class heat_equation {
  static constexpr int scale_exponent = 900;  // of rescaled_heat
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
  rescaled_heat heat_from(const std::vector<heat_source>& sources, std::span<const int> component, int unit) const {
    std::vector<unsigned char> has_source(component.size()), is_heated(component.size());
    for (const heat_source& s : sources)
      has_source[static_cast<std::size_t>(component[static_cast<std::size_t>(s.vert)])] = 1;
    for (std::size_t i = 0; i < is_heated.size(); ++i)
      is_heated[i] = has_source[static_cast<std::size_t>(component[i])];
    return solve_rescaled(
        lower_, sources, is_heated, unit, scale_exponent, [&](const Eigen::VectorXd& b) { return solver_->solve(b); },
        [](bool x) { return x; });
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
};

}  // namespace concino::detail
