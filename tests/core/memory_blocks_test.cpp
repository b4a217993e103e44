#include <concino/core/memory_blocks.hpp>

#include <doctest/doctest.h>

using namespace concino::core;

TEST_CASE("memory_blocks: a block has room for the array, and for all of the call if that is not much") {
  memory_blocks blocks;
  const auto first = blocks.block_for(100, 10);
  CHECK(first->has_room(1000));
  CHECK(blocks.block_for(100, 10) == first);
  CHECK_FALSE(first->take(1000, 1) == nullptr);
  CHECK(first->take(1, 1) == nullptr);
  CHECK_FALSE(blocks.block_for(100, 10) == first);
  CHECK(blocks.block_for(10000000, 1000)->has_room(10000000));
  CHECK_FALSE(blocks.block_for(0, 0)->has_room(100000000));
}
