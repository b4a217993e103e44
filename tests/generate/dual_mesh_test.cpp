#include <concino/generate/dual_mesh.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/random_points.hpp>
#include <concino/generate/voronoi_polyhedra.hpp>
#include <concino/io/load.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>

using namespace concino;
using namespace concino::testing;

namespace {

template<class R>
std::size_t count(const R& r) {
  std::size_t n = 0;
  for ([[maybe_unused]] const auto x : r) ++n;
  return n;
}

template<class M>
long euler(const M& m) {
  long chi = static_cast<long>(num_verts(m)) - static_cast<long>(num_edges(m));
  if constexpr (VolumeMesh<M>) chi += static_cast<long>(num_faces(m));
  return chi + (VolumeMesh<M> ? -1 : 1) * static_cast<long>(num_polys(m));
}

/// Checks the laws. In volumes each cell must be a sphere, and those of regular meshes must be oriented outward.
template<class M>
void check_sound(const M& m, bool regular = true) {
  CHECK(check_laws(m).empty());
  if constexpr (VolumeMesh<M>) {
    bool spheres = true, positive = true;
    for (const auto p : polys(m)) {
      spheres = spheres && count(adj_p2v(m, p)) + count(adj_p2f(m, p)) == count(adj_p2e(m, p)) + 2;
      positive = positive && volume(m, p) > 0;
    }
    for (const auto f : faces(m)) spheres = spheres && count(adj_f2p(m, f)) > 0 && count(adj_f2p(m, f)) < 3;
    CHECK(spheres);
    CHECK((positive || !regular));
  }
}

template<class M>
void refused(const M& m, const std::string& why) {
  try {
    (void)dual_mesh(m);
    FAIL("not refused");
  } catch (const invalid_mesh& e) {
    CHECK_MESSAGE(std::string(e.what()).find(why) != std::string::npos, e.what());
  }
}

/// For each vert the indices of the polys around it.
template<class M>
std::vector<std::vector<std::size_t>> stars(const M& m) {
  std::vector<std::vector<std::size_t>> all;
  for (const auto v : verts(m)) {
    all.emplace_back();
    for (const auto p : adj_v2p(m, v)) all.back().push_back(index_of(m, p));
    std::sort(all.back().begin(), all.back().end());
  }
  return all;
}
template<class M>
std::vector<std::vector<std::size_t>> cells(const M& m) {
  std::vector<std::vector<std::size_t>> all;
  for (const auto p : polys(m)) {
    all.emplace_back();
    for (const auto v : adj_p2v(m, p)) all.back().push_back(index_of(m, v));
    std::sort(all.back().begin(), all.back().end());
  }
  return all;
}

}  // namespace

TEST_CASE_TEMPLATE("dual_mesh: clipped, it has a poly for each vert and the measure of the mesh", M, CONCINO_KINDS) {
  for (const auto& arrays : {grid_arrays<M>(1), grid_arrays<M>(3), two_grids_arrays<M>(2)}) {
    const M m(arrays);
    const auto d = dual_mesh(m);
    check_sound(d);
    CHECK(total_measure(d) == doctest::Approx(total_measure(m)).epsilon(1e-12));
    std::size_t with_polys = 0, i = 0;
    for (const auto v : verts(m)) with_polys += count(adj_v2p(m, v)) > 0;
    CHECK(num_polys(d) == with_polys);
    CHECK(euler(d) == euler(m) - static_cast<long>(num_verts(m) - with_polys));
    for (const auto p : polys(m)) CHECK(norm(point(d, vert_id{i++}) - centroid(m, p)) < 1e-14);
    i = 0;
    for (const auto v : verts(m)) {  // each cell contains the centroids of the polys around its vert
      if (count(adj_v2p(m, v)) == 0) continue;
      std::size_t found = 0;
      for (const auto x : adj_p2v(d, poly_id{i})) found += x.raw() < num_polys(m);
      CHECK(found == count(adj_v2p(m, v)));
      ++i;
    }
  }
}

