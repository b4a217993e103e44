#include <concino/generate/to_triangles.hpp>

#include <concino/generate/agglomerate.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/random_labels.hpp>
#include <concino/generate/subdivide_midpoint.hpp>

#include <support/kinds.hpp>
#include <support/subdivisions.hpp>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

/// Checks the parts of each poly of a planar surface: their number, area and orientation.
template<class M>
void check_triangles(const M& m, int chi) {
  correspondence c;
  const trimesh t = to_triangles(m, {.correspondence = &c});
  check_sound(t, chi);
  CHECK(num_verts(t) == num_verts(m));
  std::vector<double> part(poly_index_bound(m)), weight(poly_index_bound(m));
  std::vector<std::size_t> parts(poly_index_bound(m));
  std::uint32_t before = 0;
  for (const poly_id p : polys(t)) {
    REQUIRE(c.polys[p.raw()].size() == 1);
    const origin from = c.polys[p.raw()][0];
    CHECK(from.index >= before);
    before = from.index;
    part[from.index] += measure(t, p);
    weight[from.index] += from.weight;
    ++parts[from.index];
  }
  for (const auto p : polys(m)) {
    CHECK(parts[p.raw()] == num_elements(adj_p2v(m, p)) - 2);
    CHECK(part[p.raw()] == doctest::Approx(measure(m, p)).epsilon(1e-13));
  }
  for (const poly_id p : polys(t)) {
    const origin from = c.polys[p.raw()][0];
    CHECK(from.weight / weight[from.index] == doctest::Approx(measure(t, p) / part[from.index]).epsilon(1e-12));
  }
  for (const vert_id v : verts(t)) CHECK(point(t, v) == point(m, vert_id{c.verts.only(v.raw())}));
}

}  // namespace

TEST_CASE_TEMPLATE("to_triangles: triangles cover each polygon", M, CONCINO_SURFACE_KINDS) {
  check_triangles(grid<M>(4), 1);
}

TEST_CASE("to_triangles: quads and merged polygons of closed surfaces") {
  const trimesh sphere = icosphere(2);
  const trimesh t = to_triangles(subdivide_midpoint(sphere));
  check_sound(t, 2);
  CHECK(num_polys(t) == 6 * num_polys(sphere));
  CHECK(total_measure(t) == doctest::Approx(total_measure(sphere)).epsilon(1e-13));
  CHECK(record_of(to_triangles(sphere)) == record_of(sphere));
  const auto flat = grid<quadmesh>(8);
  check_triangles(agglomerate(flat, random_labels(flat, 12)), 1);
}

TEST_CASE("to_triangles: triangles have area if verts are on few lines") {
  for (const unsigned n : {1u, 2u, 3u, 7u, 40u, 300u})
    for (const unsigned sides : {3u, 4u, 5u}) {
      const std::vector<vec3> ends = sides == 3   ? std::vector<vec3>{{0, 0, 0}, {1, 0, 2}, {0, 1, 1}}
                                     : sides == 4 ? std::vector<vec3>{{0, 0, 0}, {3, 0, 0}, {3, 2, 4}, {0, 2, 4}}
                                                  : std::vector<vec3>{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {0, 2, 0}};
      surface_arrays a{{}, {0, sides * n}, {}, 0};
      for (unsigned s = 0; s < sides; ++s)
        for (unsigned k = 0; k < n; ++k) a.points.push_back(ends[s] + (ends[(s + 1) % sides] - ends[s]) * (double(k) / n));
      for (unsigned k = 0; k < sides * n; ++k) a.verts.push_back(vert_id{k});
      check_triangles(polygonmesh(a), 1);
    }
}

TEST_CASE("to_triangles: properties, edges, archetype, deleted polys") {
  polygonmesh m = grid<polygonmesh>(2);
  add_properties(m);
  remove_poly(m, poly_id{2});
  correspondence c;
  const trimesh t = to_triangles(m, {.correspondence = &c});
  CHECK(check_laws(t).empty());
  const auto mass = find_poly_property<double>(t, "mass");
  const auto name = find_poly_property<int>(t, "name");
  const auto crease = find_edge_property<int>(t, "crease");
  REQUIRE(mass);
  for (const poly_id p : polys(t)) {
    CHECK(mass[p] == doctest::Approx(measure(t, p)).epsilon(1e-13));
    CHECK(name[p] == 10 + static_cast<int>(c.polys[p.raw()][0].index));
  }
  std::size_t kept = 0;
  for (const edge_id e : edges(t)) {
    kept += !c.edges[e.raw()].empty();
    CHECK(crease[e] == (c.edges[e.raw()].empty() ? 0 : 1 + static_cast<int>(c.edges[e.raw()][0].index)));
  }
  CHECK(kept == num_edges(m));
  const trimesh plain = to_triangles(m, {.properties = false});
  CHECK(property_list(plain).empty());
  CHECK(record_of(to_triangles(only_embedded_mesh(m))) == record_of(plain));
}

TEST_CASE("to_triangles: empty meshes, polygons without area, points that are not finite") {
  CHECK(num_polys(to_triangles(polygonmesh())) == 0);
  const std::vector<std::vector<unsigned>> quad{{0, 1, 2, 3}};
  correspondence c;
  CHECK(num_polys(to_triangles(polygonmesh(std::vector<vec3>(4), quad), {.correspondence = &c})) == 2);
  CHECK(c.polys.only(1) == 0);
  polygonmesh m = grid<polygonmesh>(1);
  set_point(m, vert_id{3}, vec3{0, std::numeric_limits<double>::quiet_NaN(), 0});
  CHECK_THROWS_WITH_AS(to_triangles(m), "to_triangles: the point of vert 3 is not finite; validate() lists all such verts", invalid_mesh);
}
