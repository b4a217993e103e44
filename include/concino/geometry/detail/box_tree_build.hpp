// Builds a box_tree: groups the items in single precision, which affects only the speed of the tree, and adds the
// boxes.
#pragma once

#include <concino/core/box_tree_builder.hpp>
#include <concino/core/parallel.hpp>
#include <concino/geometry/detail/box_tree.hpp>

namespace concino::detail {

/// The tree of n items, at most leaf_size per leaf. box_of(i): the box of item i. order: the original index of each
/// item, by leaf.
template<class BoxOf>
box_tree build_box_tree(std::size_t n, std::uint32_t leaf_size, BoxOf&& box_of, std::vector<std::uint32_t>& order) {
  std::vector<core::box_item> items;
  items.reserve(n);
  items.resize(n);
  parallel_for(n, [&](std::size_t i) {
    const box b = box_of(i);
    for (std::size_t k = 0; k < 3; ++k) {
      items[i].min[k] = static_cast<float>(b.min[k]);
      items[i].max[k] = static_cast<float>(b.max[k]);
    }
    items[i].id = static_cast<std::uint32_t>(i);
  });
  std::vector<box_node> nodes = core::box_tree_builder<box_node>(items, leaf_size)();
  order.resize(n);
  parallel_for(n, [&](std::size_t i) { order[i] = items[i].id; }, 1 << 14);
  parallel_for(nodes.size(), [&](std::size_t i) {
    box_node& node = nodes[i];
    const box none;
    node.min = none.min;
    node.max = none.max;
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) node.add(box_of(order[k]));
  });
  for (std::size_t i = nodes.size(); i-- > 0;)
    if (nodes[i].count == 0)
      for (const std::uint32_t child : {nodes[i].first, nodes[i].first + 1})
        nodes[i].add({nodes[child].min, nodes[child].max});
  return box_tree(std::move(nodes));
}

}  // namespace concino::detail
