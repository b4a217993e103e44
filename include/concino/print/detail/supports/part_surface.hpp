// The outer surface of a part as flat arrays of triangles, whatever its mesh: what the calls of print/ work on.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/outer_polygons.hpp>
#include <concino/geometry/triangulate_polygon.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// Triangles of polygons that have an area. Points are scaled to a size of about 1 around an origin, which is exact
/// except for the subtraction.
struct part_surface {
  std::vector<vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> owners;  // of each triangle: its polygon
  std::vector<vec3> areas;            // of each polygon: its vector area
  vec3 origin;                        // a point of the mesh times `shrink` is origin + point * 2^exponent
  int exponent = 0;
  double shrink = 1;
  double tolerance = 0;               // lengths below this are zero, up to the rounding of the coordinates

  std::array<vec3, 3> triangle(std::size_t t) const {
    return {points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]};
  }
  /// From units of the points to those of the mesh, of a length, an area or a volume.
  double to_mesh(double size, int dimension) const {
    return std::ldexp(size, dimension * (exponent + (shrink < 1 ? 4 : 0)));
  }
  vec3 to_mesh(const vec3& x) const {
    return (origin + vec3{std::ldexp(x.x, exponent), std::ldexp(x.y, exponent), std::ldexp(x.z, exponent)}) / shrink;
  }
  /// Heights along a unit vector.
  double height_from_mesh(double height, const vec3& up) const {
    return std::ldexp(shrink * height - dot(origin, up), -exponent);
  }
  double height_to_mesh(double height, const vec3& up) const {
    return (dot(origin, up) + std::ldexp(height, exponent)) / shrink;
  }
  vec3 from_mesh(const vec3& x) const {
    const vec3 y = shrink * x - origin;
    return {std::ldexp(y.x, -exponent), std::ldexp(y.y, -exponent), std::ldexp(y.z, -exponent)};
  }
};

/// The surface, and the elements that its polygons are.
template<class M>
struct printed_part {
  part_surface surface;
  std::vector<polygon_t<M>> polygons;  // with an area
  std::vector<polygon_t<M>> ignored;   // without one

  std::vector<polygon_t<M>> elements(const std::vector<std::uint32_t>& numbers) const {
    std::vector<polygon_t<M>> result;
    for (const std::uint32_t i : numbers) result.push_back(polygons[i]);
    return result;
  }
};

/// Fills a part_surface by its polygons.
class part_builder {
  part_surface& surface_;
  std::vector<std::uint32_t> offsets_{0}, corners_;  // of all polygons, by the numbers of all points
  std::vector<vec3> points_;
  std::vector<bool> has_area_;

 public:
  explicit part_builder(part_surface& surface) : surface_(surface) {}

  std::uint32_t add_point(const vec3& x) {
    points_.push_back(x);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }
  void add_corner(std::uint32_t point) { corners_.push_back(point); }
  void end_polygon() { offsets_.push_back(static_cast<std::uint32_t>(corners_.size())); }
  /// Whether each polygon has an area.
  const std::vector<bool>& finish();
  /// Refuses a closed surface whose normals point inward. `caller` is named in the message.
  void require_outward(const char* caller) const;
};

/// A map that is true of every poly.
template<class P>
struct every_poly {
  bool operator[](const P&) const { return true; }
};

/// The outer surface of m. `caller` is named in messages.
template<class M>
printed_part<M> outer_surface(const M& m, const char* caller) {
  printed_part<M> part;
  part_builder builder(part.surface);
  constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> numbers(vert_index_bound(m), none);
  std::vector<polygon_t<M>> all;
  for_each_visible_polygon(
      m, every_poly<poly_t<M>>{},
      [&](const poly_t<M>&, const auto& loop, bool is_outward, bool, const polygon_t<M>& x) {
        std::vector<std::uint32_t> ring;
        for (const vert_t<M> v : loop) {
          std::uint32_t& number = numbers[index_of(m, v)];
          if (number == none) {
            const vec3 y = to_vec3(point(m, v));
            if (!is_finite(y)) core::throw_joined<invalid_mesh>({caller, ": vert ", index_of(m, v), " is not finite"});
            number = builder.add_point(y);
          }
          ring.push_back(number);
        }
        for (std::size_t k = 0; k < ring.size(); ++k) builder.add_corner(ring[is_outward ? k : ring.size() - 1 - k]);
        builder.end_polygon();
        all.push_back(x);
      });
  const auto& has_area = builder.finish();
  for (std::size_t i = 0; i < all.size(); ++i) (has_area[i] ? part.polygons : part.ignored).push_back(all[i]);
  builder.require_outward(caller);
  return part;
}

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/print/detail/supports/part_surface.ipp>
#endif
