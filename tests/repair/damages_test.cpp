// Random damages of the meshes of the corpus are mended.
#include <support/damages.hpp>

#include <doctest/doctest.h>

using namespace concino::testing;

TEST_CASE("repair: random damages of the small meshes of the corpus") {
  if (corpus_meshes().empty()) return skip("no corpus");
  const std::size_t done = damage_corpus(3000, 1);
  MESSAGE(done, " damages");
  CHECK(done > 80);
}
