// embed_isolines and embed_isosurface: level sets become edges or faces of a mesh.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/core/number_text.hpp>
#include <concino/level_sets/detail/cut/level_states.hpp>
#include <concino/level_sets/detail/embed/add_edge_between.hpp>
#include <concino/level_sets/detail/embed/add_face_with.hpp>
#include <concino/level_sets/detail/embed/level_embedder.hpp>
#include <concino/mesh/element_map.hpp>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace concino {

struct embed_options {
  double snap = 0;  // where the level set crosses an edge nearer to a vert than this fraction, the value there is
                    // changed; below 0.5
};

/// Level sets of a surface of type M, as edges of it.
template<class M>
struct embedded_lines {
  std::vector<edge_t<M>> edges;        // those on the level set
  std::vector<vert_t<M>> verts;        // new ones
  std::vector<vert_t<M>> snapped;      // those at which the function now has the value
  std::vector<vert_t<M>> moved_verts;  // verts that stay on the other side; see clip_report
};

/// Level sets of a volume of type M, as faces of it.
template<class M>
struct embedded_surface {
  std::vector<face_t<M>> faces;        // those on the level set
  std::vector<vert_t<M>> verts;        // new ones
  std::vector<vert_t<M>> snapped;      // those at which the function now has the value
  std::vector<vert_t<M>> moved_verts;  // verts that stay on the other side; see clip_report
};

namespace requirement {

/// Meshes that can have the parts of their polys: of general polys, of triangles or of tets.
template<class M> concept has_room_for_parts = arity_v<M> == 0 || arity_v<M> == dimension_v<M> + 1;

/// Maps of numbers at the verts of M that can be written.
template<class U, class M>
concept is_writable_number_map =
    !std::convertible_to<U, std::string_view> && gives_numbers<U, vert_t<M>> && WritableMap<U, vert_t<M>, double>;

/// Neither such a map nor the name of a property.
template<class U, class M>
concept is_no_writable_number_map = !std::convertible_to<U, std::string_view> && !is_writable_number_map<U, M>;

}  // namespace requirement

namespace detail {

inline void check_snap(double snap, const char* caller) {
  if (!(snap >= 0 && snap < 0.5))
    core::throw_joined<invalid_argument>(
        {caller, ": .snap is ", core::number_text(snap), "; it must be at least 0 and below 0.5"});
}

/// The edge or the face with these verts.
template<class M>
void add_element(const M& m, const std::vector<vert_t<M>>& corners, std::vector<edge_t<M>>& to) {
  add_edge_between(m, corners[0], corners[1], to);
}
template<class M>
void add_element(const M& m, const std::vector<vert_t<M>>& corners, std::vector<face_t<M>>& to) {
  add_face_with(m, corners, to);
}

/// Replaces polys of m by their parts. u: its values; they become `level` at snapped verts. cut: the edges or faces on
/// the level set.
template<class M, class U, class Crossed, class Parts, class Result, class Elements, class OriginsOf>
void embed_parts(M& m, U& u, double level, const Crossed& crossed, const Parts& parts, Result& result, Elements& cut,
                 const OriginsOf& origins_of, const char* caller) {
  for (const std::uint32_t v : parts.moved_verts) result.moved_verts.push_back(crossed.verts[v]);
  const embedding_lists lists = list_embedding(parts, crossed.arrays, arity_v<M> != 0);
  level_embedder<M, Crossed> embedder(m, crossed, level, lists, parts.places, origins_of);
  cut.reserve(lists.cut_ends.size());
  embedder.run(m, u, result.snapped, caller);
  embedder.for_each_cut([&](const std::vector<vert_t<M>>& corners) { add_element(m, corners, cut); });
  result.verts = std::move(embedder.new_verts);
}

/// The values of u, and `level` at verts that are snapped.
template<class M, class U>
vert_map<M, double> snapped_values(const M& m, const U& u, double level, const std::vector<vert_t<M>>& snapped) {
  auto values = make_vert_map<double>(m);
  for (const vert_t<M> v : verts(m)) values[v] = static_cast<double>(u[v]);
  for (const vert_t<M>& v : snapped) values[v] = level;
  return values;
}

/// u: the property or the map.
template<class M, class U>
embedded_lines<M> embed_lines(M& m, U& u, double value, const embed_options& options) {
  constexpr const char* caller = "embed_isolines";
  sort_levels({value}, caller);
  check_vert_values(m, u, caller);
  embedded_lines<M> result;
  result.snapped = verts_to_snap(m, u, value, options.snap);
  const auto values = snapped_values(m, u, value, result.snapped);
  const crossed_surface_reader<M> crossed(m, values, value, crossed_polys(m, level_states(m, values, value, caller)));
  poly_cuts cuts(crossed.arrays, value);
  const poly_parts parts(cuts);
  embed_parts(
      m, u, value, crossed, parts, result, result.edges,
      [&](const level_place& x) { return crossed.origins_of(x, value); }, caller);
  return result;
}
template<class M, class U>
embedded_surface<M> embed_surface(M& m, U& u, double value, const embed_options& options) {
  constexpr const char* caller = "embed_isosurface";
  sort_levels({value}, caller);
  check_vert_values(m, u, caller);
  embedded_surface<M> result;
  result.snapped = verts_to_snap(m, u, value, options.snap);
  const auto values = snapped_values(m, u, value, result.snapped);
  const crossed_volume_reader<M> crossed(m, values, value, crossed_polys(m, level_states(m, values, value, caller)));
  constexpr auto surface = arity_v<M> == 0 ? cell_cuts::cells_are::unknown : cell_cuts::cells_are::spheres;
  cell_cuts cuts(crossed.arrays, surface, caller, crossed.poly_indices);
  const cell_parts parts(cuts);
  embed_parts(
      m, u, value, crossed, parts, result, result.faces, [&](const level_place& x) { return crossed.origins_of(x); },
      caller);
  return result;
}

}  // namespace detail

