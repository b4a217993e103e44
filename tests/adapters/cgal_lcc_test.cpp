// Linear cell complexes of CGAL are polyhedral meshes through indexed(lcc): they conform, handles convert both ways, points are not copied.
#include <concino/adapters/cgal_lcc.hpp>
#include <concino/adapters/doctest.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/graph.hpp>
#include <concino/mesh/boundary.hpp>

using namespace concino;

namespace {

using complex = CGAL::Linear_cell_complex_for_combinatorial_map<3>;
using point3 = complex::Point;

auto box(complex& c, double x) {
  return c.make_hexahedron(point3(x, 0, 0), point3(x + 1, 0, 0), point3(x + 1, 1, 0), point3(x, 1, 0), point3(x, 1, 1), point3(x, 0, 1), point3(x + 1, 0, 1), point3(x + 1, 1, 1));
}

/// A row of n boxes, and a tet that is not connected to them.
complex row(int n) {
  complex c;
  for (int i = 0; i < n; ++i) box(c, i);
  c.sew3_same_facets();
  c.make_tetrahedron(point3(0, 5, 0), point3(1, 5, 0), point3(0, 6, 0), point3(0, 5, 1));
  return c;
}

template<class L> concept may_be_temporary = requires { indexed(L()); };

}  // namespace

TEST_CASE("linear cell complexes: a row of boxes and a tet conform") {
  const complex c = row(3);
  check_conformance([&] { return indexed(c); });
  const auto m = indexed(c);
  static_assert(VolumeMesh<decltype(m)> && Embedded<decltype(m)> && !may_be_temporary<complex>);
  CHECK(num_verts(m) == 16 + 4);
  CHECK(num_edges(m) == 28 + 6);
  CHECK(num_faces(m) == 16 + 4);
  CHECK(num_polys(m) == 4);
  CHECK(connected_components(m).count == 2);
  CHECK(total_measure(m) == doctest::Approx(3 + 1.0 / 6));
  for (const auto p : polys(m)) CHECK(volume(m, p) > 0);
  const auto skin = boundary(m);
  CHECK(num_polys(skin) == 14 + 4);
}

TEST_CASE("linear cell complexes: darts and descriptors convert to each other") {
  const complex c = row(2);
  const auto m = indexed(c);
  for (const auto v : verts(m)) CHECK(m.vert(m.handle(v)) == v);
  for (const auto e : edges(m)) CHECK(m.edge(m.handle(e)) == e);
  for (const auto f : faces(m)) CHECK(m.face(m.handle(f)) == f);
  for (const auto p : polys(m)) CHECK(m.poly(m.handle(p)) == p);
  std::size_t darts = 0;
  for (auto d = c.darts().begin(); d != c.darts().end(); ++d, ++darts) {
    bool has_vert = false, has_face = false;
    for (const auto v : adj_p2v(m, m.poly(d))) has_vert = has_vert || v == m.vert(d);
    for (const auto f : adj_p2f(m, m.poly(d))) has_face = has_face || f == m.face(d);
    CHECK((has_vert && has_face));
    if (!c.is_free(d, 3)) CHECK(m.face(d) == m.face(c.beta(d, 3)));
  }
  CHECK(darts == 2 * 24 + 12);
}

TEST_CASE("linear cell complexes: points refer to those of the complex, so changes are seen") {
  complex c = row(1);
  const auto m = indexed(c);
  const vert_id v = m.vert(c.darts().begin());
  c.point(c.darts().begin()) = point3(-1, -2, -3);
  CHECK(to_vec3(point(m, v)) == vec3{-1, -2, -3});
}

TEST_CASE("linear cell complexes: an empty complex is an empty mesh, and an open facet is an error") {
  const complex none;
  const auto m = indexed(none);
  CHECK(num_polys(m) == 0);
  complex open;
  open.create_dart(point3(0, 0, 0));
  CHECK_THROWS_WITH_AS(indexed(open), doctest::Contains("not closed"), invalid_mesh);
}
