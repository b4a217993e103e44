// The adapters of docs/adapt-your-mesh.md conform: half-edges in arrays, triangles by tables, and a volume that answers every verb by a search.
#include <concino/adapters/doctest.hpp>
#include <concino/concepts/halfedge_kernel.hpp>
#include <concino/concepts/mesh.hpp>
#include <concino/geometry.hpp>
#include <concino/mesh/indexed_base.hpp>
#include <concino/mesh/surface_tables.hpp>
#include <concino/validate.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

//! [half-edges]
struct linked_mesh {  // half-edge h ends at vert target[h]
  static constexpr unsigned none = ~0u;
  std::vector<std::array<double, 3>> points;
  std::vector<unsigned> next, opposite, target, edge_of;  // one per half-edge
  std::vector<unsigned> poly_of;                          // none at the border
  std::vector<unsigned> of_vert, of_edge, of_poly;        // a half-edge of each
};
struct linked_mesh_links {
  using M = linked_mesh;
  using vert = concino::vert_id; using edge = concino::edge_id;
  using poly = concino::poly_id; using halfedge = unsigned;
  static unsigned next(const M& m, unsigned h) { return m.next[h]; }
  static unsigned opposite(const M& m, unsigned h) { return m.opposite[h]; }
  static vert target(const M& m, unsigned h) { return vert{m.target[h]}; }
  static edge edge_of(const M& m, unsigned h) { return edge{m.edge_of[h]}; }
  static poly poly_of(const M& m, unsigned h) { return poly{m.poly_of[h]}; }
  static bool is_border(const M& m, unsigned h) { return m.poly_of[h] == M::none; }
  static bool is_isolated(const M& m, vert v) { return m.of_vert[v.raw()] == M::none; }
  static unsigned halfedge_of(const M& m, vert v) { return m.of_vert[v.raw()]; }
  static unsigned halfedge_of(const M& m, edge e) { return m.of_edge[e.raw()]; }
  static unsigned halfedge_of(const M& m, poly p) { return m.of_poly[p.raw()]; }
  static std::size_t num_verts(const M& m) { return m.of_vert.size(); }
  static std::size_t num_edges(const M& m) { return m.of_edge.size(); }
  static std::size_t num_polys(const M& m) { return m.of_poly.size(); }
  static const auto& point(const M& m, vert v) { return m.points[v.raw()]; }
};
template<> struct concino::mesh_traits<linked_mesh>
    : concino::halfedge_kernel<linked_mesh, linked_mesh_links> {};
//! [half-edges]

//! [triangles]
struct triangle_list {
  std::vector<concino::vec3> points;
  concino::surface_tables<3> tables;  // the adjacencies; built once from the lists
  triangle_list(std::vector<concino::vec3> x, std::vector<concino::vert_id> corners)
      : points(std::move(x)), tables(points.size(), std::move(corners)) {}
};
template<> struct concino::mesh_traits<triangle_list>
    : concino::indexed_surface<triangle_list> {
  static constexpr int arity = 3;
  static const auto& tables(const triangle_list& m) { return m.tables; }
  static const auto& point(const triangle_list& m, vert_id v) { return m.points[v.raw()]; }
};
//! [triangles]

//! [volume]
struct cell_list {  // outward: those of its faces that run counter-clockwise seen from outside
  struct face { std::vector<concino::vert_id> verts; std::vector<concino::edge_id> edges; };
  struct poly { std::vector<concino::face_id> faces, outward; };
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<concino::vert_id, 2>> edges;
  std::vector<face> faces;
  std::vector<poly> polys;
};
template<> struct concino::mesh_traits<cell_list> {
  using M = cell_list;
  using vert = vert_id; using edge = edge_id;
  using face = face_id; using poly = poly_id;
  static constexpr int dimension = 3;
  static auto verts(const M& m) { return id_range<vert>(m.points.size()); }
  static auto edges(const M& m) { return id_range<edge>(m.edges.size()); }
  static auto faces(const M& m) { return id_range<face>(m.faces.size()); }
  static auto polys(const M& m) { return id_range<poly>(m.polys.size()); }
  static auto num_verts(const M& m) { return m.points.size(); }
  static auto num_edges(const M& m) { return m.edges.size(); }
  static auto num_faces(const M& m) { return m.faces.size(); }
  static auto num_polys(const M& m) { return m.polys.size(); }
  static auto vert_index_bound(const M& m) { return m.points.size(); }
  static auto edge_index_bound(const M& m) { return m.edges.size(); }
  static auto face_index_bound(const M& m) { return m.faces.size(); }
  static auto poly_index_bound(const M& m) { return m.polys.size(); }
  static std::size_t index_of(const M&, auto x) { return x.raw(); }
  static const auto& adj_e2v(const M& m, edge e) { return m.edges[e.raw()]; }
  static const auto& adj_f2v(const M& m, face f) { return m.faces[f.raw()].verts; }
  static const auto& adj_f2e(const M& m, face f) { return m.faces[f.raw()].edges; }
  static const auto& adj_p2f(const M& m, poly p) { return m.polys[p.raw()].faces; }

  // The elements x, but for one, where list(m, x) has an element of r.
  template<class X>
  static auto sharing(const M& m, id_range<X> all, auto list, const auto& r, X not_this = {}) {
    std::vector<X> found;
    for (X x : all) {
      const auto& of_x = list(m, x);
      const auto i = std::find_first_of(of_x.begin(), of_x.end(), r.begin(), r.end());
      if (i != of_x.end() && x != not_this) found.push_back(x);
    }
    return found;
  }
  static auto adj_v2e(const M& m, vert v) { return sharing(m, edges(m), adj_e2v, std::array{v}); }
  static auto adj_v2f(const M& m, vert v) { return sharing(m, faces(m), adj_f2v, std::array{v}); }
  static auto adj_e2f(const M& m, edge e) { return sharing(m, faces(m), adj_f2e, std::array{e}); }
  static auto adj_f2p(const M& m, face f) { return sharing(m, polys(m), adj_p2f, std::array{f}); }
  static auto adj_v2p(const M& m, vert v) { return sharing(m, polys(m), adj_p2f, adj_v2f(m, v)); }
  static auto adj_e2p(const M& m, edge e) { return sharing(m, polys(m), adj_p2f, adj_e2f(m, e)); }
  static auto adj_p2v(const M& m, poly p) { return sharing(m, verts(m), adj_v2f, adj_p2f(m, p)); }
  static auto adj_p2e(const M& m, poly p) { return sharing(m, edges(m), adj_e2f, adj_p2f(m, p)); }
  static auto adj_v2v(const M& m, vert v) { return sharing(m, verts(m), adj_v2e, adj_v2e(m, v), v); }
  static auto adj_p2p(const M& m, poly p) { return sharing(m, polys(m), adj_p2f, adj_p2f(m, p), p); }
  static bool face_is_outward(const M& m, poly p, face f) {
    const auto& some = m.polys[p.raw()].outward;
    return std::find(some.begin(), some.end(), f) != some.end();
  }
  static const auto& point(const M& m, vert v) { return m.points[v.raw()]; }
};
//! [volume]

