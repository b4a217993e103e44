// Bodies of frame_turns.hpp: the turn of frames around a face.
#pragma once

#include <concino/directions/detail/frames/frame_turns.hpp>

#include <cmath>
#include <cstddef>

namespace concino::detail {

CONCINO_INLINE int valence_of_loop(std::span<const orthonormal_frame> frames, const vec3& normal) {
  orthonormal_frame current = frames[0];
  double turned = 0;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const orthonormal_frame next = turned_to(frames[(k + 1) % frames.size()], current);
    for (const std::size_t a : {0u, 1u, 2u}) turned += dot(cross(current[a], next[a]), normal);
    current = next;
  }
  // The turn is one of the 24 rotations of a cube: its matrix in the first frame has entries 0, 1 and -1.
  int trace = 0, fixed = 0;
  for (const std::size_t a : {0u, 1u, 2u}) {
    const int entry = static_cast<int>(std::lround(dot(frames[0][a], current[a])));
    trace += entry, fixed += entry == 1;
  }
  if (trace == 3) return 4;
  if (fixed != 1) return 0;
  const int quarters = trace == 1 ? 1 : 2;
  return turned > 0 ? 4 - quarters : 4 + quarters;
}

}  // namespace concino::detail
