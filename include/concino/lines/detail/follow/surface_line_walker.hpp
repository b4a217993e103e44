// Follows a field over a surface, triangle by triangle: other polygons by the triangles of triangulate_polygon.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/lines/detail/cells/field_reader.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>
#include <concino/lines/detail/cells/polygon_reader.hpp>
#include <concino/lines/detail/cells/reason_of_end.hpp>
#include <concino/lines/detail/cells/surface_exits.hpp>
#include <concino/lines/detail/follow/cycle_detector.hpp>
#include <concino/lines/detail/follow/line_recorder.hpp>
#include <concino/lines/detail/follow/surface_line_crossing.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace concino::detail {

/// Reuses its memory from line to line; one for each thread.
template<class M, class G>
class surface_line_walker : surface_line_crossing<M, G> {
  using base = surface_line_crossing<M, G>;
  using base::at, base::cross_edge, base::leave_triangle, base::on_edge, base::reach_corner, base::reach_vert,
      base::read, base::slide;
  using base::m_, base::field_, base::polygon_, base::cycles_, base::where_, base::x_, base::edge_, base::vert_,
      base::inward_, base::found_;
  using typename base::piece, typename base::triangle_side, typename base::where;

  std::vector<surface_sector> sectors_;
  std::vector<piece> sector_pieces_;

 public:
  surface_line_walker(const M& m, const field_reader<M, G>& field) : base(m, field) {}

  /// Starts a line along the field times `sense`, 1 or -1, from a point. It is followed by calls of step().
  void start(const mesh_point<M>& start, double sense, line_recorder<M>& to) {
    field_.set_sense(sense);
    cycles_.start();
    polygon_.invalidate();
    x_ = start.position;
    to.start(start);
    if (const auto* v = std::get_if<vert_t<M>>(&start.element)) reach_vert(*v, to);
    else if (const auto* e = std::get_if<edge_point<M>>(&start.element)) start_on(*e, to);
    else start_in(std::get<poly_t<M>>(start.element));
  }

  /// Needs: !to.done().
  void step(line_recorder<M>& to) {
    if (where_ == where::vert) return leave_vert(to);
    if (where_ == where::edge) cross_edge(to);
    else leave_triangle(to);
    switch (std::exchange(found_, cycle_detector::finding::none)) {
      case cycle_detector::finding::none: return;
      case cycle_detector::finding::repeats: return to.repeat(cycles_.period());
      case cycle_detector::finding::winds_to_cycle: return follow_cycle_once(to);
      case cycle_detector::finding::winds_into_vert: return end_in_vert(to);
    }
  }

 private:
  static bool all_are_zero(const std::vector<piece>& pieces) {
    return std::all_of(pieces.begin(), pieces.end(), [](const piece& in) { return in.is_zero; });
  }

  void leave_vert(line_recorder<M>& to) {
    sectors_.clear();
    sector_pieces_.clear();
    std::size_t diagonals = edge_index_bound(*m_);
    for (const poly_t<M> p : adj_v2p(*m_, vert_)) {
      read(p);
      for (unsigned t = 0; t < polygon_.num_pieces(); ++t) {
        const piece in = polygon_.piece(t);
        for (unsigned k = 0; k < 3; ++k) {
          if (!(in.verts[k] == vert_)) continue;
          const unsigned a = (k + 1) % 3, b = (k + 2) % 3;
          const auto key = [&](unsigned side, unsigned far) {
            return in.edge[side] == piece::diagonal ? diagonals + in.corner[far]
                                                    : index_of(*m_, polygon_.edges[in.edge[side]]);
          };
          sectors_.push_back({in.at[a], in.at[b], in.normal, in.field, key(k, a), key(b, b)});
          sector_pieces_.push_back(in);
        }
      }
      diagonals += polygon_.verts.size();
    }
    const surface_exit out = steepest_exit(x_, sectors_);
    if (out.to == surface_exit::kind::none)
      return to.stop(reason_of_end(*m_, adj_v2e(*m_, vert_), !sector_pieces_.empty(), all_are_zero(sector_pieces_)));
    triangle_side& from = at();
    from.in = sector_pieces_[out.sector];
    for (unsigned k = 0; k < 3; ++k)
      if (from.in.verts[k] == vert_) from.side = k;
    if (out.to == surface_exit::kind::sector) where_ = where::corner;
    else reach_corner((from.side + (out.to == surface_exit::kind::side_a ? 1 : 2)) % 3, to);
  }

