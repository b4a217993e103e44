// voronoi_polyhedra inside convex surfaces.
#include <concino/concepts/archetypes.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/icosphere.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/quadmesh.hpp>
#include <concino/mesh/trimesh.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/corpus.hpp>

#include <cmath>

using namespace concino;
using namespace concino::testing;

namespace {

double enclosed(const auto& surface) {
  double sum = 0;
  for (const auto p : polys(surface)) {
    const polygon_shape s = shape_of(surface, adj_p2v(surface, p));
    sum += dot(s.mean, s.area) / 3;
  }
  return sum;
}

/// Random points inside a surface around the origin that contains the sphere of this radius.
std::vector<vec3> points_in_ball(std::size_t n, double radius) {
  std::vector<vec3> sites;
  for (const vec3& x : random_points(8 * n + 50, {{-1, -1, -1}, {1, 1, 1}}, 5))
    if (norm(x) < 1 && sites.size() < n) sites.push_back(radius * x);
  return sites;
}

template<class S>
void check_inside(const S& surface, const std::vector<vec3>& sites, std::size_t walls) {
  const polyhedralmesh m = voronoi_polyhedra(sites, surface);
  REQUIRE(num_polys(m) == sites.size());
  CHECK(check_laws(m).empty());
  CHECK(static_cast<long>(num_verts(m) + num_faces(m)) - static_cast<long>(num_edges(m) + num_polys(m)) == 1);
  CHECK(total_measure(m) == doctest::Approx(std::abs(enclosed(surface))).epsilon(1e-11));
  if (sites.size() == 1) CHECK(num_faces(m) == walls);
  bool planar = true, on_surface = true;
  for (const face_id f : faces(m)) {
    const polygon_shape s = shape_of(m, adj_f2v(m, f));
    for (const vert_id v : adj_f2v(m, f)) planar = planar && std::abs(dot(point(m, v) - s.mean, s.area)) <= 1e-11;
    if (!is_boundary(m, f)) continue;
    double nearest = 1;  // to a plane of the surface
    for (const auto p : polys(surface)) {
      const polygon_shape w = shape_of(surface, adj_p2v(surface, p));
      double farthest = 0;
      for (const vert_id v : adj_f2v(m, f)) farthest = std::max(farthest, std::abs(dot(point(m, v) - w.mean, w.area)) / norm(w.area));
      nearest = std::min(nearest, farthest);
    }
    on_surface = on_surface && nearest < 1e-10;
  }
  CHECK(planar);
  CHECK(on_surface);
}

}  // namespace

