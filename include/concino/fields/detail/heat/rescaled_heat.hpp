// Heat that flows from some verts to distances at which it underflows double precision, found in rounds.
#pragma once

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace concino::detail {

/// A vert at which heat starts.
struct heat_source {
  int vert;
  double strength;  // greater than 0
};

/// The logarithm of the sum of two numbers that are given by theirs.
inline double log_of_sum(double x, double y) {
  const double large = std::max(x, y), small = std::min(x, y);
  return small == -std::numeric_limits<double>::infinity() ? large : large + std::log1p(std::exp(small - large));
}

/// Heat at each vert, times 2^(2 scale_exponent) for each round of continuation before the one that found it.
struct rescaled_heat {
  /// An exponent e: heat starts from 2^e and is used down to 2^-e, which is a distance of about 1.4 e times the square
  /// root of the time.
  int scale_exponent;
  std::vector<double> heat;  // 0 where it is not positive
  std::vector<int> round;    // -1 where no heat was found

  double log_of(double x, int in_round) const {
    return x > 0 ? std::log(x) - in_round * (2 * scale_exponent * std::log(2.0))
                 : -std::numeric_limits<double>::infinity();
  }
  double log(std::size_t i) const { return log_of(heat[i], round[i]); }

  std::vector<double> logs() const {
    std::vector<double> r(heat.size());
    for (std::size_t i = 0; i < r.size(); ++i) r[i] = log(i);
    return r;
  }
  /// The logarithms of the sums of this heat and another of the same exponent.
  std::vector<double> logs_of_sum(const rescaled_heat& other) const {
    std::vector<double> r(heat.size());
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (round[i] == other.round[i]) r[i] = log_of(heat[i] + other.heat[i], round[i]);
      else r[i] = log_of_sum(log(i), other.log(i));
    }
    return r;
  }
};

/// b = -K v where v is 0, and the corresponding correction where v is u, times 2^up. v is u at the verts found in
/// `round`, else 0. lower: the lower triangle of K.
inline void continuation_rhs(const Eigen::SparseMatrix<double>& lower, const Eigen::VectorXd& u,
                             const std::vector<int>& round_of, int round, int up, Eigen::VectorXd& b) {
  b.setZero();
  for (int c = 0; c < lower.cols(); ++c)
    for (int k = lower.outerIndexPtr()[c]; k < lower.outerIndexPtr()[c + 1]; ++k) {
      const int r = lower.innerIndexPtr()[k];
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
      b[beyond] -= std::ldexp(lower.valuePtr()[k] * u[known], up);
      b[known] += std::ldexp(lower.valuePtr()[k] * u[beyond], up);
    }
}

/// Solves K u = b for the sources. solve(b): the solution for a right-hand side. is_heated: by vert, whether its
/// component has a source. 2^unit is about the mass of a vert. Where several processes solve together, each with a part
/// of the matrix and the sources, is_any(x) is whether x is true on one of them.
///
/// Where heat underflows double precision, it is continued from there. Let u be known down to a threshold, and v
/// equal to u there and 0 beyond. The rest, u - v, solves the same system with the right-hand side b - K v. This is
/// not 0 on both sides of the frontier only, and can be scaled by any factor.
template<class Solve, class IsAny>
rescaled_heat solve_rescaled(const Eigen::SparseMatrix<double>& lower, const std::vector<heat_source>& sources,
                             const std::vector<unsigned char>& is_heated, int unit, int scale_exponent,
                             const Solve& solve, const IsAny& is_any) {
  const int up = scale_exponent, max_rounds = 90'000 / up;
  const double least = std::ldexp(1.0, -up);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(lower.cols()), u;
  rescaled_heat found{up, std::vector<double>(is_heated.size()), std::vector<int>(is_heated.size(), -1)};
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
  for (const unsigned char heated : is_heated) left += heated != 0;
  for (int round = 0; is_any(left > 0) && round < max_rounds; ++round) {
    if (round > 0) continuation_rhs(lower, u, found.round, round - 1, 2 * up, b);
    const bool waits = add_sources(round);
    u = solve(b);
    const std::size_t before = left;
    for (std::size_t i = 0; i < is_heated.size(); ++i) {
      const double x = u[static_cast<Eigen::Index>(i)];
      if (found.round[i] >= 0 || !(std::abs(x) > least) || !is_heated[i]) continue;
      found.round[i] = round;
      if (x > 0) found.heat[i] = x;
      --left;
    }
    if (!is_any(left < before || waits)) break;
  }
  return found;
}

}  // namespace concino::detail
