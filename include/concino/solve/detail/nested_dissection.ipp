// Nested dissection; see nested_dissection.hpp.
#pragma once

#include <concino/solve/detail/nested_dissection.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace concino::detail {

/// An array with one value per row of a matrix, or per entry.
template<class T>
struct row_array {
  std::vector<T> values;

  int size() const { return static_cast<int>(values.size()); }
  T& operator[](int i) { return values[static_cast<std::size_t>(i)]; }
  const T& operator[](int i) const { return values[static_cast<std::size_t>(i)]; }
  void assign(int n, T x) { values.assign(static_cast<std::size_t>(n), x); }
  auto begin() const { return values.begin(); }
  auto end() const { return values.end(); }
};

/// The adjacent rows of each row of a symmetric matrix, without rows that have very many entries. Rows are numbered breadth first, so that adjacent rows
/// are close in memory.
struct row_graph {
  row_array<int> starts, adjacent;
  row_array<int> input_row;  // the number of each row in the matrix
  row_array<int> dense;      // the rows of the matrix that are left out

  explicit row_graph(const Eigen::SparseMatrix<double>& pattern) {
    const int *const begin = pattern.outerIndexPtr(), *const rows = pattern.innerIndexPtr(), n = static_cast<int>(pattern.cols());
    const double max_entries = std::max(16.0, 10 * std::sqrt(static_cast<double>(n)));
    row_array<int> number;
    number.assign(n, -1);
    const auto is_dense = [&](int r) { return begin[r + 1] - begin[r] > max_entries; };
    const auto add = [&](int r) {
      if (number[r] >= 0 || is_dense(r)) return;
      number[r] = input_row.size();
      input_row.values.push_back(r);
    };
    for (int r = 0; r < n; ++r) {
      if (is_dense(r)) dense.values.push_back(r);
      const int first = input_row.size();
      add(r);
      for (int i = first; i < input_row.size(); ++i)
        for (int k = begin[input_row[i]], end = begin[input_row[i] + 1]; k < end; ++k) add(rows[k]);
    }
    starts.values.assign(1, 0);
    adjacent.values.reserve(static_cast<std::size_t>(pattern.nonZeros()));
    for (const int r : input_row) {
      for (int k = begin[r]; k < begin[r + 1]; ++k)
        if (rows[k] != r && number[rows[k]] >= 0) adjacent.values.push_back(number[rows[k]]);
      starts.values.push_back(adjacent.size());
    }
  }

  int num_rows() const { return input_row.size(); }
};

/// Splits connected parts of a graph by small separators.
class bisection {
 public:
  enum set : char { first_half, second_half, separator, none };

 private:
  const row_graph& graph_;
  int sizes_[3] = {};    // of the sets
  row_array<char> set_;  // `none` for rows of other parts
  row_array<int> separator_, other_;  // other_: the rows of the half that the separator moves to, next to it
  row_array<int> mate_, layer_, next_, queue_, path_;  // of the matching; mate_ and layer_ are -1 between the steps

 public:
  explicit bisection(const row_graph& g) : graph_(g) {
    set_.assign(g.num_rows(), none);
    for (row_array<int>* const a : {&mate_, &layer_, &next_}) a->assign(g.num_rows(), -1);
  }

  int size_of(set s) const { return sizes_[s]; }
  set set_of(int row) const { return static_cast<set>(set_[row]); }

  /// Makes all rows members of no part again.
  void forget(const row_array<int>& rows) {
    for (const int v : rows) set_[v] = none;
  }

  /// Splits the rows of a part, in the order in which they are passed.
  void split(const row_array<int>& rows) {
    const int middle = rows.size() / 2;
    for (int i = 0; i < rows.size(); ++i) set_[rows[i]] = i < middle ? first_half : second_half;
    separator_.values.clear();
    for (int i = 0; i < middle; ++i) {
      bool is_cut = false;
      for (int k = graph_.starts[rows[i]]; k < graph_.starts[rows[i] + 1] && !is_cut; ++k) is_cut = is_in(graph_.adjacent[k], second_half);
      if (is_cut) separator_.values.push_back(rows[i]);
    }
    for (const int v : separator_) set_[v] = separator;
    sizes_[first_half] = middle - separator_.size();
    sizes_[second_half] = rows.size() - middle;
    sizes_[separator] = separator_.size();
    constexpr int max_moves = 100;
    set to = second_half;
    for (int move = 0, failed = 0; move < max_moves && failed < 2; ++move) {
      failed = improve(to) ? 0 : failed + 1;
      to = opposite(to);
    }
  }

 private:
  static set opposite(set half) { return half == first_half ? second_half : first_half; }
  bool is_in(int row, set s) const { return set_[row] == s; }

  /// f(w) for each row w of a set that is adjacent to row v.
  template<class F>
  void for_each_adjacent(int v, set s, F f) const {
    for (int k = graph_.starts[v]; k < graph_.starts[v + 1]; ++k)
      if (is_in(graph_.adjacent[k], s)) f(graph_.adjacent[k]);
  }

