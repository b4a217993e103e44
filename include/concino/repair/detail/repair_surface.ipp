// Bodies of repair_surface.hpp: the order of the steps, and the origins of what they leave.
#pragma once

#include <concino/repair/detail/repair_surface.hpp>
#include <concino/repair/detail/surface_steps.hpp>
#include <concino/repair/detail/vert_origins.hpp>

#include <numeric>

namespace concino::detail {

inline surface_lists lists_of(surface_arrays a) {
  surface_lists s;
  s.points = std::move(a.points);
  s.offsets = std::move(a.offsets);
  s.verts.reserve(a.verts.size());
  for (const vert_id v : a.verts) s.verts.push_back(v.raw());
  s.poly_origin.resize(s.num_polys());
  std::iota(s.poly_origin.begin(), s.poly_origin.end(), 0u);
  s.is_turned.resize(s.num_polys());
  s.vert_origin.resize(s.points.size());
  std::iota(s.vert_origin.begin(), s.vert_origin.end(), 0u);
  s.cluster = s.vert_origin;
  return s;
}

/// The surface without verts that have become others, and if wished without those of no poly.
inline repaired_arrays<surface_arrays> arrays_of(surface_lists s, std::uint32_t arity, bool remove_unreferenced,
                                                 repair_log& log) {
  repaired_arrays<surface_arrays> result;
  const std::vector<std::uint32_t> number =
      number_verts(s.points, s.vert_origin, s.cluster, s.verts, remove_unreferenced, log);
  result.verts = origins_of_verts(number, s.vert_origin, s.cluster, s.of_new_verts);
  result.polys = element_origins(std::move(s.poly_origin));
  surface_arrays& a = result.arrays;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != surface_lists::none) a.points.push_back(s.points[v]);
  a.verts.reserve(s.verts.size());
  for (const std::uint32_t v : s.verts) a.verts.push_back(vert_id{number[v]});
  a.arity = arity;
  if (arity == 0) a.offsets = std::move(s.offsets);
  result.cluster = std::move(s.cluster);
  return result;
}

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
  return arrays_of(std::move(s), arity, options.remove_unreferenced, log);
}

}  // namespace concino::detail
