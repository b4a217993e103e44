// Aggregation: groups the unknowns of a symmetric matrix, so that each group becomes one unknown of a coarser matrix.
#pragma once

#include <concino/solve/detail/multigrid/prolongation.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace concino::detail {

/// Rows i and j are strongly connected if a_ij is negative and -a_ij is at least 0.6 min(m_i, m_j), where m_i is the
/// largest -a_ij of row i. An aggregate is a row and those strongly connected to it. Rows that are dominated by their
/// diagonal entry belong to none, since Gauss-Seidel solves them. The filtered matrix has the strong entries only; all
/// others are added to its diagonal.
/// Source: Vanek, Mandel, Brezina 1996, "Algebraic multigrid by smoothed aggregation for second and fourth order
///         elliptic problems".
class aggregates {
  static constexpr double strong = 0.6;         // see above; 0.6 to 0.75 differ little, 0.4 takes ten times as many
                                                // iterations on flat hexes
  static constexpr double dominance = 2;        // a diagonal entry this many times the sum of the others' sizes
                                                // dominates its row
  static constexpr double damping = 2.0 / 3;    // of the Jacobi step that smooths the interpolation
  static constexpr int max_per_row = 200;

  std::size_t n_;
  std::vector<int> begin_, neighbour_;
  std::vector<float> strength_;  // -a of strong entries, divided by the diagonal entry of the filtered matrix
  std::vector<int> of_;           // the aggregate of each row; -1: none
  int num_ = 0;

 public:
  /// a: the lower triangle; each column begins with its diagonal entry.
  explicit aggregates(const Eigen::SparseMatrix<double>& a) : n_(static_cast<std::size_t>(a.cols())) {
    find_strong_entries(a);
    aggregate();
  }

  int size() const { return num_; }

  /// Frees the strong entries. Afterwards, interpolation can be constant only.
  void forget_strong_entries() {
    for (auto* const v : {&begin_, &neighbour_}) std::vector<int>().swap(*v);
    std::vector<float>().swap(strength_);
  }

  /// Interpolation that is constant on each aggregate.
  prolongation piecewise_constant() const {
    prolongation p;
    p.columns = num_;
    p.begin.reserve(n_ + 1);
    p.begin.push_back(0);
    for (std::size_t i = 0; i < n_; ++i) p.begin.push_back(p.begin.back() + (of_[i] >= 0));
    p.column.reserve(static_cast<std::size_t>(p.begin.back()));
    for (const int to : of_)
      if (to >= 0) p.column.push_back(to);
    p.weight.assign(p.column.size(), 1);
    return p;
  }

  /// The same, smoothed by one step of damped Jacobi with the filtered matrix. Rows with more than `max_per_row` strong
  /// entries are not smoothed, so that the coarse matrix of a vert with thousands of edges stays sparse; nor are rows i
  /// with stays_constant(i). Empty if the result had more than `max_entries` entries.
  prolongation smoothed(std::size_t max_entries) const {
    return smoothed(max_entries, [](std::size_t) { return false; });
  }
  template<class StaysConstant>
  prolongation smoothed(std::size_t max_entries, const StaysConstant& stays_constant) const {
    prolongation p;
    p.columns = num_;
    p.begin.reserve(n_ + 1);
    p.begin.push_back(0);
    std::vector<int> position(static_cast<std::size_t>(num_), -1), columns;
    std::vector<double> weights;
    for (std::size_t i = 0; i < n_; ++i) {
      smooth_row(i, !stays_constant(i), position, columns, weights);
      if (p.column.size() + columns.size() > max_entries) return {};
      p.column.insert(p.column.end(), columns.begin(), columns.end());
      append_rounded(weights, p.weight);
      p.begin.push_back(static_cast<int>(p.column.size()));
    }
    return p;
  }

 private:
  /// The aggregates and weights from which row i is interpolated. position: -1 for each aggregate, before and after.
  void smooth_row(std::size_t i, bool is_smoothed, std::vector<int>& position, std::vector<int>& columns,
                  std::vector<double>& weights) const {
    columns.clear();
    weights.clear();
    const auto add = [&](int to, double w) {
      if (to < 0) return;
      int& at = position[static_cast<std::size_t>(to)];
      if (at < 0) {
        at = static_cast<int>(columns.size());
        columns.push_back(to);
        weights.push_back(0);
      }
      weights[static_cast<std::size_t>(at)] += w;
    };
    const int count = begin_[i + 1] - begin_[i];
    is_smoothed = is_smoothed && count <= max_per_row;
    if (count > 0) add(of_[i], is_smoothed ? 1 - damping : 1);
    if (is_smoothed)
      for (auto k = static_cast<std::size_t>(begin_[i]); k < static_cast<std::size_t>(begin_[i + 1]); ++k)
        add(of_[static_cast<std::size_t>(neighbour_[k])], damping * static_cast<double>(strength_[k]));
    for (const int to : columns) position[static_cast<std::size_t>(to)] = -1;
  }

