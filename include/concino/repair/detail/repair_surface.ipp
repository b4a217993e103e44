// Bodies of repair_surface.hpp: the order of the steps.
#pragma once

#include <concino/repair/detail/repair_surface.hpp>
#include <concino/repair/detail/surface_steps.hpp>

namespace concino::detail {

CONCINO_INLINE repaired_arrays<surface_arrays> repair_surface(surface_arrays a, std::uint32_t arity,
                                                              const repair_options& options, repair_log& log) {
  double done = 0;
  const auto step = [&] { report_progress(options.progress, done += 0.1, "repair"); };
  surface_lists s = lists_of(std::move(a));
  if (options.merge_within) merge_verts_within(s, *options.merge_within, log);
  step();
  cut_at_repeated_verts(s, arity, log);
  if (options.remove_duplicates) remove_duplicate_polys(s, log);
  step();
  mend_degenerate(s, options.degenerate, arity, log);
  const std::vector<std::uint8_t> marked = mend_intersections(s, options.intersecting, log);
  step();
  std::vector<std::uint8_t> marked_now = marked;
  if (options.split_non_manifold) {
    split_into_fans(s, log);
    for (std::size_t v = marked_now.size(); !marked.empty() && v < s.points.size(); ++v)
      marked_now.push_back(marked[s.vert_origin[v]]);
  }
  step();
  if (options.orient) orient_polys(s, log);
  step();
  if (fill_holes(s, options.fill_holes, marked_now, options.filling, arity, log)) {
    if (options.orient) orient_polys(s, log);
    if (!marked.empty()) mend_intersections(s, intersecting_triangles::report, log);
  }
  step();
  log_turned(s, log);
  return arrays_of_lists(std::move(s), arity, options.remove_unreferenced, log);
}

}  // namespace concino::detail
