// Follows a field that is given at verts and interpolated inside polys, by the Runge-Kutta method of order 4.
#pragma once

#include <concino/lines/detail/cells/polygon_reader.hpp>
#include <concino/lines/detail/cells/polyhedron_reader.hpp>
#include <concino/lines/detail/cells/value_in_poly.hpp>
#include <concino/lines/detail/follow/follow_field.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <variant>

namespace concino::detail {

/// The same vector in each poly, which can be changed.
struct one_vector {
  vec3 value;
  template<class P>
  const vec3& operator[](const P&) const { return value; }
};

/// Errors: invalid_argument, naming the vert whose vector is not finite, or if the step is out of its range.
template<class M, class H>
class vert_field_reader {
  const H* h_;
  double step_, scale_ = 1;

 public:
  template<class Field>
  vert_field_reader(const M& m, const Field& field, const char* caller) : h_(field.values), step_(field.step) {
    if (!(step_ >= 0) || !std::isfinite(step_))
      core::throw_joined<invalid_argument>({caller, ": the step must be finite and at least 0"});
    double most = 0;
    for (const vert_t<M> v : verts(m)) {
      const vec3 x = to_vec3((*h_)[v]);
      if (!is_finite(x))
        core::throw_joined<invalid_argument>(
            {caller, ": the vector at vert ", index_of(m, v), " is not finite; give each vert a finite vector"});
      most = std::max({most, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
    }
    if (most > 0) scale_ = std::ldexp(1.0, -std::clamp(std::ilogb(most), -1022, 1022));
  }
  double step() const { return step_; }
  vec3 operator[](const vert_t<M>& v) const { return scale_ * to_vec3((*h_)[v]); }
};

template<class M, class H>
class vert_field_walker {
  using reader = typename std::conditional_t<dimension_v<M> == 2, std::type_identity<polygon_reader<M>>,
                                             std::type_identity<polyhedron_reader<M>>>::type;

  const M* m_;
  vert_field_reader<M, H> field_;
  one_vector direction_;
  line_walker<M, one_vector> straight_;
  reader cell_;
  mesh_point<M> x_ = {vert_t<M>(), {}};
  double sense_ = 1, part_ = 1;  // part_: of the step; small where the field turns back
  vec3 before_;

 public:
  vert_field_walker(const M& m, const vert_field_reader<M, H>& field)
      : m_(&m), field_(field), straight_(m, field_reader<M, one_vector>(direction_)) {}
  vert_field_walker(const vert_field_walker&) = delete;

  void start(const mesh_point<M>& start, double sense, line_recorder<M>& to) {
    to.start(start);
    sense_ = sense;
    x_ = start;
    before_ = {};
    part_ = 1;
  }

  /// Needs: !to.done().
  void step(line_recorder<M>& to) {
    const double step = part_ * (field_.step() > 0 ? field_.step() : size_at(x_) / 4);
    const vec3 d = sense_ * direction_at(x_, sense_, step);
    if (d == vec3() || !(step > 0)) return to.stop(line_end::zero);
    if (dot(d, before_) < 0 || norm(d) < 0.5) {
      part_ /= 4;
      before_ = {};
      if (part_ < 1e-3) to.stop(line_end::sink);
      return;
    }
    part_ = std::min(1.0, 1.5 * part_);
    before_ = d;
    const field_line<M> segment = walk(x_, d, step * norm(d));
    for (std::size_t i = 0; i < segment.polys.size() && !to.done(); ++i)
      to.add(segment.points[i + 1], segment.polys[i]);
    if (segment.stopped_by != line_end::max_length) return to.stop(segment.stopped_by);
    x_ = segment.points.back();
  }

 private:
  field_line<M> walk(const mesh_point<M>& x, const vec3& d, double length) {
    field_line<M> line;
    line_recorder<M> to(line, length, 10'000);
    direction_.value = d / norm(d);
    run(straight_, lowest_element_of(*m_, x, "integral_line", "start"), 1, to);  // a step may end on an edge
    return line;
  }

  /// The mean of four directions: short where they differ. Or 0 if the field is 0 at one of their places.
  vec3 direction_at(const mesh_point<M>& x, double sense, double step) {
    vec3 k = value_at(x), sum;
    for (int i = 0; i < 4; ++i) {
      const double n = norm(k);
      if (!(n > 0)) return {};
      sum += (i == 1 || i == 2 ? 2 : 1) * (k / n);
      if (i < 3) k = value_at(walk(x, sense * k, i < 2 ? step / 2 : step).points.back());
    }
    return sum / 6;
  }

  vec3 value_at(const mesh_point<M>& x) {
    if (const auto* v = std::get_if<vert_t<M>>(&x.element)) return field_[*v];
    if (const auto* e = std::get_if<edge_point<M>>(&x.element)) {
      const auto [a, b] = end_verts(*m_, e->edge);
      return (1 - e->parameter) * field_[a] + e->parameter * field_[b];
    }
    cell_.read(*m_, *poly_at(x));
    return value_in_poly(cell_, x.position, field_);
  }
  /// A poly at a place, if there is one.
  std::optional<poly_t<M>> poly_at(const mesh_point<M>& x) const {
    std::optional<poly_t<M>> first;
    for_each_poly_at(*m_, x, [&](const poly_t<M>& p) {
      if (!first) first = p;
    });
    return first;
  }

  /// The largest distance of a corner of the poly from its first one; 0 at verts and edges without polys.
  double size_at(const mesh_point<M>& x) {
    const auto p = poly_at(x);
    if (!p) return 0;
    cell_.read(*m_, *p);
    double size = 0;
    for (const vec3& y : cell_.corner_points()) size = std::max(size, distance(y, cell_.corner_points()[0]));
    return size;
  }
};

}  // namespace concino::detail
