// Defines what tubes.hpp declares: cross-sections along polylines.
#pragma once

#include <concino/render/detail/shapes/shape_size.hpp>
#include <concino/render/detail/shapes/tube_builder.hpp>
#include <concino/render/tubes.hpp>

#include <algorithm>
#include <cmath>

namespace concino::detail {

CONCINO_INLINE void check_tube_options(const flat_lines& lines, const tube_options& o, const char* caller) {
  check_shape_option(o.radius >= 0 && std::isfinite(o.radius), caller, "the radius must be finite, and positive or 0",
                     o.radius);
  check_shape_option(o.opacity >= 0 && o.opacity <= 1, caller, "the opacity must be in [0, 1]", o.opacity);
  check_shape_option(o.corners == 0 || (o.corners >= 3 && o.corners <= 256), caller, "corners must be 0 or 3 to 256",
                     o.corners);
  check_shape_option(o.tolerance >= 0 && std::isfinite(o.tolerance), caller,
                     "the tolerance must be finite, and positive or 0", o.tolerance);
  const std::size_t n = lines.points.size(), num_lines = lines.ends.size(), num_values = o.values.size();
  if (num_values != 0 && num_values != n && num_values != num_lines)
    core::throw_joined<invalid_argument>({caller, ": ", num_values, " values for ", num_lines, " lines with ", n,
                                          " points: give one for each point or one for each line"});
  if (!o.radii.empty() && o.radii.size() != n)
    core::throw_joined<invalid_argument>(
        {caller, ": ", o.radii.size(), " radii for ", n, " points: give one for each point"});
  check_radii(caller, o.radii);
  for (std::size_t line = 0, i = 0; line < num_lines; ++line)
    for (const std::size_t first = i; i < lines.ends[line]; ++i)
      if (!is_finite(lines.points[i]))
        core::throw_joined<invalid_argument>(
            {caller, ": point ", i - first, " of line ", line,
             " has a coordinate that is not a finite number: leave it out, or divide the line there"});
}

/// Draws lines, one at a time, with a tube_builder.
class line_tracer {
  static constexpr double sharp = 0.43633231299858239;  // 25 degrees
  static constexpr std::size_t longest = 64;            // points at most are left out at a time

  const flat_lines& lines_;
  const tube_options& options_;
  double radius_, value_step_ = 0;
  tube_builder build_;
  std::vector<std::uint32_t> kept_;  // the points that are not left out, of all lines
  std::vector<std::size_t> ends_;    // of the lines in kept_
  std::vector<vec3> directions_;     // of the segments of the line
  std::span<const std::uint32_t> line_;  // the points of the line
  bool closed_ = false;

  bool by_line() const { return options_.values.size() != lines_.points.size(); }
  const vec3& point(std::size_t i) const { return lines_.points[i]; }
  double radius(std::size_t i) const { return options_.radii.empty() ? radius_ : options_.radii[i]; }
  bool has_values() const { return !options_.values.empty(); }
  double value(std::size_t i) const { return options_.values[i]; }

  /// Whether a tube from point a to b is as good as one through the points between them.
  bool is_straight(std::size_t a, std::size_t b) const {
    const vec3 along = point(b) - point(a);
    const double length = norm(along);
    if (!(length > 0)) return false;
    const vec3 d = along / length;
    double before = 0;
    for (std::size_t i = a + 1; i < b; ++i) {
      const vec3 x = point(i) - point(a);
      const double t = dot(x, d), limit = options_.tolerance * radius(i);
      if (t < before - limit || t > length + limit || norm(x - d * t) > limit) return false;
      const double part = t / length;
      if (std::abs(radius(a) + part * (radius(b) - radius(a)) - radius(i)) > limit) return false;
      if (has_values() && !by_line() && !(std::abs(value(a) + part * (value(b) - value(a)) - value(i)) <= value_step_))
        return false;
      before = t;
    }
    return true;
  }

