// Slicing: the polys that meet a criterion, and the facets that bound them.
#pragma once

#include <concino/core/collect.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/geometry/outer_polygons.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/render/peeled.hpp>
#include <concino/render/poly_criterion.hpp>
#include <concino/render/position_criteria.hpp>
#include <concino/render/value_criteria.hpp>

namespace concino {

namespace mistake {

inline constexpr sentence give_criterion(
    "needs a criterion for the polys of this mesh: below('x', 0.3) needs points, labeled(map, {1}) whole numbers at polys, at_most(map, 1) numbers at polys, where(f) a bool f(p)");

inline constexpr sentence use_visible_facets(
    "surfaces have no faces: write visible_facets(m, criterion), which are edges of a surface");

}  // namespace mistake

/// The polys that meet a criterion: visible_polys(m, below('x', 0.3) && !labeled(material, {2})).
/// Needs:  AnyMesh, no temporary; a criterion for it.
/// Result: a map that is true at these polys.
/// Cost:   that of the criterion for each poly, in parallel.
/// Errors: those of the criterion.
template<class M, class C>
  requires requirement::is_lvalue_or_view<M> && CriterionOn<C, M>
poly_map<M, bool> visible_polys(M&& m, const C& criterion) {
  poly_map<M, bool> visible(m, poly_index_bound(m), false);
  detail::evaluate_criterion(std::as_const(m), criterion, visible.data());
  return visible;
}

namespace detail {

/// only_exposed: those that have hidden polys, too.
template<class M, class C>
std::vector<facet_t<M>> visible_facets(const M& m, const C& criterion, bool only_exposed) {
  std::vector<unsigned char> mask(poly_index_bound(m));
  evaluate_criterion(m, criterion, mask.data());
  return core::collect_if(facets(m), [&m, &mask, only_exposed](const facet_t<M>& x) {
    const single_visible_poly<M> found(adj_facet2p(m, x),
                                       [&](const poly_t<M>& p) { return mask[index_of(m, p)] != 0; });
    return found.is_single && (found.has_hidden || !only_exposed);
  });
}

}  // namespace detail

/// The facets with exactly one poly that meets the criterion: they bound the visible part.
/// Needs:  AnyMesh; a criterion for it.
/// Result: edges of a surface or faces of a volume, in the order of the mesh.
/// Cost:   O(polys and facets), and that of the criterion; in parallel.
/// Errors: those of the criterion.
template<AnyMesh M, CriterionOn<M> C>
std::vector<facet_t<M>> visible_facets(const M& m, const C& criterion) {
  return detail::visible_facets(m, criterion, false);
}
template<VolumeMesh M, CriterionOn<M> C>
std::vector<face_t<M>> visible_faces(const M& m, const C& criterion) {
  return detail::visible_facets(m, criterion, false);
}

/// The visible facets that are laid bare: they have a poly that does not meet the criterion, and so are inside the
/// mesh.
/// Needs:  AnyMesh; a criterion for it.
/// Result: a part of visible_facets, in the order of the mesh; the others are on the boundary.
/// Cost:   as above.
/// Errors: those of the criterion.
template<AnyMesh M, CriterionOn<M> C>
std::vector<facet_t<M>> exposed_facets(const M& m, const C& criterion) {
  return detail::visible_facets(m, criterion, true);
}

// What to write instead of calls that cannot compile.
template<class... T> void visible_polys(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void visible_polys(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void visible_facets(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void visible_faces(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class... T> void exposed_facets(mistake::no_mesh<mistake::adapt_the_mesh>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter; incomplete mesh_traits: explain_any_mesh<M>() or explain_primal_graph<M>()
template<class M, class C, class R = mistake::remedy<mistake::give_criterion>>
  requires(AnyMesh<M> && requirement::is_lvalue_or_view<M> && !CriterionOn<C, M>)
void visible_polys(M&&, const C&, ...) = delete;  // a criterion for the polys of this mesh: below() needs points, the map of labeled() whole numbers at polys
template<class M, class C, class R = mistake::remedy<mistake::give_criterion>>
  requires(AnyMesh<M> && !CriterionOn<C, M>)
void visible_facets(const M&, const C&, ...) = delete;  // a criterion for the polys of this mesh: below() needs points, the map of labeled() whole numbers at polys
template<class M, class C, class R = mistake::remedy<mistake::give_criterion>>
  requires(AnyMesh<M> && !CriterionOn<C, M>)
void visible_faces(const M&, const C&, ...) = delete;  // a criterion for the polys of this mesh: below() needs points, the map of labeled() whole numbers at polys
template<class M, class C, class R = mistake::remedy<mistake::use_visible_facets>>
  requires(SurfaceMesh<M> && CriterionOn<C, M>)
void visible_faces(const M&, const C&, ...) = delete;  // surfaces have no faces: visible_facets(m, criterion)
template<class M, class C, class R = mistake::remedy<mistake::give_criterion>>
  requires(AnyMesh<M> && !CriterionOn<C, M>)
void exposed_facets(const M&, const C&, ...) = delete;  // a criterion for the polys of this mesh: below() needs points, the map of labeled() whole numbers at polys

}  // namespace concino
