// The unlit colour of a point of a drawable: colour map of the values, iso-bands and edges.
#pragma once

#include <concino/render/detail/unit_scene.hpp>
#include <concino/render/polygon_weights.hpp>

namespace concino::detail {

/// The fraction of [x - w/2, x + w/2] that lies in bands of width `band` about 1/2, 3/2, 5/2 ..., for exact anti-aliasing.
inline double band_coverage(double x, double w, double band) {
  const auto integral = [&](double t) {
    const double whole = std::floor(t);
    return whole * band + std::min(std::max(t - whole - (0.5 - band / 2), 0.0), band);
  };
  if (!(w < 1e3)) return band;
  w = std::max(w, 1e-9);
  return std::min(1.0, std::max(0.0, (integral(x + w / 2) - integral(x - w / 2)) / w));
}

inline double segment_distance(const image_point& p, const image_point& a, const image_point& b) {
  const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
  const double t = length > 0 ? std::min(1.0, std::max(0.0, ((p.x - a.x) * x + (p.y - a.y) * y) / length)) : 0;
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}

/// A point where a ray hits the surface, with the data for shading.
struct surface_point {
  vec3 position, smooth_position;  // on the triangle; on the smooth surface that the triangle approximates
  vec3 flat, normal;   // of the triangle and of the smooth surface, towards the viewer
  rgb color;
  double shine = 0, opacity = 1;
};

/// Computes surface_points of hits in a scene. Each thread needs its own, for its working memory.
class surface_reader {
  static constexpr std::uint32_t many = 64;  // a polygon with more corners is shaded by its triangles

  const unit_scene& scene_;
  const camera& camera_;
  double pixel_, fineness_;  // size of a pixel on the film; number of samples along it
  std::vector<vec3> corners_;
  std::vector<double> weights_;

 public:
  surface_reader(const unit_scene& scene, const camera& unit_camera, std::size_t height, int samples)
      : scene_(scene), camera_(unit_camera), pixel_(2.0 / static_cast<double>(height)), fineness_(samples) {}

  surface_point operator()(const ray_hit& hit, const view_ray& ray, const image_point& film) {
    const auto [which, local] = scene_.owner(hit.triangle);
    const drawable& d = scene_[which];
    const auto& t = d.triangles[local];
    const vec3 a = corner(which, t[0]), b = corner(which, t[1]), c = corner(which, t[2]);
    const double bary[3] = {1 - hit.u - hit.v, hit.u, hit.v};
    surface_point s;
    s.position = a * bary[0] + b * bary[1] + c * bary[2];
    s.flat = cross(b - a, c - a);
    const double area = norm(s.flat);
    s.flat = area > 0 ? s.flat / area : -ray.direction;
    if (dot(s.flat, ray.direction) > 0) s.flat = -s.flat;
    s.shine = d.look.shine;

    const std::uint32_t p = d.polygon_of[local], first = d.offsets[p], n = d.offsets[p + 1] - first;
    const bool whole = n > 3 && n <= many;
    if (whole) {
      corners_.clear();
      vec3 along;
      for (std::uint32_t i = 0; i < n; ++i) corners_.push_back(corner(which, first + i));
      for (std::uint32_t i = 2; i < n; ++i) along += cross(corners_[i - 1] - corners_[0], corners_[i] - corners_[0]);
      const double length = norm(along);
      polygon_weights(corners_, length > 0 ? along / length : s.flat, s.position, weights_);
    }
    const auto mean = [&](auto&& of_corner, auto sum) {
      if (whole)
        for (std::uint32_t i = 0; i < n; ++i) sum += of_corner(first + i) * weights_[i];
      else
        for (std::size_t k = 0; k < 3; ++k) sum += of_corner(t[k]) * bary[k];
      return sum;
    };
    const auto corner_normal = [&](std::uint32_t i) { return to_vec3(d.normals[i]); };
    const vec3 smooth = mean(corner_normal, vec3{});
    const double length = norm(smooth);
    const double sign = dot(smooth, s.flat) < 0 ? -1 : 1;
    s.normal = length > 1e-6 ? smooth * (sign / length) : s.flat;

    // Rays from a coarse triangle towards grazing light would hit its neighbours, although the approximated surface is round there. So they start
    // on the tangent planes of the corners. Source: Hanika 2021, "Hacking the Shadow Terminator".
    s.smooth_position = s.position;
    const vec3 ends[3] = {a, b, c};
    for (std::size_t k = 0; k < 3; ++k) {
      const vec3 m = corner_normal(t[k]) * sign;
      s.smooth_position += m * (bary[k] * std::max(0.0, dot(ends[k] - s.position, m)));
    }

    s.color = d.look.color;
    if (!d.values.empty()) {
      const auto value = [&](std::uint32_t i) { return d.values[d.corners[i]]; };
      const double ends_value[3] = {value(t[0]), value(t[1]), value(t[2])};
      s.color = value_color(d.look, mean(value, 0.0), value_step(a, b, c, ends_value, s.position, film));
    }
    s.opacity = d.look.opacity;
    if (d.look.edge_width > 0) {
      const double edge = d.look.edge_opacity * edge_coverage(which, d, t, first, n, film);
      s.color = mix(s.color, d.look.edge_color, static_cast<float>(edge));
      if (s.opacity > 0) s.opacity += (1 - s.opacity) * edge;  // edges stay visible on transparent surfaces
    }
    return s;
  }

