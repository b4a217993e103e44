#include <concino/core/compiled.hpp>

#include <doctest/doctest.h>

#include <string>

namespace {

CONCINO_INLINE std::string mode() {
#ifdef CONCINO_COMPILED
  return "compiled";
#else
  return "header-only";
#endif
}

}  // namespace

// tests/compiled/ checks that both forms link with each other, give the same results and reject other flags.
TEST_CASE("compiled: CONCINO_INLINE functions compile header-only and in the compiled library") { CHECK_FALSE(mode().empty()); }
