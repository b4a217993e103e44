// The measures of the parts above a level set; see measure_parts.hpp.
#pragma once

#include <concino/geometry/polygon.hpp>
#include <concino/level_sets/detail/clip/measure_parts.hpp>

#include <span>

namespace concino::detail {

template<class Crossed>
std::vector<vec3> points_of_places(const std::vector<level_place>& places, const Crossed& crossed, double level) {
  std::vector<vec3> points;
  points.reserve(places.size());
  for (const level_place& x : places) {
    const double t =
        x.kind == level_place::vert ? 1 : crossing_parameter(crossed.values[x.below], crossed.values[x.above], level);
    points.push_back(crossing_point(crossed.points[x.below], crossed.points[x.above], t));
  }
  return points;
}

CONCINO_INLINE double area_above(const poly_parts& parts, const crossed_surface& s, double level) {
  const std::vector<vec3> points = points_of_places(parts.places, s, level);
  double sum = 0;
  for (const poly_parts::part& p : parts.parts) {
    if (!p.is_above) continue;
    const std::span<const std::uint32_t> loop(parts.part_places.data() + p.first, parts.part_places.data() + p.last);
    sum += norm(shape_through<std::uint32_t>(loop, [&](std::uint32_t x) { return points[x]; }).area);
  }
  return sum;
}

CONCINO_INLINE double volume_above(const cell_parts& parts, const crossed_volume& v) {
  const std::vector<vec3> points = points_of_places(parts.places, v, v.level());
  std::vector<polygon_shape> shapes;
  shapes.reserve(parts.faces.size());
  for (const cell_parts::face& f : parts.faces) {
    const std::span<const std::uint32_t> loop(parts.face_places.data() + f.first, parts.face_places.data() + f.last);
    shapes.push_back(shape_through<std::uint32_t>(loop, [&](std::uint32_t x) { return points[x]; }));
  }
  double sum = 0;
  for (const cell_parts::part& p : parts.parts) {
    if (!p.is_above) continue;
    const vec3 origin = shapes[parts.part_faces[p.first]].mean;
    double tripled = 0;
    for (std::uint32_t k = p.first; k < p.last; ++k) {
      const polygon_shape& s = shapes[parts.part_faces[k]];
      const double cone = dot(s.mean - origin, s.area);
      tripled += parts.outward[k] ? cone : -cone;
    }
    sum += tripled / 3;
  }
  return sum;
}

}  // namespace concino::detail
