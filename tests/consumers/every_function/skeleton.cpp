#include "call.hpp"

#include <concino/generate/icosphere.hpp>
#include <concino/skeleton.hpp>

void call_skeleton() {
  const cn::skeleton k({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{cn::vert_id{0}, cn::vert_id{1}}, {cn::vert_id{1}, cn::vert_id{2}}}, {0.1, 0.1, 0.1});
  const auto b = cn::bones(k);
  call("leaves", [](auto& m) { cn::leaves(m); }, all);
  call("joints", [](auto& m) { cn::joints(m); }, all);
  call("bones", [](auto& m) { cn::bones(m); }, all);
  call("bones", [&] { cn::bones(k, cn::make_vert_map<double>(k, 1.0)); });
  call("length", [&] { cn::length(b[0]); });
  call("sample", [&] { cn::sample(b[0], 0.5); });
  call("respace", [](auto& m) { cn::respace(m, 0.1); }, all);
  call("split_bone", [&] { cn::split_bone(k, b[0], 0.3); });
  call("tube", [](auto& m) { cn::tube(m, {.radius = 0.1}); }, all);
  call("nearest_bone", [&](auto& m) { cn::nearest_bone(m, b); }, all);
  call("skeleton_of", [] { cn::skeleton_of(cn::icosphere(2)); });
}
