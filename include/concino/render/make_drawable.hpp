// Drawables of meshes: the visible polygons of any mesh, with their normals, values and colours.
#pragma once

#include <concino/core/error.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/outer_polygons.hpp>
#include <concino/render/detail/colors/drawable_values.hpp>
#include <concino/render/detail/page/inspect.hpp>
#include <concino/render/drawable.hpp>
#include <concino/render/mesh_look.hpp>

#include <algorithm>
#include <memory>
#include <vector>

namespace concino {

namespace detail {

template<SurfaceMesh M>
decltype(auto) edges_of_polygon(const M& m, const poly_t<M>& p) { return adj_p2e(m, p); }
template<VolumeMesh M>
decltype(auto) edges_of_polygon(const M& m, const face_t<M>& f) { return adj_f2e(m, f); }

/// The visible polygons of a mesh, without values. Appends the index of the edge from each corner to the next to
/// `edge_of_corner`, unless it is null.
template<class M, class Visible>
drawable visible_polygons(const M& m, const Visible& visible, std::vector<std::uint32_t>* edge_of_corner) {
  constexpr std::uint32_t unseen = ~std::uint32_t{0};
  drawable d;
  bool exposed = false;
  std::vector<std::uint32_t> point_of(vert_index_bound(m), unseen);
  for_each_visible_polygon(
      m, visible, [&](const poly_t<M>& p, const auto& ring, bool is_outward, bool is_exposed, const auto& x) {
        for (const vert_t<M> v : ring) {
          std::uint32_t& at = point_of[index_of(m, v)];
          if (at == unseen) {
            at = static_cast<std::uint32_t>(d.points.size());
            d.points.push_back(to_vec3(point(m, v)));
            d.verts.push_back(static_cast<std::uint32_t>(index_of(m, v)));
            if (!is_finite(d.points.back()))
              core::throw_joined<invalid_mesh>(
                  {"make_drawable: vert ", index_of(m, v), " has a coordinate that is not a finite number"});
          }
          d.corners.push_back(at);
        }
        const auto first = static_cast<std::ptrdiff_t>(d.offsets.back());
        if (edge_of_corner)
          for (const edge_t<M> e : edges_of_polygon(m, x))
            edge_of_corner->push_back(static_cast<std::uint32_t>(index_of(m, e)));
        if (!is_outward) {
          std::reverse(d.corners.begin() + first, d.corners.end());
          if (edge_of_corner) {
            std::reverse(edge_of_corner->begin() + first, edge_of_corner->end());
            std::rotate(edge_of_corner->begin() + first, edge_of_corner->begin() + first + 1, edge_of_corner->end());
          }
        }
        d.offsets.push_back(static_cast<std::uint32_t>(d.corners.size()));
        d.polys.push_back(static_cast<std::uint32_t>(index_of(m, p)));
        d.mesh_polygons.push_back(static_cast<std::uint32_t>(index_of(m, x)));
        d.exposed.push_back(is_exposed);
        exposed = exposed || is_exposed;
      });
  if (!exposed) d.exposed = {};
  return d;
}

/// The polys that meet a criterion, as a map.
template<class Prepared>
struct accepted_polys {
  Prepared meets;
  bool operator[](const auto& p) const { return meets(p); }
};
template<class Prepared> accepted_polys(Prepared) -> accepted_polys<Prepared>;

}  // namespace detail

/// The drawable of a mesh: its visible polygons, that is the polys of a surface, or the faces of a volume that have
/// exactly one visible poly.
/// Needs:  EmbeddedMesh M; look.field and look.labels of this mesh. Values need not be finite.
/// Result: polygons oriented outward, with their appearance as `look` says; change it as you like.
/// Cost:   O(polys), and O(faces) of a volume, more if many polygons meet at a vert; that of look.visible and of
///         reading the field.
/// Errors: invalid_mesh if a visible vert has a coordinate that is not finite; invalid_argument if an option is out of
///         its range, or a map belongs to another mesh; those of look.visible.
template<EmbeddedMesh M>
drawable make_drawable(const M& m, const mesh_look<M>& look = {}) {
  detail::check_look(look.opacity, look.shine, look.crease_angle, look.edge_width, look.isobands, look.isolines,
                     look.labels.at());
  if (look.texture && !look.texture_coordinates)
    throw invalid_argument("make_drawable: a texture needs texture_coordinates");
  std::vector<double> values;
  if (look.labels) look.labels.fill(m, values);
  else if (look.field) look.field.fill(m, values);
  const element_kind at = look.labels ? look.labels.at() : look.field.at();
  std::vector<std::uint32_t> edge_of_corner;
  drawable d = detail::visible_polygons(m, detail::accepted_polys{look.visible.prepare(m)},
                                        at == element_kind::edge ? &edge_of_corner : nullptr);
  if (look.exposed) {
    std::vector<unsigned char> selected;
    look.exposed.fill(m, selected);
    detail::expose(d, selected);
  }
  detail::finish_drawable(d, look.crease_angle);
  d.look.color = look.color;
  d.look.exposed_color = look.exposed_color;
  d.look.map = look.map;
  d.look.labels = static_cast<bool>(look.labels);
  d.look.isobands = look.isobands;
  d.look.isolines = look.isolines;
  d.look.edge_width = look.edges || at == element_kind::edge ? look.edge_width : 0;
  d.look.edge_color = look.edge_color;
  d.look.opacity = look.opacity;
  d.look.shine = look.shine;
  d.look.material = look.material;
  d.look.texture = look.texture;
  if (look.colors) {
    d.colors = look.colors.read(m, d);
    d.colors_at = look.colors.at() == element_kind::vert     ? value_place::points
                  : look.colors.at() == element_kind::corner ? value_place::corners
                                                             : value_place::polygons;
  }
  if (look.texture_coordinates)
    d.texture_coordinates =
        detail::texture_points_of_corners(d, look.texture_coordinates.at(), look.texture_coordinates.read(m, d));
  if (at != element_kind::mesh) detail::take_values(d, at, values, edge_of_corner, look.scale);
  d.name = look.name;
  if (look.inspect) d.inspected = std::make_shared<const inspected_mesh>(detail::inspect(m, look, at, values));
  return d;
}

// What to write instead of calls that cannot compile.
template<class... T> void make_drawable(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void make_drawable(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)

}  // namespace concino
