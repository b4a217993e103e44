// Interpolation of multigrid at rows whose positive entries cancel most of the negative ones, as on stretched polygons.
#pragma once

#include <concino/solve/detail/aggregates.hpp>
#include <concino/solve/detail/sparse_sums.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// Rows of a symmetric matrix with large positive entries off the diagonal. On stretched polygons the stabilisation of virtual elements makes them: it is as
/// large as the stiffness along the short direction and vanishes for linear functions only. So functions that are linear along the long direction have
/// little energy, as those of a bent beam, and steps between aggregates have much. The filtered matrix of aggregates does not show that. So these rows
/// are smoothed by several Jacobi steps with all their entries. Small weights are left out, since cycles would cost twice as much with them.
class cancelling_rows {
  static constexpr double share = 0.1;          // of the diagonal entry: the least sum of positive entries of such a row
  static constexpr double damping = 0.55;       // of a Jacobi step; 0.45 to 0.65 differ little
  static constexpr double small_weight = 0.05;  // of the largest weight of a row: what is left out
  static constexpr int steps = 3, max_per_row = 200;

  const Eigen::SparseMatrix<double>& a_;
  std::vector<int> begin_, column_;  // the entries of these rows before the diagonal; a_ has those after it
  std::vector<float> entry_;
  std::vector<char> contains_;

  template<class Visit>
  static void for_each_entry(const Eigen::SparseMatrix<double>& a, const Visit& visit) {
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr(), n = static_cast<int>(a.cols());
    for (int c = 0; c < n; ++c)
      for (int k = starts[c] + 1; k < starts[c + 1]; ++k) visit(static_cast<std::size_t>(c), static_cast<std::size_t>(rows[k]), a.valuePtr()[k]);
  }

  static std::vector<char> find(const Eigen::SparseMatrix<double>& a) {
    const auto n = static_cast<std::size_t>(a.cols());
    std::vector<double> positive(n);
    for_each_entry(a, [&](std::size_t i, std::size_t j, double e) {
      positive[i] += std::max(e, 0.0);
      positive[j] += std::max(e, 0.0);
    });
    std::vector<char> r(n);
    for (std::size_t i = 0; i < n; ++i) r[i] = positive[i] > share * a.valuePtr()[a.outerIndexPtr()[i]];
    return r;
  }

 public:
  /// Whether so many rows are of this kind that fewer iterations pay for the time. They do not in rows with few entries, as of quads, whose stabilisation
  /// does not see bent lines, and in rows with many, as of hexes, since coarse matrices would not be sparse.
  static bool pay_for(const Eigen::SparseMatrix<double>& a) {
    constexpr double fewest = 5.5, most = 10;  // entries of a column of the lower triangle, on average: 7 on Voronoi polygons, 5 on quads, 13 on hexes
    constexpr double least = 0.8;              // of all rows: 0.9 on polygons stretched 1 : 100, 0.5 on uniform ones
    const auto n = static_cast<double>(a.cols()), entries = static_cast<double>(a.nonZeros());
    if (entries < fewest * n || entries > most * n) return false;
    const std::vector<char> rows = find(a);
    return static_cast<double>(std::count(rows.begin(), rows.end(), 1)) > least * n;
  }

  /// a: the lower triangle, which must outlive this object; each column begins with its diagonal entry.
  explicit cancelling_rows(const Eigen::SparseMatrix<double>& a) : a_(a), begin_(static_cast<std::size_t>(a.cols()) + 2), contains_(find(a)) {
    std::vector<int> before(contains_.size());
    for_each_entry(a, [&](std::size_t, std::size_t j, double) { ++before[j]; });
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i] + a.outerIndexPtr()[i + 1] - a.outerIndexPtr()[i] > max_per_row) contains_[i] = 0;  // so that the coarse matrix stays sparse
      begin_[i + 2] = begin_[i + 1] + (contains_[i] ? before[i] : 0);
    }
    column_.resize(static_cast<std::size_t>(begin_.back()));
    entry_.resize(column_.size());
    for_each_entry(a, [&](std::size_t i, std::size_t j, double e) {
      if (!contains_[j]) return;
      const auto at = static_cast<std::size_t>(begin_[j + 1]++);
      column_[at] = static_cast<int>(i);
      entry_[at] = static_cast<float>(e);
    });
    begin_.pop_back();
  }

  bool contains(std::size_t i) const { return contains_[i] != 0; }

  /// p with these rows smoothed; there it has one coarse value before. Empty if p is, or if the result had more than `max_entries` entries.
  prolongation smooth(prolongation p, std::size_t max_entries) const {
    for (int step = 0; step < steps && p.columns > 0; ++step) p = smooth_once(p, max_entries);
    return p;
  }

 private:
  prolongation smooth_once(const prolongation& p, std::size_t max_entries) const {
    prolongation r;
    r.begin.reserve(p.begin.size());
    r.begin.push_back(0);
    sparse_sums sums(static_cast<std::size_t>(p.columns));
    std::vector<double> weights;
    const auto add = [&](std::size_t row, double factor) {
      sums.expect(p.begin[row + 1] - p.begin[row]);
      for (auto k = static_cast<std::size_t>(p.begin[row]); k < static_cast<std::size_t>(p.begin[row + 1]); ++k)
        sums.add(p.column[k], factor * static_cast<double>(p.weight[k]));
    };
    for (std::size_t i = 0; i < contains_.size(); ++i) {
      if (contains_[i]) {
        const int first = a_.outerIndexPtr()[i];
        const double factor = -damping / a_.valuePtr()[first];
        add(i, 1 - damping);
        for (auto k = static_cast<std::size_t>(begin_[i]); k < static_cast<std::size_t>(begin_[i + 1]); ++k)
          add(static_cast<std::size_t>(column_[k]), factor * static_cast<double>(entry_[k]));
        for (int k = first + 1; k < a_.outerIndexPtr()[i + 1]; ++k) add(static_cast<std::size_t>(a_.innerIndexPtr()[k]), factor * a_.valuePtr()[k]);
        keep_large(sums, r.column, weights);
        append_rounded(weights, r.weight);
        sums.clear();
      } else {
        r.column.insert(r.column.end(), p.column.begin() + p.begin[i], p.column.begin() + p.begin[i + 1]);
        r.weight.insert(r.weight.end(), p.weight.begin() + p.begin[i], p.weight.begin() + p.begin[i + 1]);
      }
      if (r.column.size() > max_entries) return {};
      r.begin.push_back(static_cast<int>(r.column.size()));
    }
    r.columns = p.columns;
    return r;
  }

  /// The large weights, scaled so that they have the sum of all.
  static void keep_large(const sparse_sums& sums, std::vector<int>& column, std::vector<double>& weights) {
    weights.clear();
    double largest = 0, all = 0, kept = 0;
    for (int k = 0; k < sums.size(); ++k) {
      largest = std::max(largest, std::abs(sums.sum(k)));
      all += sums.sum(k);
    }
    for (int k = 0; k < sums.size(); ++k) {
      if (!(std::abs(sums.sum(k)) > small_weight * largest)) continue;
      column.push_back(sums.index(k));
      weights.push_back(sums.sum(k));
      kept += sums.sum(k);
    }
    if (!(kept > 0 && all >= kept / 2 && all <= 2 * kept)) return;  // sums that are nearly 0 stay as they are
    for (double& w : weights) w *= all / kept;
  }
};

}  // namespace concino::detail
