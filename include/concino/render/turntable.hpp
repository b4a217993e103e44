// Turntables: pictures of a scene from all around, as the frames of a film.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/scene_png.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace concino {

namespace detail {

/// A camera turned about an axis through a point. axis: of length 1.
camera turned(camera c, const vec3& center, const vec3& axis, double angle);

/// A circle at the top and one at the bottom of the cylinder that holds the scene while it turns, as points of a
/// drawable.
drawable turning_cylinder(std::span<const drawable> drawables, const vec3& center, const vec3& axis);

/// path with "_000", "_001", ... before its extension; with more digits if there are more than 1,000 frames.
std::string frame_path(const std::string& path, int frame, int num_frames);

}  // namespace detail

/// Renders a scene from all around and writes the frames as PNG files: save_turntable(s, "film.png", 120) writes
/// film_000.png to film_119.png.
/// Needs:  num_frames: 1 to 100,000. The first frame is seen by options.camera. The camera moves to the right about the
///         axis options.up through the middle of the scene; unless a camera was given, it is as far away as the scene
///         needs in all frames.
/// Result: the paths of the files, in the order of the frames.
/// Cost:   num_frames times that of save_png; the scene is prepared once.
/// Errors: as save_png of a scene; invalid_argument if num_frames is out of its range. Frames written before remain.
///         options.progress is called for each frame.
template<RayTracer T = box_tree_tracer>
std::vector<std::string> save_turntable(const scene& s, const std::string& path, int num_frames,
                                        const render_options& options = {}, const T& tracer = {}) {
  if (num_frames < 1 || num_frames > 100000) throw invalid_argument("save_turntable: num_frames must be 1 to 100000");
  detail::check_render_options(options);
  const detail::prepared_scene<T> prepared(s, tracer);
  const box bounds = s.bounds();
  const vec3 axis = options.up / norm(options.up), center = bounds.is_empty() ? vec3{} : bounds.centre();
  const drawable cylinder = detail::turning_cylinder(s.drawables(), center, axis);
  const camera first = detail::camera_of({&cylinder, 1}, s, options);
  std::vector<std::string> paths;
  for (int i = 0; i < num_frames; ++i) {
    const camera from = detail::turned(first, center, axis, 2 * 3.14159265358979323846 * i / num_frames);
    paths.push_back(detail::frame_path(path, i, num_frames));
    save_png(prepared.picture(from, options), paths.back());
  }
  return paths;
}

}  // namespace concino

#ifndef CONCINO_COMPILED
#include <concino/render/detail/trace/turntable.ipp>
#endif
