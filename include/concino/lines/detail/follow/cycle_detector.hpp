// Recognises that a line closes, repeats a cycle, or winds to a cycle or into a vert.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace concino::detail {

/// The side of a triangle by which a line enters: its poly, and the number of the side among those of the poly's
/// triangles. Or a vert: its index, and `at_vert`.
struct entry_key {
  static constexpr std::size_t at_vert = SIZE_MAX;
  std::size_t element = SIZE_MAX, side = 0;
  friend bool operator==(const entry_key&, const entry_key&) = default;
};

/// How the place s on an entered side, in [0, 1], depends on the place on the side entered before: scale * s + shift,
/// off by at most `error_bound`.
struct entry_step {
  double scale = 1, shift = 0, error_bound = 0;
  std::size_t pivot = SIZE_MAX;  // the index of the vert in which both sides meet
};

/// The map from the place on a side entered earlier to the place on the last one, and for which places the line passes
/// the same sides.
class return_map {
 public:
  double scale = 1, shift = 0, error = 0, low = 0, high = 1;

  void follow(const entry_step& next);
};

/// Follows the sides and verts that a line passes. The place on a side depends on the place when the line passed it
/// before by an affine map x -> a x + b: a line that returns to the same place is closed, and it converges to the
/// fixed point if |a| < 1. The place is compared with one of the sides or verts passed, the mark, which moves on after
/// 1, 2, 4, 8, ... steps (Brent 1980, "An improved Monte Carlo factorization algorithm"): no list of what was passed is
/// searched, and a cycle is noticed after at most three times the steps that the line takes to it and once round it.
class cycle_detector {
 public:
  enum class finding { none, repeats, winds_to_cycle, winds_into_vert };

  void start() { *this = {}; }

  /// Called at each side entered, at place s in [0, 1] and point x, after num_points points of the line.
  finding at_side(const entry_key& key, double s, const vec3& x, const entry_step& step, std::size_t num_points);
  /// Called at a side entered instead of at_side, if the line gets no point there.
  void follow(const entry_step& step);
  /// Called at each face of a volume entered: only a return but for rounding is noticed.
  finding at_face(const entry_key& key, const vec3& x, std::size_t num_points);
  /// Called at each vert.
  finding at_vert(std::size_t vert, std::size_t num_points);

  /// Of a finding: the number of points once round, the fixed place on the side where the round began, the factor
  /// of the map of one round, and the vert.
  std::size_t period() const { return period_; }
  double fixed_parameter() const { return fixed_; }
  double contraction_factor() const { return mark_.map.scale; }
  std::size_t vert() const { return pivot_; }

 private:
  struct mark {
    entry_key key;
    double s = 0;
    vec3 x;
    return_map map;
    std::size_t num_points = 0;
  };

  mark mark_;
  bool passed_vert_ = false;    // since the mark
  bool same_pivot_ = true;      // since the mark
  std::size_t pivot_ = SIZE_MAX, steps_ = 0, next_move_ = 1, period_ = 0;  // steps since the mark
  double fixed_ = 0;

  void set_mark(const entry_key& key, double s, const vec3& x, std::size_t num_points);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/follow/cycle_detector.ipp>
#endif
