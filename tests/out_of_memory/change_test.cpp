// Assignments, maps, properties and changes of points succeed or change nothing if any allocation fails, and nothing leaks.
#include <concino/convert.hpp>
#include <concino/edit.hpp>
#include <concino/generate/grade.hpp>
#include <concino/generate/jitter.hpp>
#include <concino/mesh.hpp>

#include <support/failing_allocations.hpp>
#include <support/kinds.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <stdexcept>
#include <type_traits>

namespace cn = concino;
using cn::testing::for_each_failing_allocation;
using cn::testing::whole;

namespace {

/// Runs change(m) with each of its allocations failing, and checks that m is unchanged, with its properties. Returns the number of allocations.
template<class M, class F>
std::size_t all_or_nothing(const M& before, const F& change) {
  const std::vector<double> old = whole(before);
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    M m = before;
    if (attempt([&] { change(m); })) {
      CHECK(whole(m) == old);
      CHECK(cn::property_list(m).size() == cn::property_list(before).size());
      change(m);
    }
  });
  CHECK(result.leaks == 0);
  return result.allocations;
}

template<class M>
M with_properties(unsigned n) {
  M m = cn::testing::grid<M>(n);
  cn::testing::give_properties(m);
  return m;
}

/// How many more objects can be constructed.
int left = 0;
struct limited {
  limited() {
    if (left-- == 0) throw std::runtime_error("no more");
  }
  limited(const limited&) {}
};

/// Runs made() with each of its allocations failing, and checks that nothing leaks.
template<class F>
void leaks_nothing(const F& made) {
  const auto result = for_each_failing_allocation([&](const auto& attempt) { attempt([&] { made(); }); });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
}

}  // namespace

TEST_CASE_TEMPLATE("meshes, tables and maps: moving allocates nothing", M, CONCINO_ALL_KINDS) {
  using tables = std::remove_cvref_t<decltype(std::declval<M&>().tables())>;
  static_assert(std::is_nothrow_move_constructible_v<M> && std::is_nothrow_move_assignable_v<M> && std::is_nothrow_swappable_v<M>);
  static_assert(std::is_nothrow_move_constructible_v<tables> && std::is_nothrow_move_assignable_v<tables>);
  using numbers = cn::vert_map<M, double>;
  using lists = cn::vert_map<M, std::vector<int>>;
  static_assert(std::is_nothrow_move_constructible_v<numbers> && std::is_nothrow_move_assignable_v<numbers>);
  static_assert(std::is_nothrow_move_constructible_v<lists> && std::is_nothrow_move_assignable_v<lists>);
  M m = with_properties<M>(1);
  const M moved = std::move(m);
  CHECK(cn::num_verts(moved) > 0);
  CHECK(cn::num_verts(m) == 0);
  CHECK(cn::num_polys(m) == 0);
  m = moved;
  CHECK(whole(m) == whole(moved));
}

TEST_CASE_TEMPLATE("assigning, building and converting a mesh succeeds or changes nothing", M, CONCINO_ALL_KINDS) {
  const M other = with_properties<M>(2), m = with_properties<M>(1);
  CHECK(all_or_nothing(m, [&](M& x) { x = other; }) > 10);
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    M x = m;
    if (attempt([&] { x.tables() = other.tables(); })) CHECK(whole(x) == whole(m));
    x = m;
  });
  CHECK(result.failed > 5);
  const auto arrays = cn::testing::grid_arrays<M>(1);
  leaks_nothing([&] { return M(arrays); });
  const std::vector<double> old = whole(m);
  leaks_nothing([&] { return M(m); });
  leaks_nothing([&] { return cn::convert<M>(m); });
  CHECK(whole(m) == old);
}

TEST_CASE_TEMPLATE("changing properties and points succeeds or changes nothing", M, cn::polygonmesh, cn::tetmesh) {
  const M m = with_properties<M>(2);
  using cn::testing::value_with_memory;
  CHECK(all_or_nothing(m, [](M& x) { cn::vert_property<double>(x, "a name that is long enough to need memory"); }) > 2);
  CHECK(all_or_nothing(m, [](M& x) { cn::edge_property<value_with_memory>(x, "new"); }) > 10);
  CHECK(all_or_nothing(m, [](M& x) { cn::poly_property<std::string>(x, "new"); }) > 2);
  CHECK(all_or_nothing(m, [](M& x) { cn::mesh_property<value_with_memory>(x, "new"); }) > 2);
  CHECK(all_or_nothing(m, [](M& x) { cn::remove_property(x, cn::element_kind::vert, "b"); }) == 0);
  CHECK(all_or_nothing(m, [](M& x) { cn::set_point(x, cn::vert_id{0}, cn::vec3{1, 2, 3}); }) == 0);
  CHECK(all_or_nothing(m, [](M& x) { cn::jitter(x, 0.1); }) > 1);
  CHECK(all_or_nothing(m, [](M& x) { cn::grade(x, {2, 1, 1}); }) > 0);
  const M before = with_properties<M>(2);
  const cn::correspondence c{cn::element_origins(std::vector<std::uint32_t>(cn::num_verts(m), 1)), {}, {}, cn::element_origins(std::vector<std::uint32_t>(cn::num_polys(m), 1))};
  CHECK(all_or_nothing(m, [&](M& x) { cn::transfer_properties(before, x, c); }) > 20);
}

TEST_CASE("an edit changes nothing if a default value of a property cannot be constructed") {
  cn::polygonmesh m = with_properties<cn::polygonmesh>(2);
  left = 1000;
  cn::vert_property<limited>(m, "x");
  cn::edge_property<limited>(m, "y");
  cn::poly_property<limited>(m, "z");
  const std::vector<double> old = whole(m);
  left = 0;
  CHECK_THROWS_WITH_AS(cn::add_vert(m, {1, 2, 3}), "no more", std::runtime_error);
  CHECK(whole(m) == old);
  // three new edges and a poly
  for (int n = 0; n < 4; ++n) {
    left = n;
    CHECK_THROWS_WITH_AS(cn::add_poly(m, {cn::vert_id{0}, cn::vert_id{8}, cn::vert_id{2}}), "no more", std::runtime_error);
    CHECK(whole(m) == old);
  }
  left = 4;
  const auto polys = cn::num_polys(m), edges = cn::num_edges(m);
  cn::add_poly(m, {cn::vert_id{0}, cn::vert_id{8}, cn::vert_id{2}});
  CHECK(cn::num_polys(m) == polys + 1);
  CHECK(cn::num_edges(m) == edges + 3);
}

TEST_CASE_TEMPLATE("constructing and assigning a map succeeds or changes nothing", T, double, bool, std::vector<int>) {
  const cn::trimesh small = cn::testing::grid<cn::trimesh>(1), large = cn::testing::grid<cn::trimesh>(2);
  const T one(1), two(true);
  const auto from = cn::make_vert_map<T>(large, two);
  const auto result = for_each_failing_allocation([&](const auto& attempt) {
    auto map = cn::make_vert_map<T>(small, one);
    const bool failed = attempt([&] { map = from; });
    CHECK(&map.mesh() == (failed ? &small : &large));
    CHECK(map.values().size() == cn::num_verts(map.mesh()));
    CHECK(map[cn::vert_id{3}] == (failed ? one : two));
  });
  CHECK(result.failed > 0);
  CHECK(result.leaks == 0);
  leaks_nothing([&] { return cn::make_edge_map<T>(small, one); });
  leaks_nothing([&] { return cn::make_poly_map<T>(small, one); });
}
