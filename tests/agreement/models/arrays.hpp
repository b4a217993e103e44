// Models: views of arrays, in Eigen matrices and in spans.
#pragma once

#include <concino/adapters/eigen.hpp>
#include <concino/adapters/span.hpp>

#include <agreement/run.hpp>

#include <array>
#include <span>
#include <vector>

namespace concino::agreement {

/// Points and polys as matrices, by rows or by columns.
template<class K, int Order>
struct in_matrices {
  using kind = K;
  static constexpr const char* column = "Eigen, span";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = true, gaps = false;

  template<class Arrays, class F>
  static void with(const input<Arrays>& in, F&& f) {
    constexpr int arity = arity_v<K>;
    const K m(in.arrays);
    Eigen::Matrix<double, Eigen::Dynamic, 3, Order> v(static_cast<int>(num_verts(m)), 3);
    Eigen::Matrix<int, Eigen::Dynamic, arity, Order> p(static_cast<int>(num_polys(m)), arity);
    for (const auto x : verts(m))
      for (int k = 0; k < 3; ++k) v(static_cast<int>(x.raw()), k) = point(m, x)[static_cast<std::size_t>(k)];
    for (const auto x : polys(m)) {
      int k = 0;
      for (const auto y : adj_p2v(m, x)) p(static_cast<int>(x.raw()), k++) = static_cast<int>(y.raw());
    }
    if constexpr (std::same_as<K, trimesh>) f(view_tri(v, p));
    else if constexpr (std::same_as<K, quadmesh>) f(view_quad(v, p));
    else if constexpr (std::same_as<K, tetmesh>) f(view_tet(v, p));
    else f(view_hex(v, p));
  }
};

/// Points as triples of numbers, polys with offsets.
template<class K>
struct in_spans {
  using kind = K;
  static constexpr const char* column = "Eigen, span";
  static constexpr const char* name = polys_of_kind<K>;
  static constexpr bool any_surface = true, gaps = false;

  template<class Arrays, class F>
  static void with(const input<Arrays>& in, F&& f) {
    std::vector<std::array<float, 3>> points;
    for (const vec3& x : in.arrays.points) points.push_back({float(x.x), float(x.y), float(x.z)});
    const auto numbers_of = [](const auto& ids) {
      std::vector<int> r;
      for (const auto x : ids) r.push_back(static_cast<int>(x.raw()));
      return r;
    };
    if constexpr (dimension_v<K> == 2) {
      const std::vector<int> corners = numbers_of(in.arrays.verts);
      f(view_polygons(std::span(points), std::span(in.arrays.offsets), std::span(corners)));
    } else {
      const std::vector<int> corners = numbers_of(in.arrays.face_verts), sides = numbers_of(in.arrays.poly_faces);
      f(view_polyhedra(std::span(points), std::span(in.arrays.face_offsets), std::span(corners), std::span(in.arrays.poly_offsets), std::span(sides),
                       std::span(in.arrays.outward)));
    }
  }
};

using array_surfaces = models<in_matrices<trimesh, Eigen::ColMajor>, in_matrices<quadmesh, Eigen::RowMajor>, in_spans<polygonmesh>>;
using array_volumes = models<in_matrices<tetmesh, Eigen::RowMajor>, in_matrices<hexmesh, Eigen::ColMajor>, in_spans<polyhedralmesh>>;

}  // namespace concino::agreement
