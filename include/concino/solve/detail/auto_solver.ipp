// The choice between a factorisation and multigrid; see auto_solver.hpp.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/solve/auto_solver.hpp>
#include <concino/solve/detail/iterative_system.hpp>
#include <concino/solve/detail/multigrid_levels.hpp>
#include <concino/solve/detail/solver_times.hpp>
#include <concino/solve/ldlt.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <new>

namespace concino {

struct auto_solver::state {
  std::mutex mutex;
  solver_used used = solver_used::none;
  ldlt direct;
  detail::iterative_system system;
  detail::multigrid_levels levels;
  detail::iteration_report report;
  detail::solver_times times;
  factor_size size;                // of the factor, if counted
  bool is_counted = false;
  bool fits = true;                // the factor has few enough entries, as far as is known
  bool needs_factor = false;       // multigrid has missed its tolerance
  bool may_switch = true;          // to the factor, when that pays
  std::int64_t num_solves = 0;     // by multigrid
  double spent = 0, per_iteration = 0;  // seconds by multigrid, by the model

  explicit state(const auto_solver_options& options) : options_(options) {}

  void factorize(const Eigen::SparseMatrix<double>& a);
  bool iterate(const Eigen::VectorXd& b, Eigen::VectorXd& x);
  predicted_times predicted_iteration() const { return {times.levels(), expected_iterations() * per_iteration}; }

 private:
  const auto_solver_options& options_;

  double expected_iterations() const { return times.num_iterations(options_.iteration.tolerance); }

  bool costs_less(const factor_size& f) const;
  bool has_narrow_band(const Eigen::SparseMatrix<double>& a) const;

