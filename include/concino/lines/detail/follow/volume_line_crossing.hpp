// Follows a line through the cells of a volume, from face to face.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/lines/detail/cells/tet_crossing.hpp>
#include <concino/lines/detail/cells/volume_exits.hpp>
#include <concino/lines/detail/follow/volume_line_position.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace concino::detail {

/// A line that crosses cells: where it leaves one by a vert or an edge, others continue it.
template<class M, class G>
class volume_line_crossing : protected volume_line_position<M, G> {
  using base = volume_line_position<M, G>;

 protected:
  using base::add_ridge, base::add_vert, base::enter, base::reach_ridge, base::reach_vert, base::read, base::slide,
      base::watch;
  using base::m_, base::field_, base::cell_, base::cycles_, base::where_, base::x_, base::entry_, base::entry_size_,
      base::ridge_, base::vert_;
  using typename base::where;

  // From tet to tet, the line is behind one when it has left it.
  static constexpr bool all_tets = arity_v<M> == 4;
  tet_crossing<M> tet_;
  typename tet_crossing<M>::exit out_{};
  face_t<M> face_ = face_t<M>();    // by which it left
  poly_t<M> other_ = poly_t<M>();   // the next one

  volume_line_crossing(const M& m, const field_reader<M, G>& field) : base(m, field) {}

  void leave_cell(line_recorder<M>& to) {
    if constexpr (all_tets)
      if (entry_size_ == 3) {
        tet_.set(cell_.poly(), cell_.verts, cell_.flat.points, entry_);
        tet_.field = cell_.field;
        if (leave_tet(to)) return;
      }
    leave_by_exact_signs(to);
  }

  /// Leaves tet_ through a face. False if this takes exact signs, or the line leaves by an edge or a vert.
  bool leave_tet(line_recorder<M>& to) {
    const auto out = tet_.leave(x_);
    if (!out) return false;
    out_ = *out;
    x_ = out->position;
    face_ = opposite_face(*m_, tet_.poly, tet_.verts[out->left_out]);
    to.add({face_, x_}, tet_.poly);
    if (to.done()) return true;
    std::size_t n = 0;
    for (const poly_t<M> q : other_polys(*m_, tet_.poly, face_)) {
      other_ = q;
      ++n;
    }
    if (n != 1) {
      to.stop(n < 1 ? line_end::boundary : line_end::non_manifold);
      return true;
    }
    where_ = where::behind_tet;
    return true;
  }

  void enter_tet(line_recorder<M>& to) {
    const poly_t<M> p = tet_.poly;
    tet_.read_behind(*m_, out_, other_);
    tet_.field = field_.of(other_);
    if (!tet_.leads_in()) {
      read(p);
      return cross(face_, cell_.flat.triangles[cell_.triangle(face_, 0)], p, to);
    }
    watch(other_, face_, 0, to);
    if (to.done() || leave_tet(to)) return;
    read(other_);
    enter(other_, cell_.flat.triangles[cell_.triangle(face_, 0)].corner);
    leave_by_exact_signs(to);
  }

  void leave_by_exact_signs(line_recorder<M>& to) {
    if (cell_.field == vec3()) return to.stop(line_end::zero);
    const cell_exit out = cell_.leave(x_, std::span(entry_).first(entry_size_));
    if (out.at == cell_exit::kind::none) return miss(to);
    x_ = out.position;
    const cell_triangle t = cell_.flat.triangles[out.triangle];
    if (out.at == cell_exit::kind::corner) return add_vert(cell_.verts[t.corner[out.k]], to);
    if (out.at == cell_exit::kind::side) return add_ridge(t, out.k, out.parameter, to);
    const poly_t<M> p = cell_.poly();
    const face_t<M> f = cell_.faces[t.face];
    to.add({f, x_}, p);
    if (!to.done()) cross(f, t, p, to);
  }

