// Triangulations of CGAL are tet meshes through indexed(t): they obey all laws, handles convert both ways, results equal those of a tetmesh.
#include <concino/adapters/cgal_triangulation.hpp>
#include <concino/fields.hpp>
#include <concino/geometry.hpp>
#include <concino/graph.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/tetmesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <doctest/doctest.h>
#include <support/models.hpp>

#include <random>

using namespace concino;

namespace {

using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using delaunay = CGAL::Delaunay_triangulation_3<kernel>;
using view = decltype(indexed(std::declval<const delaunay&>()));

/// The members that a complex of CGAL has, here for the cells on one side of x = 1/2.
struct half_complex {
  using Triangulation = delaunay;
  delaunay t;
  std::vector<delaunay::Cell_handle> cells;
  const delaunay& triangulation() const { return t; }
  auto cells_in_complex_begin() const { return counted{cells.data()}; }
  auto cells_in_complex_end() const { return counted{cells.data() + cells.size()}; }
  std::size_t number_of_cells_in_complex() const { return cells.size(); }

  struct counted {
    const delaunay::Cell_handle* at;
    operator delaunay::Cell_handle() const { return *at; }
    counted& operator++() { ++at; return *this; }
    bool operator!=(const counted& o) const { return at != o.at; }
  };
};

template<class T> concept may_be_temporary = requires { indexed(T()); };

delaunay random_points(int n, unsigned seed = 4) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  delaunay t;
  for (int i = 0; i < n; ++i) {
    const double x = unit(random), y = unit(random), z = unit(random);
    t.insert(kernel::Point_3(x, y, z));
  }
  return t;
}

/// A native mesh with the same verts and cells.
template<class M>
tetmesh native(const M& m) {
  cell_arrays a{{}, {}, 4};
  for (const vert_id v : verts(m)) a.points.push_back(point(m, v));
  for (const poly_id p : polys(m))
    for (const vert_id v : adj_p2v(m, p)) a.verts.push_back(v);
  return tetmesh(a);
}

template<class M>
void check_sound(const M& m) {
  for (const auto& b : check_laws(m)) FAIL_CHECK(b.law << ": " << b.what);
}

}  // namespace

static_assert(testing::models_in_all_forms<view>(testing::volume | testing::embedded | testing::fixed_arity) && TetMesh<view>);
static_assert(TetMesh<decltype(indexed(std::declval<const half_complex&>()))>);
static_assert(!may_be_temporary<delaunay> && !may_be_temporary<half_complex> && is_view_v<view>);

TEST_CASE("CGAL triangulations: laws hold before and after the triangulation changes, with a new view") {
  delaunay t;
  check_sound(indexed(t));
  CHECK(num_verts(indexed(t)) == 0);
  for (const auto& p : {kernel::Point_3(0, 0, 0), kernel::Point_3(1, 0, 0), kernel::Point_3(0, 1, 0), kernel::Point_3(1, 1, 0)}) {
    t.insert(p);
    const auto m = indexed(t);
    check_sound(m);
    CHECK(num_verts(m) == t.number_of_vertices());
    CHECK(num_polys(m) == 0);  // all points are in one plane
  }
  t = random_points(60);
  for (int step = 0; step < 6; ++step) {
    const auto m = indexed(t);
    check_sound(m);
    CHECK(num_verts(m) == t.number_of_vertices());
    CHECK(num_edges(m) == t.number_of_finite_edges());
    CHECK(num_faces(m) == t.number_of_finite_facets());
    CHECK(num_polys(m) == t.number_of_finite_cells());
    for (int i = 0; i < 7; ++i) t.remove(t.finite_vertices_begin());
  }
}

