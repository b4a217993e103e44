// Keeps the elements and properties of a mesh for pages.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/parallel.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
#include <concino/mesh/corner_property.hpp>
#include <concino/mesh/property.hpp>
#include <concino/render/detail/page/property_values.hpp>
#include <concino/render/polygon_selection.hpp>

#include <limits>
#include <span>
#include <utility>

namespace concino::detail {

/// Lists by index, whatever the order in which their elements are visited: list_of(x) is a range of items.
template<class M, class R, class ListOf, class Item>
void fill_lists(const M& m, const R& all, std::size_t bound, std::vector<std::uint32_t>& starts,
                std::vector<std::uint32_t>& items, const ListOf& list_of, const Item& item) {
  starts.assign(bound + 1, 0);
  for (const auto x : all)
    for ([[maybe_unused]] const auto y : list_of(x)) ++starts[index_of(m, x) + 1];
  for (std::size_t i = 0; i < bound; ++i) starts[i + 1] += starts[i];
  items.resize(starts.back());
  for (const auto x : all) {
    std::uint32_t at = starts[index_of(m, x)];
    for (const auto y : list_of(x)) items[at++] = item(x, y);
  }
}

template<SurfaceMesh M>
void inspect_polys(const M& m, inspected_mesh& to) {
  fill_lists(
      m, polys(m), poly_index_bound(m), to.polygon_offsets, to.polygon_verts,
      [&m](const poly_t<M>& p) -> decltype(auto) { return adj_p2v(m, p); },
      [&m](const poly_t<M>&, const vert_t<M>& v) { return static_cast<std::uint32_t>(index_of(m, v)); });
}
template<VolumeMesh M>
void inspect_polys(const M& m, inspected_mesh& to) {
  to.is_volume = true;
  fill_lists(
      m, faces(m), face_index_bound(m), to.polygon_offsets, to.polygon_verts,
      [&m](const face_t<M>& f) -> decltype(auto) { return adj_f2v(m, f); },
      [&m](const face_t<M>&, const vert_t<M>& v) { return static_cast<std::uint32_t>(index_of(m, v)); });
  fill_lists(
      m, polys(m), poly_index_bound(m), to.poly_offsets, to.poly_faces,
      [&m](const poly_t<M>& p) -> decltype(auto) { return adj_p2f(m, p); },
      [&m](const poly_t<M>& p, const face_t<M>& f) {
        return static_cast<std::uint32_t>(2 * index_of(m, f) + (face_is_outward(m, p, f) ? 0 : 1));
      });
}

/// Triangles of the polygons, unless all are triangles.
inline void triangulate_inspected(inspected_mesh& to) {
  bool all_triangles = true;
  for (std::size_t p = 0; p + 1 < to.polygon_offsets.size(); ++p) {
    const std::uint32_t n = to.polygon_offsets[p + 1] - to.polygon_offsets[p];
    all_triangles = all_triangles && (n == 3 || n == 0);
  }
  if (all_triangles) return;
  polygon_triangulator cut;
  std::vector<vec3> polygon;
  for (std::size_t p = 0; p + 1 < to.polygon_offsets.size(); ++p) {
    const std::uint32_t first = to.polygon_offsets[p];
    polygon.clear();
    for (std::uint32_t c = first; c < to.polygon_offsets[p + 1]; ++c) polygon.push_back(to.points[to.polygon_verts[c]]);
    for (const polygon_triangle& t : cut(polygon))
      for (const std::uint32_t k : t) to.triangles.push_back(first + k);
  }
}

/// The corners of polys in the order of adj_p2v: lists of a volume, those of the polygons of a surface.
template<SurfaceMesh M>
void list_corners(const M&, inspected_mesh&) {}
template<VolumeMesh M>
void list_corners(const M& m, inspected_mesh& to) {
  if (!to.corner_offsets.empty()) return;
  fill_lists(
      m, polys(m), poly_index_bound(m), to.corner_offsets, to.corner_verts,
      [&m](const poly_t<M>& p) -> decltype(auto) { return adj_p2v(m, p); },
      [&m](const poly_t<M>&, const vert_t<M>& v) { return static_cast<std::uint32_t>(index_of(m, v)); });
}

template<AnyMesh M>
void inspect_properties(const M& m, inspected_mesh& to) {
  if constexpr (ShowsProperties<M>) {
    const property_set& all = traits<M>::properties(m);
    std::vector<std::size_t> corners;
    if constexpr (NumbersCorners<M>)
      if (has_corner_properties(all)) {
        list_corners(m, to);
        const auto& starts = to.is_volume ? to.corner_offsets : to.polygon_offsets;
        corners.resize(starts.back());
        for (const poly_t<M> p : polys(m))
          for (std::size_t c = starts[index_of(m, p)], k = 0; c < starts[index_of(m, p) + 1]; ++c, ++k)
            corners[c] = traits<M>::first_corner(m, p) + k;
      }
    add_properties(to.values, all, corners);
  }
}

/// All elements by index, and the corners of all polys, to read maps of colours and texture coordinates.
template<EmbeddedMesh M>
drawable all_elements(const M& m, inspected_mesh& to, element_kind at) {
  const auto numbers = [](std::size_t n) {
    std::vector<std::uint32_t> list(n);
    for (std::size_t i = 0; i < n; ++i) list[i] = static_cast<std::uint32_t>(i);
    return list;
  };
  drawable all;
  all.verts = numbers(to.points.size());
  all.polys = numbers(poly_index_bound(m));
  all.mesh_polygons = numbers(polygon_index_bound(m));
  if (at != element_kind::corner) return all;
  list_corners(m, to);
  all.offsets = to.is_volume ? to.corner_offsets : to.polygon_offsets;
  all.corners = to.is_volume ? to.corner_verts : to.polygon_verts;
  return all;
}

/// Everything but what a mesh_look says.
template<EmbeddedMesh M>
inspected_mesh inspect(const M& m) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  inspected_mesh to;
  to.points.assign(vert_index_bound(m), vec3{nan, nan, nan});
  for (const vert_t<M> v : verts(m)) to.points[index_of(m, v)] = to_vec3(point(m, v));
  to.edge_verts.assign(2 * edge_index_bound(m), static_cast<std::uint32_t>(to.points.size()));
  for (const edge_t<M> e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    to.edge_verts[2 * index_of(m, e)] = static_cast<std::uint32_t>(index_of(m, a));
    to.edge_verts[2 * index_of(m, e) + 1] = static_cast<std::uint32_t>(index_of(m, b));
  }
  inspect_polys(m, to);
  triangulate_inspected(to);
  to.centroids.assign(poly_index_bound(m), vec3{nan, nan, nan});
  vec3* const centroids = to.centroids.data();
  parallel_for_each(polys(m), [&m, centroids](const poly_t<M>& p) { centroids[index_of(m, p)] = centroid(m, p); });
  inspect_properties(m, to);
  return to;
}