  void start_in(const poly_t<M>& p) {
    read(p);
    at() = {polygon_.piece(polygon_.nearest_piece(x_)), 0};
    where_ = where::inside;
  }

  /// From an edge: into the poly whose field leads into it fastest, or along the edge.
  void start_on(const edge_point<M>& x, line_recorder<M>& to) {
    std::vector<triangle_side> triangle_sides;
    for (const poly_t<M> p : adj_e2p(*m_, x.edge)) {
      read(p);
      const auto [triangle, side] = polygon_.with_edge(x.edge);
      triangle_sides.push_back({polygon_.piece(triangle), side});
    }
    if (triangle_sides.empty()) return to.stop(line_end::boundary);
    const triangle_side* best = nullptr;
    double best_speed = 0;
    bool all_zero = true;
    for (const triangle_side& h : triangle_sides) {
      all_zero = all_zero && h.in.is_zero;
      if (side_in_plane(h.in.field, h.to(), h.in.normal, h.from()).sign >= 0) continue;
      const double speed = speed_in_plane(h.in.field, h.in.normal);
      if (best && (speed < best_speed ||
                   (speed == best_speed && !lies_before(h.in.at[(h.side + 2) % 3], best->in.at[(best->side + 2) % 3]))))
        continue;
      best = &h;
      best_speed = speed;
    }
    if (best) {
      at() = *best;
      inward_ = side_in_plane(best->in.field, best->to(), best->in.normal, best->from()).value;
      where_ = where::side;
      const double s = best->in.verts[best->side] == end_verts(*m_, x.edge).first ? x.parameter : 1 - x.parameter;
      cycles_.at_side({index_of(*m_, best->in.poly), std::size_t{3} * best->in.number + best->side}, s, x_, {}, 1);
      return;
    }
    if (all_zero) return to.stop(line_end::zero);
    if (triangle_sides.size() > 2) return to.stop(line_end::non_manifold);
    if (triangle_sides.size() == 2) return slide(triangle_sides[1], triangle_sides[0], to);
    const triangle_side& h = triangle_sides[0];
    if (side_in_plane(h.in.field, h.to(), h.in.normal, h.from()).sign != 0) return to.stop(line_end::boundary);
    at() = h;
    reach_corner(dot(h.in.field, h.to() - h.from()) > 0 ? (h.side + 1) % 3 : h.side, to);
  }

  /// The line converges to a cycle, which is followed once.
  void follow_cycle_once(line_recorder<M>& to) {
    field_line<M> once;
    line_recorder<M> cycle(once, std::numeric_limits<double>::infinity(), cycles_.period());
    const double s = cycles_.fixed_parameter();
    const triangle_side& from = at();
    x_ = from.from() + s * (from.to() - from.from());
    cycles_.start();
    read(from.in.poly);
    const std::size_t edge = from.in.edge[from.side];
    cycle.start(edge == piece::diagonal ? mesh_point<M>{from.in.poly, x_} : on_edge(polygon_.edges[edge], from, s));
    while (!cycle.done()) step(cycle);
    if (once.stopped_by != line_end::closed) once.points.pop_back();
    to.end_in_cycle(std::move(once.points));
  }

  /// The line spirals into a vert; the distance decreases by the same factor in each round, so the length is finite.
  void end_in_vert(line_recorder<M>& to) {
    const auto& x = to.line().points;
    double once = 0;
    for (std::size_t i = 0; i < cycles_.period(); ++i)
      once += distance(x[x.size() - 2 - i].position, x[x.size() - 1 - i].position);
    const double factor = cycles_.contraction_factor(), more = once * factor / (1 - factor);
    if (more >= to.remaining_length()) return;  // the line is cut before
    for (unsigned k = 0; k < 3; ++k)
      if (const piece& in = at().in; index_of(*m_, in.verts[k]) == cycles_.vert())
        return to.end_at({in.verts[k], in.at[k]}, in.poly, more);
  }
};

}  // namespace concino::detail
