// A repair that throws std::bad_alloc at any of its allocations changes neither the mesh nor its properties.
#include <concino/edit/elements.hpp>
#include <concino/edit/flip_winding.hpp>
#include <concino/mesh.hpp>
#include <concino/repair.hpp>

#include <support/all_or_nothing.hpp>
#include <support/kinds.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

namespace cn = concino;

TEST_CASE_TEMPLATE("a repair that runs out of memory changes nothing", M, CONCINO_KINDS) {
  M m = cn::testing::grid<M>(2);
  cn::testing::give_properties(m);
  cn::flip_winding(m, cn::poly_id{0});
  cn::add_vert(m, {7, 7, 7});
  cn::add_vert(m, cn::point(m, cn::vert_id{1}));
  const auto mend = [](M& x) { cn::repair(x, {.merge_within = 1e-9, .split_non_manifold = true, .orient = true, .fill_holes = 20}); };
  CHECK(cn::testing::all_or_nothing(m, mend) > 20);
}
