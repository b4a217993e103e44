// Bodies of drawable_values.hpp: values and colours of drawables, read from arrays by the index of elements of their
// mesh.
#pragma once

#include <concino/core/error.hpp>
#include <concino/render/detail/colors/drawable_values.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void check_look(double opacity, double shine, double crease_angle, double edge_width, int isobands,
                               int isolines, element_kind labels_at) {
  const auto need = [](bool ok, const char* what) {
    if (!ok) core::throw_joined<invalid_argument>({"make_drawable: ", what});
  };
  need(opacity >= 0 && opacity <= 1, "opacity must be in [0, 1]");
  need(shine >= 0, "shine must be 0 or more");
  need(crease_angle >= 0 && crease_angle <= 180, "crease_angle must be in [0, 180] degrees");
  need(edge_width > 0, "edge_width must be positive; to draw no edges, set edges to false");
  need(isobands >= 0 && isolines >= 0, "isobands and isolines must be 0 or more");
  need(labels_at != element_kind::vert && labels_at != element_kind::edge, "labels must be at polys or faces");
}

CONCINO_INLINE void expose(drawable& d, std::span<const unsigned char> selected) {
  d.exposed.resize(d.mesh_polygons.size());
  for (std::size_t p = 0; p < d.exposed.size(); ++p)
    if (selected[d.mesh_polygons[p]] != 0) d.exposed[p] = 1;
}

CONCINO_INLINE void finish_drawable(drawable& d, double crease_angle) {
  add_triangles(d);
  d.normals = smooth_normals(d.polygons(), crease_angle);
}

/// The elements of the mesh that are the polygons of a drawable.
inline std::span<const std::uint32_t> polygon_elements(const drawable& d, element_kind at) {
  return at == element_kind::face ? d.mesh_polygons : d.polys;
}

CONCINO_INLINE void take_values(drawable& d, element_kind at, std::span<const double> by_index,
                                std::span<const std::uint32_t> edges, const std::optional<value_scale>& scale) {
  std::vector<double>& to = at == element_kind::edge ? d.edge_values : d.values;
  const std::span<const std::uint32_t> from = at == element_kind::edge   ? edges
                                              : at == element_kind::vert ? std::span<const std::uint32_t>(d.verts)
                                                                         : polygon_elements(d, at);
  if (at == element_kind::edge) d.look.edge_opacity = 1;
  d.values_at = at == element_kind::vert ? value_place::points : value_place::polygons;
  to.resize(from.size());
  std::transform(from.begin(), from.end(), to.begin(), [&](std::uint32_t i) { return by_index[i]; });
  d.look.scale = scale ? *scale : value_scale::linear(to);
}

CONCINO_INLINE std::vector<std::array<float, 2>> texture_points_of_corners(const drawable& d, element_kind at,
                                                                           std::vector<std::array<float, 2>> points) {
  if (at == element_kind::corner) return points;
  std::vector<std::array<float, 2>> result;
  result.reserve(d.corners.size());
  for (const std::uint32_t point : d.corners) result.push_back(points[point]);
  return result;
}

}  // namespace concino::detail
