// Points of surfaces that rays hit, with what shading needs: positions, normals, the unlit colour.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/render/camera.hpp>
#include <concino/render/detail/colors/interpolation.hpp>
#include <concino/render/detail/trace/unit_scene.hpp>
#include <concino/render/ray_caster.hpp>

#include <vector>

namespace concino::detail {

/// A point where a ray hits the surface, with the data for shading.
struct surface_point {
  vec3 position, smooth_position;  // on the triangle; on the smooth surface that the triangle approximates
  vec3 flat, normal;               // of the triangle and of the smooth surface, towards the viewer
  rgb color;
  double shine = 0, opacity = 1;
  const surface_material* material = nullptr;
};

/// Computes surface_points of hits in a scene. Each thread needs its own, for its working memory.
class surface_reader {
  /// The triangle of a hit, its drawable and the polygon that it is part of.
  struct hit_triangle {
    std::size_t which;
    const drawable& d;
    std::uint32_t polygon, first, n;     // the corners of the polygon are first .. first+n-1
    std::array<std::uint32_t, 3> corners;  // of the triangle
    std::array<vec3, 3> points;
    vec3 area_vector;                    // twice that of the triangle
  };
  struct corner_image {
    image_point film;
    bool is_in_front;
  };

  const unit_scene& scene_;
  const camera& camera_;
  double pixel_, fineness_;  // size of a pixel on the film; number of samples along it
  std::vector<vec3> polygon_;
  std::vector<double> weights_, right_weights_, up_weights_;
  std::vector<corner_image> images_;
  vec3 polygon_normal_;

 public:
  surface_reader(const unit_scene& scene, const camera& unit_camera, std::size_t height, int samples)
      : scene_(scene), camera_(unit_camera), pixel_(2.0 / static_cast<double>(height)), fineness_(samples) {}

  surface_point operator()(const ray_hit& hit, const view_ray& ray, const image_point& film);

 private:
  vec3 corner(std::size_t which, std::uint32_t i) const {
    return scene_.point(scene_.first_point(which) + scene_[which].corners[i]);
  }
  hit_triangle read_hit(const ray_hit& hit);
  interpolation interpolate(const hit_triangle& at, const std::array<double, 3>& bary, const vec3& position,
                            std::vector<double>& weights) const;
  void add_neighbours(sampled_interpolation& mean, const hit_triangle& at, const vec3& position,
                      const image_point& film);
  void read_color(surface_point& s, sampled_interpolation& mean, const hit_triangle& at, const image_point& film);
  void read_edges(surface_point& s, const hit_triangle& at, const image_point& film);
};

}  // namespace concino::detail

#ifndef CONCINO_COMPILED
#include <concino/render/detail/colors/surface_reader.ipp>
#endif
