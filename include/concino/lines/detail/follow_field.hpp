// Lines of one field from many starts: options and starts are checked, and lines found in parallel.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/large_pages.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/progress.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/lines/detail/surface_line_walker.hpp>
#include <concino/lines/detail/volume_line_walker.hpp>

#include <algorithm>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino {

namespace requirement {

template<class M, class S>
concept is_line_start = std::same_as<S, vert_t<M>> || std::same_as<S, poly_t<M>> || std::same_as<S, mesh_point<std::remove_cvref_t<M>>>;
template<class M, class R>
concept gives_line_starts = requires(const R& r) {
  { *r.begin() };
  r.end();
} && is_line_start<M, std::remove_cvref_t<decltype(*std::declval<const R&>().begin())>>;

}  // namespace requirement

namespace detail {

template<class M, class G>
using line_walker = typename std::conditional_t<dimension_v<M> == 2, std::type_identity<surface_line_walker<M, G>>, std::type_identity<volume_line_walker<M, G>>>::type;

/// An empty line with memory for points. Pages are requested at once: waiting for each of them takes longer than following a line through some polys.
template<class M>
field_line<M> line_with_memory(std::size_t num_points, std::size_t num_polys) {
  field_line<M> line;
  line.points.reserve(num_points);
  line.polys.reserve(num_polys);
  core::request_pages(line.points.data(), num_points * sizeof(mesh_point<M>));
  return line;
}

template<class M>
field_line<M> compact_copy(const field_line<M>& x) {
  field_line<M> line = line_with_memory<M>(x.points.size(), x.polys.size());
  line = x;
  return line;
}

/// The first part turned round, then the second one, from the same start.
template<class M>
field_line<M> joined(const field_line<M>& back, const field_line<M>& forward) {
  field_line<M> line = line_with_memory<M>(back.points.size() + forward.points.size() - 1, back.polys.size() + forward.polys.size());
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

/// Reader: of the field, from the mesh, what the caller passed and the caller's name. Walker: from the mesh and a reader.
template<class M, class Reader, class Walker>
class field_follower {
  static constexpr std::size_t lines_at_once = 16;

  const M* m_;
  const char* caller_;
  Reader field_;
  integral_line_options options_;
  std::size_t max_steps_;

 public:
  template<class G>
  field_follower(const M& m, const G& g, const integral_line_options& options, const char* caller)
      : m_(&m), caller_(caller), field_(m, g, caller), options_(options), max_steps_(options.max_steps) {
    if (!(options.max_length > 0)) core::throw_joined<invalid_argument>({caller, ": max_length must be above 0; leave it out to follow lines to their end"});
    if (max_steps_ == 0) max_steps_ = 16 * num_polys(m) + 1000;
  }

  template<class S>
  field_line<M> line(const S& start) const {
    Walker walker(*m_, field_);
    parts scratch;
    return follow(walker, place_of(start), scratch);
  }

  template<class R>
  std::vector<field_line<M>> lines(const R& starts) const {
    std::vector<mesh_point<M>> places;
    for (const auto& x : starts) places.push_back(place_of(x));
    std::vector<field_line<M>> found(places.size());
    const std::size_t chunks = (places.size() + lines_at_once - 1) / lines_at_once;
    const auto follow_chunk = [&](std::size_t c) {
      Walker walker(*m_, field_);
      parts scratch;
      for (std::size_t i = c * lines_at_once; i < std::min(places.size(), (c + 1) * lines_at_once); ++i) found[i] = follow(walker, places[i], scratch);
    };
    bool stopped = false;
    parallel_for(chunks, follow_chunk, 1, [&](double done) { return stopped = options_.progress && !options_.progress(done, caller_); });
    if (stopped) core::throw_joined<cancelled>({caller_, ": stopped by the progress callback"});
    return found;
  }

 private:
  template<class X>
  void check(const X& x, const char* kind) const {
    if (!contains(*m_, x)) core::throw_joined<invalid_mesh>({caller_, ": the start, ", kind, ' ', index_of(*m_, x), ", is no ", kind, " of the mesh"});
  }
  mesh_point<M> place_of(const vert_t<M>& v) const {
    check(v, "vert");
    return {v, to_vec3(point(*m_, v))};
  }
  mesh_point<M> place_of(const poly_t<M>& p) const {
    check(p, "poly");
    return {p, centroid(*m_, p)};
  }
  mesh_point<M> place_of(const mesh_point<M>& x) const {
    if (const auto* v = std::get_if<vert_t<M>>(&x.element)) return place_of(*v);
    if (const auto* e = std::get_if<edge_point<M>>(&x.element)) {
      check(e->edge, "edge");
      if (!(e->parameter >= 0 && e->parameter <= 1)) core::throw_joined<invalid_argument>({caller_, ": the start is on an edge, but its parameter is not in [0, 1]"});
      const auto [a, b] = end_verts(*m_, e->edge);
      const vec3 p = to_vec3(point(*m_, a)), q = to_vec3(point(*m_, b));
      return {*e, p + e->parameter * (q - p)};
    }
    if (!is_finite(x.position)) core::throw_joined<invalid_argument>({caller_, ": the position of the start is not finite"});
    if (const auto* p = std::get_if<poly_t<M>>(&x.element)) check(*p, "poly");
    return x;
  }

  /// Memory that grows with the lines: what is returned is copied from it, in memory of the right size.
  struct parts {
    field_line<M> forward, backward;
  };

  field_line<M> follow(Walker& walker, const mesh_point<M>& start, parts& scratch) const {
    const auto one_way = [&](double sense, field_line<M>& line) -> const field_line<M>& {
      line_recorder<M> to(line, options_.max_length, max_steps_);
      walker.run(start, sense, to);
      return line;
    };
    if (!options_.both_ways) return compact_copy(one_way(options_.backward ? -1 : 1, scratch.forward));
    const field_line<M>& forward = one_way(1, scratch.forward);
    return forward.stopped_by == line_end::closed ? compact_copy(forward) : joined(one_way(-1, scratch.backward), forward);
  }
};

template<class M, class G>
using poly_field_follower = field_follower<M, field_reader<M, G>, line_walker<M, G>>;

}  // namespace detail

}  // namespace concino
