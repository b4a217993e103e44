// The links between OpenMesh's half-edges and the indices of its elements, from which mesh_traits are derived.
#pragma once

#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/core/error.hpp>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <OpenMesh/Core/Utils/vector_traits.hh>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace concino::detail {

/// A property of an OpenMesh mesh, without the assertion of m.property(x), which allocates memory.
template<class Iterator, class Handle>
auto& openmesh_property(Iterator all, const Handle& x) {
  return static_cast<OpenMesh::PropertyT<typename Handle::Value>&>(*all[x.idx()]);
}

/// Whether an element of one kind is deleted.
template<class Handle>
class openmesh_is_deleted {
  using mesh = OpenMesh::PolyConnectivity;

  const mesh* m_ = nullptr;
  const OpenMesh::Attributes::StatusInfo* status_ = nullptr;  // null: the mesh has no status attribute for this kind

  static auto all_properties(const mesh& m) {
    if constexpr (std::same_as<Handle, OpenMesh::VertexHandle>) return m.vprops_begin();
    else if constexpr (std::same_as<Handle, OpenMesh::EdgeHandle>) return m.eprops_begin();
    else return m.fprops_begin();
  }

 public:
  openmesh_is_deleted() = default;
  explicit openmesh_is_deleted(const mesh& m) : m_(&m) {
    if (const auto property = m.status_pph(Handle()); property.is_valid())
      status_ = openmesh_property(all_properties(m), property).data();
  }
  bool operator()(unsigned i) const {
    if (status_) return status_[i].deleted();
    // If edges have no status, delete_face deletes an edge by leaving it without faces.
    if constexpr (std::same_as<Handle, OpenMesh::EdgeHandle>) {
      const Handle e(static_cast<int>(i));
      return m_->has_face_status() && m_->is_boundary(m_->halfedge_handle(e, 0)) &&
             m_->is_boundary(m_->halfedge_handle(e, 1));
    }
    return false;
  }
};

/// The elements of one kind that are not deleted, in order of index.
template<class Handle>
struct openmesh_elements : skipping_range<Handle, openmesh_is_deleted<Handle>> {
  openmesh_elements(const OpenMesh::PolyConnectivity& m, std::size_t index_bound)
      : skipping_range<Handle, openmesh_is_deleted<Handle>>{static_cast<unsigned>(index_bound),
                                                            openmesh_is_deleted<Handle>(m)} {}

  bool contains(Handle x) const {
    return x.is_valid() && x.idx() < static_cast<int>(this->bound) && !this->skips(static_cast<unsigned>(x.idx()));
  }
  std::size_t count() const { return num_elements(*this); }
};

/// The links between OpenMesh's half-edges.
struct openmesh_links {
  using mesh = OpenMesh::PolyConnectivity;
  using vert = OpenMesh::VertexHandle;
  using edge = OpenMesh::EdgeHandle;
  using poly = OpenMesh::FaceHandle;
  using halfedge = OpenMesh::HalfedgeHandle;

  static halfedge next(const mesh& m, halfedge h) { return m.next_halfedge_handle(h); }
  static halfedge opposite(const mesh& m, halfedge h) { return m.opposite_halfedge_handle(h); }
  static vert target(const mesh& m, halfedge h) { return m.to_vertex_handle(h); }
  static bool is_border(const mesh& m, halfedge h) { return m.is_boundary(h); }
  static poly poly_of(const mesh& m, halfedge h) { return m.face_handle(h); }
  static edge edge_of(const mesh& m, halfedge h) { return m.edge_handle(h); }
  static bool is_isolated(const mesh& m, vert v) { return m.is_isolated(v); }
  static halfedge halfedge_of(const mesh& m, vert v) { return m.halfedge_handle(v); }
  static halfedge halfedge_of(const mesh& m, edge e) { return m.halfedge_handle(e, 0); }
  static halfedge halfedge_of(const mesh& m, poly p) { return m.halfedge_handle(p); }

