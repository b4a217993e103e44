// What operator new was asked for, counted: whether something copies a mesh shows in it. Only in programs that link support/allocations.cpp.
#pragma once

#include <cstddef>

namespace concino::testing {

struct allocations {
  std::size_t count = 0, bytes = 0;
  friend allocations operator-(allocations a, allocations b) { return {a.count - b.count, a.bytes - b.bytes}; }
  friend bool operator==(allocations, allocations) = default;
};

/// Since the program began.
allocations allocated_so_far();

/// While f ran.
template<class F>
allocations allocated_by(F&& f) {
  const allocations before = allocated_so_far();
  f();
  return allocated_so_far() - before;
}

}  // namespace concino::testing
