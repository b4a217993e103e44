// isosurface: the surface in a volume where a function of its verts has a value, as a mesh.
#pragma once

#include <concino/core/mistakes.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/surfaces/level_surface_builder.hpp>
#include <concino/mesh/correspondence.hpp>
#include <concino/mesh/polygonmesh.hpp>
#include <concino/mesh/property.hpp>
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

namespace requirement {

template<class To> concept is_level_surface_mesh = std::same_as<To, polygonmesh> || std::same_as<To, trimesh>;

}  // namespace requirement

namespace detail {

struct choose_every_poly {
  bool operator()(const auto&) const { return true; }
};

/// The polygons in the polys for which is_chosen(p).
template<class To, class M, class U, class V, class IsChosen = choose_every_poly>
level_surface<M, To> find_isosurface(const M& m, const U& u, const V& values, const char* caller,
                                     const IsChosen& is_chosen = {}) {
  check_vert_values(m, u, caller);
  bool has_properties = false;
  if constexpr (ShowsProperties<M>) has_properties = traits<M>::properties(m).size() > 0;
  level_surface_builder<M> builder(m, arity_v<To> == 3, has_properties);
  for (const double level : sorted_levels(values, caller)) builder.add(u, level, caller, is_chosen);
  level_surface<M, To> result{{}, std::move(builder.places), std::move(builder.polys), std::move(builder.values)};
  correspondence from;
  from.verts = std::move(builder.origins);
  result.mesh = To(std::move(builder).arrays());
  if constexpr (ShowsProperties<M>) {
    if (!has_properties) return result;
    for (const poly_t<M>& p : result.polys) from.polys.add(static_cast<std::uint32_t>(index_of(m, p)));
    traits<To>::properties(result.mesh).transfer_verts_and_polys(traits<M>::properties(m), from);
  }
  return result;
}

}  // namespace detail

/// The level sets {u = value} of a function that is linear on edges: surfaces through the polys of a volume.
/// Needs:  Embedded VolumeMesh with polys whose faces form spheres; u[v] is a number for each vert, readable from
///         several threads; one value or several.
/// Result: a polygonmesh, or as isosurface<trimesh> its triangulation, value after value, ascending, and by the polys
///         of m. Its polys are counter-clockwise seen from larger values. It is a manifold: each edge has two polys or
///         lies on the boundary of m. Verts with u = value count as above it. The surface bounds {u < value}; where
///         this only touches the boundary of m, or parts of polys without larger values, there is none. Each poly is
///         cut along closed cycles of chords across its faces, and each cycle is filled by one polygon. Chords are
///         straight in convex faces; other faces are crossed triangle by triangle of triangulate_polygon, and faces on
///         the boundary that are not planar triangle by triangle about the mean of their points. Named properties of
///         verts are interpolated, those of polys inherited. Points do not depend on the order of adj_e2v. Infinite
///         values are limits of finite ones.
/// Cost:   O(verts + polys) a value, and O(n log n) for n polys that are cut. The polys that are cut are found in
///         parallel, with the same result for any number of threads.
/// Errors: invalid_argument if a value is NaN, naming the vert, or if u is a map of another mesh. unsupported that
///         names a poly that is to be cut, but whose faces do not form a sphere.
/// Source: on tets marching tetrahedra, Doi and Koide 1991, as the rule above is there.
template<class To = polygonmesh, VolumeMesh M, class U, class V = std::initializer_list<double>>
  requires Embedded<M> && requirement::gives_numbers<U, vert_t<M>> && requirement::is_value_list<V> &&
      requirement::is_level_surface_mesh<To>
          level_surface<M, To> isosurface(const M& m, const U& u, const V& values) {
    return detail::find_isosurface<To>(m, u, values, "isosurface");
  }

// What to write instead of calls that cannot compile.
template<class... T> void isosurface(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void isosurface(mistake::no_points<mistake::give_points>, ...) = delete;  // needs Embedded: mesh_traits<M>::point(m, v), or with_points(m, map)
template<class M, class U, class R = mistake::remedy<mistake::give_numbers_at_verts>>
  requires(VolumeMesh<M> && Embedded<M> && !requirement::gives_numbers<U, vert_t<M>>)
void isosurface(M&&, const U&, ...) = delete;  // a number at each vert: make_vert_map<double>(m)

}  // namespace concino
