#include <concino/render/value_criteria.hpp>

#include <concino/mesh/element_map.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/quadmesh.hpp>

#include <support/meshes.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace concino;

namespace {

template<class M, class C>
std::size_t count(const M& m, const C& criterion) {
  const auto meets = criterion.prepare(m);
  std::size_t n = 0;
  for (const auto p : polys(m)) n += meets(p);
  return n;
}

/// A map with another type of values, to which only its operator[] belongs.
struct unsigned_labels {
  unsigned operator[](const poly_id& p) const { return p.raw() % 3; }
};

template<class P>
inline constexpr bool can_be_labels = CriterionOn<label_criterion<P>, quadmesh>;
template<class P>
inline constexpr bool can_be_values = CriterionOn<value_criterion<P>, quadmesh>;

}  // namespace

TEST_CASE("labeled, at_most, at_least, selected, where: select by values at polys") {
  quadmesh m(testing::quad_grid(3));  // 9 polys
  auto label = make_poly_map<int>(m);
  auto value = make_poly_map<double>(m);
  auto mark = make_poly_map<bool>(m);
  for (const auto p : polys(m)) label[p] = static_cast<int>(p.raw()) % 4 - 1, value[p] = p.raw(), mark[p] = p.raw() > 6;
  CHECK(count(m, labeled(label, {1})) == 2);
  CHECK(count(m, labeled(label, {2, -1, 2, 77})) == 5);
  CHECK(count(m, labeled(label, {})) == 0);
  CHECK(count(m, labeled(label, std::vector<int>{0, 1})) == 4);
  CHECK(count(m, labeled(unsigned_labels{}, {0})) == 3);
  CHECK(count(m, at_most(value, 2)) == 3);
  CHECK(count(m, at_least(value, 2)) == 7);
  CHECK(count(m, at_least(label, 2)) == 2);
  CHECK(count(m, selected(mark)) == 2);
  CHECK(count(m, where([](const poly_id& p) { return p.raw() == 5; })) == 1);
  value[poly_id{0}] = std::numeric_limits<double>::quiet_NaN();
  CHECK(count(m, at_most(value, 2)) == 2);
  CHECK(count(m, at_least(value, -100)) == 8);
  auto named = poly_property<int>(m, "part");
  named[poly_id{4}] = 6;
  CHECK(count(m, labeled(find_poly_property<int>(m, "part"), {6})) == 1);
}

TEST_CASE("labeled, at_most: a map is referred to, a temporary one is kept") {
  const quadmesh m(testing::quad_grid(2));
  auto value = make_poly_map<double>(m, 1.0);
  const auto later = at_most(value, 0.5);
  const auto kept = at_most(make_poly_map<double>(m, 0.0), 0.5);
  CHECK(count(m, later) == 0);
  value[poly_id{3}] = 0;
  CHECK(count(m, later) == 1);
  CHECK(count(m, kept) == 4);
}

TEST_CASE("where: one call for each poly, in order") {
  const quadmesh m(testing::quad_grid(2));
  std::vector<unsigned> order;
  CHECK(count(m, where([&](const poly_id& p) { return order.push_back(p.raw()), true; })) == 4);
  CHECK(order == std::vector<unsigned>{0, 1, 2, 3});
}

TEST_CASE("labeled, at_most: maps of other elements are refused when compiled, maps of other meshes by an exception") {
  static_assert(can_be_labels<const poly_map<quadmesh, int>&>);
  static_assert(can_be_labels<unsigned_labels>);
  static_assert(!can_be_labels<poly_map<quadmesh, double>>);
  static_assert(!can_be_labels<vert_map<quadmesh, int>>);
  static_assert(can_be_values<poly_map<quadmesh, double>>);
  static_assert(!can_be_values<vert_map<quadmesh, double>>);
  const quadmesh m(testing::quad_grid(2)), other(testing::quad_grid(3));
  const auto label = make_poly_map<int>(other);
  CHECK_THROWS_WITH_AS(count(m, labeled(label, {1})), "labeled: the map belongs to another mesh; make it with make_poly_map<...>(m)", invalid_argument);
  CHECK_THROWS_AS(count(m, at_most(label, 1)), invalid_argument);
  CHECK_THROWS_WITH_AS(at_least(label, std::numeric_limits<double>::quiet_NaN()), "at_least: the limit is not a number (NaN)", invalid_argument);
}
