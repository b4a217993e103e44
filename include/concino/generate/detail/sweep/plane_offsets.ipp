// Bodies of plane_offsets.hpp: the vectors along which verts move so that the planes of polys keep a distance.
#pragma once

#include <concino/generate/detail/sweep/plane_offsets.hpp>

#include <Eigen/Eigenvalues>

#include <array>

namespace concino::detail {

CONCINO_INLINE std::vector<vec3> plane_offsets(const swept_surface& s, const std::vector<vec3>& poly_normals) {
  std::vector<std::array<double, 6>> products(s.points.size());  // of the normals with themselves: xx, xy, xz, yy, yz,
                                                                 // zz
  std::vector<vec3> sums(s.points.size());
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    const vec3 n = poly_normals[p];
    for (std::uint32_t i = s.offsets[p]; i < s.offsets[p + 1]; ++i) {
      std::array<double, 6>& a = products[s.verts[i]];
      a[0] += n.x * n.x, a[1] += n.x * n.y, a[2] += n.x * n.z, a[3] += n.y * n.y, a[4] += n.y * n.z, a[5] += n.z * n.z;
      sums[s.verts[i]] += n;
    }
  }
  parallel_for(sums.size(), [&](std::size_t v) {
    const std::array<double, 6>& a = products[v];
    Eigen::Matrix3d m;
    m << a[0], a[1], a[2], a[1], a[3], a[4], a[2], a[4], a[5];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(m);
    vec3 offset;
    for (int k = 0; k < 3; ++k) {
      // the planes are almost parallel to this direction
      if (!(parts.eigenvalues()[k] > 0.01 * parts.eigenvalues()[2])) continue;
      const auto axis = parts.eigenvectors().col(k);
      const vec3 u{axis[0], axis[1], axis[2]};
      offset += (dot(u, sums[v]) / parts.eigenvalues()[k]) * u;
    }
    sums[v] = offset;
  });
  return sums;
}

}  // namespace concino::detail
