// One polyhedron of a volume after another, as triangles in flat arrays.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/index_table.hpp>
#include <concino/lines/detail/cells/field_reader.hpp>
#include <concino/lines/detail/cells/flat_cell.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace concino::detail {

template<class M>
class polyhedron_reader {
  static constexpr std::size_t longest_scan = 8;
  static constexpr bool all_tets = arity_v<M> == 4;  // then a face is read when it is needed: a line needs two of them

  const M* m_ = nullptr;
  core::index_table corner_numbers_;  // by the indices of the verts, of cells with more of them
  poly_t<M> poly_ = poly_t<M>();
  bool is_read_ = false, has_all_ = false;

  struct cut_face_of_last {  // the face by which the line left a poly, as it was cut there
    std::vector<vert_t<M>> verts;  // in the order of the places of `ring`
    std::vector<vec3> points;
    std::vector<cell_triangle> triangles;
    bool is_outward = false;
  } kept_;

 public:
  std::vector<vert_t<M>> verts;
  std::vector<face_t<M>> faces;
  flat_cell flat;
  vec3 field;  // set by the caller

  void invalidate() { is_read_ = false; }
  const poly_t<M>& poly() const { return poly_; }

  /// False if p is the poly read last. Only the faces are read, and of tets the verts: a line needs the corners of few
  /// faces.
  bool read(const M& m, const poly_t<M>& p) {
    if (is_read_ && p == poly_) return false;
    start(m, p);
    if (all_tets) read_all();
    return true;
  }