/// Adds what a mesh_look says. values: of the field or the labels, by index.
template<EmbeddedMesh M, class Look>
inspected_mesh inspect(const M& m, const Look& look, element_kind at, std::vector<double>& values) {
  inspected_mesh to = inspect(m);
  to.crease_angle = look.crease_angle;
  if (at != element_kind::mesh) {
    to.has_field = true;
    to.values.insert(to.values.begin(), {look.labels ? "labels" : "field", at, 1, std::move(values), {}});
  }
  if (look.visible.has_criterion()) to.visible = look.visible.prepare(m).mask;
  if (look.exposed) {
    std::vector<unsigned char> selected;
    look.exposed.fill(m, selected);
    to.exposed.assign(selected.begin(), selected.end());
  }
  if (look.colors) {
    to.colors_at = look.colors.at();
    to.colors = look.colors.read(m, all_elements(m, to, to.colors_at));
  }
  if (look.texture) {
    const element_kind where = look.texture_coordinates.at();
    to.has_texture = true;
    to.values.push_back({"texture coordinates", where, 2, {}, {}});
    for (const auto& t : look.texture_coordinates.read(m, all_elements(m, to, where)))
      to.values.back().numbers.insert(to.values.back().numbers.end(), {t[0], t[1]});
  }
  return to;
}

}  // namespace concino::detail
