// Bodies of blend.hpp: blending of transforms by weights, for points in an array.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/parallel.hpp>
#include <concino/deform/detail/skin/blend.hpp>

#include <cmath>

namespace concino::detail {

/// A quaternion w + x i + y j + z k.
struct quaternion {
  double w = 1;
  vec3 v;

  quaternion operator*(const quaternion& o) const {
    return {w * o.w - dot(v, o.v), w * o.v + o.w * v + cross(v, o.v)};
  }
  double dot_with(const quaternion& o) const { return w * o.w + dot(v, o.v); }
  void add(double weight, const quaternion& o) { w += weight * o.w, v += weight * o.v; }
};

/// The quaternion of a rotation, by the largest of its four parts (Shepperd 1978).
CONCINO_INLINE quaternion quaternion_of(const affine_map& f) {
  const double trace = f.x.x + f.y.y + f.z.z;
  const double squares[4] = {1 + trace, 1 + 2 * f.x.x - trace, 1 + 2 * f.y.y - trace, 1 + 2 * f.z.z - trace};
  int largest = 0;
  for (int k = 1; k < 4; ++k)
    if (squares[k] > squares[largest]) largest = k;
  const double wx = f.y.z - f.z.y, wy = f.z.x - f.x.z, wz = f.x.y - f.y.x, xy = f.x.y + f.y.x, xz = f.x.z + f.z.x,
               yz = f.y.z + f.z.y, s = squares[largest];
  quaternion q = largest == 0   ? quaternion{s, {wx, wy, wz}}
                 : largest == 1 ? quaternion{wx, {s, xy, xz}}
                 : largest == 2 ? quaternion{wy, {xy, s, yz}}
                                : quaternion{wz, {xz, yz, s}};
  const double length = std::sqrt(q.dot_with(q));
  q.w /= length, q.v /= length;
  return q;
}

CONCINO_INLINE void check_skin(const skin_weights& weights, std::size_t num_points,
                               const std::vector<std::size_t>& used, const std::vector<affine_map>& transforms,
                               bool rigid) {
  if (weights.num_verts() != num_points)
    core::throw_joined<invalid_argument>({"skin: the weights are for ", weights.num_verts(),
                                          " verts, and the mesh has an index bound of ", num_points});
  if (weights.num_bones() != transforms.size())
    core::throw_joined<invalid_argument>(
        {"skin: there are ", transforms.size(), " transforms and weights of ", weights.num_bones(), " bones"});
  for (std::size_t b = 0; b < transforms.size(); ++b) {
    const affine_map& f = transforms[b];
    if (!is_finite(f.x) || !is_finite(f.y) || !is_finite(f.z) || !is_finite(f.origin))
      core::throw_joined<invalid_argument>({"skin: the transform of bone ", b, " is not finite"});
    if (rigid && !is_rigid(f, 1e-6))
      core::throw_joined<invalid_argument>({"skin: the transform of bone ", b,
                                            " is not a rotation and a translation; blend it with linear_blend"});
  }
  for (const std::size_t v : used)
    if (weights.bones(v).empty()) core::throw_joined<invalid_argument>({"skin: vert ", v, " has no weights"});
}

CONCINO_INLINE std::vector<vec3> blend_linearly(const std::vector<vec3>& points, const std::vector<std::size_t>& used,
                                                const skin_weights& weights,
                                                const std::vector<affine_map>& transforms) {
  std::vector<vec3> moved(points.size());
  parallel_for(used.size(), [&](std::size_t i) {
    const std::size_t v = used[i];
    const auto bones = weights.bones(v);
    const auto w = weights.weights(v);
    vec3 sum;
    for (std::size_t k = 0; k < bones.size(); ++k) sum += w[k] * transforms[bones[k]](points[v]);
    moved[v] = sum;
  });
  return moved;
}

CONCINO_INLINE std::vector<vec3> blend_dual_quaternions(const std::vector<vec3>& points,
                                                        const std::vector<std::size_t>& used,
                                                        const skin_weights& weights,
                                                        const std::vector<affine_map>& transforms) {
  std::vector<quaternion> real, dual;
  for (const affine_map& f : transforms) {
    real.push_back(quaternion_of(f));
    dual.push_back(quaternion{0, 0.5 * f.origin} * real.back());
  }
  std::vector<vec3> moved(points.size());
  parallel_for(used.size(), [&](std::size_t i) {
    const std::size_t v = used[i];
    const auto bones = weights.bones(v);
    const auto w = weights.weights(v);
    std::size_t pivot = 0;
    for (std::size_t k = 1; k < bones.size(); ++k)
      if (w[k] > w[pivot]) pivot = k;
    quaternion q{0, {}}, e{0, {}};
    for (std::size_t k = 0; k < bones.size(); ++k) {
      const double signed_weight = real[bones[k]].dot_with(real[bones[pivot]]) < 0 ? -w[k] : w[k];
      q.add(signed_weight, real[bones[k]]);
      e.add(signed_weight, dual[bones[k]]);
    }
    const double squared = q.dot_with(q);
    const vec3 &x = points[v], turned = x + (2 / squared) * cross(q.v, cross(q.v, x) + q.w * x);
    moved[v] = turned + (2 / squared) * (q.w * e.v - e.w * q.v + cross(q.v, e.v));
  });
  return moved;
}

}  // namespace concino::detail
