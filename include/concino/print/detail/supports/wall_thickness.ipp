// Defines wall_thickness.hpp. Rays through the triangles of a part, from the middles of parts of triangles.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/geometry/bounding_tree.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/print/wall_thickness.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

class thin_place_search {
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  struct place {
    double distance = infinite;
    vec3 from, to;
    std::uint32_t opposite = 0;  // a triangle
  };

  const part_surface& part_;
  const trimesh mesh_;
  const poly_tree<trimesh> tree_;
  double limit_, spacing_, min_cosine_, orientation_;

  static trimesh mesh_of(const part_surface& part) {
    surface_arrays a{part.points, {}, {}, 3};
    for (const auto& t : part.triangles)
      for (const std::uint32_t v : t) a.verts.push_back(vert_id(v));
    return trimesh(std::move(a));
  }

  /// The first place where a ray from x ends, if the triangle there is opposite to one of this normal.
  place measure(const vec3& x, const vec3& normal, std::uint32_t owner) const {
    const vec3 along = orientation_ * normal;
    const double margin = 16 * part_.tolerance;  // the triangle, and one in the same place, may be in front of x by
                                                 // rounding
    for (const auto& hit : tree_.ray_all(x - margin * along, along, {.max_parameter = limit_ + margin})) {
      const auto t = static_cast<std::uint32_t>(index_of(mesh_, hit.poly));
      if (part_.owners[t] == owner) continue;
      const auto [a, b, c] = part_.triangle(t);
      const vec3 area = cross(b - a, c - a);
      const double cosine = -dot(area, normal) / norm(area);
      if (!(cosine > 0)) continue;
      const double d = std::max(0.0, hit.parameter - margin);
      if (cosine < min_cosine_ || d >= limit_) return {};
      return {d, x, hit.point, t};
    }
    return {};
  }

  place thinnest(std::size_t triangle) const {
    const auto corners = part_.triangle(triangle);
    const vec3 &a = corners[0], &b = corners[1], &c = corners[2];
    const vec3& area = part_.areas[part_.owners[triangle]];
    const vec3 normal = area / norm(area);
    const double longest = std::max({distance(a, b), distance(b, c), distance(c, a)});
    const auto n = static_cast<std::size_t>(std::clamp(std::ceil(longest / spacing_), 1.0, 1000.0));
    place best;
    const auto visit = [&](double i, double j) {  // the middle of a part, in thirds of parts
      const double s = i / static_cast<double>(3 * n), t = j / static_cast<double>(3 * n);
      const place found = measure(a + s * (b - a) + t * (c - a), normal, part_.owners[triangle]);
      if (found.distance < best.distance) best = found;
    };
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i + j < n; ++i) {
        const double x = static_cast<double>(3 * i), y = static_cast<double>(3 * j);
        visit(x + 1, y + 1);
        if (i + j + 1 < n) visit(x + 2, y + 2);
      }
    return best;
  }

 public:
  thin_place_search(const part_surface& part, double limit, double spacing, double max_tilt_deg, bool outward)
      : part_(part), mesh_(mesh_of(part)), tree_(mesh_), limit_(limit * (1 - 1e-9)), spacing_(spacing),
        min_cosine_(std::cos((max_tilt_deg + 1e-6) * 3.14159265358979323846 / 180)), orientation_(outward ? 1 : -1) {}

  std::vector<polygon_thickness> operator()() const {
    std::vector<place> places(part_.triangles.size());
    parallel_for(places.size(), [&](std::size_t t) { places[t] = thinnest(t); }, 16);
    std::vector<polygon_thickness> result;
    for (std::size_t t = 0; t < places.size(); ++t) {
      const place& p = places[t];
      if (!(p.distance < infinite)) continue;
      const double thickness = part_.to_mesh(p.distance, 1);
      const bool is_new = result.empty() || result.back().polygon != part_.owners[t];
      if (is_new) result.emplace_back();
      if (is_new || thickness < result.back().thickness)
        result.back() = {part_.owners[t], part_.owners[p.opposite], thickness, part_.to_mesh(p.from),
                         part_.to_mesh(p.to)};
    }
    return result;
  }
};

CONCINO_INLINE std::vector<polygon_thickness> find_thin_places(const part_surface& part, double limit, bool outward,
                                                               const wall_options& options, const char* caller) {
  if (!(limit > 0))
    core::throw_joined<invalid_argument>(
        {caller, outward ? ": width must be positive" : ": thickness must be positive"});
  if (options.spacing && !(*options.spacing > 0 && std::isfinite(*options.spacing)))
    core::throw_joined<invalid_argument>({caller, ": options.spacing must be positive and finite"});
  if (!(options.max_tilt_deg >= 0 && options.max_tilt_deg <= 90))
    core::throw_joined<invalid_argument>({caller, ": options.max_tilt_deg must be in [0, 90]"});
  if (part.triangles.empty()) return {};
  const auto from_mesh = [&](double length) { return std::ldexp(part.shrink * length, -part.exponent); };
  box bounds;
  for (const vec3& x : part.points) bounds.add(x);
  const double spacing = options.spacing ? from_mesh(*options.spacing) : bounds.diagonal() / 100;
  return thin_place_search(part, from_mesh(limit), spacing, options.max_tilt_deg, outward)();
}

}  // namespace concino::detail
