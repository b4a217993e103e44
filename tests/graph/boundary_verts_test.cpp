// boundary_verts marks the verts on the boundary.
#include <concino/graph/boundary_verts.hpp>

#include <concino/concepts/archetypes.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("boundary_verts: are the verts on the boundary of a grid, as is_boundary says", M, CONCINO_KINDS) {
  const M m = grid<M>(4), none;
  const auto on_boundary = boundary_verts(m);
  std::size_t inside = 0;
  for (const auto v : verts(m)) {
    CHECK(on_boundary[v] == is_boundary(m, v));
    inside += !on_boundary[v];
  }
  CHECK(inside > 0);
  CHECK(inside < num_verts(m));
  CHECK(boundary_verts(none).values().empty());
}

TEST_CASE("boundary_verts: facets with three polys and isolated verts are not on the boundary") {
  const trimesh book({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {5, 5, 5}}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const auto on_boundary = boundary_verts(book);
  for (const unsigned v : {0u, 1u, 2u, 3u, 4u}) CHECK(on_boundary[vert_id{v}]);  // 0 and 1 have other edges on the boundary
  CHECK(!on_boundary[vert_id{5}]);
}