namespace {

template<class M>
std::string broken_laws_of(const M& m) {
  std::string text;
  //! [laws]
  for (const auto& broken : concino::check_laws(m)) text += broken.law + ": " + broken.what + "\n";
  //! [laws]
  return text;
}

/// Two triangles of a square, and an isolated vert. Half-edges 0 1 2 and 3 4 5 run along the triangles, 6 7 8 9 along the border.
linked_mesh linked_square() {
  constexpr unsigned none = linked_mesh::none;
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {5, 5, 5}},
          {1, 2, 0, 4, 5, 3, 9, 6, 7, 8},
          {6, 7, 3, 2, 8, 9, 0, 1, 4, 5},
          {1, 2, 0, 2, 3, 0, 0, 1, 2, 3},
          {0, 1, 2, 2, 3, 4, 0, 1, 3, 4},
          {0, 0, 0, 1, 1, 1, none, none, none, none},
          {0, 1, 2, 5, none},
          {0, 1, 2, 4, 5},
          {2, 5}};
}

triangle_list tetrahedron_surface() {
  using v = concino::vert_id;
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {v{0}, v{2}, v{1}, v{0}, v{1}, v{3}, v{1}, v{2}, v{3}, v{2}, v{0}, v{3}}};
}

/// A cell list of points, of faces by their verts, and of polys by their faces and whether these run counter-clockwise seen from outside.
cell_list cells_of(std::vector<std::array<double, 3>> points, const std::vector<std::vector<unsigned>>& faces,
                   const std::vector<std::vector<std::pair<unsigned, bool>>>& polys) {
  cell_list m;
  m.points = std::move(points);
  for (const auto& corners : faces) {
    cell_list::face f;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [a, b] = std::minmax(corners[k], corners[(k + 1) % corners.size()]);
      const std::array<concino::vert_id, 2> ends{concino::vert_id{a}, concino::vert_id{b}};
      const auto place = std::find(m.edges.begin(), m.edges.end(), ends);
      f.verts.emplace_back(corners[k]);
      f.edges.emplace_back(static_cast<unsigned>(place - m.edges.begin()));
      if (place == m.edges.end()) m.edges.push_back(ends);
    }
    m.faces.push_back(f);
  }
  for (const auto& list : polys) {
    cell_list::poly p;
    for (const auto& [f, is_outward] : list) {
      p.faces.emplace_back(f);
      if (is_outward) p.outward.emplace_back(f);
    }
    m.polys.push_back(p);
  }
  return m;
}

/// A cube and a pyramid that share a square, and an isolated vert.
cell_list cube_and_pyramid() {
  return cells_of({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, 0.5, 2}, {9, 9, 9}},
                  {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 4, 8}},
                  {{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}, {5, true}}, {{1, false}, {6, true}, {7, true}, {8, true}, {9, true}}});
}

}  // namespace

TEST_CASE("first adapters: half-edges in arrays conform, and have the area of the square") {
  concino::check_conformance(linked_square);
  CHECK(concino::total_measure(linked_square()) == doctest::Approx(1));
}

TEST_CASE("first adapters: triangles with tables conform") {
  concino::check_conformance(tetrahedron_surface);
  CHECK(concino::num_edges(tetrahedron_surface()) == 6);
}

TEST_CASE("first adapters: a volume that answers every verb by a search conforms") {
  concino::check_conformance(cube_and_pyramid);
  CHECK(concino::total_measure(cube_and_pyramid()) == doctest::Approx(4. / 3));
}

TEST_CASE("first adapters: check_laws names the law that a wrong answer breaks") {
  CHECK(broken_laws_of(linked_square()) == "");
  linked_mesh m = linked_square();
  m.opposite[2] = 2;
  CHECK(broken_laws_of(m).find("HE3: ") == 0);
  cell_list cells = cube_and_pyramid();
  cells.polys[1].outward.emplace_back(1);
  CHECK(broken_laws_of(cells).find("VM6: ") == 0);
}