  /// Keeps face f of the poly read last, which has been cut, for read_behind().
  void keep_cut(const face_t<M>& f) {
    const std::uint32_t face = number_of(f);
    kept_.triangles.clear();
    for (const cell_triangle& t : flat.triangles)
      if (t.face == face) kept_.triangles.push_back(t);
    kept_.verts.clear();
    kept_.points.clear();
    const std::uint32_t n = kept_.triangles[0].ring_size;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t c = corner_in_ring(i);
      kept_.verts.push_back(verts[c]);
      kept_.points.push_back(flat.points[c]);
    }
    kept_.is_outward = face_is_outward(*m_, poly_, f);
  }

  /// Reads another poly of the face that was kept. The triangles of that face are those kept.
  void read_behind(const M& m, const poly_t<M>& p, const face_t<M>& f) {
    start(m, p);
    verts.assign(kept_.verts.begin(), kept_.verts.end());
    flat.add_cut_face(number_of(f), kept_.points, kept_.triangles, face_is_outward(m, p, f) == kept_.is_outward);
  }

  /// Reads all verts and the corners of all faces. This changes the numbers of corners.
  void read_all() {
    if (has_all_) return;
    has_all_ = true;
    verts.clear();
    flat.clear();
    for (const vert_t<M> v : adj_p2v(*m_, poly_)) verts.push_back(v);
    for (const vert_t<M> v : verts) {
      flat.points.push_back(to_vec3(point(*m_, v)));
      if (!is_finite(flat.points.back())) throw_points_not_finite(index_of(*m_, poly_));
    }
    if (verts.size() > longest_scan) fill_table(*m_);
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
      flat.add_face();
      if (!all_tets) read_corners(face);
    }
  }

  void cut_faces() {
    read_all();
    for (std::uint32_t face = 0; face < faces.size(); ++face) cut_face(face);
  }

  /// As flat_cell::leave.
  cell_exit leave(const vec3& x, std::span<const std::uint32_t> entry) {
    if (faces.size() == 4) {
      for (std::uint32_t face = 0; face < 4 && !(all_tets && entry.size() == 3); ++face) read_corners(face);
      if (entry.size() == 3 && (all_tets || flat.is_tet())) return leave_tet(x, entry);
    }
    flat.look(x, field);
    for (std::uint32_t face = 0; face < faces.size(); ++face) {
      if (flat.is_cut(face)) continue;
      if (flat.may_cross(adj_f2v(*m_, faces[face]), [&](const vert_t<M>& v) { return to_vec3(point(*m_, v)); }))
        cut_face(face);
    }
    return flat.find_exit(x, field, entry);
  }

  std::uint32_t corner_of(const M& m, const vert_t<M>& v) const {
    if (!has_all_ || verts.size() <= longest_scan)
      return static_cast<std::uint32_t>(std::find(verts.begin(), verts.end(), v) - verts.begin());
    return corner_numbers_.find(core::index_table::hash(index_of(m, v)),
                                [&](std::uint32_t k) { return verts[k] == v; });
  }

  /// The triangle of a face with this number.
  std::uint32_t triangle(const face_t<M>& f, std::uint32_t number) {
    const std::uint32_t face = number_of(f);
    cut_face(face);
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t)
      if (flat.triangles[t].face == face && flat.triangles[t].number == number) return t;
    return 0;
  }

  /// The triangle of face f that contains x, seen along its normal; of several, and outside all, the nearest. The faces
  /// have been cut.
  std::uint32_t nearest_triangle(const face_t<M>& f, const vec3& x) const {
    std::uint32_t best = 0;
    double best_depth = -std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t) {
      const cell_triangle& c = flat.triangles[t];
      if (!(faces[c.face] == f)) continue;
      const std::array<vec3, 3> at = {flat.points[c.corner[0]], flat.points[c.corner[1]], flat.points[c.corner[2]]};
      const double depth = depth_in_triangle(x, at, triangle_normal(at[0], at[1], at[2]));
      if (depth > best_depth) {
        best_depth = depth;
        best = t;
      }
    }
    return best;
  }

  const std::vector<vec3>& corner_points() {
    read_all();
    return flat.points;
  }

 private:
  void start(const M& m, const poly_t<M>& p) {
    is_read_ = true;
    has_all_ = false;
    m_ = &m;
    poly_ = p;
    verts.clear();
    faces.clear();
    flat.clear();
    for (const face_t<M> f : adj_p2f(m, p)) {
      faces.push_back(f);
      flat.add_face();
    }
  }

  std::uint32_t number_of(const face_t<M>& f) const {
    return static_cast<std::uint32_t>(std::find(faces.begin(), faces.end(), f) - faces.begin());
  }

  /// The corner of the kept triangles at a place in the face's cycle.
  std::uint32_t corner_in_ring(std::uint32_t place) const {
    for (const cell_triangle& t : kept_.triangles)
      for (std::uint32_t k = 0; k < 3; ++k)
        if (t.ring[k] == place) return t.corner[k];
    return 0;
  }

  void read_corners(std::uint32_t face) {
    if (flat.has_corners(face)) return;
    for (const vert_t<M> v : adj_f2v(*m_, faces[face])) {
      const std::uint32_t c = corner_of(*m_, v);
      flat.add_corner(face, c);
      if (c < verts.size()) continue;
      verts.push_back(v);
      flat.points.push_back(to_vec3(point(*m_, v)));
      if (!is_finite(flat.points.back())) throw_points_not_finite(index_of(*m_, poly_));
    }
  }

  void cut_face(std::uint32_t face) {
    if (flat.is_cut(face)) return;
    read_corners(face);
    // asked here only: it may have to search, and few faces are cut
    flat.set_outward(face, face_is_outward(*m_, poly_, faces[face]));
    flat.cut_face(face);
  }

  bool has_corner(std::uint32_t face, std::uint32_t corner) const {
    if (flat.has_corners(face)) return flat.has_corner(face, corner);
    bool found = false;
    for (const vert_t<M> v : adj_f2v(*m_, faces[face])) found |= v == verts[corner];
    return found;
  }

  cell_exit leave_tet(const vec3& x, std::span<const std::uint32_t> entry) {
    const std::uint32_t behind = flat.corner_left_behind(x, field, entry);
    if (behind == flat_cell::no_corner) return {};
    std::uint32_t out = 4;
    for (std::uint32_t face = 4; face-- > 0;)  // all are read, without branches: so the memory of one does not wait for
                                               // another's
      out = has_corner(face, behind) ? out : face;
    if (out == 4) return {};
    cut_face(out);
    return flat.leave_through(out, x, field, entry);
  }

  /// Indices of a cell are often those of a grid, and differ by powers of two.
  void fill_table(const M& m) {
    corner_numbers_.clear();
    for (std::uint32_t k = 0; k < verts.size(); ++k)
      corner_numbers_.add(core::index_table::hash(index_of(m, verts[k])), k);
  }
};

}  // namespace concino::detail
