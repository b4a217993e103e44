// What a picture shows of a scene: the whole scene from a direction, or what a camera sees.
#pragma once

#include <concino/render/camera.hpp>
#include <concino/render/drawable.hpp>

#include <span>
#include <variant>

namespace concino {

/// The nearest camera that sees all of the drawables.
/// Needs:  aspect: width / height of the picture, above 0.
/// Result: as framing; points that are not finite are ignored.
/// Cost:   O(points).
/// Errors: as framing.
inline camera frame(std::span<const drawable> drawables, double aspect, const view_options& options = {}) {
  framing f(aspect, options);
  for (const drawable& d : drawables) f.add_points(d.points);
  return f.best();
}

/// The options of a named view: three_quarter is in perspective, from the front, the right and above; the others are
/// orthographic. isometric shows three sides of a box alike.
/// Needs:  up: of any length but 0. The front of a scene is the side of the largest z; if up is along z, it is the side
///         of the smallest y.
/// Result: options whose `up` is the given one, or a horizontal direction if the camera looks along it: the back for
///         from_above, the front for from_below.
/// Cost:   O(1).
/// Errors: invalid_argument if up is 0 or not finite.
inline view_options options_of(camera::named_view which, const vec3& up = {0, 1, 0}) {
  const double length = norm(up);
  if (!(length > 0) || !std::isfinite(length)) throw invalid_argument("view: up must be finite and not 0");
  const vec3 above = up / length;
  vec3 front = vec3{0, 0, 1} - above * above.z;
  if (norm(front) < 1e-6) front = {0, -1, 0};
  front /= norm(front);
  const vec3 right = cross(above, front);
  view_options o;
  o.up = up;
  o.angle = which == camera::three_quarter ? o.angle : 0;
  switch (which) {
    case camera::three_quarter: o.towards = right * o.towards.x + above * o.towards.y + front * o.towards.z; break;
    case camera::isometric: o.towards = right + above + front; break;
    case camera::from_front: o.towards = front; break;
    case camera::from_back: o.towards = -front; break;
    case camera::from_left: o.towards = -right; break;
    case camera::from_right: o.towards = right; break;
    case camera::from_above: o.towards = above, o.up = -front; break;
    case camera::from_below: o.towards = -above, o.up = front; break;
  }
  return o;
}

/// The camera of a picture: a camera, or the whole scene seen as view_options say, or by a named view such as
/// camera::isometric.
class view {
  std::variant<camera::named_view, view_options, camera> choice_;

 public:
  view(camera::named_view which = camera::three_quarter) : choice_(which) {}
  view(const view_options& options) : choice_(options) {}
  view(const camera& c) : choice_(c) {}

  /// Whether it is a camera, which stays where it is.
  bool has_camera() const { return std::holds_alternative<camera>(choice_); }

  /// The camera for a scene.
  /// Needs:  aspect: width / height of the picture, above 0; up: for named views, of any length but 0.
  /// Result: the camera given, or one that frames the drawables.
  /// Cost:   O(points); O(1) for a camera.
  /// Errors: as frame and options_of.
  camera of(std::span<const drawable> drawables, double aspect, const vec3& up = {0, 1, 0}) const {
    if (const auto* c = std::get_if<camera>(&choice_)) return *c;
    if (const auto* options = std::get_if<view_options>(&choice_)) return frame(drawables, aspect, *options);
    return frame(drawables, aspect, options_of(std::get<camera::named_view>(choice_), up));
  }
};

}  // namespace concino
