// Nested dissection; see nested_dissection.hpp.
#pragma once

#include <concino/solve/detail/bisection.hpp>
#include <concino/solve/detail/nested_dissection.hpp>
#include <concino/solve/detail/row_graph.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace concino::detail {

/// Splits parts until they are small. The parts are kept in a list, so that no call is recursive.
class dissection {
  struct range {
    int begin, end;  // in order_

    int size() const { return end - begin; }
  };

  row_graph graph_;
  row_array<int> order_;     // the rows of each part are neighbours in it
  row_array<int> distance_, other_distance_;  // of each row; -1 for those of the current part that are not yet visited, and never for others
  row_array<int> visited_, sorted_, counts_;
  std::vector<range> parts_;  // those that are not yet split
  bisection bisection_;

 public:
  explicit dissection(const Eigen::SparseMatrix<double>& pattern) : graph_(pattern), bisection_(graph_) {
    const int n = graph_.num_rows();
    distance_.assign(n, 0);
    other_distance_.assign(n, 0);
    for (int v = 0; v < n; ++v) order_.values.push_back(v);
  }

  std::vector<int> find_order(const std::vector<int>& by_degree) {
    constexpr int small = 200;
    std::vector<range> unsplit;
    parts_.push_back({0, graph_.num_rows()});
    while (!parts_.empty()) {
      const range r = parts_.back();
      parts_.pop_back();
      if (r.size() <= small || !split(r)) unsplit.push_back(r);
    }
    if (unsplit.size() == 1 && graph_.dense.size() == 0) return {};
    sort_parts(unsplit, by_degree);
    order_.values.insert(order_.end(), graph_.dense.begin(), graph_.dense.end());
    return std::move(order_.values);
  }

 private:
  void forget(range r, row_array<int>& distance) {
    visited_.values.clear();
    for (int i = r.begin; i < r.end; ++i) distance[order_[i]] = -1;
  }

  /// Appends the rows of a part that can be reached from a row to visited_, breadth first.
  void visit(int from, row_array<int>& distance) {
    int i = visited_.size();
    visited_.values.push_back(from);
    distance[from] = 0;
    for (; i < visited_.size(); ++i) {
      const int v = visited_[i];
      for (int k = graph_.starts[v]; k < graph_.starts[v + 1]; ++k) {
        const int w = graph_.adjacent[k];
        if (distance[w] >= 0) continue;
        distance[w] = distance[v] + 1;
        visited_.values.push_back(w);
      }
    }
  }

  /// Splits a part into two others. Returns false, and does nothing, if its separator would be large.
  bool split(range r) {
    forget(r, distance_);
    visit(order_[r.begin], distance_);
    if (visited_.size() < r.size()) {
      split_components(r);
      return true;
    }
    const int from = visited_.values.back();
    forget(r, distance_);
    visit(from, distance_);
    const int to = visited_.values.back();
    forget(r, other_distance_);
    visit(to, other_distance_);
    sort_visited(distance_[to]);
    bisection_.split(sorted_);
    const int num_first = bisection_.size_of(bisection::first_half), num_second = bisection_.size_of(bisection::second_half);
    constexpr int max_separator = 4;  // one in so many rows
    const bool is_split = num_first > 0 && num_second > 0 && bisection_.size_of(bisection::separator) <= r.size() / max_separator;
    if (is_split) {
      int next[3] = {r.begin, r.begin + num_first, r.begin + num_first + num_second};
      for (const int v : sorted_) order_[next[bisection_.set_of(v)]++] = v;
      add_halves({r.begin, r.begin + num_first + num_second}, r.begin + num_first);
    }
    bisection_.forget(sorted_);
    return is_split;
  }

  /// Sorts the visited rows by the difference of both distances, which is at most that of the two rows from which they are measured.
  void sort_visited(int max_difference) {
    const auto key = [&](int v) { return distance_[v] - other_distance_[v] + max_difference; };
    counts_.assign(2 * max_difference + 2, 0);
    for (const int v : visited_) ++counts_[key(v) + 1];
    for (int k = 1; k < counts_.size(); ++k) counts_[k] += counts_[k - 1];
    sorted_.values.resize(visited_.values.size());
    for (const int v : visited_) sorted_[counts_[key(v)]++] = v;
  }

  /// Splits a part that is not connected, of which the first component was visited. One half is the largest component, if that has more than half of the
  /// rows; otherwise it has the first components with at least a quarter of them.
  void split_components(range r) {
    std::vector<range> components{{0, visited_.size()}};
    for (int i = r.begin; i < r.end; ++i)
      if (distance_[order_[i]] < 0) {
        const int begin = visited_.size();
        visit(order_[i], distance_);
        components.push_back({begin, visited_.size()});
      }
    int middle = 0;
    for (const range c : components)
      if (c.size() > r.size() / 2) {
        std::rotate(visited_.values.begin(), visited_.values.begin() + c.begin, visited_.values.begin() + c.end);
        middle = c.size();
      }
    for (std::size_t k = 0; middle < (r.size() + 3) / 4; ++k) middle = components[k].end;
    for (int i = 0; i < r.size(); ++i) order_[r.begin + i] = visited_[i];
    add_halves(r, r.begin + middle);
  }

  void add_halves(range r, int middle) {
    parts_.push_back({r.begin, middle});
    parts_.push_back({middle, r.end});
  }

  /// Sorts the rows within each part as in another order of the matrix.
  void sort_parts(const std::vector<range>& parts, const std::vector<int>& other_order) {
    row_array<int> part, next;
    part.assign(graph_.num_rows() + graph_.dense.size(), -1);  // of the rows of the matrix
    for (const range r : parts) {
      for (int i = r.begin; i < r.end; ++i) part[graph_.input_row[order_[i]]] = next.size();
      next.values.push_back(r.begin);
    }
    for (int& v : order_.values) v = graph_.input_row[v];
    for (const int v : other_order)
      if (part[v] >= 0) order_[next[part[v]]++] = v;
  }
};

CONCINO_INLINE std::vector<int> nested_dissection_order(const Eigen::SparseMatrix<double>& pattern, const std::vector<int>& by_degree) {
  return dissection(pattern).find_order(by_degree);
}

}  // namespace concino::detail
