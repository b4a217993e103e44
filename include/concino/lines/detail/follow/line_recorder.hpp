// Collects the points of one line and stops it at its greatest length or number of steps.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/function_ref.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/lines/field_line.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace concino::detail {

/// Says how much of a segment from a to b in a poly a line may have: a part in [0, 1].
template<class M>
using segment_limit = function_ref<double(const vec3& a, const vec3& b, const poly_t<M>& p)>;

template<class M>
class line_recorder {
 public:
  /// What `to` contains is removed, but its memory is kept.
  line_recorder(field_line<M>& to, double max_length, std::size_t max_steps)
      : line_(&to), max_length_(max_length), max_steps_(max_steps) {
    to.points.clear();
    to.polys.clear();
    to.cycle.clear();
    to.length = 0;
  }
  line_recorder(field_line<M>& to, std::size_t max_steps, segment_limit<M> limit)
      : line_recorder(to, std::numeric_limits<double>::infinity(), max_steps) {
    limit_ = limit;
  }

  void start(const mesh_point<M>& x) { line_->points.push_back(x); }
  bool done() const { return done_; }
  std::size_t steps() const { return line_->polys.size(); }
  std::size_t num_points() const { return line_->points.size(); }
  const vec3& last() const { return line_->points.back().position; }
  const field_line<M>& line() const { return *line_; }

  void stop(line_end why) {
    if (done_) return;
    line_->stopped_by = why;
    done_ = true;
  }

  /// Adds the segment to x. If it is too long, it is cut.
  void add(const mesh_point<M>& x, const poly_t<M>& p) {
    const double step = distance(last(), x.position);
    line_->polys.push_back(p);
    if (limit_) {
      const double part = limit_(last(), x.position, p);
      if (part < 1) {
        if (part > 0) start({p, last() + part * (x.position - last())});
        else line_->polys.pop_back();
        line_->length += part * step;
        if (!close_at_start()) stop(line_end::too_close);
        return;
      }
    }
    if (line_->length + step >= max_length_) {
      const vec3 end = line_->length + step > max_length_
                           ? last() + (max_length_ - line_->length) / step * (x.position - last())
                           : x.position;
      start(end == x.position ? x : mesh_point<M>{p, end});
      line_->length = max_length_;
      if (!close_at_start()) stop(line_end::max_length);
      return;
    }
    start(x);
    line_->length += step;
    if (steps() >= max_steps_ && !close_at_start()) stop(line_end::max_steps);
  }

  /// The last `period` points are a closed line that repeats. If it contains the start, the line is closed; else the
  /// way to the cycle is kept.
  void repeat(std::size_t period) {
    if (close_at_start()) return;
    const auto& x = line_->points;
    std::size_t first = x.size() - 1 - period;
    while (first > 0 && x[first - 1].position == x[first - 1 + period].position) --first;
    const auto begin = x.begin() + static_cast<std::ptrdiff_t>(first);
    line_->cycle.assign(begin, begin + static_cast<std::ptrdiff_t>(period));
    cut(first + 1, first);
    stop(line_end::winds_to_cycle);
  }

  void end_in_cycle(std::vector<mesh_point<M>> cycle) {
    line_->cycle = std::move(cycle);
    stop(line_end::winds_to_cycle);
  }

  /// Of a line that spirals into a vert, `more` long.
  void end_at(const mesh_point<M>& x, const poly_t<M>& p, double more) {
    line_->polys.push_back(p);
    start(x);
    line_->length += more;
    stop(line_end::sink);
  }
  /// Leaves out what comes after this length.
  void shorten(double length) {
    while (line_->points.size() > 2 && line_->length - last_step() > length) {
      line_->length -= last_step();
      line_->points.pop_back();
      line_->polys.pop_back();
    }
    const double step = last_step(), rest = length - (line_->length - step);
    if (!(rest < step)) return;
    const vec3 from = at(num_points() - 2), end = from + rest / step * (last() - from);
    line_->points.back() = {line_->polys.back(), end};
    line_->length = length;
  }
  double remaining_length() const { return max_length_ - line_->length; }

 private:
  field_line<M>* line_;
  double max_length_;
  std::size_t max_steps_;
  segment_limit<M> limit_ = {};
  bool done_ = false;

  const vec3& at(std::size_t i) const { return line_->points[i].position; }
  double last_step() const { return distance(at(num_points() - 2), last()); }

  /// If the line passed through its start again, in the same poly, keeps once round.
  bool close_at_start() {
    const vec3 x = at(0);
    double size = 0;
    for (const std::size_t k : {0u, 1u, 2u}) size = std::max(size, std::abs(x[k]));
    const double nearly = 1e-12 * (size + (num_points() > 1 ? distance(x, at(1)) : 0));
    for (std::size_t i = 1; i < line_->polys.size(); ++i) {
      if (!(line_->polys[i] == line_->polys[0]) || distance(closest_point(x, at(i), at(i + 1)), x) > nearly) continue;
      close(distance(at(i), x) <= nearly ? i : i + 1);
      return true;
    }
    const std::size_t end = num_points() - 1;
    if (end == 0 || !(at(end) == x) || line_->points[end].element.index() != 0 || line_->points[0].element.index() != 0)
      return false;
    close(end);  // a vert
    return true;
  }
  /// Keeps the first points, and joins the last of them to the first one.
  void close(std::size_t num_points) {
    cut(num_points, num_points);
    line_->length += distance(last(), at(0));
    stop(line_end::closed);
  }
  void cut(std::size_t num_points, std::size_t num_segments) {
    line_->points.resize(num_points, line_->points.front());
    line_->polys.resize(num_segments, line_->polys.front());
    line_->length = 0;
    for (std::size_t i = 0; i + 1 < num_points; ++i) line_->length += distance(at(i), at(i + 1));
    done_ = false;
  }
};

}  // namespace concino::detail
