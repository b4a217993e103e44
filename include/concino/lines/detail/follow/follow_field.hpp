// Lines of one field from many starts: options and starts are checked, and lines found in parallel.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/progress.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/lowest_element.hpp>
#include <concino/lines/detail/follow/surface_line_walker.hpp>
#include <concino/lines/detail/follow/volume_line_walker.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

namespace requirement {

template<class M, class S>
concept is_line_start =
    std::same_as<S, vert_t<M>> || std::same_as<S, poly_t<M>> || std::same_as<S, mesh_point<std::remove_cvref_t<M>>>;
template<class M, class R>
concept gives_line_starts = requires(const R& r) {
  { *r.begin() };
  r.end();
} && is_line_start<M, std::remove_cvref_t<decltype(*std::declval<const R&>().begin())>>;

}  // namespace requirement

namespace detail {

template<class M, class G>
using line_walker = typename std::conditional_t<dimension_v<M> == 2, std::type_identity<surface_line_walker<M, G>>,
                                                std::type_identity<volume_line_walker<M, G>>>::type;

/// The first part turned round, then the second one, from the same start.
template<class M>
field_line<M> joined(const field_line<M>& back, const field_line<M>& forward) {
  field_line<M> line;
  line.points.assign(back.points.rbegin(), back.points.rend());
  line.points.insert(line.points.end(), forward.points.begin() + 1, forward.points.end());
  line.polys.assign(back.polys.rbegin(), back.polys.rend());
  line.polys.insert(line.polys.end(), forward.polys.begin(), forward.polys.end());
  line.length = back.length + forward.length;
  line.began_by = back.stopped_by;
  line.stopped_by = forward.stopped_by;
  line.cycle = forward.cycle.empty() ? back.cycle : forward.cycle;
  return line;
}

/// Follows one line to its end.
template<class M, class Walker>
void run(Walker& walker, const mesh_point<M>& start, double sense, line_recorder<M>& to) {
  walker.start(start, sense, to);
  while (!to.done()) walker.step(to);
}

/// Reader: of the field, from the mesh, what the caller passed and the caller's name. Walker: from the mesh and a
/// reader.
template<class M, class Reader, class Walker>
class field_follower {
  static constexpr std::size_t lines_per_task = 16;

  const M* m_;
  const char* caller_;
  Reader field_;
  integral_line_options options_;
  std::size_t max_steps_;

 public:
  template<class G>
  field_follower(const M& m, const G& g, const integral_line_options& options, const char* caller)
      : m_(&m), caller_(caller), field_(m, g, caller), options_(options), max_steps_(options.max_steps) {
    if (!(options.max_length > 0))
      core::throw_joined<invalid_argument>(
          {caller, ": max_length must be above 0; leave it out to follow lines to their end"});
    if (max_steps_ == 0) max_steps_ = 16 * num_polys(m) + 1000;
  }

  template<class S>
  field_line<M> line(const S& start) const {
    Walker walker(*m_, field_);
    return follow(walker, place_of(start));
  }

  template<class R>
  std::vector<field_line<M>> lines(const R& starts) const {
    std::vector<mesh_point<M>> places;
    for (const auto& x : starts) places.push_back(place_of(x));
    std::vector<field_line<M>> found(places.size());
    const auto follow_some = [&](std::size_t task) {
      Walker walker(*m_, field_);
      const std::size_t first = task * lines_per_task, last = std::min(places.size(), first + lines_per_task);
      for (std::size_t i = first; i < last; ++i) found[i] = follow(walker, places[i]);
    };
    bool stopped = false;
    parallel_for((places.size() + lines_per_task - 1) / lines_per_task, follow_some, 1,
                 [&](double done) { return stopped = options_.progress && !options_.progress(done, caller_); });
    if (stopped) core::throw_joined<cancelled>({caller_, ": stopped by the progress callback"});
    return found;
  }

 private:
  mesh_point<M> place_of(const vert_t<M>& v) const { return place_of(mesh_point<M>{v, {}}); }
  mesh_point<M> place_of(const poly_t<M>& p) const {
    if (!contains(*m_, p)) return place_of(mesh_point<M>{p, {}});
    return nearest_mesh_point(*m_, p, centroid(*m_, p), caller_);
  }
  mesh_point<M> place_of(const mesh_point<M>& x) const { return lowest_element_of(*m_, x, caller_, "start"); }

  field_line<M> follow_part(Walker& walker, const mesh_point<M>& start, bool backward) const {
    field_line<M> line;
    line_recorder<M> to(line, options_.max_length, max_steps_);
    run(walker, start, backward ? -1 : 1, to);
    return line;
  }
  /// Of lines both ways, there is no second part if the first one is closed.
  field_line<M> follow(Walker& walker, const mesh_point<M>& start) const {
    field_line<M> line = follow_part(walker, start, !options_.both_ways && options_.backward);
    if (!options_.both_ways || line.stopped_by == line_end::closed) return line;
    return joined(follow_part(walker, start, true), line);
  }
};

template<class M, class G>
using poly_field_follower = field_follower<M, field_reader<M, G>, line_walker<M, G>>;

}  // namespace detail

}  // namespace concino
