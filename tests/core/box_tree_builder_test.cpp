#include <concino/core/box_tree_builder.hpp>

#include <doctest/doctest.h>

#include <random>
#include <vector>

using concino::core::box_item;

namespace {

struct node {
  std::uint32_t first, count;
};

std::vector<box_item> random_items(std::size_t n, bool same_place) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<box_item> items;
  for (std::uint32_t i = 0; i < n; ++i) {
    const float x = same_place ? 0 : unit(random), y = same_place ? 0 : unit(random);
    items.push_back({{x, y, 0}, {x + 0.01f, y + 0.01f, 0}, i});
  }
  return items;
}

}  // namespace

TEST_CASE("box_tree_builder: every item is in one leaf, leaves are small, and children follow their parents") {
  for (const bool same_place : {false, true})
    for (const std::size_t n : {0u, 1u, 4u, 5u, 5000u}) {
      auto items = random_items(n, same_place);
      const auto nodes = concino::core::box_tree_builder<node>(items, 4)();
      std::vector<int> ids(n, 0), parents(nodes.size(), 0), places(n, 0);
      for (std::uint32_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].count == 0) {
          REQUIRE(nodes[i].first > i);
          REQUIRE(nodes[i].first + 1 < nodes.size());
          ++parents[nodes[i].first];
          ++parents[nodes[i].first + 1];
        } else {
          CHECK(nodes[i].count <= 4);
          REQUIRE(nodes[i].first + nodes[i].count <= n);
          for (std::uint32_t k = 0; k < nodes[i].count; ++k) ++places[nodes[i].first + k];
        }
      }
      for (const box_item& item : items) ++ids[item.id];
      CHECK(ids == std::vector<int>(n, 1));
      CHECK(places == std::vector<int>(n, 1));
      std::vector<int> expected(nodes.size(), 1);
      if (!nodes.empty()) expected[0] = 0;
      CHECK(parents == expected);
    }
}
