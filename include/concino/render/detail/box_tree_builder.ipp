// The tree of box_tree_tracer.hpp is built.
#pragma once

#include <concino/core/box_tree_builder.hpp>
#include <concino/core/error.hpp>
#include <concino/render/box_tree_tracer.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace concino {

/// Groups the triangles, and joins the binary nodes to nodes of eight children.
struct box_tree_caster::builder {
  struct binary_node {
    float min[3], max[3];
    std::uint32_t first, count;

    float half_area() const {
      const float x = max[0] - min[0], y = max[1] - min[1], z = max[2] - min[2];
      return x * y + y * z + z * x;
    }
  };
  static constexpr float inf = std::numeric_limits<float>::infinity();

  const triangle_soup& soup;
  box_tree_caster& result;

  builder(const triangle_soup& triangles, box_tree_caster& tree) : soup(triangles), result(tree) {}

  std::vector<core::box_item> items;
  std::vector<binary_node> binary;
  std::vector<std::array<float, 8>> costs;
  std::array<std::uint32_t, 8> group{};
  std::uint32_t group_size = 0;

  void add_items() {
    core::reserve_large(items, soup.triangles.size());
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
      core::box_item item{{inf, inf, inf}, {-inf, -inf, -inf}, static_cast<std::uint32_t>(i)};
      bool finite = true;
      for (const std::uint32_t p : soup.triangles[i]) {
        if (p >= soup.points.size()) core::throw_joined<invalid_argument>({"box_tree_tracer: triangle ", i, " names point ", p, " of ", soup.points.size()});
        for (std::size_t k = 0; k < 3; ++k) {
          const float x = soup.points[p][k];
          finite = finite && std::isfinite(x);
          item.min[k] = std::min(item.min[k], x);
          item.max[k] = std::max(item.max[k], x);
        }
      }
      if (finite) items.push_back(item);
    }
  }

  void add_boxes() {
    for (std::size_t i = binary.size(); i-- > 0;) {
      binary_node& n = binary[i];
      std::fill_n(n.min, 3, inf);
      std::fill_n(n.max, 3, -inf);
      const auto add = [&](const float (&low)[3], const float (&high)[3]) {
        for (std::size_t k = 0; k < 3; ++k) n.min[k] = std::min(n.min[k], low[k]), n.max[k] = std::max(n.max[k], high[k]);
      };
      for (std::uint32_t k = n.first; k < n.first + n.count; ++k) add(items[k].min, items[k].max);
      if (n.count == 0)
        for (const std::uint32_t c : {n.first, n.first + 1}) add(binary[c].min, binary[c].max);
    }
  }

  std::uint32_t add_block(const binary_node& n) {
    block b;
    const float none = std::numeric_limits<float>::quiet_NaN();
    for (std::uint32_t k = 0; k < 4; ++k) {
      const bool used = k < n.count;
      b.triangle[k] = used ? items[n.first + k].id : ray_hit::none;
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t axis = 0; axis < 3; ++axis) b.corner[c][axis][k] = used ? soup.points[soup.triangles[b.triangle[k]][c]][axis] : none;
    }
    result.blocks_.push_back(b);
    return static_cast<std::uint32_t>(result.blocks_.size() - 1) | is_block;
  }

  /// How to divide j subtrees between the two children of an inner node for the least cost.
  struct division {
    std::uint32_t left = 1;
    float cost = inf;

    division(const builder& b, const binary_node& n, std::uint32_t j) {
      for (std::uint32_t k = 1; k < j; ++k)
        if (const float c = b.costs[n.first][k - 1] + b.costs[n.first + 1][j - k - 1]; c < cost) left = k, cost = c;
    }
  };

  /// costs[n][j - 1]: the expected cost of a query below binary node n, if at most j of its descendants, or n itself, are children of one node.
  /// Source: Ylitie, Karras and Laine 2017, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs".
  void add_costs() {
    costs.resize(binary.size());
    for (std::size_t i = binary.size(); i-- > 0;) {
      const binary_node& n = binary[i];
      costs[i].fill(n.half_area());
      if (n.count > 0) continue;
      costs[i][0] += division(*this, n, 8).cost;
      for (std::uint32_t j = 2; j <= 8; ++j) costs[i][j - 1] = std::min(costs[i][j - 2], division(*this, n, j).cost);
    }
  }

  /// The nodes that are at most j children of one node instead of binary node n.
  void add_children(std::uint32_t n, std::uint32_t j) {
    while (j > 1 && costs[n][j - 1] == costs[n][j - 2]) --j;
    if (j == 1 || binary[n].count > 0) {
      group[group_size++] = n;
      return;
    }
    const std::uint32_t left = division(*this, binary[n], j).left;
    add_children(binary[n].first, left);
    add_children(binary[n].first + 1, j - left);
  }

  /// The node of eight children for binary node `from`.
  void fill(std::uint32_t at, std::uint32_t from) {
    group_size = 0;
    if (binary[from].count > 0) {
      group[group_size++] = from;
    } else {
      const std::uint32_t left = division(*this, binary[from], 8).left;
      add_children(binary[from].first, left);
      add_children(binary[from].first + 1, 8 - left);
    }
    const std::uint32_t size = group_size;
    for (std::uint32_t k = 0; k < 8; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        result.nodes_[at].bounds[2 * axis][k] = k < size ? binary[group[k]].min[axis] : inf;
        result.nodes_[at].bounds[2 * axis + 1][k] = k < size ? binary[group[k]].max[axis] : -inf;
      }
      std::uint32_t child = 0;
      if (k < size && binary[group[k]].count > 0) child = add_block(binary[group[k]]);
      else if (k < size) {
        child = static_cast<std::uint32_t>(result.nodes_.size());
        result.nodes_.emplace_back();
        later.push_back({child, group[k]});
      }
      result.nodes_[at].child[k] = child;
    }
  }

  struct task {
    std::uint32_t node, from;
  };
  std::vector<task> later;

  void run() {
    if (soup.triangles.size() >= is_block) throw unsupported("box_tree_tracer: more than 2^31 triangles");
    add_items();
    if (items.empty()) return;
    binary = core::box_tree_builder<binary_node>(items, 4)();
    add_boxes();
    add_costs();
    std::copy_n(binary[0].min, 3, result.low_.begin());
    std::copy_n(binary[0].max, 3, result.high_.begin());
    std::size_t leaves = 0;
    for (const binary_node& n : binary) leaves += n.count > 0;
    result.blocks_.reserve(leaves);
    result.nodes_.reserve(leaves / 4 + 1);
    result.nodes_.emplace_back();
    later.push_back({0, 0});
    while (!later.empty()) {
      const task t = later.back();
      later.pop_back();
      fill(t.node, t.from);
    }
  }
};

CONCINO_INLINE box_tree_caster::box_tree_caster(const triangle_soup& soup) { builder(soup, *this).run(); }

}  // namespace concino