  // n_vertices and its siblings count deleted elements too. They are virtual; the qualified name avoids the virtual
  // call.
  static std::size_t vert_index_bound(const mesh& m) { return m.OpenMesh::ArrayKernel::n_vertices(); }
  static std::size_t edge_index_bound(const mesh& m) { return m.OpenMesh::ArrayKernel::n_edges(); }
  static std::size_t poly_index_bound(const mesh& m) { return m.OpenMesh::ArrayKernel::n_faces(); }
  static openmesh_elements<vert> verts(const mesh& m) { return {m, vert_index_bound(m)}; }
  static openmesh_elements<edge> edges(const mesh& m) { return {m, edge_index_bound(m)}; }
  static openmesh_elements<poly> polys(const mesh& m) { return {m, poly_index_bound(m)}; }
  static std::size_t num_verts(const mesh& m) { return verts(m).count(); }
  static std::size_t num_edges(const mesh& m) { return edges(m).count(); }
  static std::size_t num_polys(const mesh& m) { return polys(m).count(); }
  static std::size_t index_of(const mesh&, vert v) { return static_cast<std::size_t>(v.idx()); }
  static std::size_t index_of(const mesh&, edge e) { return static_cast<std::size_t>(e.idx()); }
  static std::size_t index_of(const mesh&, poly p) { return static_cast<std::size_t>(p.idx()); }
  static bool contains(const mesh& m, vert v) { return verts(m).contains(v); }
  static bool contains(const mesh& m, edge e) { return edges(m).contains(e); }
  static bool contains(const mesh& m, poly p) { return polys(m).contains(p); }
};

template<class M> inline constexpr std::size_t openmesh_coordinates = 0;
template<class M>
  requires requires { typename M::Point; }
inline constexpr std::size_t openmesh_coordinates<M> = OpenMesh::vector_traits<typename M::Point>::size_;

/// The type of the points of a mesh, or an unused type if it has none.
template<class M> struct openmesh_point { using type = OpenMesh::Vec3f; };
template<class M>
  requires requires { typename M::Point; }
struct openmesh_point<M> { using type = typename M::Point; };

/// Throws for polys that OpenMesh cannot represent, with the reason, before anything changes. OpenMesh's add_face makes
/// the last three tests too, but prints its messages to the standard error stream.
inline void check_openmesh_poly(const OpenMesh::PolyConnectivity& m, std::span<const OpenMesh::VertexHandle> corners,
                                int arity) {
  using OpenMesh::HalfedgeHandle, OpenMesh::VertexHandle;
  const auto refuse = [&](const std::string& why) {
    core::throw_joined<invalid_mesh>({"add_poly: poly ", m.n_faces(), " ", why});
  };
  const auto name = [](VertexHandle v) { return core::joined({"vert ", v.idx()}); };
  const std::size_t n = corners.size();
  if (n < 3 || (arity != 0 && n != static_cast<std::size_t>(arity)))
    refuse(core::joined({"has ", n, " verts; it needs ", arity != 0 ? std::to_string(arity) : "at least 3"}));
  for (const VertexHandle v : corners)
    if (!openmesh_links::contains(m, v)) refuse(core::joined({"names ", name(v), ", which is not in the mesh"}));
  std::vector<VertexHandle> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end())
    refuse(core::joined({"has ", name(*twice), " twice; its verts must differ"}));

  std::vector<HalfedgeHandle> halfedges;  // those that exist already
  for (std::size_t i = 0; i < n; ++i) {
    const VertexHandle a = corners[i], b = corners[(i + 1) % n];
    if (!m.is_boundary(a))
      refuse(core::joined({"names ", name(a), ", which is not on the boundary; OpenMesh cannot add a poly there"}));
    halfedges.push_back(m.find_halfedge(a, b));
    if (halfedges.back().is_valid() && !m.is_boundary(halfedges.back()))
      refuse(core::joined({"goes from ", name(a), " to ", name(b),
                     " as another poly does; in OpenMesh at most two polys share an edge, in opposite directions"}));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const HalfedgeHandle in = halfedges[i], out = halfedges[(i + 1) % n];
    if (!in.is_valid() || !out.is_valid() || m.next_halfedge_handle(in) == out) continue;
    HalfedgeHandle gap = m.opposite_halfedge_handle(out);
    do gap = m.opposite_halfedge_handle(m.next_halfedge_handle(gap));
    while (!m.is_boundary(gap));
    if (gap == in)
      refuse(core::joined({"closes a fan of polys around ", name(corners[(i + 1) % n]),
                     ", which has polys of another fan too; in OpenMesh a closed fan is the only one at its vert"}));
  }
}

}  // namespace concino::detail

/// Iterators contain all that they need.
template<class Handle>
inline constexpr bool std::ranges::enable_borrowed_range<concino::detail::openmesh_elements<Handle>> = true;
