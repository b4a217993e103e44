#include <concino/core/hash_bytes.hpp>

#include <doctest/doctest.h>

using namespace concino::core;

TEST_CASE("hash_bytes: has the published values of FNV-1a") {
  CHECK(hash_bytes("") == 0xcbf29ce484222325u);
  CHECK(hash_bytes("a") == 0xaf63dc4c8601ec8cu);
  CHECK(hash_bytes("foobar") == 0x85944171f73967e8u);
  CHECK(hash_text("a") == "af63dc4c8601ec8c");
  CHECK(hash_text("") == "cbf29ce484222325");
  CHECK(hash_text("10") == "07f89207b4ba08a4");
}
