// A basis of the first cohomology; see closed_cochains.hpp.
#pragma once

#include <concino/fields/detail/problems/closed_cochains.hpp>
#include <concino/fields/detail/topology/grouped_numbers.hpp>
#include <concino/graph/disjoint_sets.hpp>

#include <cmath>
#include <cstddef>
#include <utility>

namespace concino::detail {

/// Values on edges as linear combinations of symbols. Those of a spanning forest are 0. A polygon with one unknown edge
/// determines it; where there is none, an unknown edge becomes a symbol. On surfaces these are as many as there are
/// loops; otherwise, polygons whose edges were all known say how symbols depend on each other.
class cochain_search {
  using combination = std::vector<double>;  // coefficients of symbols; missing ones are 0

  const edge_complex& complex_;
  const grouped_numbers corners_of_;    // by edge: places in loop_edges
  std::vector<combination> value_;      // by edge; few are not empty
  std::vector<unsigned char> is_known_;
  std::vector<std::uint32_t> unknown_edges_, polygon_of_;  // by polygon; by place in loop_edges
  std::vector<std::uint32_t> waiting_;  // edges that became known
  std::vector<combination> relations_;  // in echelon form
  std::size_t symbols_ = 0;

  static void add(combination& sum, double factor, const combination& x) {
    if (sum.size() < x.size()) sum.resize(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) sum[k] += factor * x[k];
  }
  static constexpr std::size_t none = ~std::size_t{0};
  static std::size_t leading(const combination& x) {
    for (std::size_t k = 0; k < x.size(); ++k)
      if (std::abs(x[k]) > 1e-9) return k;  // of small integers and their quotients
    return none;
  }

  void add_relation(combination x) {
    for (const combination& r : relations_) {
      const std::size_t k = leading(r);
      if (k < x.size() && x[k] != 0) add(x, -x[k] / r[k], r);
    }
    if (leading(x) != none) relations_.push_back(std::move(x));
  }

  void set_known(std::uint32_t edge) {
    is_known_[edge] = 1;
    waiting_.push_back(edge);
  }

  void visit(std::size_t polygon) {
    combination sum;
    std::size_t unknown = none;
    for (std::size_t k = complex_.first[polygon]; k < complex_.first[polygon + 1]; ++k) {
      const std::uint32_t edge = complex_.loop_edges[k];
      if (is_known_[edge]) add(sum, complex_.signs[k], value_[edge]);
      else unknown = k;
    }
    if (unknown == none) {
      if (leading(sum) != none) add_relation(std::move(sum));
      return;
    }
    const std::uint32_t edge = complex_.loop_edges[unknown];
    if (leading(sum) != none) add(value_[edge], -complex_.signs[unknown], sum);
    set_known(edge);
  }

  void propagate_values() {
    while (!waiting_.empty()) {
      const std::uint32_t edge = waiting_.back();
      waiting_.pop_back();
      for (const std::uint32_t corner : corners_of_[edge])
        if (--unknown_edges_[polygon_of_[corner]] <= 1) visit(polygon_of_[corner]);
    }
  }

  /// A solution of the relations for each symbol that none of them determines.
  std::vector<combination> independent_symbols() const {
    std::vector<unsigned char> is_determined(symbols_);
    for (const combination& r : relations_) is_determined[leading(r)] = 1;
    std::vector<combination> solutions;
    for (std::size_t s = 0; s < symbols_; ++s) {
      if (is_determined[s]) continue;
      combination x(symbols_);
      x[s] = 1;
      for (bool changes = true; changes;) {  // relations of later symbols first would need no repetition; they are few
        changes = false;
        for (const combination& r : relations_) {
          double sum = 0;
          for (std::size_t k = 0; k < r.size(); ++k) sum += r[k] * x[k];
          if (std::abs(sum) <= 1e-9) continue;
          x[leading(r)] -= sum / r[leading(r)];
          changes = true;
        }
      }
      solutions.push_back(std::move(x));
    }
    return solutions;
  }

 public:
  explicit cochain_search(const edge_complex& c)
      : complex_(c),
        corners_of_(c.edges.size(), c.loop_edges.size(), [&](std::size_t corner) { return c.loop_edges[corner]; }),
        value_(c.edges.size()), is_known_(c.edges.size()) {
    for (std::size_t polygon = 0; polygon + 1 < c.first.size(); ++polygon) {
      unknown_edges_.push_back(c.first[polygon + 1] - c.first[polygon]);
      polygon_of_.resize(c.first[polygon + 1], static_cast<std::uint32_t>(polygon));
    }
  }

  std::vector<std::vector<double>> run() {
    disjoint_sets sets(complex_.verts);
    for (std::uint32_t e = 0; e < complex_.edges.size(); ++e) {
      const auto [a, b] = complex_.edges[e];
      if (a == b || corners_of_[e].empty()) is_known_[e] = 1;  // edges without polygons have no part in fields
      else if (sets.unite(a, b)) set_known(e);
    }
    propagate_values();
    for (std::uint32_t e = 0; e < complex_.edges.size(); ++e) {
      if (is_known_[e]) continue;
      value_[e].resize(++symbols_);
      value_[e].back() = 1;
      set_known(e);
      propagate_values();
    }
    std::vector<std::vector<double>> cochains;
    for (const combination& x : independent_symbols()) {
      auto& values = cochains.emplace_back(complex_.edges.size());
      for (std::size_t e = 0; e < values.size(); ++e)
        for (std::size_t k = 0; k < value_[e].size(); ++k) values[e] += value_[e][k] * x[k];
    }
    return cochains;
  }
};

CONCINO_INLINE std::vector<std::vector<double>> closed_cochains(const edge_complex& complex) {
  return cochain_search(complex).run();
}

}  // namespace concino::detail
