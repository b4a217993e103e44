// Compares bounding_box, lengths, area, volume, measure, centroid, normals, angles and vert_masses.
#pragma once

#include <agreement/matched.hpp>

#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/corner_angles.hpp>
#include <concino/geometry/dihedral_angles.hpp>
#include <concino/geometry/edge_length.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/operators/mass_matrix.hpp>

#include <algorithm>
#include <numbers>

namespace concino::agreement {

inline void expect_close(const vec3& a, const vec3& b, double largest, const char* what) {
  for (std::size_t k = 0; k < 3; ++k) expect_close(a[k], b[k], largest, what);
}
/// The largest coordinate.
inline double largest_in(const box& b) {
  double largest = 0;
  for (std::size_t k = 0; k < 3 && !b.is_empty(); ++k) largest = std::max({largest, std::abs(b.min[k]), std::abs(b.max[k])});
  return largest;
}

struct sizes {
  static constexpr const char* name = "measure";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto& n = both.native;
    const auto& m = both.other;
    const box a = bounding_box(n), b = bounding_box(m);
    expect(a.min == b.min && a.max == b.max, "the bounding box");
    const double coordinate = largest_in(a), size = largest_of(both.polys.all, [&](const auto p) { return measure(n, p); });
    expect_close(total_measure(n), total_measure(m), size * static_cast<double>(both.polys.all.size()), "total_measure");
    for (const auto p : both.polys.all) {
      const auto& q = both.polys.to(p);
      expect_close(measure(n, p), measure(m, q), size, "measure");
      expect_close(vert_mean(n, p), vert_mean(m, q), coordinate, "vert_mean");
      expect_close(centroid(n, p), centroid(m, q), coordinate, "centroid");
      if constexpr (SurfaceMesh<typename B::other_mesh>) expect_close(area_vector(n, p), area_vector(m, q), size, "area_vector");
    }
    if constexpr (VolumeMesh<typename B::other_mesh>) {
      const double largest = largest_of(both.faces.all, [&](const auto f) { return area(n, f); });
      for (const auto f : both.faces.all) expect_close(area(n, f), area(m, both.faces.to(f)), largest, "area of a face");
    }
    directions(both);
    return true;
  }

 private:
  /// Compares the functions of the whole mesh on one mesh with those of single elements on the other. Polygons without area are left out: their
  /// directions consist only of rounding errors, which depend on the first vert.
  template<class B>
  static void directions(const B& both) {
    using M = typename B::other_mesh;
    const auto& n = both.native;
    const auto& m = both.other;
    const auto length = edge_lengths(n);
    const auto size = measures(m);
    const auto centre = centroids(m);
    const double longest = largest_of(both.edges.all, [&](const auto e) { return length[e]; });
    const double largest = largest_of(both.polys.all, [&](const auto p) { return measure(n, p); }), coordinate = largest_in(bounding_box(n));
    for (const auto e : both.edges.all) expect_close(length[e], edge_length(m, both.edges.to(e)), longest, "edge_length");
    for (const auto p : both.polys.all) {
      expect_close(measure(n, p), size[both.polys.to(p)], largest, "measures");
      expect_close(centroid(n, p), centre[both.polys.to(p)], coordinate, "centroids");
    }
    if constexpr (SurfaceMesh<M>) {
      const auto normals = surface_normals(m);
      const auto defect = angle_defects(m);
      const auto expected = angle_defects(n);
      for (const auto p : both.polys.all) {
        if (area(n, p) < 1e-9) continue;
        expect_close(normal(n, p), normals.polys[both.polys.to(p)], 1, "normal");
        for (const auto v : adj_p2v(n, p)) expect_close(corner_angle(n, p, v), corner_angle(m, both.polys.to(p), both.verts.to(v)), full_turn, "corner_angle");
      }
      for (const auto v : both.verts.all) {
        if (norm(vert_normal(n, v)) > 0.5) expect_close(vert_normal(n, v), normals.verts[both.verts.to(v)], 1, "vert_normal");
        expect_close(expected[v], defect[both.verts.to(v)], full_turn, "angle_defects");
      }
      for (const auto e : both.edges.all)  // where two polys have opposite orientations, the angle depends on the poly
        expect_close(one_side(dihedral_angle(n, e)), one_side(dihedral_angle(m, both.edges.to(e))), full_turn, "dihedral_angle");
    } else {
      const auto normals = vert_normals(m);
      for (const auto f : both.faces.all)
        if (area(n, f) > 1e-9) expect_close(std::abs(dot(normal(n, f), normal(m, both.faces.to(f)))), 1, 1, "normal of a face");
      for (const auto v : both.verts.all)
        if (norm(vert_normal(n, v)) > 0.5) expect_close(vert_normal(n, v), normals[both.verts.to(v)], 1, "vert_normal");
      for (const auto p : both.polys.all)
        for (const auto e : adj_p2e(n, p))
          expect_close(dihedral_angle(n, p, e), dihedral_angle(m, both.polys.to(p), both.edges.to(e)), full_turn, "dihedral_angle");
    }
  }
  static constexpr double full_turn = 2 * std::numbers::pi;
  static double one_side(double angle) { return std::min(angle, 2 * std::numbers::pi - angle); }
};

struct masses {
  static constexpr const char* name = "mass_matrix";
  template<class M> static constexpr bool runs_on = EmbeddedMesh<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto expected = mass_matrix(both.native);
    const auto found = mass_matrix(both.other);
    expect(found.nonZeros() == found.rows() && std::size_t(found.rows()) == vert_index_bound(both.other), "the size of the matrix");
    double sum = 0;
    const double largest = largest_of(both.verts.all, [&](const auto v) { return expected.coeff(static_cast<Eigen::Index>(v.raw()), static_cast<Eigen::Index>(v.raw())); });
    for (const auto v : both.verts.all) {
      const auto i = static_cast<Eigen::Index>(index_of(both.other, both.verts.to(v)));
      const auto j = static_cast<Eigen::Index>(v.raw());
      expect_close(expected.coeff(j, j), found.coeff(i, i), largest, "the mass of a vert");
      sum += found.coeff(i, i);
    }
    for (int i = 0; i < found.rows(); ++i) sum -= found.coeff(i, i);
    expect_close(sum, 0, largest * static_cast<double>(found.rows()), "no mass at removed verts");
    return true;
  }
};

}  // namespace concino::agreement
