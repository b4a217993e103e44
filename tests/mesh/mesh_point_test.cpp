#include <concino/mesh/mesh_point.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

using namespace concino;
using namespace concino::testing;

TEST_CASE_TEMPLATE("mesh_point: distinguishes verts, edges and polys", M, CONCINO_KINDS) {
  const M m = grid<M>(1);
  const mesh_point<M> at_vert{vert_id{0}, point(m, vert_id{0})}, inside{poly_id{0}, {0.25, 0.25, 0.25}};
  const mesh_point<M> along{edge_point<M>{edge_id{2}, 0.5}, {}};
  CHECK(std::get<vert_t<M>>(at_vert.element) == vert_id{0});
  CHECK(std::get<edge_point<M>>(along.element).edge == edge_id{2});
  CHECK(std::get<edge_point<M>>(along.element).parameter == 0.5);
  CHECK(std::get<poly_t<M>>(inside.element) == poly_id{0});
}
