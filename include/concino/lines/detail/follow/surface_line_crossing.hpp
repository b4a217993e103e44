// Follows a line over a surface from triangle to triangle, and along edges to the next vert.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/lines/detail/cells/field_reader.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>
#include <concino/lines/detail/cells/polygon_reader.hpp>
#include <concino/lines/detail/cells/surface_exits.hpp>
#include <concino/lines/detail/follow/cycle_detector.hpp>
#include <concino/lines/detail/follow/line_recorder.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace concino::detail {

/// A line that crosses triangles: where it reaches a vert, or winds, others continue it.
template<class M, class G>
class surface_line_crossing {
 protected:
  using piece = polygon_piece<M>;

  struct triangle_side {  // a triangle at a side: s goes from its corner number `side` to the next
    piece in;
    unsigned side = 0;
    const vec3& from() const { return in.at[side]; }
    const vec3& to() const { return in.at[(side + 1) % 3]; }
  };

  const M* m_;
  field_reader<M, G> field_;
  polygon_reader<M> polygon_;
  cycle_detector cycles_;

  // The state of a line: in a triangle, inside, at a side or at a corner of it; at a vert; or at an edge by which it
  // leaves a triangle.
  enum class where { inside, side, corner, vert, edge } where_ = where::inside;
  triangle_side triangles_[2];
  unsigned now_ = 0;       // of triangles_: the triangle entered, and its side or corner; or the side by which the line
                           // leaves it
  double inward_ = 0;      // at a side: the determinant of the field and the side
  vec3 x_;
  vert_t<M> vert_ = vert_t<M>();
  edge_t<M> edge_ = edge_t<M>();
  double edge_parameter_ = 0;               // on the edge
  entry_step entry_;               // what the place depends on
  cycle_detector::finding found_ = cycle_detector::finding::none;  // where the line entered its triangle

  surface_line_crossing(const M& m, const field_reader<M, G>& field) : m_(&m), field_(field) {}

  triangle_side& at() { return triangles_[now_]; }
  const triangle_side& at() const { return triangles_[now_]; }

  void read(const poly_t<M>& p) {
    if (polygon_.read(*m_, p)) polygon_.field = field_.of(p);
  }

  void leave_triangle(line_recorder<M>& to) {
    const piece& t = at().in;
    if (t.is_zero) return to.stop(line_end::zero);
    const vec3 &g = t.field, &n = t.normal;
    if (where_ == where::inside) return leave_inside(to);
    // i and j: the ends of the side entered, or of the side opposite to the corner where the line enters
    const unsigned i = where_ == where::side ? at().side : (at().side + 1) % 3, j = (i + 1) % 3, far = (i + 2) % 3;
    if (where_ == where::corner)
      return cross_side(i, side_in_plane(g, t.at[i], n, x_), side_in_plane(g, t.at[j], n, x_), to);
    const signed_value c = side_in_plane(g, t.at[far], n, x_);
    if (c.sign == 0) return reach_corner(far, to);
    // entering, i lies to the left of the line and j to the right; of a side by which it leaves, the first end lies to
    // the right
    const bool by_j = c.sign > 0;
    const signed_value other = side_in_plane(g, t.at[by_j ? j : i], n, x_);
    cross_side(by_j ? j : far, by_j ? other : c, by_j ? c : other, to);
  }

  void leave_inside(line_recorder<M>& to) {
    const piece& t = at().in;
    signed_value s[3];
    for (unsigned i = 0; i < 3; ++i) s[i] = side_in_plane(t.field, t.at[i], t.normal, x_);
    for (unsigned i = 0; i < 3; ++i)
      if (s[i].sign == 0 && dot(t.field, t.at[i] - x_) > 0) return reach_corner(i, to);
    for (unsigned i = 0; i < 3; ++i)
      if (s[i].sign <= 0 && s[(i + 1) % 3].sign > 0) return cross_side(i, s[i], s[(i + 1) % 3], to);
    // the start lies outside by rounding: the corner ahead that is nearest to the line
    unsigned best = 0;
    for (unsigned i = 1; i < 3; ++i)
      if (dot(t.field, t.at[i] - t.at[best]) > 0) best = i;
    reach_corner(best, to);
  }

  void reach_corner(unsigned corner, line_recorder<M>& to) {
    const piece& in = at().in;
    const vert_t<M> v = in.verts[corner];
    x_ = in.at[corner];
    to.add({v, x_}, in.poly);
    if (!to.done()) reach_vert(v, to);
  }

  void reach_vert(const vert_t<M>& v, line_recorder<M>& to) {
    vert_ = v;
    where_ = where::vert;
    if (cycles_.at_vert(index_of(*m_, v), to.num_points()) == cycle_detector::finding::repeats)
      to.repeat(cycles_.period());
  }

