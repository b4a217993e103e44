// Bodies of surface_reader.hpp: points of surfaces that rays hit, with what shading needs: positions, normals, the
// unlit colour.
#pragma once

#include <concino/render/detail/colors/surface_reader.hpp>
#include <concino/render/detail/colors/unlit_color.hpp>
#include <concino/render/polygon_weights.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace concino::detail {

inline constexpr std::uint32_t max_smooth_corners = 64;  // a polygon with more corners is shaded by its triangles

CONCINO_INLINE double segment_distance(const image_point& p, const image_point& a, const image_point& b) {
  const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
  const double t = length > 0 ? std::min(1.0, std::max(0.0, ((p.x - a.x) * x + (p.y - a.y) * y) / length)) : 0;
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

CONCINO_INLINE surface_reader::hit_triangle surface_reader::read_hit(const ray_hit& hit) {
  const auto [which, local] = scene_.owner(hit.triangle);
  const drawable& d = scene_[which];
  const auto& t = d.triangles[local];
  const std::uint32_t p = d.polygon_of[local], first = d.offsets[p], n = d.offsets[p + 1] - first;
  const std::array<vec3, 3> points{corner(which, t[0]), corner(which, t[1]), corner(which, t[2])};
  const vec3 area_vector = cross(points[1] - points[0], points[2] - points[0]);
  polygon_.clear();
  if (n > 3 && n <= max_smooth_corners) {
    vec3 sum;
    for (std::uint32_t i = 0; i < n; ++i) polygon_.push_back(corner(which, first + i));
    for (std::uint32_t i = 2; i < n; ++i) sum += cross(polygon_[i - 1] - polygon_[0], polygon_[i] - polygon_[0]);
    if (!(norm(sum) > 0)) sum = area_vector;
    const double length = norm(sum);
    polygon_normal_ = length > 0 ? sum / length : vec3{0, 0, 1};
  }
  return {which, d, p, first, n, t, points, area_vector};
}

CONCINO_INLINE interpolation surface_reader::interpolate(const hit_triangle& at, const std::array<double, 3>& bary,
                                                         const vec3& position, std::vector<double>& weights) const {
  if (polygon_.empty()) return {at.first, {}, at.corners, bary};
  polygon_weights(polygon_, polygon_normal_, position, weights);
  return {at.first, weights, at.corners, bary};
}

/// Intersects the rays of the neighbouring samples with the plane of the triangle. Far points are moved towards the
/// sample, so that values there are nearly linear between the two.
CONCINO_INLINE void surface_reader::add_neighbours(sampled_interpolation& mean, const hit_triangle& at,
                                                   const vec3& position, const image_point& film) {
  const vec3 a = at.points[0], e = at.points[1] - a, f = at.points[2] - a;
  const double nn = dot(at.area_vector, at.area_vector), size = std::sqrt(std::max(dot(e, e), dot(f, f)));
  if (!(nn > 0)) return;
  const auto neighbour = [&](double dx, double dy, std::vector<double>& weights, double& part) {
    const view_ray beside = camera_.ray_through({film.x + dx, film.y + dy});
    const double t = dot(position - beside.origin, at.area_vector) / dot(beside.direction, at.area_vector);
    vec3 way = beside.origin + beside.direction * t - position;
    const double length = norm(way);
    if (!(t > 0) || !std::isfinite(length)) return interpolation{};
    part = length > 0.01 * size ? 0.01 * size / length : 1;
    const vec3 point = position + way * part;
    const double u = dot(cross(point - a, f), at.area_vector) / nn, v = dot(cross(e, point - a), at.area_vector) / nn;
    return interpolate(at, {1 - u - v, u, v}, point, weights);
  };
  mean.right = neighbour(pixel_ / fineness_, 0, right_weights_, mean.right_part);
  mean.up = neighbour(0, pixel_ / fineness_, up_weights_, mean.up_part);
}

CONCINO_INLINE void surface_reader::read_color(surface_point& s, sampled_interpolation& mean, const hit_triangle& at,
                                               const image_point& film) {
  if (needs_steps(at.d)) add_neighbours(mean, at, s.position, film);
  s.color = unlit_color(at.d, {at.polygon, mean, fineness_, 2 / pixel_ * fineness_});
  s.opacity = at.d.look.opacity;
  if (at.d.look.edge_width > 0) read_edges(s, at, film);
}

CONCINO_INLINE void surface_reader::read_edges(surface_point& s, const hit_triangle& at, const image_point& film) {
  const drawable& d = at.d;
  double nearest = std::numeric_limits<double>::infinity();
  std::uint32_t nearest_corner = at.first;
  const auto image_of = [&](std::uint32_t i) -> corner_image {
    const vec3 p = corner(at.which, i);
    return {camera_.project(p), camera_.parallel || dot(p - camera_.eye, camera_.back) < 0};
  };
  const auto add_edge = [&](std::uint32_t i, const corner_image& a, const corner_image& b) {
    if (!a.is_in_front || !b.is_in_front) return;
    const double away = segment_distance(film, a.film, b.film);
    if (away < nearest) nearest = away, nearest_corner = i;
  };
  if (at.n <= max_smooth_corners) {
    images_.clear();
    for (std::uint32_t i = 0; i < at.n; ++i) images_.push_back(image_of(at.first + i));
    for (std::uint32_t i = 0; i < at.n; ++i) add_edge(at.first + i, images_[i], images_[(i + 1) % at.n]);
  } else {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = at.corners[k], j = at.corners[(k + 1) % 3];
      if (j - at.first == (i - at.first + 1) % at.n) add_edge(i, image_of(i), image_of(j));
    }
  }
  const double covered = std::min(1.0, std::max(0.0, (d.look.edge_width / 2 - nearest / pixel_) * fineness_ + 0.5));
  const double edge = d.look.edge_opacity * covered;
  s.color = mix(s.color, edge_color(d, nearest_corner), static_cast<float>(edge));
  if (s.opacity > 0) s.opacity += (1 - s.opacity) * edge;  // edges stay visible on transparent surfaces
}