 private:
  vec3 corner(std::size_t which, std::uint32_t i) const { return scene_.point(scene_.first_point(which) + scene_[which].corners[i]); }

  rgb value_color(const appearance& look, double value, double step) const {
    if (!std::isfinite(value)) return look.no_value;
    const double x = look.scale(value);
    const rgb color = look.map(x);
    const double slope = look.scale.slope(value);
    if (look.bands <= 0 || !(slope > 0)) return color;
    const double band_step = step * slope * look.bands;  // from one sample to the next, in distances between bands
    const double limit = look.band_limit / pixel_ * 2 * fineness_ * band_step;
    const double width = std::min({1.0, std::max(0.0, look.band_width), limit});
    return mix(color, {1, 1, 1}, static_cast<float>(band_coverage(x * look.bands, 1.5 * band_step, width)));
  }

  // The change of the value from one sample to the next: intersects the neighbouring rays with the plane of the triangle.
  double value_step(const vec3& a, const vec3& b, const vec3& c, const double (&u)[3], const vec3& position, const image_point& film) const {
    const vec3 e = b - a, f = c - a, n = cross(e, f);
    const double nn = dot(n, n);
    if (!(nn > 0)) return 0;
    const vec3 gradient = (cross(f, n) * (u[1] - u[0]) + cross(n, e) * (u[2] - u[0])) / nn;
    const auto step = [&](double dx, double dy) {
      const view_ray beside = camera_.ray_through({film.x + dx, film.y + dy});
      const double toward = dot(beside.direction, n);
      if (toward == 0) return std::numeric_limits<double>::infinity();
      return std::abs(dot(gradient, beside.origin + beside.direction * (dot(position - beside.origin, n) / toward) - position));
    };
    return std::max(step(pixel_ / fineness_, 0), step(0, pixel_ / fineness_));
  }

  double edge_coverage(std::size_t which, const drawable& d, const std::array<std::uint32_t, 3>& t, std::uint32_t first, std::uint32_t n,
                       const image_point& film) const {
    double nearest = std::numeric_limits<double>::infinity();
    const auto add_edge = [&](std::uint32_t i, std::uint32_t j) {
      nearest = std::min(nearest, segment_distance(film, camera_.project(corner(which, i)), camera_.project(corner(which, j))));
    };
    if (n <= many) {
      for (std::uint32_t i = 0; i < n; ++i) add_edge(first + i, first + (i + 1) % n);
    } else {
      for (std::size_t k = 0; k < 3; ++k)
        if (t[(k + 1) % 3] - first == (t[k] - first + 1) % n) add_edge(t[k], t[(k + 1) % 3]);
    }
    return std::min(1.0, std::max(0.0, (d.look.edge_width / 2 - nearest / pixel_) * fineness_ + 0.5));
  }
};

}  // namespace concino::detail
