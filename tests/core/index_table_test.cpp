#include <concino/core/index_table.hpp>

#include <doctest/doctest.h>

#include <map>
#include <random>
#include <vector>

using concino::core::index_table;

TEST_CASE("index_table: finds the numbers that were added, and no others") {
  std::mt19937 random(3);
  for (const unsigned different : {5u, 40u, 5000u}) {
    index_table table;
    std::vector<unsigned> keys;
    std::map<unsigned, std::uint32_t> oracle;
    for (int i = 0; i < 20000; ++i) {
      const auto key = static_cast<unsigned>(random() % different);
      const std::uint32_t hash = index_table::hash(key), found = table.find(hash, [&](std::uint32_t k) { return keys[k] == key; });
      REQUIRE(found == (oracle.count(key) ? oracle[key] : index_table::none));
      if (found != index_table::none) continue;
      oracle[key] = static_cast<std::uint32_t>(keys.size());
      table.add(hash, oracle[key]);
      keys.push_back(key);
    }
    CHECK(table.size() == oracle.size());
  }
}

TEST_CASE("index_table: values with the same hash are told apart, and all are forgotten by clear()") {
  index_table table;
  for (std::uint32_t i = 0; i < 100; ++i) table.add(7, i);
  for (std::uint32_t i = 0; i < 100; ++i) CHECK(table.find(7, [i](std::uint32_t k) { return k == i; }) == i);
  CHECK(table.find(8, [](std::uint32_t) { return true; }) == index_table::none);
  table.clear();
  CHECK(table.size() == 0);
  CHECK(table.find(7, [](std::uint32_t) { return true; }) == index_table::none);
}
