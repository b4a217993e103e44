// The value at a point of a poly, from values at its verts.
#pragma once

#include <concino/core/vec3.hpp>
#include <concino/geometry/polygon.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace concino::detail {

/// Of some triangles or tets, keeps the value in that which contains x, or, if none does, that which x is least outside
/// of.
struct simplex_choice {
  vec3 x;
  double value;  // if there is no simplex with a measure
  double best = -std::numeric_limits<double>::infinity();

  template<std::size_t N>
  void try_weights(const std::array<double, N>& weights, const std::array<double, N>& values) {
    const double least = *std::min_element(weights.begin(), weights.end());
    if (!(least > best)) return;
    best = least;
    value = values[0];
    // differences, so that constants stay what they are
    for (std::size_t k = 1; k < N; ++k) value += weights[k] * (values[k] - values[0]);
  }

  /// outward: triangles that do not face there overlap others.
  void try_triangle(const vec3& outward, const std::array<vec3, 3>& p, const std::array<double, 3>& values) {
    const vec3 area = cross(p[1] - p[0], p[2] - p[0]);
    if (!(dot(area, outward) > 0)) return;
    const double size = dot(area, area), second = dot(cross(x - p[0], p[2] - p[0]), area) / size,
                 third = dot(cross(p[1] - p[0], x - p[0]), area) / size;
    try_weights<3>({1 - second - third, second, third}, values);
  }
  void try_tet(double sign, const std::array<vec3, 4>& p, const std::array<double, 4>& values) {
    const vec3 a = p[1] - p[0], b = p[2] - p[0], c = p[3] - p[0], d = x - p[0];
    const double size = dot(a, cross(b, c));
    if (!(sign * size > 0)) return;
    const double second = dot(d, cross(b, c)) / size, third = dot(a, cross(d, c)) / size,
                 fourth = dot(a, cross(b, d)) / size;
    try_weights<4>({1 - second - third - fourth, second, third, fourth}, values);
  }
};

struct loop_mean {
  vec3 point;
  double value = 0;
};

template<class M, class Loop, class U>
loop_mean mean_of_loop(const M& m, const Loop& loop, const U& u) {
  loop_mean first, sum;
  double n = 0;
  for (const vert_t<M> v : loop) {
    const vec3 x = to_vec3(point(m, v));
    const double value = static_cast<double>(u[v]);
    if (n == 0) first = {x, value};
    sum.point += x - first.point;
    sum.value += value - first.value;
    n += 1;
  }
  return n > 0 ? loop_mean{first.point + sum.point / n, first.value + sum.value / n} : first;
}

/// Calls visit(a, u(a), b, u(b)) for the sides of a polygon.
template<class M, class Loop, class U, class Visit>
void for_each_loop_edge(const M& m, const Loop& loop, const U& u, const Visit& visit) {
  vec3 first, previous;
  double first_value = 0, previous_value = 0;
  bool any = false;
  for (const vert_t<M> v : loop) {
    const vec3 x = to_vec3(point(m, v));
    const double value = static_cast<double>(u[v]);
    if (any) visit(previous, previous_value, x, value);
    else first = x, first_value = value;
    previous = x, previous_value = value;
    any = true;
  }
  if (any) visit(previous, previous_value, first, first_value);
}

/// u is linear on the triangles between the mean of the verts of a polygon and its edges, or on the tets between the
/// mean of a polyhedron and such triangles of its faces. Means have mean values, so linear functions are exact, verts
/// have their values, and where polys are star-shaped about their means u is continuous.
template<class M, class U>
double value_in_poly(const M& m, const poly_t<M>& p, const U& u, const vec3& x) {
  const loop_mean centre = mean_of_loop(m, adj_p2v(m, p), u);
  simplex_choice choice{x, centre.value};
  if constexpr (dimension_v<M> == 2) {  // polygons have no faces
    const vec3 outward = area_vector_of(m, adj_p2v(m, p));
    for_each_loop_edge(m, adj_p2v(m, p), u, [&](const vec3& a, double at_a, const vec3& b, double at_b) {
      choice.try_triangle(outward, {centre.point, a, b}, {centre.value, at_a, at_b});
    });
  } else {
    for (const face_t<M> f : adj_p2f(m, p)) {
      const loop_mean middle = mean_of_loop(m, adj_f2v(m, f), u);
      const double sign = face_is_outward(m, p, f) ? 1 : -1;
      for_each_loop_edge(m, adj_f2v(m, f), u, [&](const vec3& a, double at_a, const vec3& b, double at_b) {
        choice.try_tet(sign, {centre.point, middle.point, a, b}, {centre.value, middle.value, at_a, at_b});
      });
    }
  }
  return choice.value;
}

}  // namespace concino::detail
