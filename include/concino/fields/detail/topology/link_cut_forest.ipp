// Trees that are joined and divided; see link_cut_forest.hpp.
#pragma once

#include <concino/fields/detail/topology/link_cut_forest.hpp>

#include <utility>

namespace concino::detail {

CONCINO_INLINE link_cut_forest::link_cut_forest(std::vector<std::uint32_t> weights)
    : nodes_(weights.size()), weight_(std::move(weights)) {
  for (std::uint32_t x = 0; x < nodes_.size(); ++x) nodes_[x] = {none, {none, none}, x, false};
}

CONCINO_INLINE void link_cut_forest::set_weight(std::uint32_t x, std::uint32_t weight) { weight_[x] = weight; }

CONCINO_INLINE bool link_cut_forest::is_path_root(std::uint32_t x) const {
  const std::uint32_t p = nodes_[x].parent;
  return p == none || (nodes_[p].child[0] != x && nodes_[p].child[1] != x);
}

CONCINO_INLINE void link_cut_forest::push(std::uint32_t x) {
  if (!nodes_[x].reversed) return;
  std::swap(nodes_[x].child[0], nodes_[x].child[1]);
  for (const std::uint32_t c : nodes_[x].child)
    if (c != none) nodes_[c].reversed = !nodes_[c].reversed;
  nodes_[x].reversed = false;
}

CONCINO_INLINE void link_cut_forest::update(std::uint32_t x) {
  std::uint32_t best = x;
  for (const std::uint32_t c : nodes_[x].child)
    if (c != none && weight_[nodes_[c].lightest] < weight_[best]) best = nodes_[c].lightest;
  nodes_[x].lightest = best;
}

CONCINO_INLINE void link_cut_forest::rotate(std::uint32_t x) {
  const std::uint32_t p = nodes_[x].parent, g = nodes_[p].parent;
  const int side = nodes_[p].child[1] == x;
  if (!is_path_root(p)) nodes_[g].child[nodes_[g].child[1] == p] = x;
  const std::uint32_t inner = nodes_[x].child[1 - side];
  nodes_[p].child[side] = inner;
  if (inner != none) nodes_[inner].parent = p;
  nodes_[x].child[1 - side] = p;
  nodes_[p].parent = x;
  nodes_[x].parent = g;
  update(p);
}

CONCINO_INLINE void link_cut_forest::splay(std::uint32_t x) {
  path_.clear();
  std::uint32_t y = x;
  path_.push_back(y);
  while (!is_path_root(y)) path_.push_back(y = nodes_[y].parent);
  for (std::size_t k = path_.size(); k-- > 0;) push(path_[k]);
  while (!is_path_root(x)) {
    const std::uint32_t p = nodes_[x].parent;
    if (!is_path_root(p)) {
      const std::uint32_t g = nodes_[p].parent;
      rotate((nodes_[p].child[0] == x) == (nodes_[g].child[0] == p) ? p : x);
    }
    rotate(x);
  }
  update(x);
}

/// Makes the path from the root of the tree to x one splay tree, with x as its root.
CONCINO_INLINE void link_cut_forest::expose(std::uint32_t x) {
  std::uint32_t below = none;
  for (std::uint32_t y = x; y != none; y = nodes_[y].parent) {
    splay(y);
    nodes_[y].child[1] = below;
    update(y);
    below = y;
  }
  splay(x);
}

CONCINO_INLINE void link_cut_forest::make_root(std::uint32_t x) {
  expose(x);
  nodes_[x].reversed = !nodes_[x].reversed;
  push(x);
}

CONCINO_INLINE std::uint32_t link_cut_forest::root(std::uint32_t x) {
  expose(x);
  std::uint32_t y = x;
  for (push(y); nodes_[y].child[0] != none; push(y)) y = nodes_[y].child[0];
  splay(y);
  return y;
}

CONCINO_INLINE std::uint32_t link_cut_forest::lightest_between(std::uint32_t a, std::uint32_t b) {
  if (a == b) return a;
  make_root(a);
  expose(b);
  return nodes_[a].parent == none ? none : nodes_[b].lightest;
}

CONCINO_INLINE void link_cut_forest::link(std::uint32_t a, std::uint32_t b) {
  make_root(a);
  nodes_[a].parent = b;
}

CONCINO_INLINE void link_cut_forest::cut(std::uint32_t a, std::uint32_t b) {
  make_root(a);
  expose(b);
  nodes_[nodes_[b].child[0]].parent = none;
  nodes_[b].child[0] = none;
  update(b);
}

}  // namespace concino::detail
