// One polyhedron of a volume after another, as triangles in flat arrays.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/concepts/oriented_edges.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/lines/detail/flat_cell.hpp>
#include <concino/lines/detail/line_signs.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

template<class M>
class polyhedron_reader {
  polygon_triangulator cut_;
  std::vector<std::uint32_t> ring_;
  std::vector<vec3> ring_points_;
  poly_t<M> poly_ = poly_t<M>();
  bool is_read_ = false;

 public:
  std::vector<vert_t<M>> verts;
  std::vector<face_t<M>> faces;
  flat_cell flat;
  vec3 field;  // set by the caller

  void forget() { is_read_ = false; }
  const poly_t<M>& poly() const { return poly_; }

  /// False if p is the poly read last.
  bool read(const M& m, const poly_t<M>& p) {
    if (is_read_ && p == poly_) return false;
    is_read_ = true;
    poly_ = p;
    verts.clear();
    faces.clear();
    flat.points.clear();
    flat.triangles.clear();
    for (const vert_t<M> v : adj_p2v(m, p)) {
      verts.push_back(v);
      flat.points.push_back(to_vec3(point(m, v)));
    }
    for (const face_t<M> f : adj_p2f(m, p)) {
      add_face(m, f);
      faces.push_back(f);
    }
    return true;
  }

  std::uint32_t corner_of(const vert_t<M>& v) const { return static_cast<std::uint32_t>(std::find(verts.begin(), verts.end(), v) - verts.begin()); }

  /// The triangle of a face with this number.
  std::uint32_t triangle(const face_t<M>& f, std::uint32_t number) const {
    for (std::uint32_t t = 0; t < flat.triangles.size(); ++t)
      if (flat.triangles[t].number == number && faces[flat.triangles[t].face] == f) return t;
    return 0;
  }

 private:
  /// The triangles of a face are those of polygon_triangulator, from its first corner in `lies_before` towards the earlier one of its neighbours: so they
  /// are the same for both cells, and do not depend on the corner with which the mesh begins the face.
  void add_face(const M& m, const face_t<M>& f) {
    ring_.clear();
    for (const vert_t<M> v : adj_f2v(m, f)) ring_.push_back(corner_of(v));
    const std::uint32_t n = static_cast<std::uint32_t>(ring_.size()), face = static_cast<std::uint32_t>(faces.size());
    bool outward = face_is_outward(m, poly_, f);
    if (n == 3) {
      if (outward) flat.triangles.push_back({{ring_[0], ring_[1], ring_[2]}, {0, 1, 2}, face, 0, 3});
      else flat.triangles.push_back({{ring_[0], ring_[2], ring_[1]}, {0, 2, 1}, face, 0, 3});
      return;
    }
    const auto at = [&](std::uint32_t i) -> const vec3& { return flat.points[ring_[i]]; };
    std::uint32_t first = 0;
    for (std::uint32_t i = 1; i < n; ++i)
      if (lies_before(at(i), at(first))) first = i;
    std::rotate(ring_.begin(), ring_.begin() + first, ring_.end());
    if (lies_before(at(n - 1), at(1))) {
      std::reverse(ring_.begin() + 1, ring_.end());
      outward = !outward;
    }
    std::uint32_t number = 0;
    const auto add = [&](const polygon_triangle& t) {
      const std::uint32_t b = outward ? t[1] : t[2], c = outward ? t[2] : t[1];
      flat.triangles.push_back({{ring_[t[0]], ring_[b], ring_[c]}, {t[0], b, c}, face, number++, n});
    };
    if (n == 4) {
      const bool from_0 = is_cut_from_0(at(0), at(1), at(2), at(3));
      add(from_0 ? polygon_triangle{0, 1, 2} : polygon_triangle{1, 2, 3});
      add(from_0 ? polygon_triangle{0, 2, 3} : polygon_triangle{1, 3, 0});
      return;
    }
    ring_points_.clear();
    for (std::uint32_t i = 0; i < n; ++i) ring_points_.push_back(at(i));
    for (const polygon_triangle& t : cut_(ring_points_)) add(t);
  }

  /// Whether the smaller triangle is as large with the diagonal from 0 to 2 as with the other: the rule of polygon_triangulator, with fewer operations.
  static bool is_cut_from_0(const vec3& p0, const vec3& p1, const vec3& p2, const vec3& p3) {
    const vec3 d02 = p2 - p0, d13 = p3 - p1, u = p1 - p0, n = cross(d02, d13);
    const double whole = dot(n, n), t012 = dot(n, cross(u, d02)), t013 = dot(n, cross(u, d13));
    return std::min(t012, whole - t012) >= std::min(t013, whole - t013);
  }
};

}  // namespace concino::detail