TEST_CASE("CGAL triangulations: handles and descriptors convert to each other") {
  const delaunay t = random_points(40);
  const auto m = indexed(t);
  for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v) {
    CHECK(m.handle(m.vert(v)) == delaunay::Vertex_handle(v));
    CHECK(point(m, m.vert(v)) == vec3{v->point().x(), v->point().y(), v->point().z()});
  }
  CHECK(m.vert(t.infinite_vertex()).is_none());
  CHECK(m.vert(delaunay::Vertex_handle()).is_none());
  for (auto c = t.all_cells_begin(); c != t.all_cells_end(); ++c) {
    const poly_id p = m.poly(c);
    CHECK(p.is_none() == t.is_infinite(c));
    if (p.is_none()) continue;
    CHECK(m.handle(p) == delaunay::Cell_handle(c));
    int i = 0;
    for (const vert_id v : adj_p2v(m, p)) CHECK(m.handle(v) == c->vertex(i++));
  }
  std::vector<int> met(num_edges(m));
  for (auto e = t.all_edges_begin(); e != t.all_edges_end(); ++e) {
    const edge_id x = m.edge(*e);
    CHECK(x.is_none() == t.is_infinite(*e));
    if (!x.is_none()) ++met[x.raw()];
  }
  CHECK(met == std::vector<int>(num_edges(m), 1));
  for (const edge_id e : edges(m)) CHECK(m.edge(m.handle(e)) == e);
  met.assign(num_faces(m), 0);
  for (auto f = t.all_facets_begin(); f != t.all_facets_end(); ++f) {
    const face_id x = m.face(*f);
    CHECK(x.is_none() == t.is_infinite(*f));
    CHECK(m.face(t.mirror_facet(*f)) == x);
    if (!x.is_none()) ++met[x.raw()];
  }
  CHECK(met == std::vector<int>(num_faces(m), 1));
  for (const face_id f : faces(m)) CHECK(m.face(m.handle(f)) == f);
}

TEST_CASE("CGAL triangulations: results equal those of a tetmesh; tets are positive, the boundary is the convex hull") {
  const delaunay t = random_points(150);
  const auto m = indexed(t);
  const tetmesh n = native(m);
  const vert_id a = m.vert(t.finite_vertices_begin()), b{num_verts(m) - 1};
  const auto d = dijkstra(m, a);
  const auto expected = dijkstra(n, a);
  const auto u = harmonic_map(m, {{a, 0.0}, {b, 1.0}});
  const auto expected_u = harmonic_map(n, {{a, 0.0}, {b, 1.0}});
  for (const vert_id v : verts(m)) {
    CHECK(d[v] == expected[v]);
    CHECK(u[v] == doctest::Approx(expected_u[v]).epsilon(1e-12));
  }
  const auto hops = bfs(m, poly_id{0});
  const auto expected_hops = bfs(n, poly_id{0});
  for (const poly_id p : polys(m)) {
    CHECK(hops[p] == expected_hops[p]);
    CHECK(volume(m, p) > 0);
  }
  const auto surface = boundary(m);
  check_sound(surface);
  CHECK(num_verts(surface) - num_edges(surface) + num_polys(surface) == 2);
  CHECK(bfs(indexed(t), a)[b] == bfs(n, a)[b]);  // maps store a copy of a temporary view
}

TEST_CASE("CGAL triangulations: a complex has exactly its cells and their verts") {
  half_complex c{random_points(100), {}};
  for (const delaunay::Cell_handle cell : c.t.finite_cell_handles())
    if (CGAL::centroid(c.t.tetrahedron(cell)).x() < 0.5) c.cells.push_back(cell);
  const auto m = indexed(c);
  check_sound(m);
  CHECK(num_polys(m) == c.cells.size());
  CHECK(num_verts(m) < c.t.number_of_vertices());
  CHECK(m.handle(poly_id{3}) == c.cells[3]);
  for (const delaunay::Vertex_handle v : c.t.finite_vertex_handles())
    if (const vert_id x = m.vert(v); !x.is_none()) CHECK(m.handle(x) == v);
  // A facet between a cell of the complex and one outside it has one face, from whichever of the two cells it is named.
  int borders = 0;
  for (const face_id f : faces(m)) {
    const auto facet = m.handle(f), mirrored = c.t.mirror_facet(facet);
    CHECK(m.face(mirrored) == f);
    borders += m.poly(mirrored.first).is_none();
  }
  CHECK(borders > 0);
  CHECK(static_cast<std::size_t>(borders) == num_polys(boundary(m)));
}
