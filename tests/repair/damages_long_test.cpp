// A thousand random damages of the meshes of the corpus are mended.
#include <support/damages.hpp>

#include <doctest/doctest.h>

using namespace concino::testing;

TEST_CASE("repair: a thousand random damages of meshes of less than 100,000 polys") {
  if (corpus_meshes().empty()) return skip("no corpus");
  std::size_t done = damage_corpus(99999, 101);
  for (unsigned seed = 102; seed < 150 && done < 1000; ++seed) done += damage_corpus(6000, seed);
  MESSAGE(done, " damages");
  CHECK(done >= 1000);
}
