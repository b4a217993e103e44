// Places evenly spaced lines one after another.
#pragma once

#include <concino/concepts/oriented_edges.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/geometry/normals.hpp>
#include <concino/lines/detail/follow/follow_field.hpp>
#include <concino/lines/detail/follow/line_samples.hpp>
#include <concino/lines/trace_geodesic.hpp>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

template<class M, class G>
class spaced_lines {
  const M* m_;
  double distance_, test_, min_length_;
  std::size_t max_steps_;
  line_walker<M, G> walker_;
  prepared_trace_geodesic<M> sideways_;
  line_samples<M> samples_;
  std::vector<char> is_kept_;  // by attempt
  std::size_t attempt_ = 0;
  std::vector<field_line<M>> lines_;
  std::vector<std::size_t> visited_;  // by poly: the number of the last search that came there
  std::vector<poly_t<M>> queue_;
  std::size_t search_ = 0;

 public:
  spaced_lines(const M& m, const field_reader<M, G>& field, double distance, double test, double min_length,
               std::size_t max_steps)
      : m_(&m), distance_(distance), test_(test), min_length_(min_length), max_steps_(max_steps), walker_(m, field),
        sideways_(prepare_trace_geodesic(m)), samples_(distance + test / 8), visited_(poly_index_bound(m), 0) {}

  std::vector<field_line<M>> take() { return std::move(lines_); }

  /// A line through the point, if it is far enough from all others, then others beside it, and so on.
  void fill_from(const mesh_point<M>& seed) {
    std::size_t next = lines_.size();
    try_line(seed);
    for (; next < lines_.size(); ++next) seed_beside(next);
  }

 private:
  static const poly_t<M>* poly_of(const mesh_point<M>& x) { return std::get_if<poly_t<M>>(&x.element); }

  /// Whether a point in one poly is joined to another poly within a ball round the point.
  bool are_joined(const vec3& x, const poly_t<M>& from, const poly_t<M>& to, double radius) {
    if (from == to) return true;
    ++search_;
    queue_.assign(1, from);
    visited_[index_of(*m_, from)] = search_;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const poly_t<M> p = queue_[i];
      for (const auto& [e, a, b] : oriented_edges(*m_, p)) {
        if (concino::distance(closest_point(x, to_vec3(point(*m_, a)), to_vec3(point(*m_, b))), x) >= radius) continue;
        for (const poly_t<M> q : adj_e2p(*m_, e)) {
          std::size_t& visited = visited_[index_of(*m_, q)];
          if (visited == search_) continue;
          visited = search_;
          if (q == to) return true;
          queue_.push_back(q);
        }
      }
    }
    return false;
  }

  /// Whether no other line is near; if `of_itself` is there, it is called for near places of the same attempt that are
  /// not near along the line.
  bool is_free(const vec3& x, const poly_t<M>& p, double radius, double arc,
               function_ref<bool(const line_sample<M>&)> of_itself) {
    return !samples_.any_near(x, radius, [&](const line_sample<M>& s) {
      if (s.line != attempt_) return is_kept_[s.line] != 0 && are_joined(x, p, s.poly, radius);
      return std::abs(s.arc - arc) >= 3 * distance_ && are_joined(x, p, s.poly, radius) && of_itself(s);
    });
  }

  double longest_sample() const { return test_ / 4; }

  /// Where between a free place and one that is not the free ones end.
  template<class F>
  static double last_free(double from, double to, const F& is_free_at) {
    for (int i = 0; i < 20; ++i) {
      const double middle = 0.5 * (from + to);
      (is_free_at(middle) ? from : to) = middle;
    }
    return from;
  }

  /// One part of a line. Where it runs straight into itself it goes on for a while, so that it is seen whether it is
  /// closed.
  field_line<M> follow(const mesh_point<M>& seed, double sense) {
    field_line<M> line;
    double arc = 0, distance_to_itself = std::numeric_limits<double>::infinity();
    const auto limit = [&](const vec3& a, const vec3& b, const poly_t<M>& p) {
      const double step = concino::distance(a, b);
      const auto n = static_cast<std::size_t>(std::ceil(step / longest_sample()));
      bool runs_into_itself = false;
      const auto of_itself = [&](const line_sample<M>& s, const vec3& x) {
        const vec3 d = closest_point(x, s.from, s.to) - x, along = (b - a) / step;
        runs_into_itself = norm(d - dot(d, along) * along) < 0.05 * distance_;
        return !runs_into_itself;
      };
      const auto is_free_at = [&](double t) {
        const vec3 x = a + t * (b - a);
        return is_free(x, p, test_, sense * (arc + t * step), [&](const line_sample<M>& s) { return of_itself(s, x); });
      };
      for (std::size_t k = 0; k < n; ++k) {
        const double from = static_cast<double>(k) / static_cast<double>(n),
                     to = static_cast<double>(k + 1) / static_cast<double>(n), here = arc + to * step;
        const auto add_up_to = [&](double t) {
          samples_.add({a + from * (b - a), a + t * (b - a), p, attempt_, sense * (arc + 0.5 * (from + t) * step)});
        };
        runs_into_itself = false;
        if (!is_free_at(to)) {
          const double end = last_free(from, to, is_free_at);
          add_up_to(end);
          return end;
        }
        if (!runs_into_itself) {
          add_up_to(to);
          continue;
        }
        distance_to_itself = std::min(distance_to_itself, here);
        if (here > distance_to_itself + 2 * distance_) return to;
      }
      arc += step;
      return 1.0;
    };
    line_recorder<M> to(line, max_steps_, limit);
    run(walker_, seed, sense, to);
    if (line.stopped_by != line_end::closed && line.length > distance_to_itself) to.shorten(distance_to_itself);
    return line;
  }

  void try_line(const mesh_point<M>& seed) {
    const poly_t<M>* const p = poly_of(seed);
    attempt_ = is_kept_.size();
    const auto never = [](const line_sample<M>&) { return false; };
    if (!p || !is_free(seed.position, *p, distance_ * (1 - 1e-9), 0, never)) return;
    is_kept_.push_back(1);
    samples_.add({seed.position, seed.position, *p, attempt_, 0});
    const mesh_point<M> start = lowest_element_of(*m_, seed, "evenly_spaced_lines", "seed");
    field_line<M> line = follow(start, 1);
    if (line.stopped_by != line_end::closed) line = joined(follow(start, -1), line);
    is_kept_[attempt_] = line.length >= min_length_;
    if (is_kept_[attempt_]) lines_.push_back(std::move(line));
  }

  /// Seeds on both sides of a line, once a distance along it.
  void seed_beside(std::size_t number) {
    const std::size_t n = lines_[number].polys.size();
    double arc = 0, next = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const field_line<M>& line = lines_[number];
      const vec3 a = line.points[i].position, b = line.points[(i + 1) % line.points.size()].position;
      const poly_t<M> p = line.polys[i];
      const double step = concino::distance(a, b);
      const vec3 side = cross(normal(*m_, p), b - a);
      for (; step > 0 && next <= arc + step; next += distance_) {
        const vec3 x = a + (next - arc) / step * (b - a);
        for (const double sense : {1.0, -1.0}) {
          const traced_geodesic<M> t = sideways_.trace_from(mesh_point<M>{p, x}, sense * side, distance_);
          if (t.stopped_by == line_end::max_length) try_line(t.points.back());
        }
      }
      arc += step;
    }
  }
};

}  // namespace concino::detail
