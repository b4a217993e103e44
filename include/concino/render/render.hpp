// Still pictures: a surface in soft daylight on a light ground, good enough to print. The rays are cast by whatever is handed in.
#pragma once

#include <concino/parallel.hpp>
#include <concino/progress.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/image.hpp>
#include <concino/render/ray_caster.hpp>
#include <concino/render/sampling.hpp>
#include <concino/render/surface_color.hpp>

#include <span>

namespace concino {

struct render_options {
  std::size_t width = 1600, height = 1200;   // pixels
  int samples = 3;                           // per pixel along each side, 1 to 32; 9 in all for 3
  int sky_rays = 72;                         // per pixel, to see how much of the sky each point sees; 0: no ambient occlusion
  double sky_distance = 1.2;                 // up to where things shade one another, in half diagonals of the bounding box
  bool ground = true;                        // catches the shadow on a plane under the lowest point; shown from above only
  vec3 up = {0, 1, 0};                       // away from the ground
  vec3 light = {-0.55, 0.9, 0.75};           // towards the light, as seen by the camera: right, up, back
  double light_size = 9;                     // degrees from its middle to its rim: how soft shadows are
  rgb background = {1, 1, 1};
  concino::progress progress = {};           // told "rendering"
};

/// The nearest camera that sees all of the drawables.      Errors: as framing.
inline camera frame(std::span<const drawable> drawables, double aspect, const view_options& options = {}) {
  framing f(aspect, options);
  for (const drawable& d : drawables) f.show(d.points);
  return f.best();
}

namespace detail {

inline void check(const render_options& o) {
  const auto need = [](bool ok, const char* what) {
    if (!ok) throw invalid_argument(std::string("render: ") + what);
  };
  need(o.samples >= 1 && o.samples <= 32, "samples must be 1 to 32");
  need(o.sky_rays >= 0 && o.sky_rays <= 1 << 20, "sky_rays must be 0 to 1048576");
  need(o.sky_distance > 0, "sky_distance must be positive");
  need(o.light_size >= 0 && o.light_size < 90, "light_size must be in [0, 90) degrees");
  need(norm(o.up) > 0 && is_finite(o.up), "up must be a finite direction");
  need(norm(o.light) > 0 && is_finite(o.light), "light must be a finite direction");
}

template<RayCaster C>
class painter {
  const unit_scene& scene_;
  const C& caster_;
  const render_options& options_;
  camera camera_;
  vec3 up_, light_;
  double light_cosine_, ground_;
  static constexpr double gap_ = 3e-5;  // rays start this far off the surface, to miss it in single precision
  static constexpr double far_ = 1e30;

  int rays_of_sample(int s) const {  // sky rays of a pixel dealt out to its samples
    const int all = options_.samples * options_.samples;
    return options_.sky_rays * (s + 1) / all - options_.sky_rays * s / all;
  }

  /// What falls in from the sky and the ground, 1 for a point that sees only sky overhead.
  double sky_light(const vec3& place, const vec3& normal, const vec3& flat, int sample, const unit_point& shift) const {
    const int rays = rays_of_sample(sample);
    const std::uint64_t first = static_cast<std::uint64_t>(options_.sky_rays) * static_cast<std::uint64_t>(sample) / static_cast<std::uint64_t>(options_.samples * options_.samples);
    const frame f(normal);
    if (rays == 0) return brightness(normal);
    double sum = 0;
    for (int k = 0; k < rays; ++k) {
      vec3 d = cosine_direction(f, spread_point(first + static_cast<std::uint64_t>(k), shift));
      const double above = dot(d, flat);
      if (above < 0) d -= flat * (2 * above);  // the smooth normal's hemisphere reaches below the triangle
      if (!caster_.occluded(place, d, 0, options_.sky_distance)) sum += brightness(d);
    }
    return sum / rays;
  }

  double brightness(const vec3& d) const { return 0.80 + 0.20 * dot(d, up_); }

  double key_light(const vec3& place, const vec3& normal, const vec3& flat, const vec3& to_light) const {
    const double cosine = dot(normal, to_light);
    if (cosine <= 0 || dot(flat, to_light) <= 0) return 0;
    return caster_.occluded(place, to_light, 0, far_) ? 0 : cosine;
  }

  rgb paint_surface(const surface_point& s, const sight& ray, int sample, const unit_point& shift, const vec3& to_light) const {
    const vec3 start = s.lifted + s.flat * gap_;
    const double sky = sky_light(start, s.normal, s.flat, sample, shift);
    const double key = key_light(start, s.normal, s.flat, to_light);
    const double front = std::max(0.0, -dot(s.normal, ray.direction));
    const double light = 0.60 * sky + 0.50 * key + 0.07 * front;
    rgb c = s.color * static_cast<float>(light);
    if (key > 0 && s.shine > 0) {
      const vec3 half = to_light - ray.direction;
      const double glint = std::pow(std::max(0.0, dot(s.normal, half) / norm(half)), 50);
      const float g = static_cast<float>(0.10 * s.shine * glint);
      c += {g, g, g};
    }
    return c;
  }