  /// Keeps the points of a line that differ from those before them and that a straight tube would not pass as well.
  void choose_points(std::size_t first, std::size_t last, bool is_closed) {
    const std::size_t start = kept_.size();
    const auto is_near = [&](std::size_t a, std::size_t b) { return distance(point(a), point(b)) <= 1e-6 * radius(b); };
    for (std::size_t i = first; i < last; ++i)
      if (kept_.size() == start || !is_near(kept_.back(), i)) kept_.push_back(static_cast<std::uint32_t>(i));
    while (is_closed && kept_.size() > start + 1 && is_near(kept_.back(), kept_[start])) kept_.pop_back();
    const std::size_t n = kept_.size() - start;
    if (options_.tolerance == 0 || n < 3) return;
    const std::size_t most = is_closed ? std::min(longest, n / 3) : longest;  // a closed line keeps three points
    const std::span<std::uint32_t> all(kept_.data() + start, n);
    std::size_t size = 1;
    for (std::size_t i = 0; i + 1 < n;) {
      std::size_t next = i + 1;
      while (next + 1 < n && next + 1 - i <= most && is_straight(all[i], all[next + 1])) ++next;
      all[size++] = all[next];
      i = next;
    }
    kept_.resize(start + size);
  }

  /// Reads the points of a line that are kept, and the directions of its segments.
  void read(std::size_t line) {
    const std::size_t first = line == 0 ? 0 : ends_[line - 1];
    line_ = {kept_.data() + first, ends_[line] - first};
    closed_ = lines_.closed[line] != 0 && line_.size() > 2;
    directions_.clear();
    for (std::size_t k = 0; k + (closed_ ? 0 : 1) < line_.size(); ++k) {
      const vec3 along = point(line_[k + 1 < line_.size() ? k + 1 : 0]) - point(line_[k]);
      directions_.push_back(along / norm(along));
    }
  }

  /// The number of rings of the line.
  std::size_t count_rings() const {
    std::size_t rings = closed_ ? 1 + static_cast<std::size_t>(steps(directions_.back(), directions_[0]))
                                : 1 + 2 * build_.cap_rings() + !directions_.empty();
    for (std::size_t k = 1; k < directions_.size(); ++k)
      rings += 1 + static_cast<std::size_t>(steps(directions_[k - 1], directions_[k]));
    return rings;
  }

  /// The frame at the start of the first segment, and the angle by which frames turn on the way round a closed line.
  double holonomy(const tube_frame& f) const {
    tube_frame g = f;
    for (std::size_t k = 1; k <= directions_.size(); ++k) g = rotated(g, directions_[k == directions_.size() ? 0 : k]);
    return std::atan2(dot(g.u, f.v), dot(g.u, f.u));
  }

  int steps(const vec3& a, const vec3& b) const {
    const double angle = angle_between(a, b);
    return angle > sharp ? static_cast<int>(std::ceil(angle / sharp)) : 0;
  }

  void start_at(std::size_t i) {
    if (has_values() && !by_line()) build_.set_value(value(i));
  }

  void connect(std::uint32_t a, std::uint32_t b, std::size_t from, std::size_t to) {
    const double change = radius(to) - radius(from);
    if (change == 0) return build_.connect(a, b);
    const vec3 along = point(to) - point(from);
    const double length = norm(along);
    build_.connect(a, b, along / length, change / length);
  }

  void draw_open() {
    const std::uint32_t first = line_.front();
    start_at(first);
    tube_frame f = frame_along(directions_.empty() ? vec3{0, 0, 1} : directions_[0]);
    std::uint32_t last = build_.begin_cap(point(first), radius(first), f);
    for (std::size_t k = 0; k < directions_.size(); ++k) {
      const std::uint32_t i = line_[k + 1];
      start_at(i);
      if (k + 1 == directions_.size()) {
        const std::uint32_t next = build_.ring(point(i), radius(i), f);
        connect(last, next, line_[k], i);
        last = next;
      } else {
        last = draw_joint(last, line_[k], i, f, directions_[k + 1], 0, 0);
        f = rotated(f, directions_[k + 1]);
      }
    }
    build_.end_cap(last, point(line_.back()), radius(line_.back()), f);
  }

