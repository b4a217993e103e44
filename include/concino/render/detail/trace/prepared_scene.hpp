// A scene whose rays can be cast, for one or several pictures of it.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/render/detail/overlays/overlays.hpp>
#include <concino/render/detail/trace/painter.hpp>
#include <concino/render/image.hpp>
#include <concino/render/ray_caster.hpp>
#include <concino/render/scene.hpp>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace concino::detail {

/// Errors: invalid_argument if the scene is empty; those of the tracer.
template<RayTracer T>
class prepared_scene {
  using caster = decltype(std::declval<const T&>().build(std::declval<const triangle_soup&>()));

  static const scene& checked(const scene& s) {
    if (s.drawables().empty())
      throw invalid_argument("render: the scene is empty; add a mesh or other things to it first");
    return s;
  }

  const scene& scene_;
  unit_scene unit_;
  caster all_;
  std::optional<caster> opaque_;  // only if it is not the same

 public:
  prepared_scene(const scene& s, const T& tracer)
      : scene_(checked(s)), unit_(s.drawables()), all_(tracer.build(unit_.soup)) {
    if (unit_.has_transparent()) opaque_.emplace(tracer.build(unit_.opaque_soup()));
  }

  /// The picture that a camera sees, with title, legend, axes and labels. Needs: options in their ranges.
  image picture(const camera& from, const render_options& options) const {
    image result = without_texts(from, options);
    std::vector<point_label> labels;
    for (const point_label& l : scene_.labels())
      if (is_seen(from, l.point)) labels.push_back(l);
    draw_overlays(result, from, scene_, labels, options);
    return result;
  }

 private:
  /// Whether nothing hides a point.
  bool is_seen(const camera& from, const vec3& point) const {
    const camera c = unit_.to_unit(from);
    const vec3 x = unit_.to_unit(point), ahead = x - c.eye;
    const double away = c.parallel ? 1e30 : norm(ahead);
    if (!(away > 0)) return false;
    const vec3 to_eye = c.parallel ? c.back : ahead / -away;
    constexpr double near = 0.03;  // of half the diagonal, so that a ball that marks the point does not hide it
    return !(opaque_ ? *opaque_ : all_).occluded(x + to_eye * near, to_eye, 0, away - near);
  }

  image without_texts(const camera& from, const render_options& options) const {
    image result(options.width, options.height, options.background);
    if (options.transparent_background) result.add_opacity();
    const painter<caster> paint(unit_, all_, opaque_ ? *opaque_ : all_, from, options);
    constexpr std::size_t tile_size = 16;  // in pixels, of the tiles that threads render in parallel
    const std::size_t num_columns = (options.width + tile_size - 1) / tile_size,
                      num_rows = (options.height + tile_size - 1) / tile_size;
    const auto tile = [&](std::size_t i) {
      auto read = paint.reader();
      const std::size_t x0 = i % num_columns * tile_size, y0 = i / num_columns * tile_size;
      for (std::size_t y = y0; y < std::min(y0 + tile_size, options.height); ++y)
        for (std::size_t x = x0; x < std::min(x0 + tile_size, options.width); ++x) {
          const covering_color seen = paint.pixel(x, y, read);
          result(x, y) = seen.color;
          if (!options.transparent_background) continue;
          if (seen.cover > 0) result(x, y) *= 1 / seen.cover;
          result.opacity(x, y) = seen.cover;
        }
    };
    const char* label = "rendering";
    report_progress(options.progress, 0, label);
    parallel_for(num_columns * num_rows, tile, 1, [&](double fraction) {
      report_progress(options.progress, fraction, label);
      return false;
    });
    report_progress(options.progress, 1, label);
    return result;
  }
};

}  // namespace concino::detail