  rgb paint_ground(const vec3& place, int sample, const unit_point& shift, const vec3& to_light) const {
    const double away = norm(place);
    double sky = 1, key = 1;
    if (away < 1 + options_.sky_distance) sky = sky_light(place + up_ * gap_, up_, up_, sample, shift) / mean_sky_;
    const double along = dot(-place, to_light);
    if (along > 0 && away * away - along * along < 1.1 && caster_.occluded(place + up_ * gap_, to_light, 0, far_)) key = 0;
    return options_.background * static_cast<float>(1 - 0.62 * (1 - std::min(1.0, sky)) - 0.22 * (1 - key));
  }

  double mean_sky_ = 1;

 public:
  painter(const unit_scene& scene, const C& caster, const camera& c, const render_options& o) : scene_(scene), caster_(caster), options_(o), camera_(scene.to_unit(c)) {
    up_ = o.up / norm(o.up);
    light_ = camera_.right * o.light.x + camera_.up * o.light.y + camera_.back * o.light.z;
    light_ /= norm(light_);
    light_cosine_ = std::cos(o.light_size * 3.14159265358979323846 / 180);
    ground_ = scene.lowest(up_);
    mean_sky_ = o.sky_rays > 0 ? 0.80 + 0.20 * 2 / 3 : 1.0;  // a cosine-weighted direction rises by 2/3
  }

  rgb pixel(std::size_t x, std::size_t y, surface_reader& read) const {
    const std::uint64_t seed = scrambled(y * options_.width + x);
    const unit_point shift = random_point(seed);
    const int n = options_.samples;
    const double unit = 2.0 / static_cast<double>(options_.height);
    rgb sum;
    for (int s = 0; s < n * n; ++s) {
      const unit_point jitter = random_point(seed + static_cast<std::uint64_t>(s) * 2 + 1), toward = random_point(seed + static_cast<std::uint64_t>(s) * 2 + 2);
      const double px = tent((s % n + jitter.x) / n), py = tent((s / n + jitter.y) / n);
      const film_point film{(static_cast<double>(x) + 0.5 + px - 0.5 * static_cast<double>(options_.width)) * unit,
                            (0.5 * static_cast<double>(options_.height) - static_cast<double>(y) - 0.5 - py) * unit};
      const sight ray = camera_.through(film);
      // Each sample gets its own part of the light, so that nine samples see nine parts.
      const vec3 to_light = cone_direction(frame(light_), light_cosine_, {(s / n + toward.x) / n, (s % n + toward.y) / n});
      const ray_hit hit = caster_.intersect(ray.origin, ray.direction, 0, far_);
      const double down = -dot(ray.direction, up_), above = dot(ray.origin, up_) - ground_;
      const double ground_at = options_.ground && down > 1e-6 && above > 0 ? above / down : far_;
      if (hit && hit.t < ground_at) sum += paint_surface(read(hit, ray, film), ray, s, shift, to_light);
      else if (ground_at < 1e3) sum += paint_ground(ray.origin + ray.direction * ground_at, s, shift, to_light);
      else sum += options_.background;
    }
    return sum * (1 / static_cast<float>(n * n));
  }

  surface_reader reader() const { return {scene_, camera_, options_.height, options_.samples}; }
};

}  // namespace detail

/// A picture of the drawables as `from` sees them, lit by a sky, a light at the viewer's shoulder and a little from the front.
/// Needs:  a ray tracer such as concino::embree{} of <concino/adapters/embree.hpp>.
/// Result: the same picture on every run and for any number of threads.
/// Cost:   samples^2 rays for each pixel; another sky_rays, and one to the light for each sample, where it shows something.
/// Errors: invalid_argument if an option is out of its range; unsupported without a ray tracer; cancelled if progress says so.
template<RayTracer T = no_ray_tracer>
image render(std::span<const drawable> drawables, const camera& from, const render_options& options = {}, const T& tracer = {}) {
  detail::check(options);
  image picture(options.width, options.height, options.background);
  const detail::unit_scene scene(drawables);
  const auto caster = tracer.build(scene.soup);
  const detail::painter paint(scene, caster, from, options);

  constexpr std::size_t side = 16;  // of the tiles that the threads take in turn
  const std::size_t across = (options.width + side - 1) / side, down = (options.height + side - 1) / side;
  const auto tile = [&](std::size_t i) {
    auto read = paint.reader();
    const std::size_t x0 = i % across * side, y0 = i / across * side;
    for (std::size_t y = y0; y < std::min(y0 + side, options.height); ++y)
      for (std::size_t x = x0; x < std::min(x0 + side, options.width); ++x) picture(x, y) = paint.pixel(x, y, read);
  };
  const char* label = "rendering";
  detail::tell(options.progress, 0, label);
  parallel_for(across * down, tile, 1, [&](double fraction) {
    detail::tell(options.progress, fraction, label);
    return false;
  });
  detail::tell(options.progress, 1, label);
  return picture;
}

}  // namespace concino