/// Makes the level set {u = value} of a property of verts edges of the surface.
/// Needs:  EditableSurfaceMesh M of general polygons or of triangles, with named properties; the property `name` of
///         verts, of type double.
/// Result: the edges of the level set, as isolines finds it. Polygons are cut to polygons, triangles to triangles. One
///         part of each poly keeps its descriptor, and elements that are not cut keep theirs. Named properties follow
///         as in replace_polys; u is `value` at all new verts. With {.snap = f} no edge is cut nearer to a vert than
///         the fraction f of it: u is set to the value there.
/// Cost:   O(elements of m), and O(n log n) for n polys that are cut.
/// Errors: invalid_argument if there is no such property, a value is NaN, naming the vert, or options.snap is not in
///         [0, 0.5); unsupported if the library of m cannot represent the result. The mesh is unchanged then, also if
///         memory runs out. In an open transaction it can be undone.
/// Source: paper section 2.2, "Fields".
template<EditableSurfaceMesh M>
  requires HasProperties<M> && requirement::has_room_for_parts<M>
embedded_lines<M> embed_isolines(M& m, std::string_view name, double value, const embed_options& options = {}) {
  detail::check_snap(options.snap, "embed_isolines");
  auto u = detail::level_property(m, name, "embed_isolines");
  return detail::embed_lines(m, u, value, options);
}

/// Makes the level set {u = value} of a map at verts edges of the surface.
/// Needs:  EditableSurfaceMesh M of general polygons or of triangles; u a map of numbers at verts that can be written
///         and follows the verts: vert_map, or a property of OpenMesh or CGAL. If u has a member resize(n), it is
///         called before the edit, with the index bound of the verts afterwards.
/// Result: as above; u is `value` at all new verts, and at those that are snapped.      Cost: as above.
/// Errors: as above, and invalid_argument if u is a map of another mesh. An undone transaction does not restore u at
///         verts that were snapped.
template<EditableSurfaceMesh M, class U>
  requires requirement::has_room_for_parts<M> && requirement::is_writable_number_map<U, M>
embedded_lines<M> embed_isolines(M& m, U&& u, double value, const embed_options& options = {}) {
  detail::check_snap(options.snap, "embed_isolines");
  return detail::embed_lines(m, u, value, options);
}

/// Makes the level set {u = value} of a property of verts faces of the volume.
/// Needs:  EditableVolumeMesh M of general polyhedra or of tets, with named properties; the property `name` of verts,
///         of type double.
/// Result: as embed_isolines: the faces of the level set, as isosurface finds it. Polyhedra are cut to polyhedra. Tets
///         are cut to tets that agree at common faces. Faces of polyhedra on the boundary that are cut but not planar
///         become triangles, as in clip; u is its mean at their middles.
/// Cost:   as embed_isolines.
/// Errors: as embed_isolines, and unsupported that names a poly that is to be cut, but whose faces do not form a
///         sphere.
/// Source: paper section 2.2, "Fields"; tets of parts by their smallest verts: Dompierre, Labbe, Vallet, Camarero 1999.
template<EditableVolumeMesh M>
  requires HasProperties<M> && requirement::has_room_for_parts<M>
embedded_surface<M> embed_isosurface(M& m, std::string_view name, double value, const embed_options& options = {}) {
  detail::check_snap(options.snap, "embed_isosurface");
  auto u = detail::level_property(m, name, "embed_isosurface");
  return detail::embed_surface(m, u, value, options);
}

/// Makes the level set {u = value} of a map at verts faces of the volume.
/// Needs:  EditableVolumeMesh M of general polyhedra or of tets; u as in embed_isolines.
/// Result: as above; u is `value` at new verts on edges, and at those that are snapped.      Cost: as above.
/// Errors: as above, and invalid_argument if u is a map of another mesh. An undone transaction does not restore u at
///         verts that were snapped.
template<EditableVolumeMesh M, class U>
  requires requirement::has_room_for_parts<M> && requirement::is_writable_number_map<U, M>
embedded_surface<M> embed_isosurface(M& m, U&& u, double value, const embed_options& options = {}) {
  detail::check_snap(options.snap, "embed_isosurface");
  return detail::embed_surface(m, u, value, options);
}

// What to write instead of calls that cannot compile.
template<class... T> void embed_isolines(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void embed_isosurface(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<EditableSurfaceMesh M, class R = mistake::remedy<mistake::use_general_polys>>
  requires(!requirement::has_room_for_parts<M>)
void embed_isolines(M&, ...) = delete;  // convert<polygonmesh>(m) has room for the parts of quads
template<EditableVolumeMesh M, class R = mistake::remedy<mistake::use_general_polys>>
  requires(!requirement::has_room_for_parts<M>)
void embed_isosurface(M&, ...) = delete;  // convert<polyhedralmesh>(m) has room for the parts of hexes
template<EditableSurfaceMesh M, class U, class R = mistake::remedy<mistake::give_writable_numbers_at_verts>>
  requires(requirement::has_room_for_parts<M> && requirement::is_no_writable_number_map<U, M>)
void embed_isolines(M&, U&&, ...) = delete;  // the name of a property, or a map that is not const: make_vert_map<double>(m)
template<EditableVolumeMesh M, class U, class R = mistake::remedy<mistake::give_writable_numbers_at_verts>>
  requires(requirement::has_room_for_parts<M> && requirement::is_no_writable_number_map<U, M>)
void embed_isosurface(M&, U&&, ...) = delete;  // the name of a property, or a map that is not const: make_vert_map<double>(m)

}  // namespace concino
