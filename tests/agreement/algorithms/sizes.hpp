// bounding_box, area, volume, measure, centroid and vert_masses.
#pragma once

#include <agreement/matched.hpp>

#include <concino/geometry/bounding_box.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/operators/mass_matrix.hpp>

namespace concino::agreement {

inline void expect_close(const vec3& a, const vec3& b, const char* what) {
  for (std::size_t k = 0; k < 3; ++k) expect_close(a[k], b[k], what);
}

struct sizes {
  static constexpr const char* name = "measure";
  template<class M> static constexpr bool runs_on = AnyMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto& n = both.native;
    const auto& m = both.other;
    const box a = bounding_box(n), b = bounding_box(m);
    expect(a.min == b.min && a.max == b.max, "the bounding box");
    expect_close(total_measure(n), total_measure(m), "total_measure");
    for (const auto p : both.polys.all) {
      const auto& q = both.polys.to(p);
      expect_close(measure(n, p), measure(m, q), "measure");
      expect_close(vert_mean(n, p), vert_mean(m, q), "vert_mean");
      expect_close(centroid(n, p), centroid(m, q), "centroid");
      if constexpr (SurfaceMesh<typename B::other_mesh>) expect_close(area_vector(n, p), area_vector(m, q), "area_vector");
    }
    if constexpr (VolumeMesh<typename B::other_mesh>)
      for (const auto f : both.faces.all) expect_close(area(n, f), area(m, both.faces.to(f)), "area of a face");
    return true;
  }
};

struct masses {
  static constexpr const char* name = "mass_matrix";
  template<class M> static constexpr bool runs_on = AnyMesh<M> && Embedded<M>;

  template<class B, class In>
  static bool check(const B& both, const In&) {
    const auto expected = mass_matrix(both.native);
    const auto found = mass_matrix(both.other);
    expect(found.nonZeros() == found.rows() && std::size_t(found.rows()) == vert_index_bound(both.other), "the size of the matrix");
    double sum = 0;
    for (const auto v : both.verts.all) {
      const auto i = static_cast<Eigen::Index>(index_of(both.other, both.verts.to(v)));
      const auto j = static_cast<Eigen::Index>(v.raw());
      expect_close(expected.coeff(j, j), found.coeff(i, i), "the mass of a vert");
      sum += found.coeff(i, i);
    }
    for (int i = 0; i < found.rows(); ++i) sum -= found.coeff(i, i);
    expect_close(sum, 0, "no mass at removed verts");
    return true;
  }
};

}  // namespace concino::agreement
