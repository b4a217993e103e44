// Renders a still picture of a scene in soft daylight on a light ground, in print quality.
#pragma once

#include <concino/core/profiler.hpp>
#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/trace/prepared_scene.hpp>

namespace concino {

/// A picture of a scene, lit by the sky, by a light beside the viewer and weakly from the front.
/// Needs:  a scene with at least one thing in it. Transparent things let others show through in the right order, and
///         cast no shadow. A ray tracer, if not the built-in one: for example embree{} of
///         <concino/adapters/embree.hpp>.
/// Result: the same picture on every run and for any number of threads.
/// Cost:   samples^2 rays for each pixel, more where transparent surfaces lie one behind the other; where it shows a
///         surface or the ground, also occlusion_rays rays, and one to the light for each sample.
/// Errors: invalid_argument if an option is out of its range, or the scene is empty; as view::of; cancelled if progress
///         says so.
template<RayTracer T = box_tree_tracer>
image render(const scene& s, const render_options& input_options = {}, const T& tracer = {}) {
  const core::profiled_options profiled(input_options, "render");
  const render_options& options = *profiled;
  detail::check_render_options(options);
  return detail::prepared_scene<T>(s, tracer).picture(detail::camera_of(s.drawables(), s, options), options);
}

}  // namespace concino
