// Bodies of limit_masks.hpp: limits of smooth subdivision: how the ring around a vert, after one step, gives the point
// and the tangent plane of the smooth surface.
#pragma once

#include <concino/generate/detail/subdivide/limit_masks.hpp>

#include <cmath>
#include <numbers>

namespace concino::detail {

/// The weights of the ring that give the tangents of a scheme. For edge k they are sin or cos of k times the angle,
/// which is a full or half turn divided by the number of polys, and for the polys `poly` times the sum of those of
/// their two edges. They are left eigenvectors of one step, for the eigenvalue `value`. At the boundary, the first and
/// the last edge and the vert have weights of their own.
struct tangent_masks {
  double angle, value, poly;
  double edge_to_end;  // the part of a new vert of an edge inside that comes from an edge beside it

  tangent_masks(smooth_scheme scheme, double turn) : angle(turn) {
    const double c = std::cos(angle);
    if (scheme == smooth_scheme::loop) {
      value = 0.375 + 0.25 * c, poly = 0, edge_to_end = 0.125;
    } else {
      value = (5 + c + std::sqrt((c + 9) * (c + 1))) / 16, poly = 1 / (16 * value - 4), edge_to_end = 0.0625;
    }
  }
  vec3 sum(const limit_ring& r, double (*wave)(double)) const {
    vec3 t;
    for (std::size_t k = 0; k < r.edges.size(); ++k) t += wave(static_cast<double>(k) * angle) * r.edges[k];
    for (std::size_t k = 0; k < r.polys.size(); ++k)
      t += poly * (wave(static_cast<double>(k) * angle) + wave(static_cast<double>(k + 1) * angle)) * r.polys[k];
    return t;
  }
  vec3 sine_sum(const limit_ring& r) const {
    return sum(r, [](double x) { return std::sin(x); });
  }
  vec3 cosine_sum(const limit_ring& r) const {
    return sum(r, [](double x) { return std::cos(x); });
  }
};

CONCINO_INLINE vec3 inner_limit(smooth_scheme scheme, const limit_ring& r) {
  const double n = static_cast<double>(r.edges.size());
  vec3 of_edges, of_polys;
  for (const vec3& x : r.edges) of_edges += x;
  for (const vec3& x : r.polys) of_polys += x;
  if (scheme == smooth_scheme::catmull_clark) return (n * n * r.vert + 4.0 * of_edges + of_polys) / (n * (n + 5));
  const double root = 0.375 + 0.25 * std::cos(2 * std::numbers::pi / n), moved = 0.625 - root * root,
               own = 0.375 * n / moved;
  return (own * r.vert + of_edges) / (own + n);
}

/// A tangent at a boundary vert that points into the surface.
CONCINO_INLINE vec3 inward_tangent(smooth_scheme scheme, const limit_ring& r) {
  const vec3 ends = r.edges.front() + r.edges.back();
  if (r.num_polys == 1) return ends - 2.0 * r.vert;
  const tangent_masks masks(scheme, std::numbers::pi / static_cast<double>(r.num_polys));
  // Edges inside have the weights of a sine, as if the ring were closed by its mirror image. The weights x of the two
  // ends and y of the vert then follow from
  //   (value - 1/2) x = y / 8 + at_end,   (value - 3/4) y = x + at_vert,
  // where at_end and at_vert are what the new verts inside take from an end and from the vert.
  double edges = 0;
  for (std::size_t k = 1; k + 1 < r.edges.size(); ++k) edges += std::sin(static_cast<double>(k) * masks.angle);
  const double s = std::sin(masks.angle);
  const double at_end = masks.edge_to_end * s + masks.poly * s / 4, at_vert = 0.375 * edges + masks.poly * edges / 2;
  const double a = masks.value - 0.5, b = masks.value - 0.75;
  const double x = -(at_vert + 8 * b * at_end) / (1 - 8 * a * b), y = 8 * (a * x - at_end);
  return masks.sine_sum(r) + x * ends + y * r.vert;
}

CONCINO_INLINE vec3 limit_normal(smooth_scheme scheme, const limit_ring& r) {
  vec3 normal;
  if (r.is_closed) {
    if (r.edges.size() < 3) return normal;
    const tangent_masks masks(scheme, 2 * std::numbers::pi / static_cast<double>(r.edges.size()));
    normal = cross(masks.cosine_sum(r), masks.sine_sum(r));
  } else {
    normal = cross(r.edges.front() - r.edges.back(), inward_tangent(scheme, r));
  }
  const double length = norm(normal);
  return length > 0 ? normal / length : vec3();
}

}  // namespace concino::detail
