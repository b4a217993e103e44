// Defines metric.hpp and what all tables of metrics share.
#pragma once

#include <concino/core/error.hpp>
#include <concino/mesh/support/standard_cells.hpp>
#include <concino/quality/detail/metric_row.hpp>
#include <concino/quality/metric.hpp>

#include <string>
#include <vector>

namespace concino {

namespace detail {

inline constexpr std::string_view metric_names[] = {"area",
                                                    "area_perimeter_ratio",
                                                    "volume",
                                                    "aspect_beta",
                                                    "aspect_frobenius",
                                                    "aspect_gamma",
                                                    "aspect_ratio",
                                                    "circle_ratio",
                                                    "collapse_ratio",
                                                    "condition",
                                                    "diagonal",
                                                    "dimension",
                                                    "distortion",
                                                    "edge_ratio",
                                                    "equiangle_skew",
                                                    "equivolume_skew",
                                                    "inradius",
                                                    "jacobian",
                                                    "max_aspect_frobenius",
                                                    "max_edge_ratio",
                                                    "maximum_angle",
                                                    "mean_ratio",
                                                    "med_aspect_frobenius",
                                                    "minimum_angle",
                                                    "nodal_jacobian_ratio",
                                                    "normalized_inradius",
                                                    "oddy",
                                                    "planarity",
                                                    "radius_ratio",
                                                    "relative_size_squared",
                                                    "scaled_jacobian",
                                                    "shape",
                                                    "shape_and_size",
                                                    "shear",
                                                    "shear_and_size",
                                                    "skew",
                                                    "star_shapedness",
                                                    "stretch",
                                                    "taper",
                                                    "warpage"};
inline constexpr std::string_view poly_shape_names[] = {"triangle", "quad",  "polygon", "tet",
                                                        "hex",      "prism", "pyramid", "polyhedron"};
static_assert(std::size(metric_names) == num_metrics && std::size(poly_shape_names) == num_poly_shapes &&
              static_cast<unsigned>(metric::warpage) + 1 == num_metrics);

/// The faces of a standard cell, one after another.
struct flat_faces {
  unsigned begins[7] = {}, verts[24] = {}, num_faces = 0;

