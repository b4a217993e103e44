#include "call.hpp"

#include <concino/testing/conformance.hpp>

void call_testing() {
  call("conformance", [](auto& m) { cn::conformance([&] { return m; }, {.algorithms = false}); }, all);
}