  /// One ring at a joint, or several where the line turns much. `omitted` rings at the end of a closed line are those
  /// at its start.
  std::uint32_t draw_joint(std::uint32_t last, std::size_t from, std::size_t at, const tube_frame& f, const vec3& to,
                           double twist, int omitted) {
    const int n = steps(f.d, to);
    for (int k = 0; k + omitted <= n; ++k) {
      const tube_frame g = rotated(f, to, n == 0 ? 0.5 : static_cast<double>(k) / n);
      const std::uint32_t next = build_.ring(point(at), radius(at), twisted(g, twist));
      if (k == 0) connect(last, next, from, at);
      else build_.connect(last, next);
      last = next;
    }
    return last;
  }

  void draw_closed() {
    const std::size_t n = directions_.size();
    tube_frame f = frame_along(directions_[0]);
    const double turn = holonomy(f);
    double length = 0, so_far = 0;
    for (std::size_t k = 0; k < n; ++k) length += distance(point(line_[k]), point(line_[(k + 1) % n]));
    start_at(line_[0]);
    const bool is_sharp = steps(directions_.back(), directions_[0]) > 0;
    const std::uint32_t first =
        build_.ring(point(line_[0]), radius(line_[0]), is_sharp ? f : rotated(f, directions_.back(), 0.5));
    std::uint32_t last = first;
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t end = (k + 1) % n;
      so_far += distance(point(line_[k]), point(line_[end]));
      start_at(line_[end]);
      const std::uint32_t before = last;
      last = draw_joint(last, line_[k], line_[end], f, directions_[end], -turn * so_far / length, end == 0 ? 1 : 0);
      if (end == 0 && last == before) connect(last, first, line_[k], line_[0]);
      else if (end == 0) build_.connect(last, first);
      f = rotated(f, directions_[end]);
    }
  }

 public:
  line_tracer(drawable& to, const flat_lines& lines, const tube_options& options, double radius, int corners)
      : lines_(lines), options_(options), radius_(radius), build_(to, corners, !options.values.empty()) {
    const value_scale range = value_scale::linear(options.values);
    value_step_ = (range.high() - range.low()) / 256;
    to.look.scale = options.scale.value_or(range);
  }

  void draw_all(const char* caller) {
    std::size_t first = 0, rings = 0, caps = 0;
    for (std::size_t line = 0; line < lines_.ends.size(); ++line) {
      choose_points(first, lines_.ends[line], lines_.closed[line] != 0);
      first = lines_.ends[line];
      ends_.push_back(kept_.size());
      read(line);
      if (line_.empty()) continue;
      rings += count_rings();
      caps += closed_ ? 0 : 2;
    }
    build_.reserve(caller, rings, caps);
    for (std::size_t line = 0; line < ends_.size(); ++line) {
      read(line);
      if (line_.empty()) continue;
      build_.begin(line);
      if (has_values() && by_line()) build_.set_value(value(line));
      if (closed_) draw_closed();
      else draw_open();
    }
  }
};

CONCINO_INLINE drawable tubes_along(const flat_lines& lines, const tube_options& options, const char* caller) {
  check_tube_options(lines, options, caller);
  const std::size_t n = lines.points.size();
  const int corners = options.corners > 0 ? options.corners : n <= 4000 ? 12 : n <= 40000 ? 8 : 6;
  drawable d;
  d.look.color = options.color;
  d.look.map = options.map;
  d.look.opacity = options.opacity;
  line_tracer(d, lines, options, shape_radius(options.radius, 0.004, lines.points), corners).draw_all(caller);
  return d;
}

}  // namespace concino::detail
