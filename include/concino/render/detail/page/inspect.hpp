// Keeps the elements and properties of a mesh for pages.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/concepts/facets.hpp>
#include <concino/core/parallel.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/geometry/triangulate_polygon.hpp>
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
  if constexpr (ShowsProperties<M>) add_properties(to.values, traits<M>::properties(m));
  return to;
}

/// Adds what a mesh_look says. d: the drawable made of it; values: of the field or the labels, by index.
template<EmbeddedMesh M, class Look>
inspected_mesh inspect(const M& m, const Look& look, const drawable& d, element_kind at, std::vector<double>& values) {
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
  if (!look.colors) return to;
  to.colors_at = look.colors.at() == element_kind::corner ? element_kind::vert : look.colors.at();
  if (look.colors.at() == element_kind::corner) {  // of each vert that is drawn, the colour at one of its corners
    to.colors.assign(to.points.size(), look.color);
    for (std::size_t c = 0; c < d.corners.size(); ++c) to.colors[d.verts[d.corners[c]]] = d.colors[c];
    return to;
  }
  drawable all;  // of all elements by index
  const auto numbers = [](std::size_t n) {
    std::vector<std::uint32_t> list(n);
    for (std::size_t i = 0; i < n; ++i) list[i] = static_cast<std::uint32_t>(i);
    return list;
  };
  all.verts = numbers(to.points.size());
  all.polys = numbers(poly_index_bound(m));
  all.mesh_polygons = numbers(polygon_index_bound(m));
  to.colors = look.colors.read(m, all);
  return to;
}

}  // namespace concino::detail