  constexpr explicit flat_faces(cell_shape s) : num_faces(standard_cell_of(s).num_faces) {
    for (unsigned f = 0; f < num_faces; ++f) {
      begins[f + 1] = begins[f];
      for (unsigned i = 0; i < standard_cell_of(s).face_size[f]; ++i)
        verts[begins[f + 1]++] = standard_cell_of(s).face_vert[f][i];
    }
  }
};

CONCINO_INLINE void set_standard_faces(poly_geometry& g) {
  static constexpr flat_faces of_shape[] = {flat_faces(cell_shape::tet), flat_faces(cell_shape::hex),
                                            flat_faces(cell_shape::prism), flat_faces(cell_shape::pyramid)};
  if (g.shape < poly_shape::tet || g.shape == poly_shape::polyhedron) return;
  const flat_faces& faces = of_shape[static_cast<unsigned>(g.shape) - static_cast<unsigned>(poly_shape::tet)];
  g.face_begins = {faces.begins, faces.num_faces + 1};
  g.face_verts = {faces.verts, faces.begins[faces.num_faces]};
}

CONCINO_INLINE const metric_row* find_row(metric what, poly_shape shape) {
  const auto find_in = [&](std::span<const metric_row> rows) -> const metric_row* {
    for (const metric_row& row : rows)
      if (row.what == what) return &row;
    return nullptr;
  };
  const metric_row* own = nullptr;
  if (shape == poly_shape::triangle) own = find_in(triangle_rows());
  if (shape == poly_shape::quad) own = find_in(quad_rows());
  if (shape == poly_shape::tet) own = find_in(tet_rows());
  if (shape == poly_shape::hex) own = find_in(hex_rows());
  if (own != nullptr) return own;
  return find_in(shape < poly_shape::tet ? polygon_rows() : polyhedron_rows());
}

/// For points so far apart or so close that products of their distances would overflow or underflow: scales by a power
/// of two.
inline double evaluate_scaled(const metric_row& row, poly_geometry g) {
  if (g.points.empty()) return no_ideal;
  std::vector<vec3> local;
  bool far_apart = false;
  for (const vec3& p : g.points) {
    if (!is_finite(p)) return no_ideal;
    far_apart = far_apart || !is_finite(p - g.points[0]);
  }
  double largest = 0;
  for (const vec3& p : g.points) {
    const vec3 d = far_apart ? p / 2 - g.points[0] / 2 : p - g.points[0];
    local.push_back(d);
    largest = std::max({largest, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  }
  const int exponent = largest > 0 ? std::ilogb(largest) : 0, scale = exponent + far_apart;
  for (vec3& p : local) p = {std::ldexp(p.x, -exponent), std::ldexp(p.y, -exponent), std::ldexp(p.z, -exponent)};
  g.points = local;
  g.mean_size = std::ldexp(g.mean_size, -scale * (g.shape < poly_shape::tet ? 2 : 3));
  double value = 0;
  row.compute(g, 1, &value);
  return std::ldexp(value, scale * static_cast<int>(row.limits.length_power));
}

CONCINO_INLINE void evaluate(const metric_row& row, const poly_geometry& all, std::size_t n, double* values) {
  const std::size_t size = all.points.size() / n;
  bool moderate = true;
  for (std::size_t i = 0; i < n; ++i) {
    const vec3* const p = all.points.data() + i * size;
    double sum = 0;
    for (std::size_t k = 1; k < size; ++k)
      sum += std::abs(p[k].x - p[0].x) + std::abs(p[k].y - p[0].y) + std::abs(p[k].z - p[0].z);
    moderate = moderate && sum > 1e-25 && sum < 1e25;
  }
  if (moderate) return row.compute(all, n, values);
  poly_geometry g = all;
  for (std::size_t i = 0; i < n; ++i) {
    g.points = all.points.subspan(i * size, size);
    if (n > 1) evaluate(row, g, 1, values + i);
    else values[i] = evaluate_scaled(row, g);
  }
}

}  // namespace detail

CONCINO_INLINE bool is_defined(metric what, poly_shape shape) { return detail::find_row(what, shape) != nullptr; }

CONCINO_INLINE metric_limits limits_of(metric what, poly_shape shape) {
  const detail::metric_row* const row = detail::find_row(what, shape);
  if (row == nullptr)
    core::throw_joined<unsupported>({"limits_of: ", name_of(what), " is not defined for a ", name_of(shape),
                                     "; is_defined says which metrics are"});
  return row->limits;
}

CONCINO_INLINE bool is_acceptable(metric what, poly_shape shape, double value) {
  return detail::is_acceptable_in(limits_of(what, shape).acceptable, larger_is_worse(what), value);
}

CONCINO_INLINE bool larger_is_worse(metric what) {
  switch (what) {
    case metric::aspect_beta:
    case metric::aspect_frobenius:
    case metric::aspect_gamma:
    case metric::aspect_ratio:
    case metric::condition:
    case metric::edge_ratio:
    case metric::equiangle_skew:
    case metric::equivolume_skew:
    case metric::max_aspect_frobenius:
    case metric::max_edge_ratio:
    case metric::maximum_angle:
    case metric::med_aspect_frobenius:
    case metric::oddy:
    case metric::radius_ratio:
    case metric::skew:
    case metric::taper:
    case metric::warpage: return true;
    default: return false;
  }
}

CONCINO_INLINE std::string_view name_of(metric what) { return detail::metric_names[static_cast<unsigned>(what)]; }
CONCINO_INLINE std::string_view name_of(poly_shape shape) {
  return detail::poly_shape_names[static_cast<unsigned>(shape)];
}

CONCINO_INLINE metric metric_named(std::string_view name) {
  if (name == "aspect") return metric::aspect;
  if (name == "kernel_ratio") return metric::kernel_ratio;
  std::string all;
  for (std::size_t i = 0; i < num_metrics; ++i) {
    if (detail::metric_names[i] == name) return static_cast<metric>(i);
    all.append(i == 0 ? "" : ", ").append(detail::metric_names[i]);
  }
  core::throw_joined<invalid_argument>({"metric_named: no metric is called '", name, "'; write one of ", all});
}

CONCINO_INLINE double quality(poly_shape shape, std::span<const vec3> points, metric what, double mean_size) {
  static constexpr std::size_t num_points[] = {3, 4, 5, 4, 8, 6, 5, 0};
  const detail::metric_row* const row = detail::find_row(what, shape);
  if (row == nullptr || shape == poly_shape::polyhedron)
    core::throw_joined<unsupported>(
        {"quality: ", name_of(what), " of a ", name_of(shape),
         row == nullptr ? " is not defined" : " needs its faces: call quality(m, p, metric)"});
  const std::size_t n = num_points[static_cast<unsigned>(shape)];
  if (points.size() < n || (points.size() > n && shape != poly_shape::polygon))
    core::throw_joined<invalid_argument>({"quality: a ", name_of(shape), " has ", n,
                                          shape == poly_shape::polygon ? " points or more, not " : " points, not ",
                                          points.size()});
  detail::poly_geometry g{shape, points, {}, {}, mean_size};
  detail::set_standard_faces(g);
  double value = 0;
  detail::evaluate(*row, g, 1, &value);
  return value;
}

}  // namespace concino
