#include <concino/render/criterion.hpp>

#include <concino/mesh/quadmesh.hpp>
#include <concino/render/value_criteria.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

using namespace concino;

namespace {

struct odd_polys : criterion_base {
  auto prepare(const quadmesh&) const {
    return [](const poly_id& p) { return p.raw() % 2 == 1; };
  }
};
struct no_criterion {};

template<class A>
concept can_be_negated = requires(const A& a) { !a; };
template<class A, class B>
concept can_be_joined = requires(const A& a, const B& b) { a && b; };

static_assert(Criterion<odd_polys> && Criterion<const odd_polys&> && !Criterion<no_criterion> && !Criterion<bool>);
static_assert(CriterionOn<odd_polys, quadmesh> && CriterionOn<const odd_polys&, const quadmesh&> && !CriterionOn<odd_polys, int>);
static_assert(can_be_negated<odd_polys> && !can_be_negated<no_criterion>);
static_assert(can_be_joined<odd_polys, odd_polys> && !can_be_joined<odd_polys, no_criterion> && !can_be_joined<no_criterion, no_criterion> && !can_be_joined<odd_polys, bool>);

}  // namespace

TEST_CASE("&&, ||, !: combine criteria, also those of users") {
  const quadmesh m(testing::quad_grid(4));
  const odd_polys odd;
  const auto low = where([](const poly_id& p) { return p.raw() < 5; });
  const auto meets = (!(odd && low) || (low && !odd)).prepare(m);
  const auto both = (odd && low).prepare(m);
  const auto either = (odd || low).prepare(m);
  const auto neither = (!odd && !low).prepare(m);
  for (const poly_id p : polys(m)) {
    const bool is_odd = p.raw() % 2 == 1, is_low = p.raw() < 5;
    CHECK(both(p) == (is_odd && is_low));
    CHECK(either(p) == (is_odd || is_low));
    CHECK(neither(p) == !(is_odd || is_low));
    CHECK(meets(p) == !both(p));
  }
}
