#include <concino/generate/voxel_hexes.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/generate/box.hpp>
#include <concino/generate/sphere.hpp>
#include <concino/generate/torus.hpp>
#include <concino/generate/unite.hpp>

#include <support/generated.hpp>
#include <support/kinds.hpp>
#include <support/same_mesh.hpp>
#include <support/threads.hpp>

#include <limits>

using namespace concino;
using namespace concino::testing;

namespace {

/// Whether all hexes are cubes of this size whose centres are inside, and no other cube of the lattice is inside: by testing each centre.
template<class M>
void check_voxels(const M& m, const hexmesh& v, double size, std::size_t expected) {
  CHECK(check_laws(v).empty());
  CHECK(num_polys(v) == expected);
  const auto tree = bounding_tree(m);
  for (const poly_id p : polys(v)) {
    CHECK(measure(v, p) == doctest::Approx(size * size * size).epsilon(1e-9));
    vec3 centre;
    for (const vert_id x : adj_p2v(v, p)) centre += 0.125 * to_vec3(point(v, x));
    CHECK(tree.is_inside(centre));
  }
}

}  // namespace

TEST_CASE_TEMPLATE("voxel_hexes: a box is filled exactly", M, CONCINO_SURFACE_KINDS) {
  const M m = make_box<M>({.cells = {2, 2, 2}, .min = {-1, 0, 3}, .max = {3, 2, 4}});
  const hexmesh v = voxel_hexes(m, 8);
  check_sound(v, 1);
  CHECK(num_polys(v) == 8 * 4 * 2);
  CHECK(total_measure(v) == doctest::Approx(8).epsilon(1e-12));
  CHECK(point(v, vert_id{0}) == vec3{-1, 0, 3});
  CHECK(point(v, vert_id{num_verts(v) - 1}) == vec3{3, 2, 4});
  CHECK(record_of(voxel_hexes(only_embedded_mesh(m), 8)) == record_of(v));
  CHECK(num_polys(voxel_hexes(m, 1)) == 1);
  CHECK(num_polys(voxel_hexes(M(), 5)) == 0);
}

TEST_CASE("voxel_hexes: the cubes whose centres are inside, at any scale and with any number of threads") {
  for (const double scale : {1.0, 1e-120, 1e80}) {
    const trimesh m = make_torus<trimesh>({.cells = {20, 12}, .radius = scale, .tube_radius = 0.4 * scale, .centre = {0.1 * scale, 0, 0}});
    const hexmesh v = voxel_hexes(m, 21);
    std::size_t inside = 0;
    const double size = 2.8 * scale / 21;
    const auto tree = bounding_tree(m);
    vec3 low, high;
    for (const vert_id x : verts(m))
      for (const std::size_t k : {0u, 1u, 2u}) low[k] = std::min(low[k], to_vec3(point(m, x))[k]), high[k] = std::max(high[k], to_vec3(point(m, x))[k]);
    const vec3 middle = 0.5 * (low + high);
    for (int i = -10; i <= 10; ++i)
      for (int j = -10; j <= 10; ++j)
        for (int k = -3; k < 3; ++k) inside += tree.is_inside(middle + size * vec3{i, j, k + 0.5});
    if (scale == 1) check_voxels(m, v, size, inside);
    CHECK(num_polys(v) == inside);
    CHECK(euler(v) == 0);
  }
  const trimesh m = make_torus<trimesh>({.cells = {20, 12}});
  const auto with_threads = [&](int n) {
    const with_num_threads threads(n);
    return record_of(voxel_hexes(m, 40));
  };
  CHECK(with_threads(1) == with_threads(4));
}

TEST_CASE("voxel_hexes: the volume tends to that of the surface") {
  const quadmesh m = make_sphere<quadmesh>({.cells = 12});
  CHECK(total_measure(voxel_hexes(m, 32)) == doctest::Approx(4.18879).epsilon(0.02));
}

TEST_CASE("voxel_hexes: nested surfaces by either rule") {
  const trimesh outer = make_box<trimesh>({.cells = {1, 1, 1}, .min = {0, 0, 0}, .max = {6, 6, 6}});
  const trimesh inner = make_box<trimesh>({.cells = {1, 1, 1}, .min = {2, 2, 2}, .max = {4, 4, 4}});
  const trimesh both = unite(outer, inner);
  CHECK(num_polys(voxel_hexes(both, 6)) == 216);
  CHECK(num_polys(voxel_hexes(both, 6, {.rule = inside_rule::parity})) == 208);
}

TEST_CASE("voxel_hexes: centres on the surface, of which some columns see polygons edge-on only") {
  const auto box_of = [](const vec3& min, const vec3& max) { return make_box<quadmesh>({.cells = {2, 1, 3}, .min = min, .max = max}); };
  const quadmesh parts = unite(unite(box_of({0, 0, 0}, {6, 6, 6}), box_of({1.5, 1.5, 1.5}, {4.5, 4.5, 4.5})), box_of({2.5, 1, 2.5}, {3.5, 5.5, 3.25}));
  const auto tree = bounding_tree(parts);
  for (const inside_rule rule : {inside_rule::winding, inside_rule::parity}) {
    std::size_t inside = 0;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 6; ++j)
        for (int k = 0; k < 6; ++k) inside += tree.is_inside(vec3{i + 0.5, j + 0.5, k + 0.5}, {rule});
    CHECK(num_polys(voxel_hexes(parts, 6, {.rule = rule})) == inside);
    CHECK((inside == 216) == (rule == inside_rule::winding));
  }
}

TEST_CASE("voxel_hexes: errors name what is wrong") {
  const trimesh closed = make_sphere<trimesh>({.cells = 2});
  CHECK_THROWS_WITH_AS(voxel_hexes(closed, 0), "voxel_hexes: n is 0; it must be at least 1", invalid_argument);
  CHECK_THROWS_WITH_AS(voxel_hexes(closed, 1100), "voxel_hexes: n is 1100, which asks for more than 2^30 cubes; choose a smaller one", invalid_argument);
  CHECK_THROWS_WITH_AS(voxel_hexes(grid<trimesh>(2), 4), doctest::Contains("voxel_hexes: the surface is open at edge "), invalid_mesh);
  trimesh bad = closed;
  set_point(bad, vert_id{0}, vec3{0, std::nan(""), 0});
  CHECK_THROWS_AS(voxel_hexes(bad, 4), invalid_mesh);
  for (const vert_id v : verts(bad)) set_point(bad, v, vec3{1, 1, 1});
  CHECK_THROWS_WITH_AS(voxel_hexes(bad, 4), "voxel_hexes: the surface has the size 0; it must be finite and above 0", invalid_mesh);
}
