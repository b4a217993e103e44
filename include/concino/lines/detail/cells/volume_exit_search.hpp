// Searches the cells at a vert or an edge for the steepest exit of a line.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/lines/detail/cells/incident_cell.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>
#include <concino/lines/detail/cells/sliding_velocity.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace concino::detail {

/// The cells on both sides of a triangle.
struct incident_facet {
  incident_key key;
  std::size_t cell = 0, triangle = 0;
  int outward = 0;  // the sign of the field's part out of the cell
};

/// The ways on which a line can leave a vert or an edge, and the fastest of them.
class volume_exit_search {
  vec3 from_;
  std::span<const incident_cell> cells_;
  core::small_array<incident_facet, 32> facets_;
  volume_exit best_;
  double best_speed_ = 0;

 public:
  volume_exit_search(const vec3& from, std::span<const incident_cell> cells) : from_(from), cells_(cells) {
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (std::size_t t = 0; t < cells[c].triangles.size(); ++t) {
        const incident_triangle& x = cells[c].triangles[t];
        facets_.push_back({x.face, c, t, side_of_line(cells[c].field, x.a, x.b, from).sign});
      }
    std::sort(facets_.begin(), facets_.end(), [&](const incident_facet& x, const incident_facet& y) {
      return x.key != y.key ? x.key < y.key : lies_before(cells_[x.cell].field, cells_[y.cell].field);
    });
  }

  const volume_exit& best() const { return best_; }

  void keep_if_faster(volume_exit::kind to, std::size_t cell, std::size_t triangle, double speed, const vec3& velocity,
                      bool along_a = false) {
    if (!(speed > 0)) return;
    if (best_.to != volume_exit::kind::none &&
        (speed < best_speed_ || (speed == best_speed_ && !lies_before(velocity, best_.velocity))))
      return;
    best_ = {to, cell, triangle, along_a, velocity};
    best_speed_ = speed;
  }

  /// Calls f(facet, velocity) for each triangle along which the fields on its sides lead.
  template<class F>
  void for_each_slide(const F& f) const {
    for (std::size_t i = 0; i < facets_.size();) {
      std::size_t last = i + 1;
      while (last < facets_.size() && facets_[last].key == facets_[i].key) ++last;
      const incident_facet &one = facets_[i], &two = facets_[last - 1];
      const std::size_t n = last - i;
      i = last;
      if (n > 2) continue;
      const incident_triangle& t = triangle(one);
      const vec3 normal = cross(t.a - from_, t.b - from_);
      if (n == 2 && one.outward >= 0 && two.outward >= 0) {
        f(one, sliding_velocity(exit_speed(one), field(one), exit_speed(two), field(two), normal));
        continue;
      }
      if (one.outward == 0) f(one, field(one));
      if (n == 2 && two.outward == 0) f(two, field(two));
    }
  }

  const incident_triangle& triangle(const incident_facet& f) const { return cells_[f.cell].triangles[f.triangle]; }
  const vec3& field(const incident_facet& f) const { return cells_[f.cell].field; }
  double exit_speed(const incident_facet& f) const {
    return speed_through(field(f), from_, triangle(f).a, triangle(f).b);
  }

  bool leads_along_triangle(const incident_triangle& t, const vec3& velocity) const {
    const vec3 normal = cross(t.a - from_, t.b - from_);
    return side_in_plane(velocity, t.a, normal, from_).sign < 0 && side_in_plane(velocity, t.b, normal, from_).sign > 0;
  }

  /// Whether the field of a cell leads into it from the vert: g lies strictly inside the cone of its triangles.
  bool leads_into(const incident_cell& c) const {
    if (c.triangles.empty() || c.field == vec3()) return false;
    bool below_all = true;
    for (const incident_triangle& t : c.triangles)
      below_all = below_all && side_of_line(c.field, t.a, t.b, from_).sign < 0;
    if (below_all) return true;
    return !is_convex(c) && is_in_cone(c);
  }

  bool is_convex(const incident_cell& c) const {
    for (const incident_triangle& t : c.triangles)
      for (const incident_triangle& other : c.triangles)
        if (side_of_line(other.a - from_, t.a, t.b, from_).sign > 0) return false;
    return true;
  }

  bool is_on_triangle(const incident_triangle& t, const vec3& g) const {
    if (side_of_line(g, t.a, t.b, from_).sign != 0) return false;
    const vec3 normal = cross(t.a - from_, t.b - from_);
    const int a = side_in_plane(g, t.a, normal, from_).sign, b = side_in_plane(g, t.b, normal, from_).sign;
    return a <= 0 && b >= 0 && a != b;
  }

  /// Of a cone, the triangle to whose plane g is the least parallel.
  const incident_triangle& steepest_triangle(const incident_cell& c) const {
    const auto slope = [&](const incident_triangle& t) {
      const double n = norm(cross(t.a - from_, t.b - from_));
      return n > 0 ? std::abs(side_of_line(c.field, t.a, t.b, from_).value) / n : 0;
    };
    return *std::max_element(c.triangles.begin(), c.triangles.end(),
                             [&](const auto& t, const auto& u) { return slope(t) < slope(u); });
  }

  /// For a cone that is not convex: counts the triangles that the arc from g to the middle of one of them crosses. g
  /// may lie in the planes of others.
  bool is_in_cone(const incident_cell& c) const {
    const vec3& g = c.field;
    for (const incident_triangle& t : c.triangles)
      if (is_on_triangle(t, g)) return false;
    const incident_triangle& first = steepest_triangle(c);
    const vec3 middle = (first.a - from_) / norm(first.a - from_) + (first.b - from_) / norm(first.b - from_),
               normal = cross(g, middle);
    const auto height = [&](const vec3& p) { return dot(normal, p - from_); };
    std::size_t crossed = 0;
    for (const incident_triangle& t : c.triangles) {
      if (&t == &first) continue;
      const bool a = height(t.a) >= 0, b = height(t.b) >= 0;
      if (a == b) continue;
      const vec3 u = t.a - from_, w = t.b - from_;
      const int s = side_of_line(g, t.a, t.b, from_).sign;
      if (!(s * dot(cross(u, w), middle) < 0)) continue;  // its plane does not separate g and the middle
      const vec3 at = height(t.a) * w - height(t.b) * u, on_arc = height(t.a) - height(t.b) < 0 ? -at : at;
      if (dot(cross(on_arc, middle), normal) > 0) ++crossed;
    }
    return (crossed % 2 == 1) == (side_of_line(g, first.a, first.b, from_).sign > 0);
  }
};

}  // namespace concino::detail
