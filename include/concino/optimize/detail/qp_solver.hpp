// The solution of a quadratic program by operator splitting, and its polishing.
#pragma once

#include <concino/optimize/detail/qp_splitting.hpp>
#include <concino/optimize/qp_result.hpp>

namespace concino::detail {

/// Solves one program: by one linear system if it has equations only, otherwise by operator splitting.
class qp_solver {
  const sparse_matrix& h_;
  const Eigen::VectorXd& g_;
  const sparse_matrix& a_;
  const Eigen::VectorXd &low_, &high_;
  const qp_options& options_;

  double feasible_residual(const Eigen::VectorXd& x) const {
    const Eigen::VectorXd ax = a_ * x;
    double most = 0;
    for (Eigen::Index i = 0; i < ax.size(); ++i) most = std::max({most, low_[i] - ax[i], ax[i] - high_[i]});
    return most;
  }
  double residual(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const {
    return std::max(largest(h_ * x + g_ + a_.transpose() * y), feasible_residual(x));
  }

  /// Solves the program with the active rows fixed at their bounds: a linear system, regularised and corrected until it
  /// is solved.
  bool solve_with_active(const std::vector<Eigen::Index>& active, const Eigen::VectorXd& bound, qp_result& r) const {
    const Eigen::Index n = g_.size(), k = static_cast<Eigen::Index>(active.size());
    std::vector<int> active_index(static_cast<std::size_t>(a_.rows()), -1);
    for (Eigen::Index i = 0; i < k; ++i)
      active_index[static_cast<std::size_t>(active[static_cast<std::size_t>(i)])] = static_cast<int>(i);
    std::vector<Eigen::Triplet<double>> t;
    for (int c = 0; c < a_.outerSize(); ++c)
      for (sparse_matrix::InnerIterator it(a_, c); it; ++it)
        if (const int i = active_index[static_cast<std::size_t>(it.row())]; i >= 0) t.emplace_back(i, c, it.value());
    sparse_matrix a(k, n);
    a.setFromTriplets(t.begin(), t.end());
    double size = 0;
    for (int c = 0; c < h_.outerSize(); ++c)
      for (sparse_matrix::InnerIterator it(h_, c); it; ++it) size = std::max(size, std::abs(it.value()));
    const double shift = 1e-8 * (size > 0 ? size : 1);
    quasidefinite system;
    system.factorize(h_, shift, a, Eigen::VectorXd::Constant(k, shift));
    Eigen::VectorXd x = r.x, y(k), best_x = x;
    for (Eigen::Index i = 0; i < k; ++i) y[i] = r.multipliers[active[static_cast<std::size_t>(i)]];
    Eigen::VectorXd best_y = y;
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 12; ++round) {
      Eigen::VectorXd b(n + k);
      b.head(n) = -(g_ + h_ * x + a.transpose() * y);
      b.tail(k) = bound - a * x;
      const double left = largest(b);
      if (!(left < best)) break;
      best = left;
      best_x = x;
      best_y = y;
      const Eigen::VectorXd step = system.solve(b);
      x += step.head(n);
      y += step.tail(k);
    }
    Eigen::VectorXd all = Eigen::VectorXd::Zero(a_.rows());
    for (Eigen::Index i = 0; i < k; ++i) {
      const Eigen::Index row = active[static_cast<std::size_t>(i)];
      if (low_[row] < high_[row] &&
          ((bound[i] == low_[row] && best_y[i] > 0) || (bound[i] == high_[row] && best_y[i] < 0))) {
        // the multiplier has the wrong sign for this bound
        if (std::abs(best_y[i]) > 1e-9 * (1 + largest(best_y))) return false;
        best_y[i] = 0;
      }
      all[row] = best_y[i];
    }
    const double reached = residual(best_x, all);
    if (!(reached <= r.residual)) return false;
    r.x = best_x;
    r.multipliers = all;
    r.residual = reached;
    return true;
  }

  bool polish(qp_result& r) const {
    std::vector<Eigen::Index> active;
    std::vector<double> at;
    const Eigen::VectorXd ax = a_ * r.x;
    for (Eigen::Index i = 0; i < a_.rows(); ++i) {
      const double y = r.multipliers[i];
      const bool lower = low_[i] == high_[i] || (y < 0 && ax[i] - low_[i] < -y),
                 upper = !lower && y > 0 && high_[i] - ax[i] < y;
      if (!lower && !upper) continue;
      active.push_back(i);
      at.push_back(lower ? low_[i] : high_[i]);
    }
    return solve_with_active(active, Eigen::Map<const Eigen::VectorXd>(at.data(), static_cast<Eigen::Index>(at.size())),
                             r);
  }