TEST_CASE_TEMPLATE("dual_mesh: discarded, only interior verts have cells", M, CONCINO_KINDS) {
  const M m = grid<M>(4);
  const auto d = dual_mesh(m, {.boundary = dual_boundary::discarded});
  check_sound(d);
  std::size_t inner = 0;
  for (const auto v : verts(m)) {
    const vec3 x = point(m, v);
    inner += x.x > 0 && x.x < 1 && x.y > 0 && x.y < 1 && (SurfaceMesh<M> || (x.z > 0 && x.z < 1));
  }
  CHECK(num_polys(d) == inner);
  CHECK(euler(d) == 1);
  for (const auto v : verts(d)) CHECK(count(adj_v2p(d, v)) > 0);
  CHECK(total_measure(d) < 1);
  const auto none = dual_mesh(grid<M>(1), {.boundary = dual_boundary::discarded});
  if constexpr (arity_v<M> > 0) CHECK((num_verts(none) == 0 && num_polys(none) == 0));
}

TEST_CASE_TEMPLATE("dual_mesh: has the same result on the archetype", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto d = dual_mesh(m), e = dual_mesh(only_embedded_mesh(m));
  REQUIRE(num_verts(e) == num_verts(d));
  REQUIRE(num_polys(e) == num_polys(d));
  for (const auto v : verts(d)) CHECK(norm(point(d, v) - point(e, v)) < 1e-14);
  for (const auto p : polys(d)) CHECK(measure(e, p) == doctest::Approx(measure(d, p)));
}

TEST_CASE_TEMPLATE("dual_mesh: scales exactly; empty meshes have an empty dual", M, CONCINO_KINDS) {
  const auto arrays = jittered(grid_arrays<M>(2), 0.02);
  const auto d = dual_mesh(M(arrays));
  for (const double scale : {0x1p-20, 0x1p20}) {
    auto scaled = arrays;
    for (vec3& x : scaled.points) x *= scale;
    const auto s = dual_mesh(M(scaled));
    for (const auto v : verts(d)) CHECK(point(s, v) == scale * point(d, v));
  }
  CHECK(num_polys(dual_mesh(M())) == 0);
}

