// Builds the rings, caps and balls of tubes in a drawable.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/drawable.hpp>

#include <cstdint>
#include <vector>

namespace concino::detail {

/// A right-handed frame of unit vectors; a tube runs along d, and its cross-section is spanned by u and v.
struct tube_frame {
  vec3 u, v, d;
};

/// A frame along a unit vector.
tube_frame frame_along(const vec3& d);

/// The frame after the smallest rotation that takes f.d to `to`, or to a part of that way. Half a turn goes about f.u.
tube_frame rotated(const tube_frame& f, const vec3& to, double part = 1);

/// The frame after a rotation about its d.
tube_frame twisted(const tube_frame& f, double angle);

/// The angle between unit vectors, accurate for small and large ones.
double angle_between(const vec3& a, const vec3& b);

/// Appends closed surfaces, ring by ring, to a drawable. The rings have equally many points.
class tube_builder {
  drawable& to_;
  std::uint32_t corners_;
  std::uint32_t poly_ = 0;
  double value_ = 0;
  bool has_values_;
  std::vector<double> cos_, sin_;
  std::vector<normal3> normals_;  // by point

  std::uint32_t add_point(const vec3& p, const vec3& normal);
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  void add_quads(std::uint32_t first, std::uint32_t second);
  vec3 normal(std::uint32_t i) const { return to_vec3(normals_[i]); }
  void end_polygon();

 public:
  tube_builder(drawable& to, int corners, bool has_values);

  /// Reserves memory, as below.
  void reserve(const char* caller, std::size_t points, std::size_t polygons, std::size_t corners,
               std::size_t triangles);
  /// Reserves memory for the rings and caps of open and closed tubes.      Errors: those of check_shape_size.
  void reserve(const char* caller, std::size_t rings, std::size_t caps);

  /// The number and the value of what is added next.
  void begin(std::size_t poly) { poly_ = static_cast<std::uint32_t>(poly); }
  void set_value(double x) { value_ = x; }

  /// A ring of points at the radius from the centre, in the plane through it across f.d, or at `height` radii of a ball
  /// beyond it. Returns its first point.
  std::uint32_t ring(const vec3& center, double radius, const tube_frame& f, double height = 0);
  /// Quads between two rings; the second is further along d. slope: how much the radius grows along a unit of length.
  void connect(std::uint32_t first, std::uint32_t second, const vec3& d = {}, double slope = 0);
  /// Half a ball that ends in the ring; it bulges along f.d, or against it. Returns its ring across f.d.
  std::uint32_t begin_cap(const vec3& center, double radius, const tube_frame& f);
  void end_cap(std::uint32_t last, const vec3& center, double radius, const tube_frame& f);

  /// A ring of quads around f.d, all with one normal: between rings in one plane, the second of them larger.
  void connect_flat(std::uint32_t first, std::uint32_t second, const vec3& normal);
  /// A flat end of a tube, before its first ring or after its last.
  void close_flat(std::uint32_t ring, const vec3& normal, bool is_last = false);
  /// The cone from a ring to its tip, of this radius and height.
  void add_cone(std::uint32_t ring, double radius, double height, const vec3& tip, const vec3& d);

  /// The rings of a cap beside the one at its end.
  std::size_t cap_rings() const { return corners_ / 4; }
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/shapes/tube_builder.ipp>
#endif
