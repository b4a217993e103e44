// Steps of curves on a surface that are taken in opposite directions, and so cancel.
#pragma once

#include <concino/core/compiled.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Step number `step` of a curve, between two verts.
struct vert_step {
  std::uint32_t from, to;
  std::uint32_t curve, step;
};

/// A step that cancels with another one: `other` is the position of that in the list.
struct cancelling_step {
  std::uint32_t curve, step;
  std::size_t other;
};

/// Pairs steps between the same verts in opposite directions. Result: by curve and step.
std::vector<cancelling_step> find_cancelling_steps(const std::vector<vert_step>& steps);

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/level_sets/detail/lines/cancelling_steps.ipp>
#endif
