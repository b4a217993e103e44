// evenly_spaced_lines: lines along a field that cover a surface, about equally far apart.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/core/profiler.hpp>
#include <concino/lines/detail/follow/spaced_lines.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace concino {

struct evenly_spaced_lines_options {
  double distance = 0;                // between lines, above 0, in units of the mesh
  double stops_below = 0.5;           // a line ends where another one is nearer than this part of the distance; above
                                      // 0, at most 1
  double min_length = 0;              // shorter lines are left out; 0 means the distance
  std::size_t max_steps = 0;          // of each line both ways from its first point, as in integral_line_options
  concino::progress progress = {};    // called now and then with the part of the seeds that were tried
  concino::profiler* profiler = nullptr;  // measures the call and its steps
};

namespace detail {

template<class M, class G>
std::vector<field_line<M>> find_spaced_lines(const M& m, const G& g, const std::vector<poly_t<M>>& seeds,
                                             const evenly_spaced_lines_options& options) {
  constexpr const char* caller = "evenly_spaced_lines";
  const core::profiled_options profiled(options, caller);
  const evenly_spaced_lines_options& o = *profiled;
  if (!(o.distance > 0) || !std::isfinite(o.distance))
    core::throw_joined<invalid_argument>(
        {caller, ": distance is ", core::number_text(o.distance), "; it must be above 0 and finite"});
  if (!(o.stops_below > 0 && o.stops_below <= 1))
    core::throw_joined<invalid_argument>(
        {caller, ": stops_below is ", core::number_text(o.stops_below), "; it must be above 0 and at most 1"});
  if (!(o.min_length >= 0))
    core::throw_joined<invalid_argument>(
        {caller, ": min_length is ", core::number_text(o.min_length), "; it must be at least 0"});
  const field_reader<M, G> field(m, g, caller);
  spaced_lines<M, G> all(m, field, o.distance, o.stops_below * o.distance, o.min_length > 0 ? o.min_length : o.distance,
                         o.max_steps ? o.max_steps : 16 * num_polys(m) + 1000);
  std::size_t done = 0;
  for (const poly_t<M>& p : seeds) {
    if (done++ % 1024 == 0)
      report_progress(o.progress, static_cast<double>(done - 1) / static_cast<double>(seeds.size()), caller);
    all.fill_from({p, nearest_mesh_point(m, p, centroid(m, p), caller).position});
  }
  return all.take();
}

}  // namespace detail

/// Lines along a field that cover a surface evenly: auto lines = evenly_spaced_lines(m, g, {.distance = 0.05}). Each
/// new line begins at the distance from a line found before, and ends where it comes nearer to another one than a part
/// of it, by 1 % of that part at most.
/// Needs:  Embedded SurfaceMesh, not a temporary; g as in integral_line. density[p], if given, a number of each poly:
///         lines begin at the polys with the greatest ones; else in the order of polys(m).
/// Result: lines as integral_line gives them both ways, with line_end::too_close where another line stopped them. No
///         point of the surface is much farther from a line than the distance, but where lines would be shorter than
///         min_length. Distances are those in space, between points that the surface joins within a ball of the
///         distance round one of them. So sheets that only lie close to each other do not count. Where the surface is
///         flat, they are distances along it.
/// Cost:   O(total length / distance x polys within the distance), and integral_line for each line and each seed.
/// Errors: as integral_line; invalid_argument if an option is out of its range, or a density is NaN. invalid_mesh as
///         trace_geodesic. cancelled.
/// Source: Jobard, Lefer 1997, "Creating evenly-spaced streamlines of arbitrary density".
template<class M, class G>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> && requirement::gives_points<G, poly_t<M>>
auto evenly_spaced_lines(M&& m, const G& g, const evenly_spaced_lines_options& options) {
  using mesh = std::remove_cvref_t<M>;
  std::vector<poly_t<mesh>> seeds;
  for (const poly_t<mesh> p : polys(m)) seeds.push_back(p);
  return detail::find_spaced_lines<mesh>(m, g, seeds, options);
}
template<class M, class G, class D>
  requires SurfaceMesh<M> && Embedded<M> && requirement::is_lvalue_or_view<M> &&
      requirement::gives_points<G, poly_t<M>> && requirement::gives_numbers<D, poly_t<M>>
auto evenly_spaced_lines(M&& m, const G& g, const D& density, const evenly_spaced_lines_options& options) {
  using mesh = std::remove_cvref_t<M>;
  std::vector<poly_t<mesh>> seeds;
  for (const poly_t<mesh> p : polys(m)) {
    if (std::isnan(static_cast<double>(density[p])))
      core::throw_joined<invalid_argument>(
          {"evenly_spaced_lines: the density at poly ", index_of(m, p), " is not a number (NaN)"});
    seeds.push_back(p);
  }
  std::stable_sort(seeds.begin(), seeds.end(), [&](const poly_t<mesh>& a, const poly_t<mesh>& b) {
    return static_cast<double>(density[a]) > static_cast<double>(density[b]);
  });
  return detail::find_spaced_lines<mesh>(m, g, seeds, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void evenly_spaced_lines(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void evenly_spaced_lines(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void evenly_spaced_lines(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
