// CGAL::Surface_mesh converts from and to native meshes, and passes the conformance kit in every state.
#include <concino/adapters/cgal_surface_mesh.hpp>
#include <concino/adapters/doctest.hpp>

#include <CGAL/Simple_cartesian.h>

#include <support/foreign_conversions.hpp>

namespace cn = concino;

namespace {

using polygons = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

}  // namespace

TEST_CASE("CGAL: converting there and back is the identity, and non-manifold meshes throw") {
  cn::testing::conversions_of_half_edge_meshes<polygons, polygons>();
}

TEST_CASE("CGAL: Surface_mesh conforms in every state") {
  cn::check_conformance([] {
    cn::quadmesh q = cn::testing::grid<cn::quadmesh>(3);
    cn::add_vert(q, {7, 7, 7});
    return cn::convert<polygons>(q);
  }, {.states = {{"after a vert was removed", [](polygons& m) { m.remove_vertex(CGAL::SM_Vertex_index(16)); }}}});
}

TEST_CASE("CGAL: the error names the reason why a poly cannot be added") {
  polygons m;
  const auto v = [&](unsigned i) { return CGAL::SM_Vertex_index(i); };
  for (int i = 0; i < 4; ++i) cn::add_vert(m, {double(i % 2), double(i / 2), 0});
  cn::add_poly(m, {v(0), v(1), v(3)});
  CHECK_THROWS_WITH_AS(cn::add_poly(m, {v(0), v(1)}), doctest::Contains("at least 3"), cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::add_poly(m, {v(0), v(1), v(9)}), doctest::Contains("vert 9"), cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::add_poly(m, {v(0), v(2), v(0)}), doctest::Contains("twice"), cn::invalid_mesh);
  CHECK_THROWS_WITH_AS(cn::add_poly(m, {v(0), v(1), v(2)}), doctest::Contains("cannot be linked"), cn::invalid_mesh);
  CHECK(cn::num_polys(m) == 1);
}

TEST_CASE("CGAL: converting the corpus there and back is the identity") { cn::testing::corpus_there_and_back<polygons>(); }
