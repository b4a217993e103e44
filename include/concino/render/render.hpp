// Renders a still picture of a scene in soft daylight on a light ground, in print quality.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/render/box_tree_tracer.hpp>
#include <concino/render/detail/painter.hpp>
#include <concino/render/image.hpp>
#include <concino/render/scene.hpp>

#include <optional>

namespace concino {

/// A picture of a scene, lit by the sky, by a light beside the viewer and weakly from the front.
/// Needs:  a scene with at least one thing in it. Transparent things let others show through in the right order, and cast no shadow. A ray tracer, if not the
///         built-in one: for example embree{} of <concino/adapters/embree.hpp>.
/// Result: the same picture on every run and for any number of threads.
/// Cost:   samples^2 rays for each pixel, more where transparent surfaces lie one behind the other; where it shows a surface or the ground, also
///         occlusion_rays rays, and one to the light for each sample.
/// Errors: invalid_argument if an option is out of its range, or the scene is empty; as view::of; cancelled if progress says so.
template<RayTracer T = box_tree_tracer>
image render(const scene& s, const render_options& options = {}, const T& tracer = {}) {
  detail::check_render_options(options);
  if (s.drawables().empty()) throw invalid_argument("render: the scene is empty; add a mesh or other things to it first");
  image picture(options.width, options.height, options.background);
  const double aspect = static_cast<double>(options.width) / static_cast<double>(options.height);
  const camera from = options.camera.of(s.drawables(), aspect, options.up);
  const detail::unit_scene unit(s.drawables());
  const auto caster = tracer.build(unit.soup);
  const bool transparent = unit.has_transparent();
  using caster_type = std::remove_const_t<decltype(caster)>;
  std::optional<caster_type> opaque;
  if (transparent) opaque.emplace(tracer.build(unit.opaque_soup()));
  const detail::painter<caster_type> paint(unit, caster, opaque ? *opaque : caster, from, options);

  constexpr std::size_t tile_size = 16;  // in pixels, of the tiles that threads render in parallel
  const std::size_t num_columns = (options.width + tile_size - 1) / tile_size, num_rows = (options.height + tile_size - 1) / tile_size;
  const auto tile = [&](std::size_t i) {
    auto read = paint.reader();
    const std::size_t x0 = i % num_columns * tile_size, y0 = i / num_columns * tile_size;
    for (std::size_t y = y0; y < std::min(y0 + tile_size, options.height); ++y)
      for (std::size_t x = x0; x < std::min(x0 + tile_size, options.width); ++x) picture(x, y) = paint.pixel(x, y, read).color;
  };
  const char* label = "rendering";
  detail::report_progress(options.progress, 0, label);
  parallel_for(num_columns * num_rows, tile, 1, [&](double fraction) {
    detail::report_progress(options.progress, fraction, label);
    return false;
  });
  detail::report_progress(options.progress, 1, label);
  return picture;
}

}  // namespace concino
