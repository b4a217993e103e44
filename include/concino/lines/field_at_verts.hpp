// field_at_verts: lines along a field that is given at verts.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/lines/detail/follow/vert_field_walker.hpp>

#include <type_traits>

namespace concino {

/// Says that a field has its vectors at verts: integral_line(m, field_at_verts(vert_gradient(m, u)), v) is an error,
/// since the map must stay alive; write auto h = vert_gradient(m, u); integral_line(m, field_at_verts(h), v). step: the
/// length of a step, 0 for a quarter of the size of each poly.
template<class H>
struct field_at_verts {
  const H* values;
  double step;

  explicit field_at_verts(const H& values_, double step_ = 0) : values(&values_), step(step_) {}
  explicit field_at_verts(const H&& values_, double step_ = 0) = delete;  // give the map a name
};

/// The line that follows a field given at verts.
/// Needs:  as integral_line; field_at_verts of a map with a vector at each vert.
/// Result: as integral_line. Inside a poly the field is interpolated: linear in the triangles of polygons, and in the
///         tets between the mean of the verts of a polyhedron and the triangles of its surface. Steps have equal
///         length; each goes straight through the polys on its way. On surfaces a step follows the part of its
///         direction in each polygon. On flat surfaces and in volumes the error is of order 4 where the field is
///         smooth. A line that turns back takes smaller steps, and ends there: a sink. Closed lines are not recognised,
///         unless they return exactly: max_length or max_steps ends them.
/// Cost:   O(V) to check the field, and five times that of integral_line for each step.
/// Errors: as integral_line, for the vectors of verts; invalid_argument if the step is negative or not finite.
/// Source: Kutta 1901, "Beitrag zur näherungsweisen Integration totaler Differentialgleichungen".
template<class M, class H, class S>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_points<H, vert_t<M>> &&
      requirement::is_line_start<M, S>
auto integral_line(M&& m, const field_at_verts<H>& h, const S& start, const integral_line_options& options = {}) {
  using mesh = std::remove_cvref_t<M>;
  const detail::field_follower<mesh, detail::vert_field_reader<mesh, H>, detail::vert_field_walker<mesh, H>> follow(
      m, h, options, "integral_line");
  return follow.line(start);
}
template<class M, class H, class R>
  requires requirement::is_lvalue_or_view<M> && EmbeddedMesh<M> && requirement::gives_points<H, vert_t<M>> &&
      requirement::gives_line_starts<M, R>
auto integral_lines(M&& m, const field_at_verts<H>& h, const R& starts, const integral_line_options& options = {}) {
  using mesh = std::remove_cvref_t<M>;
  const core::profiled_options profiled(options, "integral_lines");
  const detail::field_follower<mesh, detail::vert_field_reader<mesh, H>, detail::vert_field_walker<mesh, H>> follow(
      m, h, *profiled, "integral_lines");
  return follow.lines(starts);
}

}  // namespace concino
