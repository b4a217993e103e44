// The colours of pixels: surfaces lit by the sky, by a light beside the viewer and weakly from the front, and the
// ground with their shadows.
#pragma once

#include <concino/core/message.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/detail/colors/surface_reader.hpp>
#include <concino/render/detail/trace/sampling.hpp>
#include <concino/render/ray_caster.hpp>
#include <concino/render/render_options.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace concino::detail {

inline void check_render_options(const render_options& o) {
  const auto need = [](bool ok, const char* what) {
    if (!ok) core::throw_joined<invalid_argument>({"render: ", what});
  };
  need(o.width >= 1 && o.width <= 65535 && o.height >= 1 && o.height <= 65535,
       "width and height must be 1 to 65535 pixels");
  need(o.samples >= 1 && o.samples <= 32, "samples must be 1 to 32");
  need(o.occlusion_rays >= 0 && o.occlusion_rays <= 1 << 20, "occlusion_rays must be 0 to 1048576");
  need(o.occlusion_distance > 0, "occlusion_distance must be positive");
  need(o.light_size >= 0 && o.light_size < 90, "light_size must be in [0, 90) degrees");
  need(norm(o.up) > 0 && is_finite(o.up), "up must be finite and not 0");
  need(norm(o.light) > 0 && is_finite(o.light), "light must be finite and not 0");
}

/// A colour and how much of what lies behind it is covered, in [0, 1]. The colour is that of the covering part, times
/// the part covered.
struct covering_color {
  rgb color;
  float cover = 0;

  /// Adds what lies behind.
  covering_color& operator+=(const covering_color& behind) {
    color += behind.color * (1 - cover);
    cover += behind.cover * (1 - cover);
    return *this;
  }
};

/// Computes the colours of pixels. Surfaces through which others show cast no shadow.
template<RayCaster C>
class painter {
  const unit_scene& scene_;
  const C &caster_, &opaque_;
  const render_options& options_;
  camera camera_;
  vec3 up_, light_;
  frame light_frame_{{0, 0, 1}};
  double light_cosine_, light_sine_, ground_, ball_, mean_sky_;
  cosine_directions sky_;
  static constexpr double gap_ = 3e-5;  // rays start at this distance from the surface, so that they miss it in single
                                        // precision
  static constexpr double far_ = 1e30;
  static constexpr std::size_t light_rays_ = 1;  // for each sample
  static constexpr int max_layers_ = 64;         // of transparent surfaces, one behind the other

  /// The light from the sky and the ground; 1 for light that comes only from straight above.
  double sky_light(const vec3& position, const vec3& normal, const vec3& flat, std::size_t sample,
                   const cosine_directions::turn& turn) const {
    const std::size_t all = static_cast<std::size_t>(options_.samples) * static_cast<std::size_t>(options_.samples);
    if (sky_.size() == 0) return brightness(normal);
    const std::size_t first = sky_.size() * sample / all;  // each sample casts its share of the rays, at least one
    const std::size_t last = std::max(first + 1, sky_.size() * (sample + 1) / all);
    const frame f(normal);
    double sum = 0;
    for (std::size_t k = first; k < last; ++k) {
      vec3 d = sky_(k, turn, f);
      const double above = dot(d, flat);
      if (above < 0) d -= flat * (2 * above);  // the hemisphere of the smooth normal extends below the triangle
      if (misses_all(position, d) || !opaque_.occluded(position, d, 0, options_.occlusion_distance))
        sum += brightness(d);
    }
    return sum / static_cast<double>(last - first);
  }

  /// Whether a ray misses the bounding ball of the scene: a fast test, true for most rays from the ground.
  bool misses_all(const vec3& position, const vec3& d) const {
    const double away = dot(position, position), along = -dot(position, d);
    return away > ball_ && (along <= 0 || away - along * along > ball_);
  }

  double brightness(const vec3& d) const { return 0.80 + 0.20 * dot(d, up_); }

  /// The light from the area light; 1 if it is perpendicular and unshaded. Every sample tests another part of the
  /// light.
  double key_light(const vec3& position, const vec3& normal, const vec3& flat, std::size_t sample,
                   const unit_point& shift) const {
    if (dot(normal, light_) <= -light_sine_) return 0;
    double sum = 0;
    for (std::size_t k = 0; k < light_rays_; ++k) {
      const vec3 d =
          cone_direction(light_frame_, light_cosine_, low_discrepancy_point(sample * light_rays_ + k, shift));
      const double cosine = dot(normal, d);
      if (cosine > 0 && dot(flat, d) > 0 && (misses_all(position, d) || !opaque_.occluded(position, d, 0, far_)))
        sum += cosine;
    }
    return sum / static_cast<double>(light_rays_);
  }

  /// Materials that are not daylight: cavities are dark as under an even sky.
  rgb paint_material(const surface_point& s, const view_ray& ray, double sky) const {
    const double even_sky = 0.80 + 0.20 * 2 / 3 * dot(s.normal, up_);  // the light from a sky that nothing occludes
    const double open = sky_.size() == 0 ? 1 : std::min(1.0, sky / even_sky);
    const vec3 to_eye = -ray.direction, side = cross(camera_.up, to_eye), right = side / norm(side);
    const vec3 normal{dot(s.normal, right), dot(s.normal, cross(to_eye, right)), dot(s.normal, to_eye)};
    return s.color * (*s.material)(normal) * static_cast<float>(open);
  }

