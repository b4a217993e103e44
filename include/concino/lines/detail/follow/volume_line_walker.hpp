// Follows a field through a volume, cell by cell; a cell is bounded by the triangles of its faces, and is not divided.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/lines/detail/cells/field_reader.hpp>
#include <concino/lines/detail/cells/incident_cells.hpp>
#include <concino/lines/detail/cells/line_ridge.hpp>
#include <concino/lines/detail/cells/polyhedron_reader.hpp>
#include <concino/lines/detail/cells/volume_exits.hpp>
#include <concino/lines/detail/cells/reason_of_end.hpp>
#include <concino/lines/detail/follow/line_recorder.hpp>
#include <concino/lines/detail/follow/volume_line_crossing.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace concino::detail {

/// Reuses its memory from line to line; one for each thread.
template<class M, class G>
class volume_line_walker : volume_line_crossing<M, G> {
  using base = volume_line_crossing<M, G>;
  using base::add_ridge, base::add_vert, base::enter, base::reach_ridge, base::reach_vert, base::read, base::slide,
      base::watch;
  using base::all_tets, base::cross, base::enter_tet, base::leave_cell;
  using base::m_, base::field_, base::cell_, base::cycles_, base::where_, base::x_, base::entry_, base::entry_size_,
      base::ridge_, base::vert_;
  using typename base::where;

  incident_cells<M> incident_;  // of the vert or the ridge

 public:
  volume_line_walker(const M& m, const field_reader<M, G>& field) : base(m, field) {}

  /// Starts a line along the field times `sense`, 1 or -1, from a point. It is followed by calls of step().
  void start(const mesh_point<M>& start, double sense, line_recorder<M>& to) {
    field_.set_sense(sense);
    cycles_.start();
    cell_.invalidate();
    x_ = start.position;
    to.start(start);
    if (const auto* v = std::get_if<vert_t<M>>(&start.element)) reach_vert(*v, to);
    else if (const auto* e = std::get_if<edge_point<M>>(&start.element)) reach_ridge(ridge_of(*m_, e->edge));
    else if (const auto* f = std::get_if<face_t<M>>(&start.element)) start_on(*f, to);
    else enter(std::get<poly_t<M>>(start.element), {});
  }

  /// Needs: !to.done().
  void step(line_recorder<M>& to) {
    if (where_ == where::vert) leave_vert(to);
    else if (where_ == where::ridge) leave_ridge(to);
    else if (where_ == where::cell) leave_cell(to);
    else if constexpr (all_tets) enter_tet(to);
  }

 private:
  void read_triangles(const poly_t<M>& p) {
    read(p);
    cell_.cut_faces();
  }

  void leave_vert(line_recorder<M>& to) {
    incident_.clear();
    for (const poly_t<M> p : adj_v2p(*m_, vert_)) {
      read_triangles(p);
      incident_.add_at_vert(*m_, cell_, vert_);
    }
    const volume_exit out = steepest_exit(x_, incident_.all());
    if (out.to == volume_exit::kind::none) return stop_at(adj_v2f(*m_, vert_), to);
    const std::uint32_t corner = read_exit(out, vert_);
    if (out.to == volume_exit::kind::cell) return enter(incident_.poly(out.cell), std::array{corner});
    const cell_triangle t = incident_.triangle_of(*m_, cell_, out);
    if (out.to == volume_exit::kind::triangle) return slide(t, out.velocity, std::array{corner}, to);
    const std::size_t k =
        static_cast<std::size_t>(std::find(t.corner.begin(), t.corner.end(), corner) - t.corner.begin());
    const std::uint32_t end = t.corner[(k + (out.along_a ? 1 : 2)) % 3];
    x_ = cell_.flat.points[end];
    add_vert(cell_.verts[end], to);
  }

