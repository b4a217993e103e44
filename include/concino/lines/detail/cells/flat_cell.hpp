// The surface of a polyhedron as triangles in flat arrays, and where a line inside leaves it.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/lines/detail/cells/line_signs.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace concino::detail {

/// A triangle of a face, counter-clockwise seen from outside.
struct cell_triangle {
  std::array<std::uint32_t, 3> corner{};  // of the cell
  std::array<std::uint32_t, 3> ring{};    // of the face: places in its cycle of verts, the same ones for both cells of
                                          // the face
  std::uint32_t face = 0, number = 0;     // among the faces of the cell, among the triangles of the face
  std::uint32_t ring_size = 3;

  /// Whether the side from corner k to the next one is a diagonal of the face.
  bool is_diagonal(unsigned k) const {
    const std::uint32_t a = ring[k], b = ring[(k + 1) % 3];
    return (a + 1) % ring_size != b && (b + 1) % ring_size != a;
  }
};

/// Where a line leaves a cell: inside a triangle, on side k of it, or at corner k of it.
struct cell_exit {
  enum class kind { none, triangle, side, corner };
  kind at = kind::none;
  std::uint32_t triangle = 0, k = 0;
  double parameter = 0;  // on the side, from corner k to the next one
  vec3 position;
};

/// One cell after another. Faces are cut into triangles when they are needed.
class flat_cell {
 public:
  std::vector<vec3> points;
  std::vector<cell_triangle> triangles;  // of the faces that were cut

  void clear();
  /// Adds a face; its corners are given before it is used, and its direction before it is cut.
  void add_face() { faces_.push_back({0, 0, false, false}); }
  /// The corners of a face are given one after another, before those of the next face.
  void add_corner(std::uint32_t face, std::uint32_t corner) {
    if (faces_[face].size++ == 0) faces_[face].first = static_cast<std::uint32_t>(corners_.size());
    corners_.push_back(corner);
  }
  void set_outward(std::uint32_t face, bool is_outward) { faces_[face].is_outward = is_outward; }
  bool is_cut(std::uint32_t face) const { return faces_[face].is_cut; }
  bool has_corners(std::uint32_t face) const { return faces_[face].size > 0; }
  bool has_corner(std::uint32_t face, std::uint32_t corner) const;
  /// ring: the corners of the face in cyclic order, counter-clockwise seen from outside or not.
  void set_face(std::uint32_t face, std::span<const std::uint32_t> ring, bool is_outward);
  void add_face(std::span<const std::uint32_t> ring, bool is_outward) {
    add_face();
    set_face(static_cast<std::uint32_t>(faces_.size() - 1), ring, is_outward);
  }
  /// The triangles are those of polygon_triangulator, from the first corner in `lies_before` towards the earlier one of
  /// its neighbours: so they are the same for both cells, and do not depend on the corner with which the mesh begins
  /// the face.
  void cut_face(std::uint32_t face);
  /// Adds a face that another cell has cut, with its points; its first corner is the next of this cell. cut: the
  /// triangles there; same_way: outward is the same direction in both cells.
  void add_cut_face(std::uint32_t face, std::span<const vec3> ring, std::span<const cell_triangle> cut, bool same_way);

  /// Where the line from x along g leaves the cell for the first time.
  /// Needs: entry: the corners of the triangle (3), the edge (2) or the vert (1) at which x lies, or none, inside. x
  ///        lies there but for rounding.
  /// `none` if the line misses the cell, which happens if x is so near to the border of its triangle or edge that
  /// rounding put it outside.
  cell_exit leave(const vec3& x, const vec3& g, std::span<const std::uint32_t> entry);
  // The same in steps: look along the line, cut the faces that it may cross, and take the exit from what was cut.
  void look(const vec3& x, const vec3& g);
  /// Whether the line may pass through a face. corners: anything with a range of points, by a function.
  template<class R, class P>
  bool may_cross(const R& corners, const P& point_of);
  cell_exit find_exit(const vec3& x, const vec3& g, std::span<const std::uint32_t> entry);

  /// Whether this is a tet. Where all corners are known, its exit is found by fewer determinants.
  bool is_tet() const { return points.size() == 4 && faces_.size() == 4 && corners_.size() == 12; }
  static constexpr std::uint32_t no_corner = ~0u;
  /// Of a tet: which corner of the triangle of entry is not on the face by which the line leaves. `no_corner` if it
  /// misses the tet.
  std::uint32_t corner_left_behind(const vec3& x, const vec3& g, std::span<const std::uint32_t> entry) const;
  /// Where the line leaves a tet through a face. Its position does not depend on the vert with which the mesh begins
  /// the face.
  cell_exit leave_through(std::uint32_t face, const vec3& x, const vec3& g, std::span<const std::uint32_t> entry);

 private:
  struct projected_corner {  // a corner in the plane across g, relative to x
    double u, v;
    bool is_entry = false;
  };
  struct face_ring {
    std::uint32_t first, size;
    bool is_outward, is_cut;
  };

  polygon_triangulator cut_;
  std::vector<face_ring> faces_;
  std::vector<std::uint32_t> corners_, ring_;
  std::vector<vec3> ring_points_;
  vec3 x_, u_, v_;  // of the line: a point on it, and two directions across it
  std::vector<projected_corner> projected_;
  std::vector<projected_corner> projected_face_ = std::vector<projected_corner>(16);
  double product_error_ = 0;  // more than the errors of products of projected_

  void project_corners(std::span<const std::uint32_t> entry);
  int quick_side(std::uint32_t a, std::uint32_t b) const;
  signed_value side(std::uint32_t a, std::uint32_t b, const vec3& x, const vec3& g,
                    std::span<const std::uint32_t> entry) const;
  bool leaves_through(const cell_triangle& t, const vec3& x, const vec3& g, std::span<const std::uint32_t> entry) const;
  double distance_to(std::uint32_t triangle, const vec3& x, const vec3& g) const;
  /// first: the corner of the triangle from which the position inside it is measured.
  cell_exit exit_in(std::uint32_t triangle, const vec3& x, const vec3& g, std::span<const std::uint32_t> entry,
                    std::uint32_t first) const;
};

template<class R, class P>
inline bool flat_cell::may_cross(const R& corners, const P& point_of) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const vec3 x = x_, a = u_, b = v_;
  double squares = 0, least_u = infinity, most_u = -infinity, least_v = infinity, most_v = -infinity;
  projected_corner sum = {0, 0};
  std::size_t n = 0;
  for (const auto& c : corners) {
    const vec3 d = point_of(c) - x;
    const projected_corner p = {dot(d, a), dot(d, b)};
    if (n == projected_face_.size()) projected_face_.resize(2 * n);
    projected_face_[n++] = p;
    squares += dot(d, d);
    least_u = std::min(least_u, p.u);
    most_u = std::max(most_u, p.u);
    least_v = std::min(least_v, p.v);
    most_v = std::max(most_v, p.v);
    sum.u += p.u;
    sum.v += p.v;
  }
  // the line is so far on one side of all corners
  const double off = std::max(std::max(least_u, -most_u), std::max(least_v, -most_v));
  if (off > 0 && off * off > 1e-28 * squares) return false;
  double least = infinity;  // the parts of the corners along the direction to their mean
  for (std::size_t i = 0; i < n; ++i)
    least = std::min(least, projected_face_[i].u * sum.u + projected_face_[i].v * sum.v);
  return !(least > 0 && least * least > 1e-28 * squares * (sum.u * sum.u + sum.v * sum.v));
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/lines/detail/cells/flat_cell.ipp>
#endif
