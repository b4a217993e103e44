// Splits a graph by a small separator; see nested_dissection.hpp.
#pragma once

#include <concino/solve/detail/row_graph.hpp>

#include <algorithm>

namespace concino::detail {

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

}  // namespace concino::detail
