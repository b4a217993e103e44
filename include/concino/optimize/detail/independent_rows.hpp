// Classifies the rows of a system of constraints: independent, dependent on others, or contradicting them.
#pragma once

#include <concino/core/number_text.hpp>
#include <concino/core/system_checks.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace concino::detail {

struct reduced_row {
  std::vector<std::pair<int, double>> entries;  // divided by the pivot, which comes first
  double value;
  double terms;  // the sum of the absolute values of the terms of value
  double noise;  // a bound of the errors of entries
  double pivot;
  std::vector<std::pair<int, double>> taken;  // reduced rows that were subtracted: numbers and factors
};

/// Independent rows of constraints, in their original form and reduced by earlier rows.
struct row_space {
  std::vector<int> independent;
  std::vector<reduced_row> reduced;  // as many as original rows
  bool is_nearly_dependent = false;  // the reduction left little of some row

  /// The multipliers of the original rows, from those of the reduced rows.
  void multipliers_of_original_rows(std::vector<double>& of_reduced) const {
    for (std::size_t i = reduced.size(); i-- > 0;) {
      of_reduced[i] /= reduced[i].pivot;
      for (const auto& [row, factor] : reduced[i].taken)
        of_reduced[static_cast<std::size_t>(row)] -= factor * of_reduced[i];
    }
  }
};

/// Eliminates the rows of C x = d one after the other, with the largest entry of each as its pivot.
class row_elimination {
  using row_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  /// A reduced right side, and the accuracy of its reduced row.
  struct reduced_side {
    double value, terms, noise;
    std::vector<std::pair<int, double>> taken;
  };
  struct largest_entry {
    int column = -1;  // of the pivot; -1: none
    double size = 0;
  };

  row_space space_;
  std::vector<int> pivot_of_;  // by column: the reduced row whose pivot it is, or -1
  std::vector<double> row_;    // the row being reduced; zero except where is_touched_
  std::vector<char> is_touched_;
  std::vector<int> touched_;                                                   // columns
  std::priority_queue<int, std::vector<int>, std::greater<int>> waiting_;  // pivots to eliminate, oldest first

  void touch(int column) {
    if (is_touched_[static_cast<std::size_t>(column)]) return;
    is_touched_[static_cast<std::size_t>(column)] = 1;
    touched_.push_back(column);
    if (pivot_of_[static_cast<std::size_t>(column)] >= 0) waiting_.push(pivot_of_[static_cast<std::size_t>(column)]);
  }

  /// Result: the size of the largest entry.
  double load(const row_matrix& rows, int i) {
    double scale = 0;
    for (row_matrix::InnerIterator it(rows, i); it; ++it) {
      scale = std::max(scale, std::abs(it.value()));
      row_[static_cast<std::size_t>(it.col())] = it.value();
      touch(static_cast<int>(it.col()));
    }
    return scale;
  }

  /// Subtracts multiples of the reduced rows until the columns of their pivots are zero.
  reduced_side eliminate(double value, double scale) {
    reduced_side r{value, std::abs(value), 8 * std::numeric_limits<double>::epsilon() * scale, {}};
    double steps = 0;
    while (!waiting_.empty()) {
      const int at = waiting_.top();
      const reduced_row& pivot = space_.reduced[static_cast<std::size_t>(at)];
      waiting_.pop();
      const auto column = static_cast<std::size_t>(pivot.entries.front().first);
      const double factor = row_[column];
      if (factor == 0) continue;
      for (const auto& [j, x] : pivot.entries) {
        touch(j);
        row_[static_cast<std::size_t>(j)] -= factor * x;
      }
      row_[column] = 0;
      r.taken.emplace_back(at, factor);
      r.value -= factor * pivot.value;
      r.terms += std::abs(factor) * pivot.terms;
      r.noise = std::max(r.noise, std::abs(factor) * pivot.noise);
      ++steps;
    }
    r.noise *= 1 + std::sqrt(steps) / 8;
    return r;
  }

  largest_entry find_largest() const {
    largest_entry r;
    for (const int j : touched_)
      if (const double x = std::abs(row_[static_cast<std::size_t>(j)]); x > r.size) r = {j, x};
    return r;
  }

  void add_independent(int i, int column, reduced_side&& left) {
    const double pivot = row_[static_cast<std::size_t>(column)];
    reduced_row next{{{column, 1.0}}, left.value / pivot,   left.terms / std::abs(pivot), left.noise / std::abs(pivot),
                     pivot,           std::move(left.taken)};
    for (const int j : touched_)
      if (j != column && row_[static_cast<std::size_t>(j)] != 0)
        next.entries.emplace_back(j, row_[static_cast<std::size_t>(j)] / pivot);
    pivot_of_[static_cast<std::size_t>(column)] = static_cast<int>(space_.reduced.size());
    space_.reduced.push_back(std::move(next));
    space_.independent.push_back(i);
  }

  void clear_row() {
    for (const int j : touched_) {
      row_[static_cast<std::size_t>(j)] = 0;
      is_touched_[static_cast<std::size_t>(j)] = 0;
    }
    touched_.clear();
  }

 public:
  explicit row_elimination(Eigen::Index columns)
      : pivot_of_(static_cast<std::size_t>(columns), -1), row_(static_cast<std::size_t>(columns)),
        is_touched_(row_.size()) {}

  /// Reduces row i of `rows`, whose right side is `value`, and keeps it if it is independent of earlier rows.
  void add(const char* caller, const row_matrix& rows, int i, double value) {
    const double scale = load(rows, i);
    reduced_side left = eliminate(value, scale);
    const largest_entry largest = find_largest();
    if (largest.column >= 0 && largest.size > left.noise) {
      space_.is_nearly_dependent |= largest.size < 1e-6 * scale;
      add_independent(i, largest.column, std::move(left));
    } else if (!(std::abs(left.value) <= 1e-9 * left.terms)) {
      core::throw_joined<solver_error>({caller, ": constraint ", static_cast<std::size_t>(i),
                                        " contradicts those before it: its left side is a combination"
                                        " of theirs, but its right side differs by ",
                                        core::number_text(std::abs(left.value))});
    }
    clear_row();
  }

  row_space take() && { return std::move(space_); }
};

/// The rows of C x = d, in their order, that do not depend on earlier rows; by elimination with the largest entry of
/// each row as its pivot. A row is dependent if elimination leaves no entry above rounding errors. These are the errors
/// of its largest entry, and of the rows that reduce it, which are larger if the reduction left little of them. A
/// dependent row contradicts the others if more than 1e-9 of the d involved is then left.
/// Errors: solver_error if a row contradicts earlier ones; the message names it.
inline row_space independent_rows(const char* caller, const Eigen::SparseMatrix<double>& c, const Eigen::VectorXd& d) {
  Eigen::SparseMatrix<double, Eigen::RowMajor> rows = c;
  rows.makeCompressed();
  row_elimination elimination(c.cols());
  for (int i = 0; i < rows.rows(); ++i) elimination.add(caller, rows, i, d[i]);
  return std::move(elimination).take();
}

}  // namespace concino::detail
