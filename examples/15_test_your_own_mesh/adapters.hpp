// Adapters for three mesh types that do not know concino: winged edges, half-faces and a corner table. No type is changed, and each adapter has less than
// 30 lines.
#pragma once

#include "corner_table.hpp"
#include "half_faces.hpp"
#include "winged_edge.hpp"

//! [winged edges]
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/concepts/mesh.hpp>

struct winged_links {  // a half-edge is an edge with a direction: from start to end, or back
  using vert = concino::vert_id;
  using edge = concino::edge_id;
  using poly = concino::poly_id;
  struct halfedge { int e; bool back; bool operator==(const halfedge&) const = default; };
  using M = wings::Mesh;

  static vert target(const M& m, halfedge h) { return vert{h.back ? m.edge(h.e).start : m.edge(h.e).end}; }
  static halfedge opposite(const M&, halfedge h) { return {h.e, !h.back}; }
  static halfedge next(const M& m, halfedge h) { return from(m, h.back ? m.edge(h.e).right_next : m.edge(h.e).left_next, target(m, h)); }
  static halfedge from(const M& m, int e, vert v) { return {e, vert{m.edge(e).start} != v}; }
  static bool is_border(const M& m, halfedge h) { return (h.back ? m.edge(h.e).right : m.edge(h.e).left) < 0; }
  static poly poly_of(const M& m, halfedge h) { return poly{h.back ? m.edge(h.e).right : m.edge(h.e).left}; }
  static edge edge_of(const M&, halfedge h) { return edge{h.e}; }
  static bool is_isolated(const M& m, vert v) { return m.edgeAtVertex(static_cast<int>(v.raw())) < 0; }
  static halfedge halfedge_of(const M& m, vert v) { return from(m, m.edgeAtVertex(static_cast<int>(v.raw())), v); }
  static halfedge halfedge_of(const M&, edge e) { return {static_cast<int>(e.raw()), false}; }
  static halfedge halfedge_of(const M& m, poly p) { const int f = static_cast<int>(p.raw()), e = m.edgeAtFace(f); return {e, m.edge(e).left != f}; }
  static std::size_t num_verts(const M& m) { return static_cast<std::size_t>(m.vertices()); }
  static std::size_t num_edges(const M& m) { return static_cast<std::size_t>(m.edges()); }
  static std::size_t num_polys(const M& m) { return static_cast<std::size_t>(m.faces()); }
  static const double* point(const M& m, vert v) { return m.coordinates(static_cast<int>(v.raw())); }
};
template<> struct concino::mesh_traits<wings::Mesh> : concino::halfedge_kernel<wings::Mesh, winged_links> {};
//! [winged edges]

//! [half-faces]
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/arrays.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/polyhedra_tables.hpp>

struct indexed_volume_of {  // a pointer to the mesh, and the adjacencies that it does not store
  const hfm::PolyhedralMesh* mesh;
  concino::polyhedra_tables tables;
  explicit indexed_volume_of(const hfm::PolyhedralMesh& m) : mesh(&m) {
    concino::polyhedra_arrays a{{}, {0}, {}, {0}, {}, {}};
    for (const auto& face : m.faces()) {
      for (const hfm::VertexHandle v : face) a.face_verts.emplace_back(v.idx);
      a.face_offsets.push_back(static_cast<std::uint32_t>(a.face_verts.size()));
    }
    for (const auto& cell : m.cells()) {
      for (const hfm::HalfFaceHandle h : cell) a.poly_faces.emplace_back(h.face().idx), a.outward.push_back(!h.isOpposite());
      a.poly_offsets.push_back(static_cast<std::uint32_t>(a.poly_faces.size()));
    }
    tables = {m.points().size(), a.face_offsets, a.face_verts, a.poly_offsets, a.poly_faces, a.outward};
  }
};
template<> struct concino::mesh_traits<indexed_volume_of> : concino::indexed_volume<indexed_volume_of> {
  static const auto& tables(const indexed_volume_of& m) { return m.tables; }
  static const auto& point(const indexed_volume_of& m, vert_id v) { return m.mesh->points()[v.raw()]; }
};
//! [half-faces]

//! [corner table]
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/surface_tables.hpp>

#include <vector>

struct indexed_corners {
  const CornerTable* mesh;
  concino::surface_tables<3> tables;
  explicit indexed_corners(const CornerTable& m) : mesh(&m), tables(m.G.size() / 3, std::vector<concino::vert_id>(m.V.begin(), m.V.end())) {}
};
template<> struct concino::mesh_traits<indexed_corners> : concino::indexed_surface<indexed_corners> {
  static constexpr int arity = 3;
  static const auto& tables(const indexed_corners& m) { return m.tables; }
  static const float* point(const indexed_corners& m, vert_id v) { return &m.mesh->G[3 * v.raw()]; }
};
//! [corner table]
