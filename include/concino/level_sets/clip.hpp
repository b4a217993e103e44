// clip and split: a mesh, cut along a level set or a plane.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/level_sets/detail/level_values.hpp>
#include <concino/level_sets/detail/surface_clipper.hpp>
#include <concino/level_sets/detail/volume_clipper.hpp>

namespace concino {

namespace detail {

template<class M, class U>
auto clip_mesh(const M& m, const U& u, double level, bool both, const clip_options& options, const char* caller) {
  check_vert_values(m, u, caller);
  sort_levels({level}, caller);
  report_progress(options.progress, 0, "clipping");
  if constexpr (dimension_v<M> == 2) return surface_clipper<M, U>(m, u, level, both, caller).run(options, caller);  // polygons are cut by chords, polyhedra by caps
  else return volume_clipper<M, U>(m, u, level, both, caller).run(options, caller);
}

}  // namespace detail

template<EmbeddedMesh M, class U>
  requires requirement::gives_numbers<U, vert_t<M>>
auto clip(const M& m, const U& u, double value, const clip_options& options = {}) {
  return detail::clip_mesh(m, u, value, false, options, "clip");
}

template<EmbeddedMesh M, class U>
  requires requirement::gives_numbers<U, vert_t<M>>
auto split(const M& m, const U& u, double value, const clip_options& options = {}) {
  return detail::clip_mesh(m, u, value, true, options, "split");
}

}  // namespace concino