  rgb paint_surface(const surface_point& s, const view_ray& ray, std::size_t sample,
                    const cosine_directions::turn& turn, const unit_point& shift) const {
    const vec3 start = s.smooth_position + s.flat * gap_;
    const double sky = sky_light(start, s.normal, s.flat, sample, turn);
    if (!s.material->is_daylight()) return paint_material(s, ray, sky);
    const double key = key_light(start, s.normal, s.flat, sample, shift);
    const double front = std::max(0.0, -dot(s.normal, ray.direction));
    const double light = 0.60 * sky + 0.50 * key + 0.07 * front;
    rgb c = s.color * static_cast<float>(light);
    if (key > 0 && s.shine > 0) {
      const vec3 half = light_ - ray.direction;
      const double glint = std::pow(std::max(0.0, dot(s.normal, half) / norm(half)), 50);
      const float g = static_cast<float>(0.10 * s.shine * glint);
      c += {g, g, g};
    }
    return c;
  }

  covering_color paint_ground(const vec3& position, std::size_t sample, const cosine_directions::turn& turn,
                              const unit_point& shift) const {
    const double away = norm(position);
    const vec3 start = position + up_ * gap_;
    double sky = 1, key = 1;
    if (away < 1 + options_.occlusion_distance) sky = sky_light(start, up_, up_, sample, turn) / mean_sky_;
    if (const double straight = dot(up_, light_); straight > 0)
      key = std::min(1.0, key_light(start, up_, up_, sample, shift) / straight);
    const float light = static_cast<float>(1 - 0.62 * (1 - std::min(1.0, sky)) - 0.22 * (1 - key));
    if (options_.transparent_background) return {{}, 1 - light};  // only the shadow is seen
    return {options_.background * light, 1};
  }

  covering_color background() const {
    return options_.transparent_background ? covering_color{} : covering_color{options_.background, 1};
  }

  /// What a ray sees, from front to back.
  covering_color along(const view_ray& ray, const image_point& film, std::size_t sample,
                       const cosine_directions::turn& turn, const unit_point& shift, surface_reader& read) const {
    covering_color seen;
    const double down = -dot(ray.direction, up_), above = dot(ray.origin, up_) - ground_;
    const double ground_at = options_.ground && down > 1e-6 && above > 0 ? above / down : far_;
    double from = 0;
    for (int layer = 0; layer < max_layers_ && !misses_all(ray.origin, ray.direction); ++layer) {
      const ray_hit hit = caster_.intersect(ray.origin, ray.direction, from, far_);
      if (!hit || !(hit.t < ground_at)) break;
      const surface_point s = read(hit, ray, film);
      const float cover = static_cast<float>(s.opacity);
      if (cover > 0) seen += {paint_surface(s, ray, sample, turn, shift) * cover, cover};
      if (seen.cover > 0.998f) return {seen.color * (1 / seen.cover), 1};
      from = hit.t + gap_;
    }
    return seen +=
           ground_at < 1e3 ? paint_ground(ray.origin + ray.direction * ground_at, sample, turn, shift) : background();
  }

 public:
  /// `opaque` has only the triangles that cast shadows.
  painter(const unit_scene& scene, const C& caster, const C& opaque, const camera& c, const render_options& o)
      : scene_(scene), caster_(caster), opaque_(opaque), options_(o), camera_(scene.to_unit(c)),
        sky_(static_cast<std::size_t>(o.occlusion_rays)) {
    up_ = o.up / norm(o.up);
    light_ = camera_.right * o.light.x + camera_.up * o.light.y + camera_.back * o.light.z;
    light_ /= norm(light_);
    light_frame_ = frame(light_);
    light_cosine_ = std::cos(o.light_size * 3.14159265358979323846 / 180);
    light_sine_ = std::sin(o.light_size * 3.14159265358979323846 / 180);
    ground_ = scene.lowest(up_);
    ball_ = scene.squared_radius() * 1.0001;
    mean_sky_ = o.occlusion_rays > 0 ? 0.80 + 0.20 * 2 / 3 : 1.0;  // the mean height of cosine-weighted directions is
                                                                   // 2/3
  }

  covering_color pixel(std::size_t x, std::size_t y, surface_reader& read) const {
    const std::uint64_t seed = core::scrambled(y * options_.width + x);
    const cosine_directions::turn turn(random_point(seed));
    const unit_point shift = random_point(seed + 1);
    const int n = options_.samples;
    const double unit = 2.0 / static_cast<double>(options_.height);
    covering_color sum;
    for (int s = 0; s < n * n; ++s) {
      const unit_point jitter = random_point(seed + static_cast<std::uint64_t>(s) + 2);
      const double px = tent((s % n + jitter.x) / n), py = tent((s / n + jitter.y) / n);
      const image_point film{(static_cast<double>(x) + 0.5 + px - 0.5 * static_cast<double>(options_.width)) * unit,
                            (0.5 * static_cast<double>(options_.height) - static_cast<double>(y) - 0.5 - py) * unit};
      const covering_color one = along(camera_.ray_through(film), film, static_cast<std::size_t>(s), turn, shift, read);
      sum.color += one.color;
      sum.cover += one.cover;
    }
    const float share = 1 / static_cast<float>(n * n);
    return {sum.color * share, sum.cover * share};
  }

  surface_reader reader() const { return {scene_, camera_, options_.height, options_.samples}; }
};

}  // namespace concino::detail
