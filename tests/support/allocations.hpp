// Counts the calls of operator new and their bytes, to test whether code copies a mesh. Only in programs that link support/allocations.cpp.
#pragma once

#include <cstddef>

namespace concino::testing {

struct allocations {
  std::size_t count = 0, bytes = 0;
  friend allocations operator-(allocations a, allocations b) { return {a.count - b.count, a.bytes - b.bytes}; }
  friend bool operator==(allocations, allocations) = default;
};

/// The allocations since the program started.
allocations allocated_so_far();

/// The allocations during f().
template<class F>
allocations allocated_by(F&& f) {
  const allocations before = allocated_so_far();
  f();
  return allocated_so_far() - before;
}

}  // namespace concino::testing