  /// The line leaves the triangle through side k, whose first end lies to its right and second one to its left.
  void cross_side(unsigned k, const signed_value& right, const signed_value& left, line_recorder<M>& to) {
    const double whole = right.value - left.value;
    double s = whole != 0 ? right.value / whole : 0.5;
    s = !(s > 0) ? 0 : s > 1 ? 1 : s;
    const entry_step step = entry_step_at(k, s);
    triangle_side& out = at();
    out.side = k;
    x_ = out.from() + s * (out.to() - out.from());
    read(out.in.poly);
    if (out.in.edge[k] == piece::diagonal) {
      if (!polygon_.is_flat) to.add({out.in.poly, x_}, out.in.poly);
      if (to.done()) return;
      const auto [triangle, side] = polygon_.beside(out.in, k);
      return enter(triangle, side, 1 - s, step, to);
    }
    edge_ = polygon_.edges[out.in.edge[k]];
    edge_parameter_ = s;
    entry_ = step;
    where_ = where::edge;
  }

  void cross_edge(line_recorder<M>& to) {
    const triangle_side& out = at();
    to.add(on_edge(edge_, out, edge_parameter_), out.in.poly);
    if (to.done()) return;
    poly_t<M> other{};
    std::size_t num_others = 0;
    for (const poly_t<M> p : other_polys(*m_, out.in.poly, edge_)) {
      other = p;
      ++num_others;
    }
    if (num_others != 1) return to.stop(num_others == 0 ? line_end::boundary : line_end::non_manifold);
    read(other);
    const auto [triangle, side] = polygon_.with_edge(edge_);
    enter(triangle, side,
          polygon_.vert(triangle, side) == out.in.verts[out.side] ? edge_parameter_ : 1 - edge_parameter_, entry_, to);
  }

  /// x, at place s of a side that is edge e.
  mesh_point<M> on_edge(const edge_t<M>& e, const triangle_side& h, double s) const {
    return {edge_point<M>{e, end_verts(*m_, e).first == h.in.verts[h.side] ? s : 1 - s}, x_};
  }

  /// How the place on the side by which the line leaves depends on the place where it entered.
  entry_step entry_step_at(unsigned k, double s) const {
    const piece& t = at().in;
    if (where_ != where::side) return {0, s, 0};
    const unsigned a = at().side, b = (a + 1) % 3, c = (a + 2) % 3;
    const bool pivots_at_b = k == b;
    const double whole = side_in_plane(t.field, t.at[c], t.normal, t.at[pivots_at_b ? b : a]).value;
    const double q = whole != 0 ? std::abs(inward_ / whole) : 0;
    const double size = max_abs_component(t.at[c]);
    const vec3 d = t.at[(k + 1) % 3] - t.at[k];
    const double error_bound = 0x1p-50 * (1 + size / std::max(max_abs_component(d), 1e-300));
    const std::size_t pivot = index_of(*m_, t.verts[pivots_at_b ? b : a]);
    if (pivots_at_b) return {-q, q, error_bound, pivot};  // q (1 - s), from b to c
    return {-q, 1, error_bound, pivot};                   // q s from a to c, so 1 - q s from c to a
  }

  /// Enters a triangle of the polygon at place s of its side, or slides along the side, if the field there pushes back.
  void enter(unsigned triangle, unsigned side, double s, entry_step step, line_recorder<M>& to) {
    const triangle_side& out = at();
    triangle_side& next = triangles_[1 - now_];
    polygon_.read_piece(triangle, next.in);
    next.side = side;
    if (next.in.is_zero) return to.stop(line_end::zero);
    const signed_value inward = side_in_plane(next.in.field, next.to(), next.in.normal, next.from());
    if (inward.sign >= 0) return slide(next, out, to);
    // step.scale, step.shift give the place from the first to the second end of the side as `out` sees it
    if (!(next.in.verts[side] == out.in.verts[out.side]))
      step = {-step.scale, 1 - step.shift, step.error_bound, step.pivot};
    const bool gets_no_point = out.in.edge[out.side] == piece::diagonal && polygon_.is_flat;
    now_ = 1 - now_;
    inward_ = inward.value;
    where_ = where::side;
    if (gets_no_point) return cycles_.follow(step);
    const std::size_t key = index_of(*m_, next.in.poly);
    found_ = cycles_.at_side({key, std::size_t{3} * next.in.number + next.side}, s, x_, step, to.num_points());
  }

  void slide(const triangle_side& next, const triangle_side& out, line_recorder<M>& to) {
    const vec3 along = out.to() - out.from();
    const double length = norm(along);
    if (!(length > 0)) return to.stop(line_end::sink);
    const auto exit_speed = [&](const triangle_side& h) {
      return std::max(0.0,
                      side_in_plane(h.in.field, h.to(), h.in.normal, h.from()).value / (norm(h.in.normal) * length));
    };
    const double speed = sliding_speed(exit_speed(out), dot(out.in.field, along) / length, exit_speed(next),
                                       dot(next.in.field, along) / length);
    if (!(speed != 0)) return to.stop(line_end::sink);
    if (&out != &at()) at() = out;
    reach_corner(speed > 0 ? (out.side + 1) % 3 : out.side, to);
  }
};

}  // namespace concino::detail
