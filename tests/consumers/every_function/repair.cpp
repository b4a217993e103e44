#include "call.hpp"

#include <concino/repair.hpp>

void call_repair() {
  call("repair", [](auto& m) { cn::repair(m, {.merge_within = 0.0}); }, all);
  call("repaired", [](auto& m) { cn::repaired(m); }, all);
  call("is_left", [] { cn::is_left(cn::repair_kind::open_cell); });
}