 public:
  qp_solver(const sparse_matrix& h, const Eigen::VectorXd& g, const sparse_matrix& a, const Eigen::VectorXd& low,
            const Eigen::VectorXd& high, const qp_options& options)
      : h_(h), g_(g), a_(a), low_(low), high_(high), options_(options) {}

  qp_result solve() const {
    qp_result r = first_guess();
    if (low_ == high_)
      if (qp_result direct = r; solve_equations(direct)) return direct;
    const scaled_qp p(h_, g_, a_, low_, high_);
    splitting_iterates iterates(p, r.x, r.multipliers);
    for (r.iterations = 1; r.iterations <= options_.max_iterations; ++r.iterations) {
      iterates.step();
      if (r.iterations % 25 != 0 && r.iterations != options_.max_iterations) continue;
      report_progress(options_.progress, static_cast<double>(r.iterations) / options_.max_iterations,
                      "quadratic program");
      r.x = iterates.x();
      r.multipliers = iterates.multipliers();
      const relative_residuals left = residuals_of(r, iterates.row_values());
      r.residual = residual(r.x, r.multipliers);
      if (!std::isfinite(r.residual))
        throw solver_error("quadratic program: the iterates are no longer finite; scale H, g and A");
      if (left.are_within(options_.tolerance)) {
        r.status = qp_status::solved;
        if (options_.polish) r.polished = polish(r);
        return r;
      }
      if (find_certificate(p, iterates, r)) return r;
      iterates.balance(left.primal_to_dual());
    }
    --r.iterations;
    if (options_.polish && polish(r) && r.residual <= options_.tolerance * scale_of(r)) {
      r.polished = true;
      r.status = qp_status::solved;
    }
    return r;
  }

 private:
  /// The errors of rows and gradient, and the largest of the terms whose differences they are.
  struct relative_residuals {
    double primal, primal_scale, dual, dual_scale;

    bool are_within(double tolerance) const {
      return primal <= tolerance * (1e-3 + primal_scale) && dual <= tolerance * (1e-3 + dual_scale);
    }
    double primal_to_dual() const {
      return std::sqrt((primal / std::max(primal_scale, 1e-10)) / std::max(dual / std::max(dual_scale, 1e-10), 1e-10));
    }
  };

  qp_result first_guess() const {
    qp_result r;
    r.x = options_.x.size() ? options_.x : Eigen::VectorXd::Zero(g_.size());
    r.multipliers = options_.multipliers.size() ? options_.multipliers : Eigen::VectorXd::Zero(low_.size());
    r.residual = std::numeric_limits<double>::infinity();
    return r;
  }

  /// Solves programs with equations only, or without rows: one linear system.   Result: whether it gave the minimum.
  bool solve_equations(qp_result& r) const {
    std::vector<Eigen::Index> all;
    for (Eigen::Index i = 0; i < low_.size(); ++i) all.push_back(i);
    if (!solve_with_active(all, low_, r) || !(r.residual <= 1e-9 * scale_of(r))) return false;
    r.status = qp_status::solved;
    return true;
  }

  relative_residuals residuals_of(const qp_result& r, const Eigen::VectorXd& row_values) const {
    const Eigen::VectorXd ax = a_ * r.x, hx = h_ * r.x, aty = a_.transpose() * r.multipliers;
    return {largest(ax - row_values), std::max(largest(ax), largest(row_values)), largest(hx + g_ + aty),
            std::max({largest(hx), largest(g_), largest(aty)})};
  }

  /// Whether the last step proves that there is no minimum; stores the certificate in r.
  static bool find_certificate(const scaled_qp& p, const splitting_iterates& iterates, qp_result& r) {
    const Eigen::VectorXd dy = iterates.multiplier_change(), dx = iterates.x_change();
    if (proves_infeasible(p, dy, 1e-6)) {
      r.status = qp_status::infeasible;
      r.certificate = dy.cwiseProduct(p.row) / largest(dy.cwiseProduct(p.row));
      return true;
    }
    if (proves_unbounded(p, dx, 1e-6)) {
      r.status = qp_status::unbounded;
      r.certificate = dx.cwiseProduct(p.column) / largest(dx.cwiseProduct(p.column));
      return true;
    }
    return false;
  }

  /// The scale of the terms whose differences are the residuals.
  double scale_of(const qp_result& r) const {
    return 1e-3 +
           std::max({largest(h_ * r.x), largest(g_), largest(a_.transpose() * r.multipliers), largest(a_ * r.x)});
  }
};

}  // namespace concino::detail
