#include "call.hpp"

#include <concino/print.hpp>

void call_print() {
  call("overhangs", [](auto& m) { cn::overhangs(m, {.max_angle_deg = 60}); }, all);
  call("best_build_direction", [](auto& m) { cn::best_build_direction(m, {.samples = 1}); }, all);
  call("height_map", [](auto& m) { cn::height_map(m, {.resolution = 8}); }, all);
  call("thin_walls", [](auto& m) { cn::thin_walls(m, 2); }, all);
  call("narrow_gaps", [](auto& m) { cn::narrow_gaps(m, 2); }, all);
}
