// isosurface: the surface in a volume where a function of its verts has a value, as a mesh.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/level_sets/detail/level_surface_maker.hpp>
#include <concino/level_sets/detail/level_values.hpp>
#include <concino/level_sets/detail/simple_surface.hpp>
#include <concino/level_sets/detail/surface_builder.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <concepts>
#include <initializer_list>
#include <utility>
#include <vector>

namespace concino {

/// Level sets of a volume of type M, as a surface mesh. Its elements are numbered from 0.
template<class M, class To = polygonmesh>
struct level_surface {
  To mesh;
  std::vector<mesh_point<M>> places;  // by vert of mesh: at a vert, on an edge, or inside a face
  std::vector<poly_t<M>> polys;       // by poly of mesh: the poly of the volume that it cuts, or that is below it
  std::vector<double> values;         // by poly of mesh: the value of its level set

  const mesh_point<M>& place_of(vert_t<To> v) const { return places[index_of(mesh, v)]; }
  const poly_t<M>& poly_of(poly_t<To> p) const { return polys[index_of(mesh, p)]; }
  double value_of(poly_t<To> p) const { return values[index_of(mesh, p)]; }
};

template<class To = polygonmesh, VolumeMesh M, class U, class V = std::initializer_list<double>>
  requires Embedded<M> && requirement::gives_numbers<U, vert_t<M>> && requirement::is_value_list<V> && (std::same_as<To, polygonmesh> || std::same_as<To, trimesh>)
level_surface<M, To> isosurface(const M& m, const U& u, const V& values) {
  detail::check_vert_values(m, u, "isosurface");
  const std::vector<double> levels = detail::sorted_levels(values, "isosurface");
  const auto make = [&](bool simple_ones) {
    level_surface<M, To> result;
    detail::surface_builder builder(arity_v<To> == 3);
    for (const double level : levels) {
      const detail::level_surface_maker<M, U> maker(m, u, level, "isosurface");
      detail::level_surface_parts<M> parts;
      if (!simple_ones || !maker.make_simple(parts)) parts = maker.make_general();
      for (const mesh_point<M>& x : parts.places) builder.add_point(x.position);
      for (std::size_t i = 0; i < parts.ends.size(); ++i) {
        const std::size_t first = i == 0 ? 0 : parts.ends[i - 1];
        const std::size_t n = builder.add_polygon({parts.verts.data() + first, parts.ends[i] - first});
        result.polys.insert(result.polys.end(), n, parts.polys[i]);
        result.values.insert(result.values.end(), n, level);
      }
      builder.end_part();
      if (result.places.empty()) result.places = std::move(parts.places);
      else result.places.insert(result.places.end(), parts.places.begin(), parts.places.end());
    }
    result.mesh = To(std::move(builder).arrays());
    return result;
  };
  level_surface<M, To> result = make(true);
  return detail::is_simple_surface(result.mesh) ? std::move(result) : make(false);
}

}  // namespace concino
