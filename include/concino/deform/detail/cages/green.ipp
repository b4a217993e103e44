// Bodies of green.hpp: Green coordinates of points in a cage of triangles: weights of its verts and of its normals.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/deform/detail/cages/green.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace concino::detail {

/// The integrals over a triangle of 1 / r, and of the linear functions of its corners times the solid angle that they
/// are seen in from x, both divided by 4 pi. The normal points away from the side on which the solid angle is positive.
CONCINO_INLINE void add_green_integrals(const vec3 (&corner)[3], const vec3& normal, const vec3& x, double& single,
                                        double (&linear)[3]) {
  vec3 to[3];
  double r[3], of_edge[3];
  for (int k = 0; k < 3; ++k) to[k] = corner[k] - x, r[k] = norm(to[k]);
  const double height = dot(to[0], normal);  // positive where x is behind the triangle
  const double solid = 2 * std::atan2(dot(to[0], cross(to[1], to[2])),
                                      r[0] * r[1] * r[2] + dot(to[0], to[1]) * r[2] + dot(to[1], to[2]) * r[0] +
                                          dot(to[2], to[0]) * r[1]);
  vec3 in_plane[3];  // the outward normals of the edges; edge k is opposite of corner k
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const vec3 along = (corner[b] - corner[a]) / distance(corner[b], corner[a]);
    in_plane[k] = cross(along, normal);
    const double from = dot(to[a], along), until = dot(to[b], along), offset = dot(to[a], in_plane[k]);
    // the integral of 1 / r along the edge, without cancellation
    if (from > 0) of_edge[k] = std::log((r[b] + until) / (r[a] + from));
    else if (until < 0) of_edge[k] = std::log((r[a] - from) / (r[b] - until));
    else of_edge[k] = std::log((r[b] + until) * (r[a] - from) / (offset * offset + height * height));
    sum += offset * of_edge[k];
  }
  const vec3 foot = x + height * normal;
  const double doubled = dot(cross(corner[1] - corner[0], corner[2] - corner[0]), normal);
  constexpr double whole = 4 * std::numbers::pi;
  single = (sum - height * solid) / whole;
  for (int k = 0; k < 3; ++k) {
    // the gradient of the linear function of corner k points against the outward normal of the edge
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    const double slope = distance(corner[b], corner[a]) / doubled;
    const double at_foot = dot(cross(corner[b] - corner[a], foot - corner[a]), normal) / doubled;
    double bend = 0;
    for (int e = 0; e < 3; ++e) bend -= slope * dot(in_plane[k], in_plane[e]) * of_edge[e];
    linear[k] = (at_foot * solid - height * bend) / whole;
  }
}

CONCINO_INLINE green_rows make_green_rows(const cage_polys& cage, const std::vector<vec3>& points,
                                          const std::vector<std::size_t>& rows) {
  const char* const caller = "green_coordinates";
  for (std::size_t p = 0; p < cage.index.size(); ++p)
    if (cage.poly(p).size() != 3)
      core::throw_joined<unsupported>({caller, ": poly ", cage.index[p], " of the cage has ", cage.poly(p).size(),
                                       " verts; pass to_triangles(cage)"});
  const flat_cage flat = make_flat_cage(cage, caller);
  green_rows result;
  result.num_verts = flat.num_verts;
  result.triangles = flat.triangles;
  for (std::size_t t = 0; t < flat.triangles.size(); ++t) {
    const auto& [a, b, c] = flat.triangles[t];
    if (!(norm(flat.normals[t]) > 0))
      core::throw_joined<invalid_mesh>({caller, ": poly ", cage.index[t], " of the cage has no area"});
    result.spans.push_back(
        {flat.unit * (flat.points[b] - flat.points[a]), flat.unit * (flat.points[c] - flat.points[a])});
  }
  const std::size_t n = flat.num_verts, f = flat.triangles.size();
  result.of_verts.resize(points.size() * n);
  result.of_normals.resize(points.size() * f);
  std::vector<double> errors(rows.size());
  // A cage whose normals point inwards is used as if they pointed outwards.
  double volume = 0;
  for (const auto& [a, b, c] : flat.triangles) {
    const vec3& o = flat.points[flat.triangles[0][0]];
    volume += dot(flat.points[a] - o, cross(flat.points[b] - o, flat.points[c] - o));
  }
  const double sign = volume < 0 ? -1 : 1;
  parallel_for(
      rows.size(),
      [&](std::size_t i) {
        double* const of_verts = result.of_verts.data() + rows[i] * n;
        double* const of_normals = result.of_normals.data() + rows[i] * f;
        const vec3 x = points[rows[i]] / flat.unit;
        double sum = 0;
        for (std::size_t t = 0; t < f; ++t) {
          const vec3 corner[3] = {flat.points[flat.triangles[t][0]], flat.points[flat.triangles[t][1]],
                                  flat.points[flat.triangles[t][2]]};
          double linear[3];
          add_green_integrals(corner, flat.normals[t], x, of_normals[t], linear);
          of_normals[t] *= sign * flat.unit;
          for (std::size_t k = 0; k < 3; ++k) {
            of_verts[flat.triangles[t][k]] += sign * linear[k];
            sum += sign * linear[k];
          }
        }
        errors[i] = std::abs(sum - 1);
      },
      16);
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (!(errors[i] < 1e-6))
      core::throw_joined<invalid_argument>(
          {caller, ": point ", rows[i], " is not inside of the cage; these coordinates are for points inside"});
  return result;
}

CONCINO_INLINE void check_triangles(const green_rows& weights, const std::vector<std::array<std::uint32_t, 3>>& bent) {
  if (bent != weights.triangles)
    core::throw_joined<invalid_argument>(
        {"points_of: the polys of the bent cage are not those of the cage; pass a copy of it whose points were moved"});
}

CONCINO_INLINE std::vector<vec3> green_rows::points_of(const std::vector<vec3>& bent) const {
  std::vector<vec3> points = weighted_sums(of_verts, num_verts, num_verts == 0 ? 0 : of_verts.size() / num_verts, bent);
  std::vector<vec3> normals(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [u, v] = spans[t];
    const vec3 p = bent[triangles[t][1]] - bent[triangles[t][0]], q = bent[triangles[t][2]] - bent[triangles[t][0]];
    // the stretch of the triangle: the root of the mean of its squares in all directions
    const double stretch =
        std::sqrt(std::max(0.0, dot(p, p) * dot(v, v) - 2 * dot(p, q) * dot(u, v) + dot(q, q) * dot(u, u)) / 2) /
        norm(cross(u, v));
    const vec3 n = cross(p, q);
    const double length = norm(n);
    normals[t] = length > 0 ? (stretch / length) * n : vec3();
  }
  const std::vector<vec3> offsets = weighted_sums(of_normals, triangles.size(), points.size(), normals);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] += offsets[i];
  return points;
}

}  // namespace concino::detail
