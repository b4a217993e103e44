// What a stranger's first program may look like.
#include <concino/concepts/mesh.hpp>
#include <concino/error.hpp>

#include <cstdio>

int main() {
  static_assert(!concino::PrimalGraph<int>);
  try {
    throw concino::invalid_mesh("hello");
  } catch (const concino::error& e) {
    std::printf("%s\n", e.what());
  }
}