  /// The line is so near to the border of the triangle or edge by which it entered that it misses the cell: it goes on
  /// from there.
  void miss(line_recorder<M>& to) {
    if (entry_size_ == 3) {
      double most = -std::numeric_limits<double>::infinity();
      std::uint32_t best = 0;
      for (std::uint32_t k = 0; k < 3; ++k) {
        const vec3 &a = cell_.flat.points[entry_[k]], &b = cell_.flat.points[entry_[(k + 1) % 3]];
        const double s = side_of_line(cell_.field, a, b, x_).value / distance(a, b);
        if (s > most) {
          most = s;
          best = k;
        }
      }
      for (const cell_triangle& t : cell_.flat.triangles)
        for (std::uint32_t k = 0; k < 3; ++k)
          if (t.corner[k] == entry_[best] && t.corner[(k + 1) % 3] == entry_[(best + 1) % 3] &&
              is_corner(t, entry_[(best + 2) % 3])) {
            const vec3 &a = cell_.flat.points[t.corner[k]], &b = cell_.flat.points[t.corner[(k + 1) % 3]];
            const double s = std::clamp(dot(x_ - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
            x_ = a + s * (b - a);
            return add_ridge(t, k, s, to);
          }
    }
    // from an edge the nearer end; from a vert or inside, only in cells that are inverted or intersect themselves, the
    // corner that is farthest along the field
    std::uint32_t best =
        entry_size_ == 2
            ? entry_[distance(x_, cell_.flat.points[entry_[1]]) < distance(x_, cell_.flat.points[entry_[0]])]
            : 0;
    if (entry_size_ == 0) cell_.read_all();
    if (entry_size_ < 2)
      for (std::uint32_t k = 1; k < cell_.verts.size(); ++k)
        if (dot(cell_.field, cell_.flat.points[k] - cell_.flat.points[best]) > 0) best = k;
    if (entry_size_ == 1 && best == entry_[0]) return to.stop(line_end::sink);
    x_ = cell_.flat.points[best];
    add_vert(cell_.verts[best], to);
  }
  static bool is_corner(const cell_triangle& t, std::uint32_t c) {
    return t.corner[0] == c || t.corner[1] == c || t.corner[2] == c;
  }

  /// From a triangle of face f of poly p, from inside p: into the other poly, or along the face if the field there
  /// pushes back.
  void cross(const face_t<M>& f, const cell_triangle t, const poly_t<M>& p, line_recorder<M>& to) {
    std::optional<poly_t<M>> other;
    std::size_t n = 0;
    for (const poly_t<M> q : adj_f2p(*m_, f)) {
      if (!(q == p)) other = q;
      ++n;
    }
    if (n != 2 || !other) return to.stop(n <= 2 ? line_end::boundary : line_end::non_manifold);
    const std::array<vec3, 3> at = {cell_.flat.points[t.corner[0]], cell_.flat.points[t.corner[1]],
                                    cell_.flat.points[t.corner[2]]};
    const vec3 g = cell_.field;
    if constexpr (all_tets) {
      read(*other);
    } else {
      cell_.keep_cut(f);
      cell_.read_behind(*m_, *other, f);
      cell_.field = field_.of(*other);
    }
    if (cell_.field == vec3()) return to.stop(line_end::zero);
    const cell_triangle next = cell_.flat.triangles[cell_.triangle(f, t.number)];
    const auto& points = cell_.flat.points;
    if (side_of_line(cell_.field, points[next.corner[1]], points[next.corner[2]], points[next.corner[0]]).sign < 0) {
      enter(*other, next.corner);
      watch(*other, f, next.number, to);
      return;
    }
    const vec3 normal = triangle_normal(at[0], at[1], at[2]);
    const double exit_speed =
        speed_through(cell_.field, points[next.corner[0]], points[next.corner[1]], points[next.corner[2]]);
    slide(next, sliding_velocity(speed_through(g, at[0], at[1], at[2]), g, exit_speed, cell_.field, normal), {}, to);
  }
};

}  // namespace concino::detail
