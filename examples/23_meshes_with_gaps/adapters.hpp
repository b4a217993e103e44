// The adapters of the page docs/adapt-advanced.md for three meshes: half-edges with deleted elements and holes, a corner table without border half-edges,
// and hexes in lexicographic order.
#pragma once

#include "../15_test_your_own_mesh/corner_table.hpp"
#include "student.hpp"

//! [half-edges]
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/concepts/mesh.hpp>

#include <array>

struct student_links {  // every element is an index; deleted elements leave gaps
  using vert = concino::vert_id;
  using edge = concino::edge_id;
  using poly = concino::poly_id;
  using halfedge = unsigned;
  using M = student::Mesh;

  static unsigned next(const M& m, unsigned h) { return m.halfedges[h].next; }
  static unsigned opposite(const M& m, unsigned h) { return m.twin(h); }
  static vert target(const M& m, unsigned h) { return vert{m.target(h)}; }
  static bool is_border(const M& m, unsigned h) { return m.halfedges[h].face == student::none; }
  static poly poly_of(const M& m, unsigned h) { return poly{m.halfedges[h].face}; }
  static edge edge_of(const M&, unsigned h) { return edge{h / 2}; }
  static bool is_isolated(const M& m, vert v) { return m.vertices[v.raw()].halfedge == student::none; }
  static unsigned halfedge_of(const M& m, vert v) { return m.vertices[v.raw()].halfedge; }
  static unsigned halfedge_of(const M&, edge e) { return 2 * e.raw(); }
  static unsigned halfedge_of(const M& m, poly p) { return m.faces[p.raw()].halfedge; }

  static auto verts(const M& m) { return concino::ids_where<vert>(m.vertices.size(), [&m](auto i) { return !m.vertices[i].deleted; }); }
  static auto edges(const M& m) { return concino::ids_where<edge>(m.halfedges.size() / 2, [&m](auto i) { return !m.halfedges[2 * i].deleted; }); }
  static auto polys(const M& m) { return concino::ids_where<poly>(m.faces.size(), [&m](auto i) { return !m.faces[i].deleted; }); }
  static std::size_t num_verts(const M& m) { return m.vertices.size() - m.deletedVertices; }  // without the deleted ones
  static std::size_t num_edges(const M& m) { return m.halfedges.size() / 2 - m.deletedEdges; }
  static std::size_t num_polys(const M& m) { return m.faces.size() - m.deletedFaces; }
  static std::size_t vert_index_bound(const M& m) { return m.vertices.size(); }               // one more than the largest index
  static std::size_t edge_index_bound(const M& m) { return m.halfedges.size() / 2; }
  static std::size_t poly_index_bound(const M& m) { return m.faces.size(); }

  static auto point(const M& m, vert v) { return std::array{m.vertices[v.raw()].x, m.vertices[v.raw()].y, m.vertices[v.raw()].z}; }
  static void set_point(M& m, vert v, const auto& x) { m.vertices[v.raw()].x = x[0], m.vertices[v.raw()].y = x[1], m.vertices[v.raw()].z = x[2]; }
};
template<> struct concino::mesh_traits<student::Mesh> : concino::halfedge_kernel<student::Mesh, student_links> {};
//! [half-edges]

//! [corners]
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/concepts/mesh.hpp>

#include <algorithm>
#include <vector>

struct corners {  // the table, and what it does not store: a corner of each vert, the number of edges
  const CornerTable* table;
  std::vector<unsigned> at_vert;
  std::size_t num_edges = 0;
  explicit corners(const CornerTable& t) : table(&t), at_vert(t.G.size() / 3, ~0u) {
    for (unsigned c = 0; c < t.V.size(); ++c) at_vert[t.V[c]] = c, num_edges += t.O[c] < 0 || unsigned(t.O[c]) > c;
  }
};
struct corner_links {  // half-edge c leaves corner c; the previous corner faces it
  using vert = concino::vert_id;
  using edge = concino::edge_id;  // the index is the smaller one of its half-edges
  using poly = concino::poly_id;
  using halfedge = unsigned;
  static constexpr bool has_border_halfedges = false;
  static unsigned next(const corners&, unsigned c) { return CornerTable::next(c); }
  static bool has_opposite(const corners& m, unsigned c) { return m.table->O[CornerTable::previous(c)] >= 0; }
  static unsigned opposite(const corners& m, unsigned c) { return CornerTable::next(unsigned(m.table->O[CornerTable::previous(c)])); }
  static vert target(const corners& m, unsigned c) { return vert{m.table->V[CornerTable::next(c)]}; }
  static poly poly_of(const corners&, unsigned c) { return poly{c / 3}; }
  static edge edge_of(const corners& m, unsigned c) { return edge{has_opposite(m, c) ? std::min(c, opposite(m, c)) : c}; }
  static bool is_isolated(const corners& m, vert v) { return m.at_vert[v.raw()] == ~0u; }
  static unsigned halfedge_of(const corners& m, vert v) { return m.at_vert[v.raw()]; }
  static unsigned halfedge_of(const corners&, edge e) { return e.raw(); }
  static unsigned halfedge_of(const corners&, poly p) { return 3 * p.raw() + 2; }  // it leads to corner 0
  static auto edges(const corners& m) { return concino::ids_where<edge>(m.table->V.size(), [&m](unsigned c) { return edge_of(m, c).raw() == c; }); }
  static std::size_t num_verts(const corners& m) { return m.at_vert.size(); }
  static std::size_t num_edges(const corners& m) { return m.num_edges; }
  static std::size_t num_polys(const corners& m) { return m.table->V.size() / 3; }
  static std::size_t edge_index_bound(const corners& m) { return m.table->V.size(); }
  static const float* point(const corners& m, vert v) { return &m.table->G[3 * v.raw()]; }
};
template<> struct concino::mesh_traits<corners> : concino::halfedge_kernel<corners, corner_links> { static constexpr int arity = 3; };
//! [corners]

#include "bricks.hpp"

//! [hexes]
#include <concino/concepts/mesh.hpp>
#include <concino/mesh/cell_tables.hpp>
#include <concino/mesh/indexed_base.hpp>

#include <array>
#include <vector>

struct indexed_bricks {
  const Bricks* mesh;
  concino::hex_tables tables;
  explicit indexed_bricks(const Bricks& m)
      : mesh(&m), tables(m.x.size(), std::vector<concino::vert_id>(m.corners.begin(), m.corners.end()), concino::hex_order::lexicographic) {}
};
template<> struct concino::mesh_traits<indexed_bricks> : concino::indexed_volume<indexed_bricks> {
  static constexpr int arity = 8;  // fixed by hex_tables
  static const auto& tables(const indexed_bricks& m) { return m.tables; }
  static auto point(const indexed_bricks& m, vert_id v) { return std::array{m.mesh->x[v.raw()], m.mesh->y[v.raw()], m.mesh->z[v.raw()]}; }
};
//! [hexes]