TEST_CASE("dual_mesh: cube and octahedron are dual to each other") {
  const quadmesh cube({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                      {{0, 3, 2, 1}, {1, 2, 6, 5}, {4, 5, 6, 7}, {3, 0, 4, 7}, {0, 1, 5, 4}, {2, 3, 7, 6}});
  const polygonmesh octahedron = dual_mesh(cube);
  check_sound(octahedron);
  CHECK(num_verts(octahedron) == 6);
  CHECK(num_edges(octahedron) == 12);
  CHECK(num_polys(octahedron) == 8);
  for (const auto p : polys(octahedron)) {
    CHECK(count(adj_p2v(octahedron, p)) == 3);
    CHECK(dot(area_vector(octahedron, p), centroid(octahedron, p) - vec3{0.5, 0.5, 0.5}) > 0);  // oriented outward, as the cube
  }
  const polygonmesh again = dual_mesh(octahedron);
  CHECK(num_polys(again) == 6);
  CHECK(cells(again) == cells(cube));
}

TEST_CASE("dual_mesh: on closed surfaces the dual of the dual has the connectivity of the mesh") {
  for (const char* name : {"tri/bunny.obj", "tri/torus.obj", "quad/bamboo_pen_genus8.obj", "polygon/dodecahedron.obj", "quad/ring.off"}) {
    CAPTURE(name);
    const auto file = corpus(name);
    if (file.empty()) continue;
    const auto m = load<polygonmesh>(file);
    bool closed = true;
    for (const auto e : edges(m)) closed = closed && count(adj_e2p(m, e)) == 2;
    const polygonmesh d = dual_mesh(m);
    CHECK(check_laws(d).empty());
    CHECK(euler(d) == euler(m));
    if (!closed) continue;
    CHECK(num_verts(d) == num_polys(m));
    CHECK(num_edges(d) == num_edges(m));
    CHECK(num_polys(d) == num_verts(m));
    CHECK(cells(d) == stars(m));
    const polygonmesh again = dual_mesh(d);
    CHECK(cells(again) == cells(m));
  }
}

TEST_CASE("dual_mesh: works on the boundary of a volume, a view") {
  const tetmesh m = grid<tetmesh>(2);
  const auto skin = boundary(m);
  const polygonmesh d = dual_mesh(skin);
  check_sound(d);
  CHECK(euler(d) == 2);
  CHECK(num_polys(d) == num_verts(skin));
  CHECK(num_verts(d) == num_polys(skin));
}

TEST_CASE("dual_mesh: works on volumes with any boundary") {
  box b;
  b.min = {0, 0, 0};
  b.max = {2, 1, 1};
  const polyhedralmesh v = voronoi_polyhedra(random_points(40, b, 3), b);
  const polyhedralmesh d = dual_mesh(v);
  check_sound(d, false);
  CHECK(num_polys(d) == num_verts(v));
  CHECK(total_measure(d) == doctest::Approx(2).epsilon(1e-12));
  CHECK(euler(d) == 1);
  // each edge between interior verts has a face, which separates the cells of its ends
  for (const auto x : verts(v)) {
    bool inner = true;
    for (const auto f : adj_v2f(v, x)) inner = inner && count(adj_f2p(v, f)) == 2;
    if (inner) CHECK(count(adj_p2f(d, poly_id{x.raw()})) == count(adj_v2e(v, x)));
  }
}

TEST_CASE("dual_mesh: works on a real volume") {
  CONCINO_CORPUS_OR_SKIP(file, "tet/quarter_crown.mesh");
  const auto crown = load<tetmesh>(file);
  const polyhedralmesh c = dual_mesh(crown);
  CHECK(check_laws(c).empty());
  CHECK(euler(c) == euler(crown));
  CHECK(total_measure(c) == doctest::Approx(total_measure(crown)).epsilon(1e-12));
}

TEST_CASE("dual_mesh: polys that share several facets are connected through each of them") {
  const polygonmesh lens({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 1, 0}, {0, 2, 0}}, {{0, 1, 2, 3}, {0, 3, 4}});
  check_sound(dual_mesh(lens));
  const polygonmesh pocket({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}}, {{0, 1, 2, 4}, {0, 4, 2, 3}});  // vert 4 has only two polys
  const polygonmesh d = dual_mesh(pocket);
  check_sound(d);
  CHECK(num_polys(d) == 5);
  CHECK(count(adj_p2v(d, poly_id{4})) == 4);
  CHECK(total_measure(d) == doctest::Approx(4).epsilon(1e-14));
  const polygonmesh pillow({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
  const polygonmesh e = dual_mesh(pillow);
  CHECK(check_laws(e).empty());
  CHECK(euler(e) == 2);
}

TEST_CASE("dual_mesh: works on non-orientable surfaces") {
  CONCINO_CORPUS_OR_SKIP(file, "quad/moebius.obj");
  const auto m = load<quadmesh>(file);
  const polygonmesh d = dual_mesh(m);
  CHECK(check_laws(d).empty());
  CHECK(euler(d) == 0);
  CHECK(num_polys(d) == num_verts(m));
}

TEST_CASE("dual_mesh: throws if the mesh is not manifold, not closed or not finite") {
  refused(polygonmesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), "edge 0 has more than two polys");
  refused(trimesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{1, 2, 0}, {3, 4, 0}}), "vert 0 do not form a single fan");
  refused(trimesh({{0, 0, 0}, {1, 0, 0}, {0, std::numeric_limits<double>::quiet_NaN(), 0}}, {{0, 1, 2}}), "poly 0");

  const std::vector<vec3> x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  refused(tetmesh(x, std::vector<std::vector<unsigned>>{{0, 1, 2, 3}, {0, 2, 1, 6}, {2, 1, 0, 4}}), "has more than two polys");
  refused(tetmesh(x, std::vector<std::vector<unsigned>>{{0, 1, 2, 3}, {0, 1, 6, 5}}), "do not form a single fan");   // not manifold at an edge
  refused(tetmesh(x, std::vector<std::vector<unsigned>>{{0, 1, 2, 3}, {0, 4, 5, 6}}), "vert 0 do not form a single ball");
  const polyhedralmesh open({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}, {{{0, true}, {1, true}, {2, true}}});
  refused(open, "poly 0 is not closed");
}

TEST_CASE("dual_mesh: throws on real surfaces that are not manifold") {
  const auto is_invalid = [](const auto& m) { CHECK_THROWS_AS((void)dual_mesh(m), invalid_mesh); };
  is_invalid(load<trimesh>(corpus("tri/hourglass_nonmanifold_vertex.obj")));
  is_invalid(load<trimesh>(corpus("tri/fan3_nonmanifold_edge.obj")));
}