  void leave_ridge(line_recorder<M>& to) {
    incident_.clear();
    const auto add = [&](const poly_t<M>& p) {
      read_triangles(p);
      incident_.add_at_ridge(*m_, cell_, *ridge_);
    };
    if (ridge_->edge)
      for (const poly_t<M> p : adj_e2p(*m_, *ridge_->edge)) add(p);
    else
      for (const poly_t<M> p : adj_f2p(*m_, *ridge_->face)) add(p);
    const volume_exit out = steepest_exit(ridge_->from_point, ridge_->to_point, ridge_->key, incident_.all());
    if (out.to == volume_exit::kind::none)
      return ridge_->edge ? stop_at(adj_e2f(*m_, *ridge_->edge), to) : stop_at(std::array{*ridge_->face}, to);
    const std::uint32_t from = read_exit(out, ridge_->from), end = cell_.corner_of(*m_, ridge_->to);
    if (out.to == volume_exit::kind::cell) return enter(incident_.poly(out.cell), std::array{from, end});
    if (out.to == volume_exit::kind::triangle)
      return slide(incident_.triangle_of(*m_, cell_, out), out.velocity, std::array{from, end}, to);
    const bool back = out.to == volume_exit::kind::edge_back;
    x_ = back ? ridge_->from_point : ridge_->to_point;
    add_vert(back ? ridge_->from : ridge_->to, to);
  }

  /// Reads the cell of an exit; the corner of the vert in it.
  std::uint32_t read_exit(const volume_exit& out, const vert_t<M>& v) {
    read_triangles(incident_.poly(out.cell));
    return cell_.corner_of(*m_, v);
  }
  template<class Faces>
  void stop_at(const Faces& faces, line_recorder<M>& to) const {
    to.stop(reason_of_end(*m_, faces, !incident_.all().empty(), incident_.all_are_zero()));
  }

  /// The diagonal of a face of the cell that was read last at which x is, but for rounding.
  std::optional<line_ridge<M>> diagonal_at(const face_t<M>& f) {
    for (const cell_triangle& t : cell_.flat.triangles)
      for (unsigned k = 0; k < 3; ++k) {
        if (!(cell_.faces[t.face] == f) || !t.is_diagonal(k)) continue;
        const vec3 &a = cell_.flat.points[t.corner[k]], &b = cell_.flat.points[t.corner[(k + 1) % 3]];
        if (distance(closest_point(x_, a, b), x_) <= 1e-12 * distance(a, b) + 0x1p-49 * max_abs_component(x_))
          return ridge_of(*m_, cell_, t, k);
      }
    return {};
  }

  /// From inside a face: from one of its diagonals, or into the poly whose field leads into it fastest, or along the
  /// face.
  void start_on(const face_t<M>& f, line_recorder<M>& to) {
    for (const poly_t<M> p : adj_f2p(*m_, f)) {
      read_triangles(p);
      if (const auto diagonal = diagonal_at(f)) return reach_ridge(*diagonal);
      break;  // the diagonals of the others are the same
    }
    struct side {
      poly_t<M> poly;
      std::uint32_t triangle;
      signed_value outward;
    };
    std::vector<side> sides;
    std::optional<side> best;
    vec3 best_field;
    bool all_zero = true;
    for (const poly_t<M> p : adj_f2p(*m_, f)) {
      read_triangles(p);
      const std::uint32_t t = cell_.nearest_triangle(f, x_);
      const auto& c = cell_.flat.triangles[t].corner;
      const auto& at = cell_.flat.points;
      const side s = {p, t, side_of_line(cell_.field, at[c[1]], at[c[2]], at[c[0]])};
      sides.push_back(s);
      all_zero = all_zero && cell_.field == vec3();
      if (s.outward.sign >= 0) continue;
      const double speed = norm(cell_.field), so_far = norm(best_field);
      if (best && (speed < so_far || (speed == so_far && !lies_before(cell_.field, best_field)))) continue;
      best = s;
      best_field = cell_.field;
    }
    if (sides.empty()) return to.stop(line_end::boundary);
    if (best) {
      read_triangles(best->poly);
      enter(best->poly, cell_.flat.triangles[best->triangle].corner);
      return;
    }
    if (all_zero) return to.stop(line_end::zero);
    if (sides.size() > 2) return to.stop(line_end::non_manifold);
    if (sides.size() == 1) {
      if (sides[0].outward.sign != 0) return to.stop(line_end::boundary);
      read_triangles(sides[0].poly);
      return slide(cell_.flat.triangles[sides[0].triangle], cell_.field, {}, to);
    }
    read_triangles(sides[0].poly);
    cross(f, cell_.flat.triangles[sides[0].triangle], sides[0].poly, to);
  }
};

}  // namespace concino::detail
