// Which rows of a system of constraints are independent, which follow from others, and which contradict them.
#pragma once

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
  double terms;  // the sum of what value is the sum of, each taken positive
  double noise;  // what entries may be off by
  double pivot;
  std::vector<std::pair<int, double>> taken;  // reduced rows that were taken away, numbers and factors
};

/// Independent rows of constraints, as they are given and reduced by those before.
struct row_space {
  std::vector<int> independent;
  std::vector<reduced_row> reduced;  // as many
  bool is_nearly_dependent = false;  // of some row, little is left

  /// The multipliers of the given rows, from those of the reduced ones.
  void multipliers_of_given(std::vector<double>& of_reduced) const {
    for (std::size_t i = reduced.size(); i-- > 0;) {
      of_reduced[i] /= reduced[i].pivot;
      for (const auto& [row, factor] : reduced[i].taken) of_reduced[static_cast<std::size_t>(row)] -= factor * of_reduced[i];
    }
  }
};

/// The rows of C x = d, in their order, that do not follow from those before; by elimination with the largest entry of each row as its pivot.
/// A row counts as dependent if elimination leaves no entry above rounding errors: those of its largest entry, and those of the rows that it is reduced
/// by, which are larger where little was left of these. It contradicts the others if then more than 1e-9 of the d involved is left.
/// Errors: solver_error if a row contradicts those before; it is named.
inline row_space independent_rows(const char* who, const Eigen::SparseMatrix<double>& c, const Eigen::VectorXd& d) {
  using row_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  row_matrix rows = c;
  rows.makeCompressed();
  row_space space;
  std::vector<reduced_row>& pivots = space.reduced;
  std::vector<int> pivot_of(static_cast<std::size_t>(c.cols()), -1), touched;
  std::vector<double> row(static_cast<std::size_t>(c.cols()));
  std::vector<char> is_touched(row.size());
  for (int i = 0; i < rows.rows(); ++i) {
    std::priority_queue<int, std::vector<int>, std::greater<int>> waiting;  // pivots to eliminate, oldest first
    const auto touch = [&](int column) {
      if (is_touched[static_cast<std::size_t>(column)]) return;
      is_touched[static_cast<std::size_t>(column)] = 1;
      touched.push_back(column);
      if (pivot_of[static_cast<std::size_t>(column)] >= 0) waiting.push(pivot_of[static_cast<std::size_t>(column)]);
    };
    double scale = 0;
    for (row_matrix::InnerIterator it(rows, i); it; ++it) {
      scale = std::max(scale, std::abs(it.value()));
      row[static_cast<std::size_t>(it.col())] = it.value();
      touch(static_cast<int>(it.col()));
    }
    double value = d[i], terms = std::abs(d[i]), noise = 8 * std::numeric_limits<double>::epsilon() * scale, steps = 0;
    std::vector<std::pair<int, double>> taken;
    while (!waiting.empty()) {
      const int at = waiting.top();
      const reduced_row& pivot = pivots[static_cast<std::size_t>(at)];
      waiting.pop();
      const auto column = static_cast<std::size_t>(pivot.entries.front().first);
      const double factor = row[column];
      if (factor == 0) continue;
      for (const auto& [j, x] : pivot.entries) {
        touch(j);
        row[static_cast<std::size_t>(j)] -= factor * x;
      }
      row[column] = 0;
      taken.emplace_back(at, factor);
      value -= factor * pivot.value;
      terms += std::abs(factor) * pivot.terms;
      noise = std::max(noise, std::abs(factor) * pivot.noise);
      ++steps;
    }
    int largest = -1;
    double most = 0;
    for (const int j : touched)
      if (const double x = std::abs(row[static_cast<std::size_t>(j)]); x > most) {
        most = x;
        largest = j;
      }
    noise *= 1 + std::sqrt(steps) / 8;
    if (largest >= 0 && most > noise) {
      const double pivot = row[static_cast<std::size_t>(largest)];
      reduced_row next{{{largest, 1.0}}, value / pivot, terms / std::abs(pivot), noise / std::abs(pivot), pivot, std::move(taken)};
      space.is_nearly_dependent |= most < 1e-6 * scale;
      for (const int j : touched)
        if (j != largest && row[static_cast<std::size_t>(j)] != 0) next.entries.emplace_back(j, row[static_cast<std::size_t>(j)] / pivot);
      pivot_of[static_cast<std::size_t>(largest)] = static_cast<int>(pivots.size());
      pivots.push_back(std::move(next));
      space.independent.push_back(i);
    } else if (!(std::abs(value) <= 1e-9 * terms)) {
      core::throw_joined<solver_error>({who, ": constraint ", static_cast<std::size_t>(i), " contradicts those before it: its left side follows from"
                                  " theirs, but its right side is off by ", core::number_text(std::abs(value))});
    }
    for (const int j : touched) {
      row[static_cast<std::size_t>(j)] = 0;
      is_touched[static_cast<std::size_t>(j)] = 0;
    }
    touched.clear();
  }
  return space;
}

}  // namespace concino::detail