TEST_CASE("voronoi_polyhedra in a surface: cells fill it, and their outer faces are in its planes") {
  const trimesh ball = icosphere(1), box_of_triangles = make_box<trimesh>({.cells = {3, 2, 1}, .min = {-1, -1, -1}, .max = {1, 1, 1}});
  const std::vector<vec3> octahedron_points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const std::vector<std::vector<unsigned>> octahedron_polys{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const trimesh octahedron(octahedron_points, octahedron_polys);
  for (const std::size_t n : {1u, 2u, 100u}) {
    check_inside(ball, points_in_ball(n, 0.75), 80);
    check_inside(octahedron, points_in_ball(n, 0.55), 8);
    check_inside(box_of_triangles, points_in_ball(n, 0.99), 6);
  }
}

TEST_CASE("voronoi_polyhedra in a surface: sites on lattices, whose cells touch the planes of the surface in common points") {
  const std::vector<vec3> octahedron_points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  const std::vector<std::vector<unsigned>> octahedron_polys{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  const trimesh octahedron(octahedron_points, octahedron_polys), ball = icosphere(1);
  for (const int n : {2, long_run() ? 10 : 4}) {
    std::vector<vec3> sites;
    for (int x = -n; x <= n; ++x)
      for (int y = -n; y <= n; ++y)
        for (int z = -n; z <= n; ++z)
          if (std::abs(x) + std::abs(y) + std::abs(z) <= n) sites.push_back(vec3{x, y, z} / n);  // corners of the octahedron too
    const polyhedralmesh m = voronoi_polyhedra(sites, octahedron);
    CHECK(check_laws(m).empty());
    CHECK(num_polys(m) == sites.size());
    CHECK(total_measure(m) == doctest::Approx(4 / 3.0).epsilon(1e-11));
    for (const poly_id p : polys(m)) CHECK(volume(m, p) > 0);
    for (vec3& x : sites) x *= 0.9;
    CHECK(total_measure(voronoi_polyhedra(sites, ball)) == doctest::Approx(enclosed(ball)).epsilon(1e-11));
  }
}

TEST_CASE("voronoi_polyhedra in a surface: a box gives what the box gives") {
  const box unit{{0, 0, 0}, {1, 1, 1}};
  const auto sites = random_points(100, unit, 3);
  const auto walls = make_box<quadmesh>({.cells = {2, 2, 2}});
  const polyhedralmesh a = voronoi_polyhedra(sites, unit, {.relax = 2}), b = voronoi_polyhedra(sites, walls, {.relax = 2});
  CHECK(num_verts(a) == num_verts(b));
  CHECK(num_faces(a) == num_faces(b));
  for (const poly_id p : polys(a)) CHECK(volume(a, p) == doctest::Approx(volume(b, p)).epsilon(1e-9));
  std::vector<vec3> lattice;  // with sites on the boundary, at corners too
  for (int i = 0; i < 27; ++i) lattice.push_back(vec3{i % 3, i / 3 % 3, i / 9} / 2);
  const polyhedralmesh bricks = voronoi_polyhedra(lattice, walls);
  CHECK(num_polys(bricks) == 27);
  CHECK(num_verts(bricks) == 64);
  CHECK(total_measure(bricks) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("voronoi_polyhedra in a surface: relaxed cells of a ball are more equal") {
  const trimesh ball = icosphere(2);
  const auto sites = points_in_ball(60, 0.9);
  const auto spread = [&](unsigned rounds) {
    const polyhedralmesh m = voronoi_polyhedra(sites, ball, {.relax = rounds});
    CHECK(total_measure(m) == doctest::Approx(enclosed(ball)).epsilon(1e-11));
    double least = 1, most = 0;
    for (const poly_id p : polys(m)) {
      least = std::min(least, volume(m, p));
      most = std::max(most, volume(m, p));
    }
    return most / least;
  };
  const double before = spread(0), after = spread(12);
  CHECK(after < 2);
  CHECK(after < before / 3);
}

TEST_CASE("voronoi_polyhedra in a surface: inward orientation, any scale") {
  const trimesh ball = icosphere(1);
  const auto sites = points_in_ball(20, 0.7);
  const double whole = total_measure(voronoi_polyhedra(sites, ball));
  CHECK(total_measure(voronoi_polyhedra(sites, only_embedded_mesh(ball))) == whole);
  for (const double scale : {1e-8, 1e8}) {
    std::vector<vec3> points, scaled;
    std::vector<std::vector<unsigned>> triangles;
    for (const vert_id v : verts(ball)) points.push_back(scale * point(ball, v));
    for (const poly_id p : polys(ball)) {
      const auto v = adj_p2v(ball, p);
      triangles.push_back({v[0].raw(), v[2].raw(), v[1].raw()});
    }
    for (const vec3& x : sites) scaled.push_back(scale * x);
    CHECK(total_measure(voronoi_polyhedra(scaled, trimesh(points, triangles))) == doctest::Approx(whole * scale * scale * scale));
  }
}

TEST_CASE("voronoi_polyhedra in a surface: errors") {
  const trimesh ball = icosphere(1);
  CHECK_THROWS_WITH_AS(voronoi_polyhedra({{0, 0, 0}, {0.8, 0.8, 0.8}}, ball), "Voronoi diagram: site 1 lies outside of the surface", invalid_argument);
  CHECK_THROWS_AS(voronoi_polyhedra({{0, 0, 0}, {5, 0, 0}}, ball), invalid_argument);
  CHECK_THROWS_AS(voronoi_polyhedra({{0, 0, 0}}, make_torus<trimesh>()), invalid_mesh);
  CHECK_THROWS_WITH_AS(voronoi_polyhedra({{0, 0, 0}}, trimesh()), "Voronoi diagram: the surface has no polys", invalid_mesh);
  const std::vector<vec3> tet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const vec3 inside{0.1, 0.1, 0.1};
  const std::vector<std::vector<unsigned>> open{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}, flipped{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 3, 0}};
  CHECK_THROWS_WITH_AS(voronoi_polyhedra({inside}, trimesh(tet, open)), "Voronoi diagram: poly 0 of the surface is at a boundary edge; the surface must be closed", invalid_mesh);
  CHECK_THROWS_AS(voronoi_polyhedra({inside}, trimesh(tet, flipped)), invalid_mesh);
  std::vector<vec3> two = tet;
  for (const vec3& x : tet) two.push_back(x + vec3{5, 0, 0});
  const std::vector<std::vector<unsigned>> both{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 6, 5}, {4, 5, 7}, {5, 6, 7}, {6, 4, 7}};
  CHECK_THROWS_WITH_AS(voronoi_polyhedra({inside}, trimesh(two, both)), "Voronoi diagram: the surface has 2 pieces; it must have one", invalid_mesh);
  quadmesh bent = make_box<quadmesh>({.cells = {1, 1, 1}});
  set_point(bent, vert_id{0}, vec3{0.1, 0.1, 0.2});
  CHECK_THROWS_WITH_AS(voronoi_polyhedra({{0.5, 0.5, 0.5}}, bent), "Voronoi diagram: poly 0 of the surface is not planar", invalid_mesh);
  std::vector<vec3> more = tet;
  more.push_back({0.5, 0, 0});
  const std::vector<std::vector<unsigned>> flat{{0, 2, 1}, {0, 1, 4}, {0, 4, 3}, {4, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  CHECK_THROWS_WITH_AS(voronoi_polyhedra({inside}, trimesh(more, flat)), "Voronoi diagram: poly 1 of the surface has no area", invalid_mesh);
  more = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}};
  const std::vector<std::vector<unsigned>> joined{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {4, 0, 5}};
  CHECK_THROWS_AS(voronoi_polyhedra({inside}, trimesh(more, joined)), invalid_mesh);
  std::vector<vec3> twice{{0, 0, 1}, {0, 0, -1}};  // an octahedron around which the surface winds twice
  std::vector<std::vector<unsigned>> winding;
  const vec3 corners[]{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  for (unsigned k = 0; k < 8; ++k) {
    twice.push_back(corners[k % 4]);
    winding.push_back({0, 2 + k, 2 + (k + 1) % 8});
    winding.push_back({1, 2 + (k + 1) % 8, 2 + k});
  }
  CHECK_THROWS_WITH_AS(voronoi_polyhedra({{0, 0, 0}}, trimesh(twice, winding)), "voronoi_polyhedra: the surface is not convex: it winds around its inside more than once", invalid_mesh);
  trimesh infinite = icosphere(0);
  set_point(infinite, vert_id{0}, vec3{std::nan(""), 0, 0});
  CHECK_THROWS_AS(voronoi_polyhedra({{0, 0, 0}}, infinite), invalid_mesh);
}
