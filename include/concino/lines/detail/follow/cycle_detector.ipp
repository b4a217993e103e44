// Bodies of cycle_detector.hpp: recognises that a line on a surface closes, runs round a cycle, or winds to a cycle or
// into a vert.
#pragma once

#include <concino/lines/detail/follow/cycle_detector.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace concino::detail {

CONCINO_INLINE void return_map::follow(const entry_step& next) {
  constexpr double roundoff = 0x1p-52;
  error = std::abs(next.scale) * (error + 2 * roundoff * (std::abs(scale) + std::abs(shift))) +
          roundoff * std::abs(next.shift) + next.error_bound;
  shift = next.scale * shift + next.shift;
  scale *= next.scale;
  if (scale == 0) return;
  double from = -shift / scale, to = (1 - shift) / scale;
  if (scale < 0) std::swap(from, to);
  low = std::max(low, from);
  high = std::min(high, to);
}

CONCINO_INLINE void cycle_detector::set_mark(const entry_key& key, double s, const vec3& x, std::size_t num_points) {
  mark_ = {key, s, x, {}, num_points};
  steps_ = 0;
  passed_vert_ = false;
  same_pivot_ = true;
  pivot_ = SIZE_MAX;
  next_move_ *= 2;
}

CONCINO_INLINE void cycle_detector::follow(const entry_step& step) {
  ++steps_;
  mark_.map.follow(step);
  if (steps_ == 1) pivot_ = step.pivot;
  else if (pivot_ != step.pivot) same_pivot_ = false;
}

CONCINO_INLINE cycle_detector::finding cycle_detector::at_side(const entry_key& key, double s, const vec3& x,
                                                               const entry_step& step, std::size_t num_points) {
  if (mark_.key.element == SIZE_MAX) {
    set_mark(key, s, x, num_points);
    return finding::none;
  }
  follow(step);
  if (key == mark_.key) {
    period_ = num_points - mark_.num_points;
    const return_map& map = mark_.map;
    if (std::abs(s - mark_.s) <= map.error) return finding::repeats;
    if (!passed_vert_ && std::abs(map.scale) + map.error < 1) {
      if (same_pivot_ && pivot_ != SIZE_MAX) return finding::winds_into_vert;
      fixed_ = map.shift / (1 - map.scale);
      if (fixed_ > map.low && fixed_ < map.high && s >= map.low && s <= map.high) return finding::winds_to_cycle;
    }
  }
  if (steps_ >= next_move_) set_mark(key, s, x, num_points);
  return finding::none;
}

CONCINO_INLINE cycle_detector::finding cycle_detector::at_face(const entry_key& key, const vec3& x,
                                                               std::size_t num_points) {
  ++steps_;
  if (key == mark_.key) {
    const double size = std::max({std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    period_ = num_points - mark_.num_points;
    if (distance(x, mark_.x) <= 0x1p-50 * size * static_cast<double>(period_)) return finding::repeats;
  }
  if (mark_.key.element == SIZE_MAX || steps_ >= next_move_) set_mark(key, 0, x, num_points);
  return finding::none;
}

CONCINO_INLINE cycle_detector::finding cycle_detector::at_vert(std::size_t vert, std::size_t num_points) {
  const entry_key key = {vert, entry_key::at_vert};
  mark_.map = {};  // what comes does not depend on the place where the line was at the mark
  mark_.map.scale = 0;
  ++steps_;
  passed_vert_ = true;
  if (key == mark_.key) {
    period_ = num_points - mark_.num_points;
    return finding::repeats;
  }
  if (mark_.key.element == SIZE_MAX || steps_ >= next_move_) set_mark(key, 0, {}, num_points);
  return finding::none;
}

}  // namespace concino::detail
