// Handles of a deformation and their positions, as arrays by index of verts, with checks.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/compiled.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/deform/detail/arap/arap_problem.hpp>
#include <concino/deform/detail/cages/weighted_sums.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace concino::detail {

[[noreturn, gnu::cold]] void throw_no_handle_vert(const char* caller);
[[noreturn, gnu::cold]] void throw_other_position(const char* caller, std::size_t vert);
[[noreturn, gnu::cold]] void throw_not_a_handle(std::size_t vert);
[[noreturn, gnu::cold]] void throw_no_handles(const char* caller);
[[noreturn, gnu::cold]] void throw_no_position(std::size_t vert);
/// Errors: invalid_argument if max_iterations is negative, or tolerance is not from 0 to 1.
void check_limits(int max_iterations, double tolerance);

/// Errors: invalid_mesh if one is no vert of m.
template<class M, class V>
std::vector<std::size_t> handle_indices(const M& m, const V& handles, const char* caller) {
  std::vector<std::size_t> all;
  for (const vert_t<M> v : handles) {
    if (!contains(m, v)) throw_no_handle_vert(caller);
    all.push_back(index_of(m, v));
  }
  return all;
}

/// Handles with their positions, each once, in the order of the list.
template<class M>
struct placed_handles {
  std::vector<vert_t<M>> vert;
  std::vector<std::uint32_t> index;
  std::vector<vec3> position;
};

/// Errors: invalid_argument if there are none, a position is not finite, or a vert is given two different ones;
///         invalid_mesh if a vert is none of m.
template<class M, class D>
placed_handles<M> place_handles(const M& m, const D& positions, const char* caller) {
  placed_handles<M> all;
  std::vector<std::uint32_t> place(vert_index_bound(m));  // in all, counted from 1
  for (const auto& [vert, position] : positions) {
    const vert_t<M> v = vert;
    if (!contains(m, v)) throw_no_handle_vert(caller);
    const std::size_t i = index_of(m, v);
    const vec3 x = to_vec3(position);
    if (!is_finite(x)) throw_point_not_finite(caller, "the position of vert", i);
    if (place[i] > 0) {
      if (all.position[place[i] - 1] != x) throw_other_position(caller, i);
      continue;
    }
    all.vert.push_back(v);
    all.index.push_back(static_cast<std::uint32_t>(i));
    all.position.push_back(x);
    place[i] = static_cast<std::uint32_t>(all.vert.size());
  }
  if (all.vert.empty()) throw_no_handles(caller);
  return all;
}

/// Positions by index; those of other verts are the origin.
/// Errors: see prepared_deform::with_positions.
template<class M, class D>
std::vector<vec3> handle_positions(const M& m, const D& positions, const arap_problem& problem) {
  constexpr double unset = std::numeric_limits<double>::quiet_NaN();
  std::vector<vec3> all(vert_index_bound(m));
  for (const std::uint32_t i : problem.handles()) all[i].x = unset;
  for (const auto& [vert, position] : positions) {
    const vert_t<M> v = vert;
    if (!contains(m, v)) throw_no_handle_vert("with_positions");
    const std::size_t i = index_of(m, v);
    const vec3 x = to_vec3(position);
    if (!problem.is_handle(i)) throw_not_a_handle(i);
    if (!is_finite(x)) throw_point_not_finite("with_positions", "the position of vert", i);
    if (all[i].x == all[i].x && all[i] != x) throw_other_position("with_positions", i);
    all[i] = x;
  }
  for (const std::uint32_t i : problem.handles())
    if (all[i].x != all[i].x) throw_no_position(i);
  return all;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/deform/detail/arap/handle_positions.ipp>
#endif