  /// Moves the separator towards a half, by a minimum cover of the edges between them. Returns whether that makes the separator smaller, or leaves its size
  /// and makes the halves more equal.
  bool improve(set to) {
    find_adjacent(to);
    match(to);
    int num_matched = 0;
    for (const int v : separator_) num_matched += mate_[v] >= 0;
    const bool shrinks = num_matched < separator_.size();
    row_array<int> cover, left;  // rows that leave the separator
    if (shrinks) cover_nearer(to, cover, left);
    else if (sizes_[to] > sizes_[opposite(to)]) cover_farther(cover, left);
    for (const row_array<int>* const side : {&separator_, &other_})
      for (const int v : *side) mate_[v] = layer_[v] = -1;
    if (left.size() == 0) return false;
    const int total = sizes_[0] + sizes_[1] + sizes_[2];
    const int away = sizes_[opposite(to)] + left.size(), near = total - away - cover.size();
    const int larger = std::max(away, near), previous = std::max(sizes_[0], sizes_[1]);
    constexpr double max_share = 0.7;  // of the larger half; a bound on the depth
    if (shrinks ? larger > std::max(max_share * total, 1.0 * previous) : larger >= previous) return false;
    for (const int v : left) set_[v] = opposite(to);
    for (const int v : cover) set_[v] = separator;
    sizes_[opposite(to)] = away;
    sizes_[to] = near;
    sizes_[separator] = cover.size();
    separator_.values.swap(cover.values);
    return true;
  }

  void find_adjacent(set to) {
    other_.values.clear();
    for (const int v : separator_)
      for_each_adjacent(v, to, [&](int w) {
        if (layer_[w] < 0) other_.values.push_back(w);
        layer_[w] = 0;
      });
    for (const int w : other_) layer_[w] = -1;
  }

  /// Finds a maximum matching of the separator with rows of a half. Afterwards layer_ is at least 0 for rows of the separator to which an alternating path
  /// leads from one without a mate.
  void match(set to) {
    for (const int v : separator_)
      for_each_adjacent(v, to, [&](int w) {
        if (mate_[v] >= 0 || mate_[w] >= 0) return;
        mate_[v] = w;
        mate_[w] = v;
      });
    while (find_layers(to))
      for (const int v : separator_)
        if (mate_[v] < 0) augment(v, to);
  }

  /// Finds the length of the shortest alternating paths to each row of the separator. Returns whether one can be augmented.
  bool find_layers(set to) {
    bool can_augment = false;
    queue_.values.clear();
    for (const int v : separator_) {
      next_[v] = graph_.starts[v];
      layer_[v] = mate_[v] < 0 ? 0 : -1;
      if (mate_[v] < 0) queue_.values.push_back(v);
    }
    for (int i = 0; i < queue_.size(); ++i) {
      const int v = queue_[i];
      for_each_adjacent(v, to, [&](int w) {
        const int u = mate_[w];
        if (u < 0) can_augment = true;
        if (u < 0 || layer_[u] >= 0) return;
        layer_[u] = layer_[v] + 1;
        queue_.values.push_back(u);
      });
    }
    return can_augment;
  }

  /// Follows an alternating path through the layers, depth first, and augments it if it ends at a row without a mate.
  void augment(int seed, set to) {
    constexpr int dead_end = -2;
    path_.values.assign(1, seed);
    while (path_.size() > 0) {
      const int v = path_.values.back();
      int& k = next_[v];
      const auto leads_on = [&](int w) { return is_in(w, to) && (mate_[w] < 0 || layer_[mate_[w]] == layer_[v] + 1); };
      while (k < graph_.starts[v + 1] && !leads_on(graph_.adjacent[k])) ++k;
      if (k == graph_.starts[v + 1]) {
        layer_[v] = dead_end;
        path_.values.pop_back();
      } else if (const int u = mate_[graph_.adjacent[k]]; u >= 0) {
        path_.values.push_back(u);
      } else {
        for (const int x : path_) {
          const int w = graph_.adjacent[next_[x]++];
          mate_[x] = w;
          mate_[w] = x;
        }
        return;
      }
    }
  }

  /// The minimum cover with most rows of the separator. Alternating paths from its rows without a mate lead to the rows that leave it.
  void cover_nearer(set to, row_array<int>& cover, row_array<int>& left) {
    for (const int v : separator_) {
      (layer_[v] < 0 ? cover : left).values.push_back(v);
      if (layer_[v] < 0) continue;
      for_each_adjacent(v, to, [&](int w) {
        if (layer_[w] < 0) cover.values.push_back(w);
        layer_[w] = 0;
      });
    }
  }

  /// The minimum cover with fewest rows of the separator, if all of these have mates. Alternating paths from the other rows without a mate lead to those that
  /// stay in it.
  void cover_farther(row_array<int>& cover, row_array<int>& left) {
    queue_.values.clear();
    for (const int w : other_)
      if (mate_[w] < 0) {
        layer_[w] = 0;
        queue_.values.push_back(w);
      }
    for (const int v : separator_) layer_[v] = -1;
    for (int i = 0; i < queue_.size(); ++i)
      for_each_adjacent(queue_[i], separator, [&](int v) {
        layer_[v] = 0;
        const int w = mate_[v];
        if (layer_[w] < 0) queue_.values.push_back(w);
        layer_[w] = 0;
      });
    for (const int w : other_)
      if (layer_[w] < 0) cover.values.push_back(w);
    for (const int v : separator_) (layer_[v] >= 0 ? cover : left).values.push_back(v);
  }
};

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
