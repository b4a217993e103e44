// Adapter for OpenMesh: every polygon and triangle mesh of OpenMesh, whatever its traits, and every class derived from
// one, is a SurfaceMesh. The descriptors are OpenMesh's own handles, and nothing is copied. as_map(mesh, handle) makes
// a map of a property.
//
// Elements that are deleted but not yet collected as garbage are skipped; hidden ones are not, since hiding concerns
// only display. num_verts and its siblings count what is left, in time proportional to all. Polys that touch only at a
// vert are all in the rings of that vert, since OpenMesh links their borders. OpenMesh cannot represent edges of more
// than two polys. Meshes with points in space are editable: all operators of <concino/edit.hpp> work on them. What
// OpenMesh cannot represent is refused with the reason. Properties stay at elements that keep their handles; new ones
// have default values, but a new edge that takes the handle of a removed one also takes its values. No value is
// interpolated, as property_rule says for properties of native meshes: write those of new elements after an edit, which
// returns them. Transactions undo what functions of this library change. Removed elements come back with their handles
// and values. Values that are written in a transaction are not undone, and redo() gives new elements default values. A
// copy of a mesh has no edits that can be undone.
// Needs: OpenMesh (Debian: libopenmesh-dev).
#pragma once

#include <concino/adapters/detail/openmesh_compaction.hpp>
#include <concino/adapters/detail/openmesh_kernel.hpp>
#include <concino/adapters/detail/openmesh_links.hpp>
#include <concino/concepts/editable.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <cassert>
#include <concepts>
#include <span>
#include <type_traits>

namespace concino {

namespace detail {

template<class M> inline constexpr int openmesh_arity = std::derived_from<M, OpenMesh::TriConnectivity> ? 3 : 0;

/// The editing of meshes with points in space.
template<class M>
using openmesh_editing =
    std::conditional_t<(openmesh_coordinates<M> >= 3),
                       halfedge_editing<openmesh_kernel<typename openmesh_point<M>::type>, openmesh_arity<M>>,
                       no_halfedge_editing>;

}  // namespace detail

template<std::derived_from<OpenMesh::PolyConnectivity> M>
struct mesh_traits<M> : halfedge_kernel<OpenMesh::PolyConnectivity, detail::openmesh_links>,
                        detail::openmesh_editing<M> {
  using vert = OpenMesh::VertexHandle;
  using poly = OpenMesh::FaceHandle;
  static constexpr int arity = detail::openmesh_arity<M>;

  // Points may be of any type with x[0], x[1], x[2]; those of the plane have z = 0.
  static decltype(auto) point(const M& m, vert v) requires(detail::openmesh_coordinates<M> >= 3) { return m.point(v); }
  static vec3 point(const M& m, vert v) requires(detail::openmesh_coordinates<M> == 2) {
    return {m.point(v)[0], m.point(v)[1], 0};
  }
  template<class X>
    requires(detail::openmesh_coordinates<M> >= 3)
  static void set_point(M& m, vert v, const X& x) {
    if (auto* const recorder = detail::halfedge_recorder_of<kernel>(m))
      recorder->save_point(static_cast<unsigned>(v.idx()));
    // allocates no memory
    kernel::assign_point(detail::openmesh_property(m.vprops_begin(), m.points_property_handle())[v.idx()], x);
  }

  static poly add_poly(M& m, std::span<const vert> corners) {
    detail::check_openmesh_poly(m, corners, arity);
    if constexpr (detail::openmesh_coordinates<M> >= 3)
      if (detail::halfedge_recorder_of<kernel>(m)) return detail::add_poly_by_rewire(m, corners);
    auto* const before = kernel::find_edits(m);
    kernel::reserve(m, 0, static_cast<unsigned>(corners.size()), 1, false);
    const poly p = m.OpenMesh::PolyConnectivity::add_face(corners.data(), corners.size());
    assert(p.is_valid() && "check_openmesh_poly has refused the polys that OpenMesh refuses");
    detail::count_edit(before);
    return p;
  }
  // OpenMesh deletes by status attributes. If the mesh has none, they are requested, as users of OpenMesh do
  // themselves.
  static void reserve_removal(M& m, std::span<const poly>) {
    detail::openmesh_status::request_of_verts(m);
    detail::openmesh_status::request_of_edges_and_polys(m);
  }
  static void remove_poly(M& m, poly p) {
    // OpenMesh allocates memory while it removes
    if constexpr (detail::openmesh_coordinates<M> >= 3) return detail::remove_poly_by_rewire(m, p);
    detail::openmesh_status::request_of_edges_and_polys(m);
    m.OpenMesh::PolyConnectivity::delete_face(p, false);
  }
  static void remove_vert(M& m, vert v) {
    if constexpr (detail::openmesh_coordinates<M> >= 3) return detail::remove_vert_by_rewire(m, v);
    detail::openmesh_status::request_of_verts(m);
    m.status(v).set_deleted(true);  // as delete_vertex does for a vert without polys, which allocates memory for none
  }

  static correspondence garbage_collect(M& m) {
    if (detail::halfedge_recorder_of<kernel>(m)) detail::refuse_garbage_collection();
    auto* const before = kernel::find_edits(m);
    detail::openmesh_compaction compaction(m);
    compaction.make();
    detail::count_edit(before);
    return compaction.origins();
  }

 private:
  using kernel = detail::openmesh_kernel<typename detail::openmesh_point<M>::type>;
};

/// A property of an OpenMesh mesh as a map. Copies of it are the same map.
template<class Handle, class Property>
class openmesh_map {
  Property* property_;

 public:
  using key_type = Handle;
  using value_type = typename Property::value_type;

  explicit openmesh_map(Property& p) : property_(&p) {}
  decltype(auto) operator[](Handle x) const { return (*property_)[x.idx()]; }
};

namespace requirement {

template<class P>
concept is_openmesh_property = std::same_as<P, OpenMesh::VPropHandleT<typename P::Value>> ||
    std::same_as<P, OpenMesh::EPropHandleT<typename P::Value>> ||
    std::same_as<P, OpenMesh::FPropHandleT<typename P::Value>>;

}  // namespace requirement

/// A property of verts, edges or faces as a map, u = as_map(m, handle): u[v] is the mesh's own value, writable unless m
/// is const. An OpenMesh::PropertyManager is already such a map.
/// Needs:  the property stays in the mesh while the map is used.
/// Result: a map by the handles of verts, edges or faces. Copies of it are the same map.
/// Cost:   none; nothing is copied.
/// Errors: invalid_argument if the handle belongs to no property.
template<std::derived_from<OpenMesh::BaseKernel> M, requirement::is_openmesh_property P>
auto as_map(M& m, const P& handle) {
  if (!handle.is_valid())
    throw invalid_argument("as_map: the property handle is not valid; add the property to the mesh first");
  auto& property = m.property(handle);
  return openmesh_map<typename P::Handle, std::remove_reference_t<decltype(property)>>(property);
}

static_assert(SurfaceMesh<OpenMesh::PolyConnectivity> && TriMesh<OpenMesh::TriConnectivity>);
static_assert(EditableSurfaceMesh<OpenMesh::PolyMesh_ArrayKernelT<>>);
static_assert(TriMesh<OpenMesh::TriMesh_ArrayKernelT<>> && EditableSurfaceMesh<OpenMesh::TriMesh_ArrayKernelT<>>);

}  // namespace concino
