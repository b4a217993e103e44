// Cameras: perspective and orthographic cameras, and the nearest camera that frames a set of points.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace concino {

/// A point on the film: x to the right, y up. y is in [-1, 1] over the height of the picture, and x has the same unit.
struct image_point {
  double x = 0, y = 0;
};

/// A ray from the camera. The direction has length 1.
struct view_ray {
  vec3 origin, direction;
};

/// A perspective or orthographic camera, constructed by perspective_camera, orthographic_camera, framing or view.
struct camera {
  /// Directions from which the whole scene is looked at, see view.
  enum named_view : unsigned char {
    three_quarter,
    isometric,
    from_front,
    from_back,
    from_left,
    from_right,
    from_above,
    from_below
  };

  vec3 eye;
  vec3 right = {1, 0, 0}, up = {0, 1, 0}, back = {0, 0, 1};  // orthonormal; it looks along -back
  double half_height = 1;                                    // of the film: at distance 1 from the eye, or in units of
                                                             // the mesh if parallel
  bool parallel = false;

  view_ray ray_through(const image_point& f) const {
    const vec3 offset = right * (f.x * half_height) + up * (f.y * half_height);
    if (parallel) return {eye + offset, -back};
    const vec3 d = offset - back;
    return {eye, d / norm(d)};
  }

  /// The position of p on the film; only for points in front of the eye.
  image_point project(const vec3& p) const {
    const vec3 d = p - eye;
    const double unit = (parallel ? 1 : -dot(d, back)) * half_height;
    return {dot(d, right) / unit, dot(d, up) / unit};
  }
};

namespace detail {

inline camera looking(const vec3& eye, const vec3& back, const vec3& up) {
  camera c;
  c.eye = eye;
  const double length = norm(back), up_length = norm(up);
  if (!(length > 0) || !std::isfinite(length) || !is_finite(eye))
    throw invalid_argument("camera: the eye and its target must be finite and differ");
  if (!(up_length > 0) || !std::isfinite(up_length)) throw invalid_argument("camera: up must be finite and not 0");
  c.back = back / length;
  vec3 right = cross(up / up_length, c.back);
  const double right_length = norm(right);
  if (!(right_length > 1e-9)) throw invalid_argument("camera: up must not run along the line of sight");
  c.right = right / right_length;
  c.up = cross(c.back, c.right);
  return c;
}

inline double half_height_of_angle(double degrees) {
  if (!(degrees > 0 && degrees < 180))
    throw invalid_argument("camera: the angle of view must be between 0 and 180 degrees");
  return std::tan(degrees * 3.14159265358979323846 / 360);
}

}  // namespace detail

/// A perspective camera at `eye` that looks at `target`. `angle` is the vertical angle of view in degrees.
/// Needs:  eye and target that are different; up: a direction of any length, not parallel to the line of sight; angle
///         in (0, 180).
/// Result: a camera for which `up` points up in the picture.      Cost: O(1).
/// Errors: invalid_argument if eye or target is not finite or they coincide, up is 0, not finite or parallel to the
///         line of sight, or angle is not in (0, 180).
inline camera perspective_camera(const vec3& eye, const vec3& target, const vec3& up = {0, 1, 0}, double angle = 30) {
  camera c = detail::looking(eye, eye - target, up);
  c.half_height = detail::half_height_of_angle(angle);
  return c;
}

/// An orthographic camera at `eye` that looks at `target`. `height` is the height of the picture in units of the mesh.
/// Needs:  as perspective_camera; height above 0.
/// Result: as perspective_camera.      Cost: O(1).
/// Errors: as perspective_camera; invalid_argument if height is not positive and finite.
inline camera orthographic_camera(const vec3& eye, const vec3& target, const vec3& up, double height) {
  if (!(height > 0) || !std::isfinite(height))
    throw invalid_argument("camera: the height of the picture must be positive");
  camera c = detail::looking(eye, eye - target, up);
  c.half_height = height / 2;
  c.parallel = true;
  return c;
}

struct view_options {
  vec3 towards = {0.5, 0.35, 1};  // from the scene to the viewer, of any length; the default is a three-quarter view
                                  // from the front and above
  vec3 up = {0, 1, 0};            // up in the picture
  double angle = 25;              // the vertical angle of view, in degrees, in (0, 180); 0: orthographic
  double margin = 0.06;           // free space at each edge of the picture, as a fraction of half its size, in [0, 1)
};

/// Finds the nearest camera in a direction that sees all points added to it.
class framing {
 public:
  /// Needs:  aspect = width / height of the picture.
  /// Errors: invalid_argument if an option is out of its range.
  explicit framing(double aspect, const view_options& options = {})
      : camera_(detail::looking({}, options.towards, options.up)) {
    if (!(aspect > 0) || !std::isfinite(aspect))
      throw invalid_argument("framing: the aspect of the picture must be positive");
    if (!(options.margin >= 0 && options.margin < 1)) throw invalid_argument("framing: margin must be in [0, 1)");
    camera_.parallel = options.angle == 0;
    if (!camera_.parallel) camera_.half_height = detail::half_height_of_angle(options.angle);
    y_.slope = (camera_.parallel ? 1 : camera_.half_height) * (1 - options.margin);
    x_.slope = y_.slope * aspect;
  }

  void add_points(std::span<const vec3> points) {
    for (const vec3& p : points) {
      if (!is_finite(p)) continue;
      const double z = dot(p, camera_.back);
      near_ = std::max(near_, z);
      x_.add_points(dot(p, camera_.right), camera_.parallel ? 0 : z);
      y_.add_points(dot(p, camera_.up), camera_.parallel ? 0 : z);
    }
  }

  /// Result: all points lie within the margins of the picture, and two opposite margins are touched.      Cost: O(1).
  camera best() const {
    camera c = camera_;
    if (!(near_ > -std::numeric_limits<double>::infinity())) return c;
    const double radius = std::max(x_.distance(), y_.distance());
    const double spread = std::max(x_.high - x_.low, y_.high - y_.low);
    // for a single point any distance is right
    const double unit = spread > 0 ? spread : std::max(1.0, std::abs(near_)) * 1e-3;
    double distance = radius;
    if (c.parallel) {
      c.half_height = radius > 0 ? radius : unit;
      distance = near_ + unit;
    }
    if (!(distance > near_)) distance = near_ + unit;
    c.eye = c.right * x_.center() + c.up * y_.center() + c.back * distance;
    return c;
  }

 private:
  // A point at (x, z) lies on the film of a camera at (c, d) if |x - c| <= (d - z) slope. These are two half-planes for
  // each point, and only the extreme ones matter.
  struct axis {
    double slope = 1;
    double high = -std::numeric_limits<double>::infinity(), low = std::numeric_limits<double>::infinity();
    void add_points(double x, double z) {
      high = std::max(high, x + z * slope);
      low = std::min(low, x - z * slope);
    }
    double distance() const { return (high - low) / (2 * slope); }
    double center() const { return (high + low) / 2; }
  };

  camera camera_;
  axis x_, y_;
  double near_ = -std::numeric_limits<double>::infinity();
};

}  // namespace concino
