#include <concino/generate/dual_mesh_options.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/convert/convert.hpp>
#include <concino/generate/dual_mesh.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/geometry/measure.hpp>
#include <concino/mesh/submesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

template<class R>
std::size_t count(const R& r) {
  std::size_t n = 0;
  for ([[maybe_unused]] const auto x : r) ++n;
  return n;
}

/// Checks the laws, and that each cell of a volume is a sphere.
template<class M>
void check_sound(const M& m) {
  CHECK(check_laws(m).empty());
  if constexpr (VolumeMesh<M>)
    for (const auto p : polys(m)) CHECK(count(adj_p2v(m, p)) + count(adj_p2f(m, p)) == count(adj_p2e(m, p)) + 2);
}

template<class M>
M jittered_grid(unsigned n) {
  M m = grid<M>(n);
  jitter(m, 0.1);
  return m;
}

}  // namespace

TEST_CASE_TEMPLATE("dual_mesh: with creases where the boundary turns, it has the measure of the mesh and fewer elements", M, CONCINO_KINDS) {
  for (const M& m : {grid<M>(1), grid<M>(3)}) {
    const auto everywhere = dual_mesh(m), turning = dual_mesh(m, {.crease_angle_deg = 30});
    check_sound(turning);
    CHECK(total_measure(turning) == doctest::Approx(1).epsilon(1e-12));
    CHECK(num_polys(turning) == num_polys(everywhere));
    CHECK(num_verts(turning) <= num_verts(everywhere));
    if constexpr (VolumeMesh<M>) CHECK(num_faces(turning) <= num_faces(everywhere));
    const auto of_archetype = dual_mesh(only_embedded_mesh(m), {.crease_angle_deg = 30});
    CHECK(num_verts(of_archetype) == num_verts(turning));
    CHECK(num_edges(of_archetype) == num_edges(turning));
    CHECK(total_measure(of_archetype) == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("dual_mesh: a grid of 3 x 3 x 3 hexes has a cell of 4 x 4 x 4, whose faces on the boundary are rectangles") {
  const hexmesh m = grid<hexmesh>(3);
  const polyhedralmesh d = dual_mesh(m, {.crease_angle_deg = 30});
  CHECK(num_polys(d) == 64);
  for (const auto p : polys(d)) CHECK(count(adj_p2f(d, p)) == 6);
  CHECK(num_faces(d) == 144 + 96);  // one for each edge of m, and for each quad of 4 x 4 on the six sides
  CHECK(count(adj_p2v(d, poly_id{0})) == 8);
}

TEST_CASE_TEMPLATE("dual_mesh: closed, cells cut off what turns, and nothing else", M, CONCINO_KINDS) {
  const M m = grid<M>(4);
  dual_maps maps;
  const auto d = dual_mesh(m, {.boundary = dual_boundary::closed, .maps = &maps});
  check_sound(d);
  CHECK(num_polys(d) == num_polys(dual_mesh(m)));
  CHECK(total_measure(d) < 1);
  CHECK(total_measure(d) > 0.5);
  if constexpr (arity_v<M> != 0)  // elsewhere, faces that share several edges need creases
    for (const vert_id v : maps.vert_of_vert) CHECK(v.is_none());
  if constexpr (VolumeMesh<M>)
    for (const auto p : polys(d)) CHECK(volume(d, p) > 0);
}

TEST_CASE("dual_mesh: of one tet, closed, it has four tets around its centroid") {
  const tetmesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2, 3}});
  const polyhedralmesh d = dual_mesh(m, {.boundary = dual_boundary::closed});
  check_sound(d);
  CHECK(num_verts(d) == 5);
  CHECK(num_polys(d) == 4);
  for (const auto p : polys(d)) CHECK((count(adj_p2f(d, p)) == 4 && volume(d, p) > 0));
}

TEST_CASE("dual_mesh: creases by a map") {
  const hexmesh m = grid<hexmesh>(2);
  const auto none = make_edge_map<bool>(m, false);
  check_sound(dual_mesh(m, none));
  CHECK(num_verts(dual_mesh(m, none)) == num_verts(dual_mesh(m, {.boundary = dual_boundary::closed})));
  const auto all = make_edge_map<bool>(m, true);
  CHECK(num_verts(dual_mesh(m, all)) == num_verts(dual_mesh(m)));
  CHECK(num_faces(dual_mesh(m, all)) == num_faces(dual_mesh(m)));

  // At each end of a single crease the cell has one face on the boundary, with the midpoint of the crease.
  auto one = none;
  for (const auto e : edges(m)) {
    if (!is_boundary(m, e)) continue;
    one[e] = true;
    dual_maps maps;
    const polyhedralmesh d = dual_mesh(m, one, {.maps = &maps});
    check_sound(d);
    CHECK(num_verts(d) == num_verts(dual_mesh(m, none)) + 1);
    CHECK(num_faces(d) == num_faces(dual_mesh(m, none)));
    CHECK(!maps.vert_of_edge[e.raw()].is_none());
    one[e] = false;
  }
  const quadmesh flat = grid<quadmesh>(3);
  auto corner = make_vert_map<bool>(flat, false);
  corner[vert_id{0}] = true;
  CHECK(num_verts(dual_mesh(flat, corner)) == num_polys(flat) + 12 + 1);
  CHECK(total_measure(dual_mesh(flat, corner)) == doctest::Approx(1 - 3.0 / 72));
}