  void find_strong_entries(const Eigen::SparseMatrix<double>& a) {
    const int *const starts = a.outerIndexPtr(), *const rows = a.innerIndexPtr(), n = static_cast<int>(n_);
    const double* const x = a.valuePtr();
    std::vector<double> largest(n_), sum(n_);  // m of each row, and the sum of |a| off the diagonal
    const auto for_each_entry = [&](auto visit) {
      for (int c = 0; c < n; ++c)
        for (int k = starts[c] + 1; k < starts[c + 1]; ++k)
          visit(static_cast<std::size_t>(c), static_cast<std::size_t>(rows[k]), x[k]);
    };
    for_each_entry([&](std::size_t i, std::size_t j, double e) {
      largest[i] = std::max(largest[i], -e);
      largest[j] = std::max(largest[j], -e);
      sum[i] += std::abs(e);
      sum[j] += std::abs(e);
    });
    const auto is_strong = [&](std::size_t i, std::size_t j, double e) {
      return e < 0 && -e >= strong * std::min(largest[i], largest[j]);
    };
    of_.assign(n_, -1);
    for (std::size_t i = 0; i < n_; ++i)
      if (x[starts[i]] >= dominance * sum[i]) of_[i] = -2;  // Gauss-Seidel solves such rows
    begin_.assign(n_ + 2, 0);
    std::vector<double>& strong_sum = sum;
    std::vector<double> diagonal(n_);  // of the filtered matrix
    for (std::size_t i = 0; i < n_; ++i) {
      strong_sum[i] = 0;
      diagonal[i] = x[starts[i]];
    }
    for_each_entry([&](std::size_t i, std::size_t j, double e) {  // adds zeros where others would branch, unpredictably
      const bool s = is_strong(i, j, e);
      const double strength = s ? -e : 0, rest = s ? 0 : e;
      for (const std::size_t k : {i, j}) {
        begin_[k + 2] += s;
        strong_sum[k] += strength;
        diagonal[k] += rest;
      }
    });
    // rows of negative sum: as if the sum were 0
    for (std::size_t i = 0; i < n_; ++i) diagonal[i] = 1 / std::max(diagonal[i], strong_sum[i]);
    for (std::size_t i = 2; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
    const auto unused = static_cast<std::size_t>(begin_.back());  // where entries are written that are not strong
    neighbour_.resize(unused + 1);
    strength_.resize(neighbour_.size());
    for_each_entry([&](std::size_t i, std::size_t j, double e) {
      const bool s = is_strong(i, j, e);
      const auto add = [&](std::size_t row, std::size_t other) {
        const std::size_t at = s ? static_cast<std::size_t>(begin_[row + 1]) : unused;
        neighbour_[at] = static_cast<int>(other);
        strength_[at] = static_cast<float>(-e * diagonal[row]);
        begin_[row + 1] += s;
      };
      add(i, j);
      add(j, i);
    });
    begin_.pop_back();
  }

  void aggregate() {
    const auto neighbours = [&](std::size_t i, auto visit) {
      for (auto k = static_cast<std::size_t>(begin_[i]); k < static_cast<std::size_t>(begin_[i + 1]); ++k)
        visit(static_cast<std::size_t>(neighbour_[k]), strength_[k]);
    };
    for (std::size_t i = 0; i < n_; ++i) {  // rows whose neighbours are all free become centres
      if (of_[i] != -1) continue;
      bool is_free = true, has_any = false;
      neighbours(i, [&](std::size_t j, float) {
        is_free = is_free && of_[j] < 0;
        has_any = has_any || of_[j] == -1;
      });
      if (!is_free || !has_any) continue;
      of_[i] = num_;
      neighbours(i, [&](std::size_t j, float) {
        if (of_[j] == -1) of_[j] = num_;
      });
      ++num_;
    }
    const int of_centres = num_;
    std::vector<int> joined(n_, -1);
    for (std::size_t i = 0; i < n_; ++i) {  // the others join the aggregate of their strongest neighbour
      if (of_[i] != -1) continue;
      float strongest = 0;
      neighbours(i, [&](std::size_t j, float s) {
        if (of_[j] >= 0 && of_[j] < of_centres && s > strongest) {
          strongest = s;
          joined[i] = of_[j];
        }
      });
    }
    for (std::size_t i = 0; i < n_; ++i) {
      if (of_[i] == -1) of_[i] = joined[i];
      if (of_[i] < 0) of_[i] = -1;
    }
  }
};

}  // namespace concino::detail
