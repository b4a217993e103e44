// All drawables of a picture as one triangle soup about the origin, scaled to unit size.
#pragma once

#include <concino/geometry/bounding_box.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/drawable.hpp>
#include <concino/render/ray_caster.hpp>

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

/// A scene moved so that the middle of its bounding box is 0, and scaled so that half the diagonal is 1. Single
/// precision is then enough for any mesh.
class unit_scene {
  std::span<const drawable> drawables_;
  std::vector<std::uint32_t> first_point_, first_triangle_;
  vec3 center_;
  double radius_ = 1;

 public:
  triangle_soup soup;

  explicit unit_scene(std::span<const drawable> drawables) : drawables_(drawables) {
    box bounds;
    std::size_t points = 0, triangles = 0;
    for (const drawable& d : drawables_) {
      first_point_.push_back(static_cast<std::uint32_t>(points));
      first_triangle_.push_back(static_cast<std::uint32_t>(triangles));
      points += d.points.size();
      triangles += d.triangles.size();
      for (const vec3& p : d.points) bounds.add(p);
    }
    if (points > 0) {
      center_ = bounds.centre();
      const double half = norm(bounds.max / 2 - bounds.min / 2);
      radius_ = half > 0 ? half : 1;
    }
    soup.points.reserve(points);
    soup.triangles.reserve(triangles);
    for (std::size_t i = 0; i < drawables_.size(); ++i) {
      const drawable& d = drawables_[i];
      for (const vec3& p : d.points) soup.points.push_back(to_normal3(to_unit(p)));
      for (const auto& t : d.triangles)
        soup.triangles.push_back(
            {first_point_[i] + d.corners[t[0]], first_point_[i] + d.corners[t[1]], first_point_[i] + d.corners[t[2]]});
    }
  }

  static bool is_opaque(const drawable& d) { return d.look.opacity >= 1; }

  /// Whether something in the scene lets others show through.
  bool has_transparent() const { return !std::all_of(drawables_.begin(), drawables_.end(), is_opaque); }

  /// The soup without the triangles of transparent drawables.
  triangle_soup opaque_soup() const {
    triangle_soup opaque{soup.points, {}};
    for (std::size_t i = 0; i < drawables_.size(); ++i)
      if (is_opaque(drawables_[i])) {
        const auto first = soup.triangles.begin() + first_triangle_[i];
        opaque.triangles.insert(opaque.triangles.end(), first,
                                first + static_cast<std::ptrdiff_t>(drawables_[i].triangles.size()));
      }
    return opaque;
  }

  vec3 to_unit(const vec3& p) const { return (p - center_) / radius_; }
  double to_unit(double length) const { return length / radius_; }
  camera to_unit(camera c) const {
    c.eye = to_unit(c.eye);
    if (c.parallel) c.half_height /= radius_;
    return c;
  }

  vec3 point(std::uint32_t i) const { return to_vec3(soup.points[i]); }

  /// The drawable of triangle t of the soup, and the number of the triangle there.
  std::pair<std::size_t, std::uint32_t> owner(std::uint32_t t) const {
    const auto it = std::upper_bound(first_triangle_.begin(), first_triangle_.end(), t) - 1;
    return {static_cast<std::size_t>(it - first_triangle_.begin()), t - *it};
  }
  const drawable& operator[](std::size_t i) const { return drawables_[i]; }
  std::uint32_t first_point(std::size_t i) const { return first_point_[i]; }

  /// The square of the largest distance from the origin.
  double squared_radius() const {
    double radius = 0;
    for (std::size_t i = 0; i < soup.points.size(); ++i)
      radius = std::max(radius, dot(point(static_cast<std::uint32_t>(i)), point(static_cast<std::uint32_t>(i))));
    return radius;
  }

  /// The smallest coordinate of the scene along a direction.
  double lowest(const vec3& up) const {
    double low = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < soup.points.size(); ++i)
      low = std::min(low, dot(point(static_cast<std::uint32_t>(i)), up));
    return low;
  }
};

}  // namespace concino::detail
