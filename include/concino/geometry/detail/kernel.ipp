// Defines kernel.hpp: a box is cut by the lines or planes of all facets.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/kernel.hpp>
#include <concino/geometry/support/convex_cuts.hpp>

#include <array>
#include <cstdint>
#include <limits>

namespace concino::detail {

inline constexpr vec3 no_witness{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN(),
                                 std::numeric_limits<double>::quiet_NaN()};

CONCINO_INLINE polygon_kernel kernel_in_plane(const core::flat_polygon& flat) {
  const core::flat_kernel found = core::kernel_of(flat.corners());
  const double area = core::flat_area(found.corners);
  if (!(area > 0)) return {{}, 0, no_witness};
  polygon_kernel kernel{{}, flat.to_space(area, 2), {}};
  const vec3 origin = found.corners[0];
  vec3 moment;
  for (std::size_t i = 1; i + 1 < found.corners.size(); ++i) {
    const vec3 a = found.corners[i] - origin, b = found.corners[i + 1] - origin;
    moment += cross(a, b).z / 6 * (a + b);
  }
  kernel.witness = flat.to_space(origin + moment / area);
  for (const vec3& x : found.corners) kernel.corners.push_back(flat.to_space(x));
  return kernel;
}

/// The centroid of a convex polyhedron with a positive volume.
inline vec3 centroid_of_body(const core::convex_body& body) {
  const vec3 origin = body.faces()[0][0];
  vec3 moment;
  double total = 0;
  for (const auto& f : body.faces())
    for (std::size_t i = 1; i + 1 < f.size(); ++i) {
      const vec3 a = f[0] - origin, b = f[i] - origin, c = f[i + 1] - origin;
      const double part = dot(a, cross(b, c));
      total += part;
      moment += part / 4 * (a + b + c);
    }
  return origin + moment / total;
}

/// The faces of a convex polyhedron on common verts: points closer than eps are one.
inline surface_arrays joined_faces(const core::convex_body& body, double eps) {
  surface_arrays s;
  s.offsets.push_back(0);
  std::vector<vert_id> loop;
  for (const auto& f : body.faces()) {
    loop.clear();
    for (const vec3& x : f) {
      std::size_t v = 0;
      while (v < s.points.size() && distance(s.points[v], x) > eps) ++v;
      if (v == s.points.size()) s.points.push_back(x);
      const vert_id id{static_cast<std::uint32_t>(v)};
      if (std::find(loop.begin(), loop.end(), id) == loop.end()) loop.push_back(id);
    }
    if (loop.size() < 3) continue;
    s.verts.insert(s.verts.end(), loop.begin(), loop.end());
    s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
  }
  return s;
}

CONCINO_INLINE polyhedron_kernel kernel_inside_faces(const std::vector<std::vector<vec3>>& faces, std::size_t poly) {
  const local_frame frame([&](auto&& visit) {
    for (const auto& f : faces)
      for (const vec3& x : f) visit(x);
  });
  if (!frame.is_finite())
    core::throw_joined<invalid_mesh>(
        {"kernel: poly ", poly, " has a vert that is not finite; validate(m) finds such verts"});
  polyhedron_kernel kernel{{}, 0, no_witness};
  if (faces.empty() || faces[0].empty()) return kernel;
  vec3 low, high;
  std::vector<std::array<vec3, 2>> planes;
  auto local = faces;
  for (auto& f : local)
    for (vec3& x : f) {
      x = frame(x);
      for (std::size_t k = 0; k < 3; ++k) low[k] = std::min(low[k], x[k]), high[k] = std::max(high[k], x[k]);
    }
  const double eps = core::flat_part * std::max({high.x - low.x, high.y - low.y, high.z - low.z});
  for (const auto& f : local)
    core::for_each_face_plane(
        f.size(), [&](std::size_t i) -> const vec3& { return f[i]; }, eps,
        [&](const vec3& n, const vec3& x) { planes.push_back({n, x}); });
  core::convex_body body(low, high);
  for (const auto& [n, x] : planes) body.cut(n, x);
  const double volume = body.faces().empty() ? 0 : body.volume();
  if (!(volume > 1e3 * eps * eps * eps)) return kernel;
  kernel.surface = joined_faces(body, 100 * eps);
  for (vec3& x : kernel.surface.points) x = frame.from_local(x);
  kernel.volume = frame.from_local(volume, 3);
  kernel.witness = frame.from_local(centroid_of_body(body));
  return kernel;
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE polygon_kernel kernel(std::span<const vec3> polygon) {
  return detail::kernel_in_plane(core::checked_simple_polygon(polygon, "kernel"));
}

}  // namespace concino
