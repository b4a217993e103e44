#include <concino/generate/subdivide_midpoint.hpp>

#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/jitter.hpp>

#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("subdivide_midpoint: a quad or hex at each vert of each poly", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto s = subdivide_midpoint(m);
  CHECK(check_laws(s).empty());
  std::size_t corners = 0;
  for (const poly_t<M> p : polys(m)) corners += num_elements(adj_p2v(m, p));
  REQUIRE(num_polys(s) == corners);
  CHECK(euler(s) == 1);
  CHECK(num_verts(s) == num_verts(m) + num_edges(m) + num_polys(m) + (VolumeMesh<M> ? num_facets(m) : 0));
  for (const vert_id v : verts(m)) CHECK(point(s, v) == point(m, v));
  std::vector<double> part(num_polys(m));
  correspondence c;
  std::vector<poly_id> inverted{poly_id{7}};
  const auto again = subdivide_midpoint(m, {.correspondence = &c, .inverted = &inverted});
  CHECK(record_of(again) == record_of(s));
  for (const poly_id p : polys(s)) part[c.polys.only(p.raw())] += measure(s, p);
  if constexpr (arity_v<M> != 0) {
    check_sound(s, 1);
    CHECK(inverted.empty());
    for (const poly_t<M> p : polys(m)) CHECK(part[p.raw()] == doctest::Approx(measure(m, p)).epsilon(1e-12));
  } else {
    CHECK(!inverted.empty());  // at the reflex corners of the L
    for (const poly_id p : inverted) CHECK(quality(s, p, metric::scaled_jacobian) <= 0);
    if constexpr (VolumeMesh<M>)
      for (const poly_t<M> p : polys(m)) CHECK(part[p.raw()] == doctest::Approx(measure(m, p)).epsilon(1e-12));
  }
}

TEST_CASE_TEMPLATE("subdivide_midpoint: properties, correspondence, repetition", M, CONCINO_KINDS) {
  check_subdivision(grid<M>(1), [](const auto& m, const subdivide_options& o) {
    return subdivide_midpoint(m, {.times = o.times, .properties = o.properties, .correspondence = o.correspondence});
  });
}

TEST_CASE("subdivide_midpoint: jittered tets give valid hexes, at every vert of each") {
  tetmesh m = grid<tetmesh>(3);
  jitter(m, 0.2);
  std::vector<poly_id> inverted;
  const hexmesh s = subdivide_midpoint(m, {.inverted = &inverted});
  check_sound(s, 1);
  CHECK(inverted.empty());
  CHECK(num_polys(s) == 4 * num_polys(m));
  CHECK(total_measure(s) == doctest::Approx(total_measure(m)).epsilon(1e-13));
}

TEST_CASE("subdivide_midpoint: Voronoi cells keep their volumes, and few hexes are inverted") {
  const polyhedralmesh m = voronoi_polyhedra(random_points(60, {{0, 0, 0}, {1, 1, 1}}, 3), {{0, 0, 0}, {1, 1, 1}});
  std::vector<poly_id> inverted;
  correspondence c;
  const hexmesh s = subdivide_midpoint(m, {.correspondence = &c, .inverted = &inverted});
  CHECK(check_laws(s).empty());
  std::vector<double> part(num_polys(m));
  for (const poly_id p : polys(s)) part[c.polys.only(p.raw())] += measure(s, p);
  for (const poly_id p : polys(m)) CHECK(part[p.raw()] == doctest::Approx(measure(m, p)).epsilon(1e-12));
  MESSAGE(inverted.size(), " of ", num_polys(s), " hexes are inverted");
  CHECK(inverted.size() * 50 < num_polys(s));
}

TEST_CASE("subdivide_midpoint: a poly with four edges at a vert is named") {
  const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
  const std::vector<std::vector<unsigned>> walls{{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  const std::vector<std::vector<std::pair<unsigned, bool>>> cells{{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}}};
  const polyhedralmesh pyramid(points, walls, cells);
  CHECK_THROWS_WITH_AS(subdivide_midpoint(pyramid), "subdivide_midpoint: poly 0 has 4 edges at vert 4, but must have 3; subdivide_barycentric() divides all polyhedra", unsupported);
}

TEST_CASE("subdivide_midpoint: a poly whose faces are not closed is named") {
  const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  polyhedra_arrays a{points, {0, 3, 6, 9, 12}, {}, {0, 4}, {}, {1, 1, 1, 0}};  // the last face is turned inside
  for (const unsigned v : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u}) a.face_verts.push_back(vert_id{v});
  for (const unsigned f : {0u, 1u, 2u, 3u}) a.poly_faces.push_back(face_id{f});
  CHECK_THROWS_WITH_AS(subdivide_midpoint(polyhedralmesh(a)), doctest::Contains("subdivide_midpoint: the faces of poly 0 are not closed around vert "), invalid_mesh);
  a.poly_offsets = {0, 3}, a.poly_faces.pop_back(), a.outward.pop_back();
  CHECK_THROWS_WITH_AS(subdivide_midpoint(polyhedralmesh(a)), doctest::Contains("subdivide_midpoint: poly 0 has 2 edges at vert 0"), unsupported);
}