TEST_CASE("dual_mesh: boundary faces that share several edges are separated by creases in any case") {
  // Two halves of a cube whose common face is a zigzag: the sides that it divides share several edges.
  const polyhedralmesh m({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1.2, 0}, {0, 1, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 1}},
                         {{0, 4, 3, 2, 1}, {0, 1, 7}, {1, 2, 7}, {2, 3, 7}, {3, 4, 7}, {4, 0, 7}, {2, 3, 4, 6, 5}, {2, 5, 7}, {5, 6, 7}, {6, 4, 7}},
                         {{{0, true}, {1, true}, {2, true}, {3, true}, {4, true}, {5, true}}, {{6, true}, {7, true}, {8, true}, {9, true}, {3, false}, {4, false}}});
  for (const auto boundary : {dual_boundary::clipped, dual_boundary::closed}) {
    dual_maps maps;
    const polyhedralmesh d = dual_mesh(m, {.boundary = boundary, .maps = &maps});
    check_sound(d);
    CHECK(num_polys(d) == num_verts(m));
    std::size_t creases = 0;
    for (const vert_id v : maps.vert_of_edge) creases += !v.is_none();
    CHECK(creases == (boundary == dual_boundary::closed ? 2 : num_edges(m) - 1));  // one edge is inside
  }
}

TEST_CASE("dual_mesh: works on volumes with any boundary, with creases and without") {
  box b;
  b.min = {0, 0, 0}, b.max = {2, 1, 1};
  const polyhedralmesh v = voronoi_polyhedra(random_points(40, b, 3), b);
  const polyhedralmesh d = dual_mesh(v, {.crease_angle_deg = 30});
  check_sound(d);
  CHECK(total_measure(d) == doctest::Approx(2).epsilon(1e-12));
  check_sound(dual_mesh(v, {.boundary = dual_boundary::closed}));
}

TEST_CASE_TEMPLATE("dual_mesh: with circumcentres, the faces of duals of Delaunay meshes are planar and orthogonal to edges", M, trimesh, polygonmesh, tetmesh) {
  const M m = [] {
    if constexpr (TetMesh<M>) return grid<tetmesh>(2);
    else return convert<M>(icosphere(2));
  }();
  dual_maps maps;
  const auto d = dual_mesh(m, {.points = dual_points::circumcentres, .maps = &maps});
  CHECK(check_laws(d).empty());
  std::size_t i = 0;
  for (const auto p : polys(m)) CHECK(point(d, vert_id{i++}) == circumcentre(m, p));
  for (const auto e : edges(m)) {
    const auto [a, b] = end_verts(m, e);
    if constexpr (VolumeMesh<M>) {
      if (is_boundary(m, e)) continue;
      for (const auto x : adj_f2v(d, maps.face_of_edge[e.raw()])) CHECK(norm(point(d, x) - point(m, a)) == doctest::Approx(norm(point(d, x) - point(m, b))));
    } else {
      for (const auto p : adj_e2p(m, e)) {
        const vec3 c = point(d, maps.vert_of_poly[p.raw()]);
        CHECK(norm(c - point(m, a)) == doctest::Approx(norm(c - point(m, b))));
      }
    }
  }
}

TEST_CASE_TEMPLATE("dual_mesh: the maps say which dual element each element has", M, CONCINO_KINDS) {
  const M m = jittered_grid<M>(3);
  for (const auto boundary : {dual_boundary::clipped, dual_boundary::closed, dual_boundary::discarded}) {
    dual_maps maps;
    const auto d = dual_mesh(m, {.boundary = boundary, .maps = &maps});
    REQUIRE(maps.poly_of_vert.size() == vert_index_bound(m));
    std::size_t next = 0;
    for (const auto v : verts(m)) {
      const poly_id cell = maps.poly_of_vert[index_of(m, v)];
      const bool has_cell = count(adj_v2p(m, v)) > 0 && (boundary != dual_boundary::discarded || !is_boundary(m, v));
      CHECK(cell.is_none() == !has_cell);
      if (has_cell) CHECK(cell.raw() == next++);
      const vert_id own = maps.vert_of_vert[index_of(m, v)];
      if (!own.is_none()) CHECK(point(d, own) == point(m, v));
      if (boundary != dual_boundary::closed || arity_v<M> != 0) CHECK((boundary == dual_boundary::clipped && has_cell && is_boundary(m, v)) == !own.is_none());
    }
    CHECK(next == num_polys(d));
    for (const auto p : polys(m)) {
      const vert_id x = maps.vert_of_poly[index_of(m, p)];
      if (x.is_none()) CHECK(boundary == dual_boundary::discarded);
      else CHECK(norm(point(d, x) - centroid(m, p)) < 1e-14);
    }
    for (const auto e : edges(m)) {
      const auto [a, b] = end_verts(m, e);
      const vert_id middle = maps.vert_of_edge[index_of(m, e)];
      if (!middle.is_none()) CHECK(norm(point(d, middle) - (point(m, a) + point(m, b)) / 2) < 1e-14);
      if constexpr (VolumeMesh<M>) {
        const face_id f = maps.face_of_edge[index_of(m, e)];
        if (f.is_none()) continue;
        for (const auto v : {a, b}) {
          const poly_id cell = maps.poly_of_vert[index_of(m, v)];
          bool found = cell.is_none();
          if (!found)
            for (const auto g : adj_p2f(d, cell)) found = found || g == f;
          CHECK(found);
        }
      }
    }
    if constexpr (VolumeMesh<M>)
      for (const auto f : faces(m))
        if (const vert_id x = maps.vert_of_face[index_of(m, f)]; !x.is_none()) CHECK(norm(point(d, x) - centroid(m, f)) < 1e-14);
  }
}

