// Renders a still picture of surfaces in soft daylight on a light ground, in print quality. The ray tracer is an argument.
#pragma once

#include <concino/core/message.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/progress.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/detail/sampling.hpp>
#include <concino/render/detail/surface_color.hpp>
#include <concino/render/image.hpp>
#include <concino/render/ray_caster.hpp>

#include <span>

namespace concino {

struct render_options {
  std::size_t width = 1600, height = 1200;  // pixels, 1 to 65535 each
  int samples = 3;                          // per pixel along each axis, 1 to 32: 3 means 9 samples
  int sky_rays = 36;                        // rays per pixel to estimate the visible sky, at least one for each sample; 0: none; at most 2^20
  double sky_distance = 0.9;                // above 0: surfaces farther away do not occlude the sky, in half diagonals of the bounding box
  bool ground = true;                       // adds a plane under the lowest point, which receives shadows; visible only from above
  vec3 up = {0, 1, 0};                      // away from the ground; of any length but 0
  vec3 light = {-0.55, 0.9, 0.75};          // towards the light, in the frame of the camera: right, up, back; of any length but 0
  double light_size = 9;                    // angular radius in degrees, in [0, 90); larger lights give softer shadows
  rgb background = {1, 1, 1};               // also the colour of the ground
  concino::progress progress = {};  // called with the fraction done and "rendering"
};

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

namespace detail {

inline void check_render_options(const render_options& o) {
  const auto need = [](bool ok, const char* what) {
    if (!ok) core::throw_joined<invalid_argument>({"render: ", what});
  };
  need(o.samples >= 1 && o.samples <= 32, "samples must be 1 to 32");
  need(o.sky_rays >= 0 && o.sky_rays <= 1 << 20, "sky_rays must be 0 to 1048576");
  need(o.sky_distance > 0, "sky_distance must be positive");
  need(o.light_size >= 0 && o.light_size < 90, "light_size must be in [0, 90) degrees");
  need(norm(o.up) > 0 && is_finite(o.up), "up must be finite and not 0");
  need(norm(o.light) > 0 && is_finite(o.light), "light must be finite and not 0");
}

template<RayCaster C>
class painter {
  const unit_scene& scene_;
  const C& caster_;
  const render_options& options_;
  camera camera_;
  vec3 up_, light_;
  frame light_frame_{{0, 0, 1}};
  double light_cosine_, light_sine_, ground_, ball_, mean_sky_;
  cosine_directions sky_;
  static constexpr double gap_ = 3e-5;  // rays start at this distance from the surface, so that they miss it in single precision
  static constexpr double far_ = 1e30;
  static constexpr std::size_t light_rays_ = 1;  // for each sample

  /// The light from the sky and the ground; 1 for light that comes only from straight above.
  double sky_light(const vec3& position, const vec3& normal, const vec3& flat, std::size_t sample, const cosine_directions::turn& turn) const {
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
      if (misses_all(position, d) || !caster_.occluded(position, d, 0, options_.sky_distance)) sum += brightness(d);
    }
    return sum / static_cast<double>(last - first);
  }

  /// Whether a ray misses the bounding ball of the scene: a fast test, true for most rays from the ground.
  bool misses_all(const vec3& position, const vec3& d) const {
    const double away = dot(position, position), along = -dot(position, d);
    return away > ball_ && (along <= 0 || away - along * along > ball_);
  }

  double brightness(const vec3& d) const { return 0.80 + 0.20 * dot(d, up_); }

  /// The light from the area light; 1 if it is perpendicular and unshaded. Every sample tests another part of the light.
  double key_light(const vec3& position, const vec3& normal, const vec3& flat, std::size_t sample, const unit_point& shift) const {
    if (dot(normal, light_) <= -light_sine_) return 0;
    double sum = 0;
    for (std::size_t k = 0; k < light_rays_; ++k) {
      const vec3 d = cone_direction(light_frame_, light_cosine_, spread_point(sample * light_rays_ + k, shift));
      const double cosine = dot(normal, d);
      if (cosine > 0 && dot(flat, d) > 0 && (misses_all(position, d) || !caster_.occluded(position, d, 0, far_))) sum += cosine;
    }
    return sum / static_cast<double>(light_rays_);
  }

