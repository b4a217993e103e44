// Defines kernel.hpp. A box is cut by the planes of all facets, which gives the volume and a point inside. Seen from
// there, the planes have dual points, and the verts of the kernel are the faces of their convex hull.
#pragma once

#include <concino/core/error.hpp>
#include <concino/geometry/convex_hull.hpp>
#include <concino/geometry/kernel.hpp>
#include <concino/geometry/support/convex_cuts.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <utility>

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

/// The polyhedron whose dual is the convex hull of points about the origin: a vert for each face, a face for each
/// corner. Verts closer than eps are joined.
class dual_of_hull {
  using index = std::uint32_t;
  struct directed_edge {
    index from, to, face;
    bool operator<(const directed_edge& o) const { return from != o.from ? from < o.from : to < o.to; }
  };

  const surface_arrays& hull_;
  std::vector<directed_edge> edges_;
  std::vector<vec3> verts_;
  std::vector<index> joined_to_;

  std::span<const vert_id> corners(std::size_t f) const {
    return std::span(hull_.verts).subspan(hull_.offsets[f], hull_.offsets[f + 1] - hull_.offsets[f]);
  }
  const directed_edge& edge(index from, index to) const {
    return *std::lower_bound(edges_.begin(), edges_.end(), directed_edge{from, to, 0});
  }
  index representative(index v) const {
    while (joined_to_[v] != v) v = joined_to_[v];
    return v;
  }

 public:
  dual_of_hull(const surface_arrays& hull, double eps) : hull_(hull) {
    for (std::size_t f = 0; f < hull.num_polys(); ++f) {
      const auto loop = corners(f);
      vec3 doubled, mean;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const index a = loop[i].raw(), b = loop[i + 1 == loop.size() ? 0 : i + 1].raw();
        edges_.push_back({a, b, static_cast<index>(f)});
        doubled += cross(hull.points[a] - hull.points[loop[0].raw()], hull.points[b] - hull.points[loop[0].raw()]);
        mean += hull.points[a] / static_cast<double>(loop.size());
      }
      verts_.push_back(doubled / dot(doubled, mean));
      joined_to_.push_back(static_cast<index>(f));
    }
    std::sort(edges_.begin(), edges_.end());
    for (const directed_edge& e : edges_) {
      const index a = representative(e.face), b = representative(edge(e.to, e.from).face);
      if (a != b && distance(verts_[a], verts_[b]) <= eps) joined_to_[std::max(a, b)] = std::min(a, b);
    }
  }

  surface_arrays operator()() const {
    surface_arrays s;
    constexpr index none = static_cast<index>(-1);
    std::vector<index> number(verts_.size(), none);
    s.offsets.push_back(0);
    std::vector<index> loop;
    for (auto first = edges_.begin(); first != edges_.end(); ++first) {
      if (first != edges_.begin() && first->from == (first - 1)->from) continue;
      loop.clear();
      // From each face around the corner to the next one clockwise.
      directed_edge e = *first;
      do {
        const index v = representative(e.face);
        if (loop.empty() || loop.back() != v) loop.push_back(v);
        const index f = edge(e.to, e.from).face;
        const auto around = corners(f);
        std::size_t i = 0;
        while (around[i].raw() != e.from) ++i;
        e = {e.from, around[i + 1 == around.size() ? 0 : i + 1].raw(), f};
      } while (e.to != first->to);
      while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
      if (loop.size() < 3) continue;
      for (auto v = loop.rbegin(); v != loop.rend(); ++v) {
        if (number[*v] == none) {
          number[*v] = static_cast<index>(s.points.size());
          s.points.push_back(verts_[*v]);
        }
        s.verts.push_back(vert_id{number[*v]});
      }
      s.offsets.push_back(static_cast<std::uint32_t>(s.verts.size()));
    }
    return s;
  }
};

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
  const vec3 witness = centroid_of_body(body);
  std::vector<vec3> dual;
  for (const auto& [n, x] : planes) {
    const double height = dot(n, x - witness);
    if (!(height > 0)) return kernel;  // the volume was rounding errors
    dual.push_back(n / height);
  }
  const convex_hull_result hull = convex_hull(dual);
  if (hull.dimension < 3) return kernel;
  kernel.surface = dual_of_hull(hull.surface, 10 * eps)();
  for (vec3& x : kernel.surface.points) x = frame.from_local(witness + x);
  kernel.volume = frame.from_local(volume, 3);
  kernel.witness = frame.from_local(witness);
  return kernel;
}

}  // namespace concino::detail

namespace concino {

CONCINO_INLINE polygon_kernel kernel(std::span<const vec3> polygon) {
  return detail::kernel_in_plane(core::checked_simple_polygon(polygon, "kernel"));
}

}  // namespace concino
