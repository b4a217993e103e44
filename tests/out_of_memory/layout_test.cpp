// A collapse or insertion of a chord or sheet that throws std::bad_alloc at any of its allocations changes neither the mesh nor its properties.
#include <concino/edit.hpp>
#include <concino/generate/grid.hpp>
#include <concino/layout.hpp>

#include <support/all_or_nothing.hpp>
#include <support/sheet_edits.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

TEST_CASE_TEMPLATE("a collapse and an insertion that run out of memory change nothing", M, cn::quadmesh, cn::hexmesh) {
  M m = cn::make_grid<M>({.cells = {2, 2, 2}});
  cn::testing::give_properties(m);
  const auto collapse = [](M& x) { cn::testing::collapse_layer(x, cn::testing::layer_through(x, cn::edge_id{0})); };
  CHECK(cn::testing::all_or_nothing(m, collapse) > 10);
  const auto insert = [](M& x) {
    const auto at = cn::testing::facets_of(cn::testing::collapse_layer(x, cn::testing::layer_through(x, cn::edge_id{0})));
    if constexpr (cn::SurfaceMesh<M>) cn::insert_chord(x, at, {.keep = {cn::min_quality(0.1)}});
    else cn::insert_sheet(x, at, {.keep = {cn::min_quality(0.1)}});
  };
  const std::vector<cn::poly_id> one{cn::poly_id{0}};
  CHECK(cn::testing::all_or_nothing(m, [&](M& x) { cn::pillow(x, one); }, 100) > 10);
  const auto recorded = [&](M& x) {
    cn::transaction t(x);
    insert(x);
    cn::pillow(x, std::vector{*cn::polys(x).begin()}, {.keep = {cn::no_inversion, cn::protect_edges(x, [](cn::edge_id) { return false; })}});
    t.commit();
  };
  M numbers = cn::make_grid<M>({.cells = {2, 2, 1}});  // a transaction needs values that can be copied byte by byte
  cn::vert_property<double>(numbers, "a");
  cn::poly_property<int>(numbers, "d");
  CHECK(cn::testing::all_or_nothing(numbers, recorded, 50) > 10);  // of some thousand allocations
  if constexpr (cn::SurfaceMesh<M>) CHECK(cn::testing::all_or_nothing(m, [](M& x) { cn::diagonal_collapse(x, cn::poly_id{3}, cn::vert_id{4}); }) > 10);
}
