// Building, validate and check_laws take time about proportional to the mesh, whatever its shape: compared with a mesh of as many disjoint polys.
// An algorithm that is quadratic in the number of polys at an element takes hundreds of times as long at these sizes.
#include <concino/mesh.hpp>
#include <concino/mesh/support/face_soup.hpp>
#include <concino/validate/check_laws.hpp>
#include <concino/validate/validate.hpp>

#include <support/dense_meshes.hpp>

#include <doctest/doctest.h>

#include <chrono>
#include <optional>

using namespace concino;
using namespace concino::testing;

namespace {

template<class F>
double seconds(const F& f) {
  const auto start = std::chrono::steady_clock::now();
  f();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

dense_mesh apart(unsigned n, unsigned arity) {
  dense_mesh c{"apart", {}, {}};
  for (unsigned i = 0; i < n; ++i) {
    auto& p = c.polys.emplace_back();
    for (unsigned k = 0; k < arity; ++k) p.push_back(c.add(i + (k == 1 || k == 2), k >= 2, k >= 3));
  }
  return c;
}

struct times {
  double build = 0, validate = 0, laws = 0;
};

template<class Make>
times times_of(const Make& make, bool laws = true) {
  times t;
  std::optional<decltype(make())> m;
  t.build = seconds([&] { m = make(); });
  t.validate = seconds([&] { (void)validate(*m); });
  if (laws) t.laws = seconds([&] { CHECK(check_laws(*m).empty()); });
  return t;
}

/// Checks that the times are at most `most` times those of the mesh of disjoint polys.
void is_in_proportion(const std::string& name, const times& t, const times& usual, double most) {
  CAPTURE(name);
  CHECK(t.build < most * usual.build);
  CHECK(t.validate < most * usual.validate);
  CHECK(t.laws < most * usual.laws);
}

constexpr unsigned n = 150000;

}  // namespace

TEST_CASE("dense meshes: tets and hexes take time proportional to the mesh") {
  const times usual = times_of([] { return apart(n, 4).mesh<tetmesh>(); });
  is_in_proportion("tets around an edge", times_of([] { return tets_around_an_edge(n).mesh<tetmesh>(); }), usual, 20);
  is_in_proportion("tets on an edge", times_of([] { return tets_on_an_edge(n).mesh<tetmesh>(); }), usual, 20);
  is_in_proportion("tets at a vert", times_of([] { return tets_at_a_vert(n).mesh<tetmesh>(); }), usual, 20);
  is_in_proportion("rings at a vert", times_of([] { return rings_at_a_vert(n).mesh<tetmesh>(); }), usual, 20);
  // each tet has all others as neighbours at the face: these lists are quadratic, and are not queried
  is_in_proportion("tets on a face", times_of([] { return tets_on_a_face(n).mesh<tetmesh>(); }, false), usual, 20);
  is_in_proportion("equal tets", times_of([] { return equal_tets(n).mesh<tetmesh>(); }, false), usual, 20);
  is_in_proportion("hexes around an edge", times_of([] { return hexes_around_an_edge(n / 2).mesh<hexmesh>(); }), usual, 20);
}

TEST_CASE("dense meshes: polyhedra take time proportional to the mesh") {
  const times usual = times_of([] { return as_polyhedra(apart(n, 4)); });
  is_in_proportion("tets around an edge", times_of([] { return as_polyhedra(tets_around_an_edge(n)); }), usual, 20);
  is_in_proportion("tets on an edge", times_of([] { return as_polyhedra(tets_on_an_edge(n)); }), usual, 20);
  is_in_proportion("tets at a vert", times_of([] { return as_polyhedra(tets_at_a_vert(n)); }), usual, 20);
  is_in_proportion("tets on a face", times_of([] { return as_polyhedra(tets_on_a_face(n)); }, false), usual, 20);
  is_in_proportion("hexes on three verts", times_of([] { return as_polyhedra(hexes_on_three_verts(n / 4)); }), usual, 20);
  is_in_proportion("prism", times_of([] { return polyhedra_of(prism_faces(n), 1); }), usual, 20);
  is_in_proportion("equal prisms", times_of([] { return polyhedra_of(prism_faces(n / 3), 3); }), usual, 20);
  is_in_proportion("bipyramid", times_of([] { return polyhedra_of(bipyramid_faces(n), 1); }), usual, 20);
  // a large face of many polys: the adjacencies of its verts and polys would be quadratic, and throw
  is_in_proportion("polys of a face of 16 verts", times_of([] { return polyhedra_of(equal_polygons(16, 1, false), n); }, false), usual, 20);
  is_in_proportion("16 polys of a large face", times_of([] { return polyhedra_of(equal_polygons(n, 1, false), 16); }, false), usual, 20);
  times refused;
  refused.build = seconds([] { CHECK_THROWS_AS(polyhedra_of(equal_polygons(n, 1, false), n), unsupported); });
  is_in_proportion("polys of a large face", refused, usual, 20);
}

TEST_CASE("dense meshes: surfaces take time proportional to the mesh") {
  const times usual = times_of([] { return apart(n, 3).mesh<polygonmesh>(); });
  is_in_proportion("a polygon", times_of([] { return equal_polygons(3 * n, 1, false).mesh<polygonmesh>(); }), usual, 20);
  is_in_proportion("equal polygons", times_of([] { return equal_polygons(n, 3, false).mesh<polygonmesh>(); }), usual, 20);
  is_in_proportion("equal polygons with leaves", times_of([] { return equal_polygons(n / 4, 2, true).mesh<polygonmesh>(); }), usual, 20);
  is_in_proportion("a polygon with pages", times_of([] { return polygon_with_pages(n).mesh<polygonmesh>(); }, false), usual, 20);
  is_in_proportion("pages", times_of([] { return pages(n / 2).mesh<trimesh>(); }, false), usual, 20);
  is_in_proportion("pages, as polygons", times_of([] { return pages(n / 2).mesh<polygonmesh>(); }, false), usual, 20);
  is_in_proportion("comb", times_of([] { return comb(n).mesh<polygonmesh>(); }), usual, 60);
}

TEST_CASE("dense meshes: the time of check_laws is proportional to the lists that it reads, even if these are quadratic") {
  constexpr unsigned k = 1600;  // k^2 neighbours
  const times usual = times_of([] { return apart(k * k / 16, 3).mesh<trimesh>(); });
  is_in_proportion("equal triangles", times_of([] { return equal_triangles(k).mesh<trimesh>(); }), usual, 20);
  is_in_proportion("equal triangles, as polygons", times_of([] { return equal_triangles(k).mesh<polygonmesh>(); }), usual, 20);
  is_in_proportion("equal tets", times_of([] { return equal_tets(k).mesh<tetmesh>(); }), usual, 20);
  is_in_proportion("pages", times_of([] { return pages(k).mesh<polygonmesh>(); }), usual, 20);
  is_in_proportion("equal polygons", times_of([] { return equal_polygons(32, k, false).mesh<polygonmesh>(); }), usual, 20);
  is_in_proportion("a polygon with pages", times_of([] { return polygon_with_pages(k).mesh<polygonmesh>(); }), usual, 20);
}
