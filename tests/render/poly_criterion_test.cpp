#include <concino/render/poly_criterion.hpp>

#include <concino/render/position_criteria.hpp>
#include <concino/render/slicing.hpp>
#include <concino/render/value_criteria.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/hexmesh.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

using namespace concino;

namespace {

struct options {
  poly_criterion<hexmesh> visible = {};
};

std::size_t count(const hexmesh& m, const options& o) {
  const auto meets = o.visible.prepare(m);
  std::size_t n = 0;
  for (const auto p : polys(m)) n += meets(p);
  return n;
}

static_assert(!std::is_convertible_v<int, poly_criterion<hexmesh>> && CriterionOn<poly_criterion<hexmesh>, hexmesh>);
static_assert(!std::is_convertible_v<decltype(at_most(std::declval<vert_map<hexmesh, double>&>(), 1)), poly_criterion<hexmesh>>);

static_assert(std::is_convertible_v<poly_map<hexmesh, bool>, poly_criterion<hexmesh>>);
static_assert(!std::is_convertible_v<poly_map<hexmesh, int>, poly_criterion<hexmesh>>);
static_assert(!std::is_convertible_v<vert_map<hexmesh, bool>, poly_criterion<hexmesh>>);

}  // namespace

TEST_CASE("poly_criterion: holds any criterion; by default all polys meet it") {
  const hexmesh m(testing::hex_grid(4));
  CHECK(count(m, {}) == 64);
  CHECK(!options{}.visible.has_criterion());
  CHECK(count(m, {.visible = below('x', 0.5)}) == 32);
  options kept;
  {
    auto label = make_poly_map<int>(m, 2);
    label[poly_id{63}] = 3;
    kept = {.visible = labeled(std::move(label), {3}) || below('z', 0.25)};
  }
  const options copy = kept;
  kept = {};
  CHECK(copy.visible.has_criterion());
  CHECK(count(m, copy) == 17);
  const poly_criterion<hexmesh> first = copy.visible, second = above('y', 0.5);
  CHECK(count(m, {.visible = !first && second}) == 23);  // is a criterion itself
  CHECK(count(hexmesh(), {.visible = below('x', 1)}) == 0);
}

TEST_CASE("poly_criterion: a map of bool at polys, such as visible_polys") {
  const hexmesh m(testing::hex_grid(4));
  CHECK(count(m, {.visible = visible_polys(m, below('x', 0.5))}) == 32);
  auto some = make_poly_map<bool>(m, false);
  const options by_reference{.visible = some};
  some[poly_id{3}] = true;
  CHECK(count(m, by_reference) == 1);
  CHECK(count(m, {.visible = poly_criterion<hexmesh>(some) || below('x', 0.25)}) > 1);
  const hexmesh other(testing::hex_grid(2));
  CHECK_THROWS_AS(count(other, by_reference), invalid_argument);
}
