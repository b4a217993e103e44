#include <concino/graph/grow_regions.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>

#include <support/kinds.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

constexpr auto freely = [](const auto&, const auto&) { return true; };

}  // namespace

TEST_CASE("grow_regions: regions grow evenly, ties go to the earlier seed, barriers are obeyed") {
  const auto m = grid<quadmesh>(4);  // polys 0 .. 3 in the first row
  const poly_id p{0}, q{3};
  const auto rg = grow_regions(m, {q, p}, freely);
  CHECK(rg[q] == 0);
  CHECK(rg[p] == 1);
  CHECK(rg[poly_id{1}] == 1);
  CHECK(rg[poly_id{2}] == 0);
  const auto three = grow_regions(m, {poly_id{0}, poly_id{2}}, [](auto, auto) { return 1.0; });
  CHECK(three[poly_id{1}] == 0);  // at equal distance from both seeds
  CHECK(grow_regions(m, {poly_id{2}, poly_id{0}}, [](auto, auto) { return 1.0; })[poly_id{1}] == 0);
  CHECK(grow_regions(m, {p, p, q}, freely)[q] == 2);
  CHECK(grow_regions(m, p, freely, {.max_cost = 1})[poly_id{1}] == 0);
  CHECK(grow_regions(m, p, freely, {.max_cost = 1})[poly_id{2}] == -1);
  CHECK_THROWS_WITH_AS(grow_regions(m, std::vector<poly_id>{}, freely), "grow_regions: there is no seed; give at least one poly", invalid_argument);
  CHECK(grow_regions(m, vert_id{0}, freely, {.may_enter = [](auto) { return false; }})[vert_id{0}] == 0);
  CHECK(grow_regions(m, vert_id{0}, freely, {.may_cross = [](auto) { return false; }})[vert_id{1}] == -1);
  CHECK(grow_regions(dual(m), p, freely, {.may_cross = [](auto) { return false; }})[poly_id{1}] == -1);
  // With growth::step the cheapest steps come first, however many: in the row 0 1 2 the second seed is faster than the expensive step of the first.
  const auto dear = [](auto from, auto) { return from == poly_id{0} ? 5.0 : 1.0; };
  CHECK(grow_regions(m, {poly_id{0}, poly_id{3}}, dear, {.priority = growth::step})[poly_id{1}] == 1);
  CHECK(grow_regions(m, {poly_id{0}, poly_id{15}}, dear)[poly_id{1}] == 0);
  CHECK(grow_regions(m, {poly_id{0}, poly_id{15}}, dear, {.priority = growth::step})[poly_id{1}] == 1);
}

TEST_CASE_TEMPLATE("grow_regions: runs on the archetypes of primal and dual graphs", M, CONCINO_KINDS) {
  const M m = grid<M>(2);
  const auto g = only_primal_graph(m);
  const auto d = only_dual_graph(m);
  const vert_id v{0}, w{static_cast<unsigned>(num_verts(m) - 1)};
  const poly_id p{0};
  for (const auto priority : {growth::accumulated, growth::step}) {
    const auto by_verts = grow_regions(m, {v, w}, freely, {.priority = priority});
    const auto bare = grow_regions(g, {g.vert(v), g.vert(w)}, freely, {.priority = priority, .may_enter = [](const auto&) { return true; }});
    for (const auto x : verts(g)) CHECK(bare[x] == by_verts[g.base(x)]);
    const auto cells = grow_regions(d, d.poly(p), [](const auto&, const auto&) { return 1; }, {.priority = priority});
    for (const auto x : polys(d)) CHECK(cells[x] == 0);
  }
  static_assert(requirement::is_cost<decltype(freely), vert_id> && !requirement::is_cost<int, vert_id>);
}

TEST_CASE("grow_regions: throws if an argument is invalid") {
  const auto m = grid<trimesh>(2);
  CHECK_THROWS_WITH_AS(grow_regions(m, {vert_id{0}, vert_id{9}}, freely), "grow_regions: the seed is not a vert of the mesh; take one from verts(m)", invalid_mesh);
  CHECK_THROWS_WITH_AS(grow_regions(m, poly_id{0}, [](auto, auto) { return -2.0; }),
                       doctest::Contains("is -2; costs must be 0 or more; +inf keeps regions out"), invalid_mesh);
  CHECK_THROWS_WITH_AS(grow_regions(m, poly_id{0}, [](auto, auto) { return std::nan(""); }), doctest::Contains("grow_regions: the cost from poly 0 to poly "),
                       invalid_mesh);
  CHECK_THROWS_WITH_AS(grow_regions(m, poly_id{0}, freely, {.max_cost = -1}), "grow_regions: max_cost must be 0 or more", invalid_argument);
}
