// The choice between a factorisation and multigrid; see auto_solver.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/detail/iterative/iterative_system.hpp>
#include <concino/solve/detail/multigrid/multigrid_levels.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <mutex>

namespace concino {

struct auto_solver::state {
  std::mutex mutex;
  solver_used used = solver_used::none;
  ldlt direct;
  detail::iterative_system system;
  detail::multigrid_levels levels;
  detail::iteration_report report;
  bool fits = true;           // the factor has few enough entries, as far as is known
  bool needs_factor = false;  // multigrid has missed its tolerance

  explicit state(const auto_solver_options& options) : options_(options) {}

  void factorize(const Eigen::SparseMatrix<double>& a);
  bool iterate(const Eigen::VectorXd& b, Eigen::VectorXd& x);

 private:
  const auto_solver_options& options_;
  Eigen::Index size_ = 0;

  bool is_small(Eigen::Index lower_entries) const;
  bool factorize_directly(const Eigen::SparseMatrix<double>& a);
  bool replace_multigrid();
};

/// lower_entries: of the lower triangle, the diagonal included.
CONCINO_INLINE bool auto_solver::state::is_small(Eigen::Index lower_entries) const {
  constexpr Eigen::Index long_row = 13;  // entries: polygons that meet in threes have at most as many on average, tets
                                         // more
  const bool has_long_rows = 2 * lower_entries - size_ > long_row * size_, are_many = options_.questions >= 10;
  if (has_long_rows) return size_ < (are_many ? 5'000 : 1'000);
  return size_ < (are_many ? 200'000 : 10'000);
}

/// Factorises if the factor is small enough.
CONCINO_INLINE bool auto_solver::state::factorize_directly(const Eigen::SparseMatrix<double>& a) {
  fits = fits && direct.factorize_within(a, options_.max_factor_entries);
  if (!fits) return false;
  used = solver_used::ldlt;
  levels = {};
  report = {};
  return true;
}

CONCINO_INLINE void auto_solver::state::factorize(const Eigen::SparseMatrix<double>& a) {
  used = solver_used::none;
  report = {};
  size_ = a.cols();
  Eigen::Index entries = 0;
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i) entries += i.row() >= c;
  if (!system.has_pattern_of(a)) {
    fits = entries - size_ <= options_.max_factor_entries;
    needs_factor = false;
  }
  if ((needs_factor || is_small(entries)) && factorize_directly(a)) return;
  Eigen::SparseMatrix<double> prepared;
  try {
    system.prepare("multigrid", a).swap(prepared);
  } catch (const core::singular_row&) {
    if (factorize_directly(a)) return;
    throw;
  }
  levels.build(prepared);
  if (levels.has_kernel() && factorize_directly(a)) return;
  system.accept(a.cols());
  used = solver_used::multigrid;
}

/// Factorises the matrix of multigrid, which has missed its tolerance.
CONCINO_INLINE bool auto_solver::state::replace_multigrid() {
  if (!fits) return false;
  return needs_factor = factorize_directly(system.restore(levels.finest()));
}

/// Solves by multigrid, or returns false if there is a factor now.
CONCINO_INLINE bool auto_solver::state::iterate(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  constexpr int patience = 40;  // iterations, where a factor may be computed
  const multigrid_options& given = options_.iteration;
  const auto most =
      static_cast<int>(given.max_iterations > 0 ? given.max_iterations
                                                : std::min<Eigen::Index>(std::numeric_limits<int>::max(), 2 * size_));
  core::check_right_hand_side("multigrid", b, size_);
  detail::multigrid_levels::workspace work = levels.make_workspace();
  for (;;) {
    const int limit = fits ? std::min(patience, most) : most;
    try {
      system
          .solve("multigrid", levels.finest(), b, {given.tolerance, limit, true}, 100, report,
                 [&](const Eigen::VectorXd& r, Eigen::VectorXd& z, Eigen::VectorXd& y) {
                   return levels.apply(r.data(), z.data(), y.data(), work);
                 })
          .swap(x);
    } catch (const solver_error&) {  // the solution is not finite
      if (!replace_multigrid()) throw;
      return false;
    }
    if (report.has_converged || (given.accept_missed_tolerance && limit == most)) return true;
    if (replace_multigrid()) return false;
    if (limit == most) detail::iterative_system::throw_missed("multigrid", report, given.tolerance);
  }
}

CONCINO_INLINE auto_solver::auto_solver() : auto_solver(auto_solver_options()) {}
CONCINO_INLINE auto_solver::auto_solver(const auto_solver_options& options)
    : options_(options), state_(new state(options_)) {
  detail::iterative_system::check_options("auto_solver", options.iteration.tolerance, options.iteration.max_iterations);
  if (options.max_factor_entries < 0) throw invalid_argument("auto_solver: max_factor_entries is negative");
  if (options.questions < 1) throw invalid_argument("auto_solver: questions must be 1 or more");
}
CONCINO_INLINE auto_solver::~auto_solver() = default;

CONCINO_INLINE void auto_solver::factorize(const Eigen::SparseMatrix<double>& a) { state_->factorize(a); }

CONCINO_INLINE void auto_solver::use_order_of(const auto_solver& other) {
  state_->used = solver_used::none;
  state_->direct.use_order_of(other.state_->direct);
}

CONCINO_INLINE Eigen::VectorXd auto_solver::solve(const Eigen::VectorXd& b) const {
  {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    if (state_->used == solver_used::none)
      throw solver_error("auto_solver: solve without a factorised matrix; call factorize first");
    Eigen::VectorXd x;
    if (state_->used == solver_used::multigrid && state_->iterate(b, x)) return x;
  }
  return state_->direct.solve(b);  // several threads may, since it changes nothing
}

CONCINO_INLINE solver_used auto_solver::used() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->used;
}

CONCINO_INLINE bool auto_solver::has_replaced_multigrid() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->used == solver_used::ldlt && state_->needs_factor;
}

CONCINO_INLINE int auto_solver::iterations() const { return static_cast<int>(state_->report.iterations); }
CONCINO_INLINE double auto_solver::error() const { return state_->report.error; }
CONCINO_INLINE double auto_solver::residual() const { return state_->report.residual; }
CONCINO_INLINE bool auto_solver::has_converged() const { return state_->report.has_converged; }

}  // namespace concino