TEST_CASE_TEMPLATE("dual_mesh: the dual of a selected region", M, CONCINO_KINDS) {
  const M m = grid<M>(3);
  const auto chosen = [&](const poly_t<M>& p) { return centroid(m, p).x < 0.6; };
  const auto region = submesh(m, chosen);
  double size = 0;
  for (const auto p : polys(region)) size += measure(m, p);
  dual_maps maps;
  const auto d = dual_mesh(region, {.crease_angle_deg = 10, .maps = &maps});
  check_sound(d);
  CHECK(total_measure(d) > 0);
  CHECK(num_polys(d) == num_verts(region));
  if constexpr (arity_v<M> != 0) CHECK(total_measure(d) == doctest::Approx(size).epsilon(1e-12));
  for (const auto v : verts(region)) CHECK(!maps.poly_of_vert[index_of(region, v)].is_none());
}

TEST_CASE("dual_mesh: lists cells that come out inverted") {
  const box b{{0, 0, 0}, {1, 1, 1}};
  std::size_t listed = 0;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const polyhedralmesh m = voronoi_polyhedra(random_points(20, b, seed), b);
    std::vector<poly_id> inverted = {poly_id{99}}, expected;
    const polyhedralmesh d = dual_mesh(m, {.inverted = &inverted});
    for (const poly_id p : polys(d))
      if (!(measure(d, p) > 0)) expected.push_back(p);
    CHECK(inverted == expected);
    listed += inverted.size();
  }
  CHECK(listed > 0);

  // A vert with one neighbour that is far away: with circumcentres its cell turns over.
  const trimesh fan({{0, 0, 0}, {6, 0, 0}, {1, 1, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}},
                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 8}, {0, 8, 1}});
  std::vector<poly_id> inverted;
  dual_maps maps;
  const polygonmesh d = dual_mesh(fan, {.boundary = dual_boundary::discarded, .points = dual_points::circumcentres, .maps = &maps, .inverted = &inverted});
  REQUIRE(num_polys(d) == 1);
  CHECK(area_vector(d, poly_id{0}).z < 0);
  CHECK(inverted == std::vector{maps.poly_of_vert[0]});
  CHECK(num_polys(dual_mesh(fan, {.inverted = &inverted})) == 9);
  CHECK(inverted.empty());  // centroids lie in their triangles, so cells see their verts
}

TEST_CASE("dual_mesh: refuses options that contradict each other, and circumcentres of other polys; the maps are unchanged") {
  dual_maps maps;
  maps.poly_of_vert = {poly_id{5}};
  const tetmesh m = grid<tetmesh>(1);
  const auto creases = make_edge_map<bool>(m, true);
  for (const double angle : {-1.0, std::numeric_limits<double>::quiet_NaN()})
    CHECK_THROWS_AS((void)dual_mesh(m, {.crease_angle_deg = angle, .maps = &maps}), invalid_argument);
  CHECK_THROWS_AS((void)dual_mesh(m, creases, {.boundary = dual_boundary::closed, .maps = &maps}), invalid_argument);
  CHECK_THROWS_AS((void)dual_mesh(m, creases, {.crease_angle_deg = 20, .maps = &maps}), invalid_argument);
  CHECK_THROWS_WITH_AS((void)dual_mesh(grid<hexmesh>(1), {.points = dual_points::circumcentres, .maps = &maps}),
                       "circumcentre: poly 0 has 8 verts; only triangles and tets have one", invalid_argument);
  const tetmesh flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2, 3}});
  CHECK_THROWS_AS((void)dual_mesh(flat, {.points = dual_points::circumcentres, .maps = &maps}), invalid_mesh);
  CHECK(maps.poly_of_vert == std::vector{poly_id{5}});
}
