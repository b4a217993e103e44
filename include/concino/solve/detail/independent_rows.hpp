// Which rows of a system of constraints are independent, which follow from others, and which contradict them.
#pragma once

#include <concino/solve/detail/system_checks.hpp>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

namespace concino::detail {

/// The rows of C x = d, in their order, that do not follow from those before; by elimination with the largest entry of each row as its pivot.
/// Rows count as dependent if of their largest entry less than 1e-11 is left, and as contradicting if of the d involved more than 1e-9 is left.
/// Errors: solver_error if a row contradicts those before; it is named.
inline std::vector<int> independent_rows(const char* who, const Eigen::SparseMatrix<double>& c, const Eigen::VectorXd& d) {
  using row_matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;
  row_matrix rows = c;
  rows.makeCompressed();
  struct reduced {
    std::vector<std::pair<int, double>> entries;  // divided by the pivot
    double value;
    double terms;  // the sum of what value is the sum of, each taken positive
  };
  std::vector<reduced> pivots;
  std::vector<int> pivot_of(static_cast<std::size_t>(c.cols()), -1), independent, touched;
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
    double value = d[i], terms = std::abs(d[i]);
    while (!waiting.empty()) {
      const reduced& pivot = pivots[static_cast<std::size_t>(waiting.top())];
      waiting.pop();
      const auto column = static_cast<std::size_t>(pivot.entries.front().first);
      const double factor = row[column];
      if (factor == 0) continue;
      for (const auto& [j, x] : pivot.entries) {
        touch(j);
        row[static_cast<std::size_t>(j)] -= factor * x;
      }
      row[column] = 0;
      value -= factor * pivot.value;
      terms += std::abs(factor) * pivot.terms;
    }
    int largest = -1;
    double most = 0;
    for (const int j : touched)
      if (const double x = std::abs(row[static_cast<std::size_t>(j)]); x > most) {
        most = x;
        largest = j;
      }
    if (largest >= 0 && most > 1e-11 * scale) {
      const double pivot = row[static_cast<std::size_t>(largest)];
      reduced next{{{largest, 1.0}}, value / pivot, terms / std::abs(pivot)};
      for (const int j : touched)
        if (j != largest && row[static_cast<std::size_t>(j)] != 0) next.entries.emplace_back(j, row[static_cast<std::size_t>(j)] / pivot);
      pivot_of[static_cast<std::size_t>(largest)] = static_cast<int>(pivots.size());
      pivots.push_back(std::move(next));
      independent.push_back(i);
    } else if (!(std::abs(value) <= 1e-9 * terms)) {
      throw_joined<solver_error>({who, ": constraint ", static_cast<std::size_t>(i), " contradicts those before it: its left side follows from"
                                  " theirs, but its right side is off by ", number_text(std::abs(value))});
    }
    for (const int j : touched) {
      row[static_cast<std::size_t>(j)] = 0;
      is_touched[static_cast<std::size_t>(j)] = 0;
    }
    touched.clear();
  }
  return independent;
}

}  // namespace concino::detail
