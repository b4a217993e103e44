// Embedding a level set that throws std::bad_alloc at any of its allocations changes neither the mesh, nor its properties.
#include <concino/level_sets/embed_path.hpp>

#include <concino/generate/grid.hpp>
#include <concino/mesh.hpp>

#include <support/all_or_nothing.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <vector>

namespace cn = concino;

TEST_CASE_TEMPLATE("embedding that runs out of memory changes nothing", M, cn::trimesh, cn::tetmesh, cn::polyhedralmesh) {
  M m = cn::make_grid<M>({.cells = {2, 1, 1}});
  if (cn::arity_v<M> != 4) cn::testing::give_properties(m);  // thousands of allocations for the parts of tets
  const auto u = cn::vert_property<double>(m, "a");  // whole() lists its values
  for (const auto v : cn::verts(m)) u[v] = cn::point(m, v).x + 0.3 * cn::point(m, v).y;
  const std::size_t failed = cn::testing::all_or_nothing(m, [](M& x) {
    if constexpr (cn::dimension_v<M> == 3) cn::embed_isosurface(x, "a", 0.45, {.snap = 0.2});
    else cn::embed_isolines(x, "a", 0.45, {.snap = 0.2});
  });
  CHECK(failed > 20);
}

TEST_CASE_TEMPLATE("embedding a path that runs out of memory changes nothing", M, cn::trimesh, cn::polygonmesh) {
  M m = cn::make_grid<M>({.cells = {2, 1, 1}});
  cn::testing::give_properties(m);
  std::vector<cn::edge_point<M>> path;
  for (const auto e : cn::adj_p2e(m, *cn::polys(m).begin())) path.push_back({e, 0.4});
  const std::size_t failed = cn::testing::all_or_nothing(m, [&](M& x) { cn::embed_path(x, path); });
  CHECK(failed > 20);
}