CONCINO_INLINE surface_point surface_reader::operator()(const ray_hit& hit, const view_ray& ray,
                                                        const image_point& film) {
  const hit_triangle at = read_hit(hit);
  const std::array<double, 3> bary{1 - hit.u - hit.v, hit.u, hit.v};
  surface_point s;
  s.position = at.points[0] * bary[0] + at.points[1] * bary[1] + at.points[2] * bary[2];
  const double area = norm(at.area_vector);
  s.flat = area > 0 ? at.area_vector / area : -ray.direction;
  if (dot(s.flat, ray.direction) > 0) s.flat = -s.flat;
  s.shine = at.d.look.shine;
  s.material = &at.d.look.material;

  sampled_interpolation mean;
  mean.at = interpolate(at, bary, s.position, weights_);
  const auto corner_normal = [&](std::uint32_t i) { return to_vec3(at.d.normals[i]); };
  const vec3 smooth = mean.at(corner_normal, vec3{});
  const double length = norm(smooth);
  const double sign = dot(smooth, s.flat) < 0 ? -1 : 1;
  s.normal = length > 1e-6 ? smooth * (sign / length) : s.flat;

  // Rays from a coarse triangle towards grazing light would hit its neighbours, although the approximated surface is
  // round there. So they start on the tangent planes of the corners. Source: Hanika 2021, "Hacking the Shadow
  // Terminator".
  s.smooth_position = s.position;
  for (std::size_t k = 0; k < 3; ++k) {
    const vec3 m = corner_normal(at.corners[k]) * sign;
    s.smooth_position += m * (bary[k] * std::max(0.0, dot(at.points[k] - s.position, m)));
  }
  read_color(s, mean, at, film);
  return s;
}

}  // namespace concino::detail
