// Bodies of tube_builder.hpp: builds the rings, caps and balls of tubes in a drawable.
#pragma once

#include <concino/render/detail/shapes/shape_size.hpp>
#include <concino/render/detail/shapes/tube_builder.hpp>

#include <cmath>

namespace concino::detail {

CONCINO_INLINE tube_frame frame_along(const vec3& d) {
  const double x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
  const vec3 axis = x <= y && x <= z ? vec3{1, 0, 0} : y <= z ? vec3{0, 1, 0} : vec3{0, 0, 1};
  vec3 u = axis - d * dot(axis, d);
  u /= norm(u);
  return {u, cross(d, u), d};
}

CONCINO_INLINE double angle_between(const vec3& a, const vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

CONCINO_INLINE tube_frame rotated(const tube_frame& f, const vec3& to, double part) {
  vec3 axis = cross(f.d, to);
  const double length = norm(axis), angle = part * std::atan2(length, dot(f.d, to));
  if (length > 1e-9) axis /= length;
  else if (dot(f.d, to) > 0) return part == 1 ? tube_frame{f.u, f.v, to} : f;
  else axis = f.u;
  const double c = std::cos(angle), s = std::sin(angle);
  const auto turn = [&](const vec3& x) { return x * c + cross(axis, x) * s + axis * (dot(axis, x) * (1 - c)); };
  tube_frame g;
  g.d = part == 1 ? to : turn(f.d);
  g.u = turn(f.u);
  g.u -= g.d * dot(g.u, g.d);  // rounding errors do not add up along the line
  g.u /= norm(g.u);
  g.v = cross(g.d, g.u);
  return g;
}

CONCINO_INLINE tube_frame twisted(const tube_frame& f, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {f.u * c + f.v * s, f.v * c - f.u * s, f.d};
}

CONCINO_INLINE tube_builder::tube_builder(drawable& to, int corners, bool has_values)
    : to_(to), corners_(static_cast<std::uint32_t>(corners)), has_values_(has_values) {
  for (std::uint32_t i = 0; i < corners_; ++i) {
    const double angle = 6.28318530717958647693 * i / corners_;
    cos_.push_back(std::cos(angle));
    sin_.push_back(std::sin(angle));
  }
}

CONCINO_INLINE void tube_builder::reserve(const char* caller, std::size_t points, std::size_t polygons,
                                          std::size_t corners, std::size_t triangles) {
  check_shape_size(caller, corners);
  to_.points.reserve(points);
  if (has_values_) to_.values.reserve(points);
  normals_.reserve(points);
  to_.corners.reserve(corners);
  to_.normals.reserve(corners);
  to_.offsets.reserve(polygons + 1);
  to_.polys.reserve(polygons);
  to_.triangles.reserve(triangles);
  to_.polygon_of.reserve(triangles);
}

CONCINO_INLINE void tube_builder::reserve(const char* caller, std::size_t rings, std::size_t caps) {
  const std::size_t quads = (rings - caps / 2) * corners_, triangles = caps * corners_;
  reserve(caller, rings * corners_ + caps, quads + triangles, 4 * quads + 3 * triangles, 2 * quads + triangles);
}

CONCINO_INLINE std::uint32_t tube_builder::add_point(const vec3& p, const vec3& normal) {
  to_.points.push_back(p);
  normals_.push_back(to_normal3(normal));
  if (has_values_) to_.values.push_back(value_);
  return static_cast<std::uint32_t>(to_.points.size() - 1);
}

CONCINO_INLINE void tube_builder::end_polygon() {
  to_.offsets.push_back(static_cast<std::uint32_t>(to_.corners.size()));
  to_.polys.push_back(poly_);
}

CONCINO_INLINE void tube_builder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  const auto first = static_cast<std::uint32_t>(to_.corners.size());
  for (const std::uint32_t i : {a, b, c}) {
    to_.corners.push_back(i);
    to_.normals.push_back(normals_[i]);
  }
  to_.triangles.push_back({first, first + 1, first + 2});
  to_.polygon_of.push_back(static_cast<std::uint32_t>(to_.polys.size()));
  end_polygon();
}

CONCINO_INLINE std::uint32_t tube_builder::ring(const vec3& center, double radius, const tube_frame& f, double height) {
  const double across = std::sqrt(1 - height * height);
  const auto first = static_cast<std::uint32_t>(to_.points.size());
  for (std::uint32_t i = 0; i < corners_; ++i) {
    const vec3 out = (f.u * cos_[i] + f.v * sin_[i]) * across + f.d * height;
    add_point(center + out * radius, out);
  }
  return first;
}

CONCINO_INLINE void tube_builder::add_quads(std::uint32_t first, std::uint32_t second) {
  for (std::uint32_t i = 0; i < corners_; ++i) {
    const std::uint32_t j = i + 1 == corners_ ? 0 : i + 1, at = static_cast<std::uint32_t>(to_.corners.size());
    for (const std::uint32_t k : {first + i, first + j, second + j, second + i}) to_.corners.push_back(k);
    to_.triangles.push_back({at, at + 1, at + 2});
    to_.triangles.push_back({at, at + 2, at + 3});
    to_.polygon_of.insert(to_.polygon_of.end(), 2, static_cast<std::uint32_t>(to_.polys.size()));
    end_polygon();
  }
}

CONCINO_INLINE void tube_builder::connect(std::uint32_t first, std::uint32_t second, const vec3& d, double slope) {
  add_quads(first, second);
  const double shorter = 1 / std::sqrt(1 + slope * slope);
  for (std::size_t k = to_.normals.size(); k < to_.corners.size(); ++k) {
    const std::uint32_t i = to_.corners[k];
    to_.normals.push_back(slope == 0 ? normals_[i] : to_normal3((normal(i) - d * slope) * shorter));
  }
}

CONCINO_INLINE void tube_builder::connect_flat(std::uint32_t first, std::uint32_t second, const vec3& normal) {
  add_quads(first, second);
  to_.normals.resize(to_.corners.size(), to_normal3(normal));
}

CONCINO_INLINE void tube_builder::close_flat(std::uint32_t ring, const vec3& normal, bool is_last) {
  const auto at = static_cast<std::uint32_t>(to_.corners.size());
  for (std::uint32_t i = 0; i < corners_; ++i) to_.corners.push_back(ring + (is_last ? i : corners_ - 1 - i));
  to_.normals.resize(to_.corners.size(), to_normal3(normal));
  for (std::uint32_t i = 2; i < corners_; ++i) {
    to_.triangles.push_back({at, at + i - 1, at + i});
    to_.polygon_of.push_back(static_cast<std::uint32_t>(to_.polys.size()));
  }
  end_polygon();
}

CONCINO_INLINE void tube_builder::add_cone(std::uint32_t ring, double radius, double height, const vec3& tip,
                                           const vec3& d) {
  const std::uint32_t top = add_point(tip, d);
  const double slant = std::hypot(radius, height), flat = radius / slant, steep = height / slant;
  const auto tilted = [&](const vec3& out) { return out * steep + d * flat; };
  for (std::uint32_t i = 0; i < corners_; ++i) {
    const std::uint32_t a = ring + i, b = ring + (i + 1 == corners_ ? 0 : i + 1);
    add_triangle(a, b, top);
    const vec3 middle = normal(a) + normal(b);
    auto* const last = to_.normals.data() + to_.normals.size() - 3;
    last[0] = to_normal3(tilted(normal(a)));
    last[1] = to_normal3(tilted(normal(b)));
    last[2] = to_normal3(tilted(middle / norm(middle)));
  }
}

inline constexpr double half_pi = 1.57079632679489661923;

CONCINO_INLINE std::uint32_t tube_builder::begin_cap(const vec3& center, double radius, const tube_frame& f) {
  const std::uint32_t pole = add_point(center - f.d * radius, -f.d);
  const std::size_t rings = cap_rings();
  std::uint32_t last = 0;
  for (std::size_t k = 0; k <= rings; ++k) {
    const std::uint32_t next =
        ring(center, radius, f,
             k == rings ? 0 : -std::cos(half_pi * static_cast<double>(k + 1) / static_cast<double>(rings + 1)));
    if (k > 0) connect(last, next);
    else
      for (std::uint32_t i = 0; i < corners_; ++i) add_triangle(pole, next + (i + 1 == corners_ ? 0 : i + 1), next + i);
    last = next;
  }
  return last;
}

CONCINO_INLINE void tube_builder::end_cap(std::uint32_t last, const vec3& center, double radius, const tube_frame& f) {
  const std::size_t rings = cap_rings();
  for (std::size_t k = 0; k < rings; ++k) {
    const std::uint32_t next =
        ring(center, radius, f, std::sin(half_pi * static_cast<double>(k + 1) / static_cast<double>(rings + 1)));
    connect(last, next);
    last = next;
  }
  const std::uint32_t pole = add_point(center + f.d * radius, f.d);
  for (std::uint32_t i = 0; i < corners_; ++i) add_triangle(pole, last + i, last + (i + 1 == corners_ ? 0 : i + 1));
}

}  // namespace concino::detail
