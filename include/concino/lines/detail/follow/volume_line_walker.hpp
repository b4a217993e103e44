// Follows a field through a volume, cell by cell; a cell is bounded by the triangles of its faces, and is not divided.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/geometry/closest_point.hpp>
#include <concino/lines/detail/cells/field_reader.hpp>
#include <concino/lines/detail/cells/incident_cells.hpp>
#include <concino/lines/detail/cells/line_ridge.hpp>
#include <concino/lines/detail/cells/polyhedron_reader.hpp>
#include <concino/lines/detail/cells/tet_crossing.hpp>
#include <concino/lines/detail/cells/volume_exits.hpp>
#include <concino/lines/detail/cells/reason_of_end.hpp>
#include <concino/lines/detail/follow/line_recorder.hpp>
#include <concino/lines/detail/follow/line_watch.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace concino::detail {

/// Reuses its memory from line to line; one for each thread.
template<class M, class G>
class volume_line_walker {
  const M* m_;
  field_reader<M, G> field_;
  polyhedron_reader<M> cell_;
  line_watch watch_;
  incident_cells<M> incident_;  // of the vert or the ridge

  enum class where { cell, ridge, vert, behind_tet } where_ = where::cell;
  vec3 x_;
  std::array<std::uint32_t, 3> entry_{};  // corners of the cell that was read last
  std::size_t entry_size_ = 0;
  std::optional<line_ridge<M>> ridge_;
  vert_t<M> vert_ = vert_t<M>();

  // From tet to tet, the line is behind one when it has left it.
  static constexpr bool all_tets = arity_v<M> == 4;
  tet_crossing<M> tet_;
  typename tet_crossing<M>::exit out_{};
  face_t<M> face_ = face_t<M>();    // by which it left
  poly_t<M> other_ = poly_t<M>();   // the next one

 public:
  volume_line_walker(const M& m, const field_reader<M, G>& field) : m_(&m), field_(field) {}

  /// Starts a line along the field times `sense`, 1 or -1, from a point. It is followed by calls of step().
  void start(const mesh_point<M>& start, double sense, line_recorder<M>& to) {
    field_.sense(sense);
    watch_.start();
    cell_.forget();
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
  void read(const poly_t<M>& p) {
    if (cell_.read(*m_, p)) cell_.field = field_.of(p);
  }
  void enter(const poly_t<M>& p, std::span<const std::uint32_t> entry) {
    read(p);
    std::copy(entry.begin(), entry.end(), entry_.begin());
    entry_size_ = entry.size();
    where_ = where::cell;
  }

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

  void add_vert(const vert_t<M>& v, line_recorder<M>& to) {
    to.add({v, x_}, cell_.poly());
    if (!to.done()) reach_vert(v, to);
  }
  void reach_vert(const vert_t<M>& v, line_recorder<M>& to) {
    vert_ = v;
    where_ = where::vert;
    if (watch_.at_vert(index_of(*m_, v), to.num_points()) == line_watch::finding::repeats) to.repeat(watch_.period());
  }

  void add_ridge(const cell_triangle& t, std::uint32_t k, double parameter, line_recorder<M>& to) {
    const line_ridge<M> r = ridge_of(*m_, cell_, t, k);
    if (r.edge)
      to.add({edge_point<M>{*r.edge, end_verts(*m_, *r.edge).first == r.from ? parameter : 1 - parameter}, x_},
             cell_.poly());
    else to.add({*r.face, x_}, cell_.poly());
    if (!to.done()) reach_ridge(r);
  }
  void reach_ridge(const line_ridge<M>& r) {
    ridge_ = r;
    where_ = where::ridge;
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
    const double push =
        push_through(cell_.field, points[next.corner[0]], points[next.corner[1]], points[next.corner[2]]);
    slide(next, sliding_velocity(push_through(g, at[0], at[1], at[2]), g, push, cell_.field, normal), {}, to);
  }

  /// The line enters poly p through the triangle of face f with this number.
  void watch(const poly_t<M>& p, const face_t<M>& f, std::uint32_t number, line_recorder<M>& to) {
    const entry_key key = {index_of(*m_, p), index_of(*m_, f) << 32 | number};
    if (watch_.at_face(key, x_, to.num_points()) == line_watch::finding::repeats) to.repeat(watch_.period());
  }

  /// Moves in a triangle of the cell that was read last from x, which is inside (no entry), on the side with corners
  /// entry (2), or at a corner (1).
  void slide(const cell_triangle t, const vec3& velocity, std::span<const std::uint32_t> entry, line_recorder<M>& to) {
    if (velocity == vec3()) return to.stop(line_end::sink);
    std::array<vec3, 3> at;
    std::array<signed_value, 3> s;
    for (std::size_t k = 0; k < 3; ++k) at[k] = cell_.flat.points[t.corner[k]];
    const vec3 normal = triangle_normal(at[0], at[1], at[2]);
    for (std::size_t k = 0; k < 3; ++k) s[k] = side_in_plane(velocity, at[k], normal, x_);
    const auto is_entry = [&](std::uint32_t k) {
      return std::find(entry.begin(), entry.end(), t.corner[k]) != entry.end();
    };
    for (std::uint32_t k = 0; k < 3; ++k)
      if (!is_entry(k) && s[k].sign == 0 && dot(velocity, at[k] - x_) > 0) {
        x_ = at[k];
        return add_vert(cell_.verts[t.corner[k]], to);
      }
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t j = (k + 1) % 3;
      if (entry.size() == 1 && (is_entry(k) || is_entry(j))) continue;
      if (entry.size() == 2 && is_entry(k) && is_entry(j)) continue;
      const bool right = s[k].sign <= 0 || (entry.size() == 2 && is_entry(k)),
                 left = s[j].sign > 0 || (entry.size() == 2 && is_entry(j));
      if (entry.size() != 1 && !(right && left)) continue;
      const double a = std::max(0.0, -s[k].value), b = std::max(0.0, s[j].value),
                   parameter = a + b > 0 ? a / (a + b) : 0.5;
      x_ = at[k] + parameter * (at[j] - at[k]);
      return add_ridge(t, k, parameter, to);
    }
    std::uint32_t best = 0;  // x lies outside by rounding
    for (std::uint32_t k = 1; k < 3; ++k)
      if (dot(velocity, at[k] - at[best]) > 0) best = k;
    x_ = at[best];
    add_vert(cell_.verts[t.corner[best]], to);
  }

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
        if (distance(closest_point(x_, a, b), x_) <= 1e-12 * distance(a, b) + 0x1p-49 * max_part(x_))
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