  /// Factorises if the factor is small enough and accepts(size).
  bool factorize_if(const Eigen::SparseMatrix<double>& a, function_ref<bool(const factor_size&)> accepts);
  bool is_due(const factor_size& f) const { return times.levels() + spent - static_cast<double>(num_solves) * times.substitution(f) >= times.factorization(f); }
  bool switch_if_due();
  bool replace_after_miss(bool was_stopped);
};

/// Whether ldlt solves for all expected right-hand sides in less time. If their number is unknown, ldlt may cost twice as much: it is cheap for others.
CONCINO_INLINE bool auto_solver::state::costs_less(const factor_size& f) const {
  const bool is_known = options_.questions > 0;
  const double questions = is_known ? static_cast<double>(options_.questions) : 1;
  return times.factorization(f) + questions * times.substitution(f) <=
         (is_known ? 1 : 2) * (times.levels() + questions * expected_iterations() * per_iteration);
}

CONCINO_INLINE bool auto_solver::state::factorize_if(const Eigen::SparseMatrix<double>& a, function_ref<bool(const factor_size&)> accepts) {
  bool is_counted_now = false;
  const bool done = direct.factorize_within(a, options_.max_factor_entries, [&](const factor_size& f) {
    size = f;
    is_counted = is_counted_now = true;
    return !accepts || accepts(f);
  });
  fits = done || is_counted_now;
  if (!done) return false;
  used = solver_used::ldlt;
  levels = {};
  report = {};
  return true;
}

/// a: a prepared matrix, whose rows are numbered breadth first. Eliminating them in this order costs at most as much as the result is compared with.
CONCINO_INLINE bool auto_solver::state::has_narrow_band(const Eigen::SparseMatrix<double>& a) const {
  factor_size band;
  int last = 0;
  for (int c = 0; c < a.cols(); ++c) {
    last = std::max(last, a.innerIndexPtr()[a.outerIndexPtr()[c + 1] - 1]);
    const double width = last - c;
    band.entries += width;
    band.multiplications += width * width;
  }
  return times.factorization(band) + times.substitution(band) <= times.levels() + expected_iterations() * per_iteration;
}

CONCINO_INLINE void auto_solver::state::factorize(const Eigen::SparseMatrix<double>& a) {
  constexpr double small = 100'000;  // entries; ordering such a matrix costs little
  used = solver_used::none;
  report = {};
  num_solves = 0;
  spent = 0;
  is_counted = false;
  may_switch = true;
  times = {static_cast<double>(a.cols()), 0};
  for (int c = 0; c < a.outerSize(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i) times.entries += i.row() >= c;
  if (!system.has_pattern_of(a)) {
    fits = times.entries - times.unknowns <= static_cast<double>(options_.max_factor_entries);
    needs_factor = false;
  }
  per_iteration = times.iteration();
  const double questions = static_cast<double>(std::max<std::int64_t>(options_.questions, 1));
  const bool is_small = times.entries < small, is_near_tree = times.entries < 2.25 * times.unknowns,
             is_asked_often = questions * expected_iterations() * per_iteration > times.ordering();
  const auto accepts = [&](const factor_size& f) { return needs_factor || costs_less(f); };
  const bool counts_first = fits && (is_small || is_near_tree || (questions > 1 && is_asked_often) || needs_factor || direct.has_order_of(a));
  if (counts_first && factorize_if(a, accepts)) return;
  Eigen::SparseMatrix<double> prepared;
  try {
    system.prepare("multigrid", a).swap(prepared);
  } catch (const core::singular_row&) {
    if (fits && factorize_if(a, nullptr)) return;
    throw;
  }
  if (!counts_first && fits && has_narrow_band(prepared) && factorize_if(a, accepts)) return;
  levels.build(prepared);
  if (levels.has_kernel() && fits && factorize_if(a, nullptr)) return;
  per_iteration = times.iteration(levels.entries_per_cycle());
  system.accept(a.cols());
  used = solver_used::multigrid;
}

/// Computes the factor when multigrid has cost as much. It is counted when multigrid has cost twice as much as that takes.
CONCINO_INLINE bool auto_solver::state::switch_if_due() {
  if (options_.questions > 0 || !fits || !may_switch || !(is_counted ? is_due(size) : spent >= 2 * times.ordering())) return false;
  try {
    return factorize_if(system.restore(levels.finest()), [&](const factor_size& f) { return is_due(f); });
  } catch (const solver_error&) {
    may_switch = false;
  } catch (const std::bad_alloc&) {
    may_switch = false;
  }
  return false;
}

/// was_stopped: the iteration could go on. Then the factor is computed only if it costs little more than the iteration so far.
CONCINO_INLINE bool auto_solver::state::replace_after_miss(bool was_stopped) {
  if (!fits) return false;
  const double so_far = static_cast<double>(report.iterations) * per_iteration;
  needs_factor = factorize_if(system.restore(levels.finest()), [&](const factor_size& f) { return !was_stopped || times.factorization(f) <= 2 * so_far; });
  return needs_factor;
}

/// Solves by multigrid, or returns false if there is a factor now.
CONCINO_INLINE bool auto_solver::state::iterate(const Eigen::VectorXd& b, Eigen::VectorXd& x) {
  core::check_right_hand_side("multigrid", b, static_cast<Eigen::Index>(times.unknowns));
  if (switch_if_due()) return false;
  const multigrid_options& given = options_.iteration;
  const double unlimited = std::numeric_limits<int>::max(), most = given.max_iterations > 0 ? given.max_iterations : std::min(unlimited, 2 * times.unknowns);
  double limit = fits ? std::max(60.0, (is_counted ? times.factorization(size) : 2 * times.ordering()) / per_iteration) : unlimited;
  detail::multigrid_levels::workspace work = levels.make_workspace();
  ++num_solves;
  for (;;) {
    const bool is_limited = limit < most;
    try {
      system.solve("multigrid", levels.finest(), b, {given.tolerance, static_cast<int>(std::min(limit, most)), true}, 100, report,
                   [&](const Eigen::VectorXd& r, Eigen::VectorXd& z, Eigen::VectorXd& y) { return levels.apply(r.data(), z.data(), y.data(), work); }).swap(x);
    } catch (const solver_error&) {  // the solution is not finite
      if (!replace_after_miss(false)) throw;
      return false;
    }
    spent += static_cast<double>(report.iterations) * per_iteration;
    const bool was_stopped = is_limited && static_cast<double>(report.iterations) + 1 > limit;
    if (report.has_converged || (given.accept_missed_tolerance && !was_stopped)) return true;
    if (replace_after_miss(was_stopped)) return false;
    if (!was_stopped) detail::iterative_system::throw_missed("multigrid", report, given.tolerance);
    limit = fits ? times.factorization(size) / per_iteration : unlimited;
  }
}

CONCINO_INLINE auto_solver::auto_solver() : auto_solver(auto_solver_options()) {}
CONCINO_INLINE auto_solver::auto_solver(const auto_solver_options& options) : options_(options), state_(new state(options_)) {
  detail::iterative_system::check_options("auto_solver", options.iteration.tolerance, options.iteration.max_iterations);
  if (options.max_factor_entries < 0) throw invalid_argument("auto_solver: max_factor_entries is negative");
  if (options.questions < 0) throw invalid_argument("auto_solver: questions is negative");
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
    if (state_->used == solver_used::none) throw solver_error("auto_solver: solve without a factorised matrix; call factorize first");
    Eigen::VectorXd x;
    if (state_->used == solver_used::multigrid && state_->iterate(b, x)) return x;
  }
  return state_->direct.solve(b);  // several threads may, since it changes nothing
}

CONCINO_INLINE solver_used auto_solver::used() const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  return state_->used;
}

CONCINO_INLINE predicted_times auto_solver::predicted(solver_used method) const {
  const std::lock_guard<std::mutex> lock(state_->mutex);
  const detail::solver_times& t = state_->times;
  if (method == solver_used::none) return {};
  if (method == solver_used::multigrid) return state_->predicted_iteration();
  if (state_->is_counted) return {t.ordering() + t.factorization(state_->size), t.substitution(state_->size)};
  const double unknown = state_->fits ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
  return {unknown, unknown};
}

CONCINO_INLINE int auto_solver::iterations() const { return static_cast<int>(state_->report.iterations); }
CONCINO_INLINE double auto_solver::error() const { return state_->report.error; }
CONCINO_INLINE double auto_solver::residual() const { return state_->report.residual; }
CONCINO_INLINE bool auto_solver::has_converged() const { return state_->report.has_converged; }

}  // namespace concino
