// with_points(m, map) has the connectivity of m and the coordinates of the map.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views/with_points.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/models.hpp>
#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <array>
#include <vector>

namespace cn = concino;
using cn::testing::models_in_all_forms;

namespace {

const user_mesh::surface s = user_mesh::surface_example();
const user_mesh::volume w = user_mesh::volume_example();

struct raised {  // computes its values
  double z;
  std::array<double, 3> operator[](user_mesh::vertex v) const { return {double(v.i), 0, z}; }
};
struct table {  // stores its values and cannot be copied
  std::vector<std::array<double, 3>> at;
  explicit table(std::size_t n) : at(n) {}
  table(const table&) = delete;
  const std::array<double, 3>& operator[](user_mesh::vertex v) const { return at[std::size_t(v.i)]; }
};
struct no_map {};

template<class A> struct through {  // has the opaque descriptors of an archetype as keys
  A a;
  std::array<double, 3> operator[](cn::vert_t<A> v) const { return {0, double(a.base(v).i), 0}; }
};

static_assert(models_in_all_forms<decltype(cn::with_points(s, raised{1}))>(cn::testing::surface | cn::testing::embedded));
static_assert(models_in_all_forms<decltype(cn::with_points(w, raised{1}))>(cn::testing::volume | cn::testing::embedded));
template<class M, class P> concept accepts = requires(M&& m, P&& p) { cn::with_points(static_cast<M&&>(m), static_cast<P&&>(p)); };
static_assert(accepts<const user_mesh::surface&, raised> && accepts<user_mesh::surface&, raised&> && accepts<user_mesh::surface&, const table&>);
static_assert(!accepts<user_mesh::surface, raised> && !accepts<const user_mesh::surface, raised&>);
static_assert(!accepts<user_mesh::surface&, no_map> && !accepts<user_mesh::surface&, int>);

}  // namespace

TEST_CASE("with_points: points come from the map, everything else from the mesh") {
  const auto v = cn::with_points(s, raised{7});
  CHECK(cn::point(v, user_mesh::vertex{3})[0] == 3);
  CHECK(cn::point(v, user_mesh::vertex{3})[2] == 7);
  CHECK(cn::num_edges(v) == cn::num_edges(s));
  CHECK(cn::adj_p2v(v, user_mesh::cell{3}) == cn::adj_p2v(s, user_mesh::cell{3}));
  CHECK(cn::check_laws(v).empty());
  CHECK(cn::check_laws(cn::with_points(w, raised{7})).empty());
}

TEST_CASE("with_points: a map passed as an lvalue is not copied, and its changes are seen") {
  table t(10);
  const auto v = cn::with_points(w, t);
  t.at[4] = {1, 2, 3};
  CHECK(&cn::point(v, user_mesh::vertex{4}) == &t.at[4]);
  const auto copy = v;
  CHECK(cn::point(copy, user_mesh::vertex{4})[2] == 3);
}

TEST_CASE("with_points: graphs without points get points, and views of views work") {
  const auto bare = cn::only_mesh(w);
  const auto v = cn::with_points(bare, through<decltype(cn::only_mesh(w))>{bare});
  static_assert(models_in_all_forms<decltype(cn::with_points(bare, through<decltype(cn::only_mesh(w))>{bare}))>(cn::testing::volume |
                                                                                                                cn::testing::embedded));
  CHECK(cn::check_laws(v).empty());
  const auto g = cn::with_points(cn::only_primal_graph(s), through<decltype(cn::only_primal_graph(s))>{cn::only_primal_graph(s)});
  CHECK(cn::Embedded<decltype(g)>);
  CHECK(cn::check_laws(g).empty());
  const auto twice = cn::with_points(cn::with_points(s, raised{1}), raised{2});
  CHECK(cn::point(twice, user_mesh::vertex{0})[2] == 2);
}
