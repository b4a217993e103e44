// How a quadratic program is solved, step by step, and polished.
#pragma once

#include <concino/optimize/detail/qp_splitting.hpp>
#include <concino/optimize/qp_result.hpp>

namespace concino::detail {

/// One program: by the equations alone where there is nothing else, otherwise by operator splitting.
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

  /// The program with those rows held at their bounds: a linear system, regularised and corrected until it is solved.
  bool solve_with_active(const std::vector<Eigen::Index>& active, const Eigen::VectorXd& bound, qp_result& r) const {
    const Eigen::Index n = g_.size(), k = static_cast<Eigen::Index>(active.size());
    std::vector<int> place(static_cast<std::size_t>(a_.rows()), -1);
    for (Eigen::Index i = 0; i < k; ++i) place[static_cast<std::size_t>(active[static_cast<std::size_t>(i)])] = static_cast<int>(i);
    std::vector<Eigen::Triplet<double>> t;
    for (int c = 0; c < a_.outerSize(); ++c)
      for (sparse_matrix::InnerIterator it(a_, c); it; ++it)
        if (const int i = place[static_cast<std::size_t>(it.row())]; i >= 0) t.emplace_back(i, c, it.value());
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
      if (low_[row] < high_[row] && ((bound[i] == low_[row] && best_y[i] > 0) || (bound[i] == high_[row] && best_y[i] < 0))) {
        if (std::abs(best_y[i]) > 1e-9 * (1 + largest(best_y))) return false;  // this bound pushes the wrong way
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
      const bool lower = low_[i] == high_[i] || (y < 0 && ax[i] - low_[i] < -y), upper = !lower && y > 0 && high_[i] - ax[i] < y;
      if (!lower && !upper) continue;
      active.push_back(i);
      at.push_back(lower ? low_[i] : high_[i]);
    }
    return solve_with_active(active, Eigen::Map<const Eigen::VectorXd>(at.data(), static_cast<Eigen::Index>(at.size())), r);
  }

 public:
  qp_solver(const sparse_matrix& h, const Eigen::VectorXd& g, const sparse_matrix& a, const Eigen::VectorXd& low, const Eigen::VectorXd& high,
            const qp_options& options)
      : h_(h), g_(g), a_(a), low_(low), high_(high), options_(options) {}

  qp_result solve() const {
    const Eigen::Index n = g_.size(), m = low_.size();
    qp_result r;
    r.x = options_.x.size() ? options_.x : Eigen::VectorXd::Zero(n);
    r.multipliers = options_.multipliers.size() ? options_.multipliers : Eigen::VectorXd::Zero(m);
    r.residual = std::numeric_limits<double>::infinity();
    if (low_ == high_) {  // equations only, or nothing: one linear system
      std::vector<Eigen::Index> all;
      for (Eigen::Index i = 0; i < m; ++i) all.push_back(i);
      qp_result direct = r;
      if (solve_with_active(all, low_, direct) && direct.residual <= 1e-9 * scale_of(direct)) {
        direct.status = qp_status::solved;
        return direct;
      }
    }

    const scaled_qp p(h_, g_, a_, low_, high_);
    const double shift = 1e-6, relaxation = 1.6;
    double rho = 0.1;
    Eigen::VectorXd weight(m);
    const auto set_weights = [&] {
      for (Eigen::Index i = 0; i < m; ++i)
        weight[i] = p.low[i] == p.high[i] ? 1e3 * rho : std::isinf(p.low[i]) && std::isinf(p.high[i]) ? 1e-6 : rho;
    };
    quasidefinite system;
    const auto factorize = [&] {
      set_weights();
      system.factorize(p.h, shift, p.a, weight.cwiseInverse());
    };
    factorize();
    Eigen::VectorXd x = r.x.cwiseQuotient(p.column), y = p.objective * r.multipliers.cwiseQuotient(p.row), z = p.a * x;
    for (Eigen::Index i = 0; i < m; ++i) z[i] = std::clamp(z[i], p.low[i], p.high[i]);
    const auto unscale = [&] {
      r.x = x.cwiseProduct(p.column);
      r.multipliers = y.cwiseProduct(p.row) / p.objective;
    };
    Eigen::VectorXd b(n + m);
    for (r.iterations = 1; r.iterations <= options_.max_iterations; ++r.iterations) {
      const Eigen::VectorXd x_before = x, y_before = y;
      b.head(n) = shift * x - p.g;
      b.tail(m) = z - y.cwiseQuotient(weight);
      const Eigen::VectorXd s = system.solve(b);
      x = relaxation * s.head(n) + (1 - relaxation) * x;
      for (Eigen::Index i = 0; i < m; ++i) {
        const double z_tilde = relaxation * (z[i] + (s[n + i] - y[i]) / weight[i]) + (1 - relaxation) * z[i];
        const double next = std::clamp(z_tilde + y[i] / weight[i], p.low[i], p.high[i]);
        y[i] += weight[i] * (z_tilde - next);
        z[i] = next;
      }
      if (r.iterations % 25 != 0 && r.iterations != options_.max_iterations) continue;
      tell(options_.progress, static_cast<double>(r.iterations) / options_.max_iterations, "quadratic program");
      unscale();
      const Eigen::VectorXd z_true = z.cwiseQuotient(p.row), ax = a_ * r.x, hx = h_ * r.x, aty = a_.transpose() * r.multipliers;
      const double primal = largest(ax - z_true), dual = largest(hx + g_ + aty);
      const double primal_scale = std::max(largest(ax), largest(z_true)), dual_scale = std::max({largest(hx), largest(g_), largest(aty)});
      r.residual = residual(r.x, r.multipliers);
      if (!std::isfinite(r.residual)) throw solver_error("quadratic program: the iteration left the finite numbers; scale the program");
      if (primal <= options_.tolerance * (1e-3 + primal_scale) && dual <= options_.tolerance * (1e-3 + dual_scale)) {
        r.status = qp_status::solved;
        if (options_.polish) r.polished = polish(r);
        return r;
      }
      const Eigen::VectorXd dy = y - y_before, dx = x - x_before;
      if (proves_infeasible(p, dy, 1e-6)) {
        r.status = qp_status::infeasible;
        r.certificate = dy.cwiseProduct(p.row) / largest(dy.cwiseProduct(p.row));
        return r;
      }
      if (proves_unbounded(p, dx, 1e-6)) {
        r.status = qp_status::unbounded;
        r.certificate = dx.cwiseProduct(p.column) / largest(dx.cwiseProduct(p.column));
        return r;
      }
      const double ratio = std::sqrt((primal / std::max(primal_scale, 1e-10)) / std::max(dual / std::max(dual_scale, 1e-10), 1e-10));
      if (ratio > 5 || ratio < 0.2) {  // one residual lags behind the other
        const double better = std::clamp(rho * ratio, 1e-6, 1e6);
        if (better != rho) {
          rho = better;
          factorize();
        }
      }
    }
    --r.iterations;
    if (options_.polish && polish(r) && r.residual <= options_.tolerance * scale_of(r)) {
      r.polished = true;
      r.status = qp_status::solved;
    }
    return r;
  }

 private:
  /// The terms that residuals are differences of.
  double scale_of(const qp_result& r) const {
    return 1e-3 + std::max({largest(h_ * r.x), largest(g_), largest(a_.transpose() * r.multipliers), largest(a_ * r.x)});
  }
};

}  // namespace concino::detail