  rgb paint_surface(const surface_point& s, const view_ray& ray, std::size_t sample, const cosine_directions::turn& turn,
                    const unit_point& shift) const {
    const vec3 start = s.smooth_position + s.flat * gap_;
    const double sky = sky_light(start, s.normal, s.flat, sample, turn);
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

  rgb paint_ground(const vec3& position, std::size_t sample, const cosine_directions::turn& turn, const unit_point& shift) const {
    const double away = norm(position);
    const vec3 start = position + up_ * gap_;
    double sky = 1, key = 1;
    if (away < 1 + options_.sky_distance) sky = sky_light(start, up_, up_, sample, turn) / mean_sky_;
    if (const double straight = dot(up_, light_); straight > 0) key = std::min(1.0, key_light(start, up_, up_, sample, shift) / straight);
    return options_.background * static_cast<float>(1 - 0.62 * (1 - std::min(1.0, sky)) - 0.22 * (1 - key));
  }

 public:
  painter(const unit_scene& scene, const C& caster, const camera& c, const render_options& o)
      : scene_(scene), caster_(caster), options_(o), camera_(scene.to_unit(c)), sky_(static_cast<std::size_t>(o.sky_rays)) {
    up_ = o.up / norm(o.up);
    light_ = camera_.right * o.light.x + camera_.up * o.light.y + camera_.back * o.light.z;
    light_ /= norm(light_);
    light_frame_ = frame(light_);
    light_cosine_ = std::cos(o.light_size * 3.14159265358979323846 / 180);
    light_sine_ = std::sin(o.light_size * 3.14159265358979323846 / 180);
    ground_ = scene.lowest(up_);
    ball_ = scene.squared_radius() * 1.0001;
    mean_sky_ = o.sky_rays > 0 ? 0.80 + 0.20 * 2 / 3 : 1.0;  // the mean height of cosine-weighted directions is 2/3
  }

  rgb pixel(std::size_t x, std::size_t y, surface_reader& read) const {
    const std::uint64_t seed = scrambled(y * options_.width + x);
    const cosine_directions::turn turn(random_point(seed));
    const unit_point shift = random_point(seed + 1);
    const int n = options_.samples;
    const double unit = 2.0 / static_cast<double>(options_.height);
    rgb sum;
    for (int s = 0; s < n * n; ++s) {
      const unit_point jitter = random_point(seed + static_cast<std::uint64_t>(s) + 2);
      const double px = tent((s % n + jitter.x) / n), py = tent((s / n + jitter.y) / n);
      const image_point film{(static_cast<double>(x) + 0.5 + px - 0.5 * static_cast<double>(options_.width)) * unit,
                            (0.5 * static_cast<double>(options_.height) - static_cast<double>(y) - 0.5 - py) * unit};
      const view_ray ray = camera_.ray_through(film);
      const std::size_t at = static_cast<std::size_t>(s);
      const ray_hit hit = misses_all(ray.origin, ray.direction) ? ray_hit{} : caster_.intersect(ray.origin, ray.direction, 0, far_);
      const double num_rows = -dot(ray.direction, up_), above = dot(ray.origin, up_) - ground_;
      const double ground_at = options_.ground && num_rows > 1e-6 && above > 0 ? above / num_rows : far_;
      if (hit && hit.t < ground_at) sum += paint_surface(read(hit, ray, film), ray, at, turn, shift);
      else if (ground_at < 1e3) sum += paint_ground(ray.origin + ray.direction * ground_at, at, turn, shift);
      else sum += options_.background;
    }
    return sum * (1 / static_cast<float>(n * n));
  }

  surface_reader reader() const { return {scene_, camera_, options_.height, options_.samples}; }
};

}  // namespace detail

/// A picture of the drawables from camera `from`, lit by the sky, by a light beside the viewer and weakly from the front.
/// Needs:  a ray tracer such as concino::embree{} of <concino/adapters/embree.hpp>.
/// Result: the same picture on every run and for any number of threads.
/// Cost:   samples^2 rays for each pixel; where it shows a surface or the ground, also sky_rays rays, and one to the light for each sample.
/// Errors: invalid_argument if an option is out of its range; unsupported without a ray tracer; cancelled if progress says so.
template<RayTracer T = no_ray_tracer>
image render(std::span<const drawable> drawables, const camera& from, const render_options& options = {}, const T& tracer = {}) {
  detail::check_render_options(options);
  image picture(options.width, options.height, options.background);
  const detail::unit_scene scene(drawables);
  const auto caster = tracer.build(scene.soup);
  const detail::painter paint(scene, caster, from, options);

  constexpr std::size_t tile_size = 16;  // in pixels, of the tiles that threads render in parallel
  const std::size_t num_columns = (options.width + tile_size - 1) / tile_size, num_rows = (options.height + tile_size - 1) / tile_size;
  const auto tile = [&](std::size_t i) {
    auto read = paint.reader();
    const std::size_t x0 = i % num_columns * tile_size, y0 = i / num_columns * tile_size;
    for (std::size_t y = y0; y < std::min(y0 + tile_size, options.height); ++y)
      for (std::size_t x = x0; x < std::min(x0 + tile_size, options.width); ++x) picture(x, y) = paint.pixel(x, y, read);
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
