// garbage_collect: the same mesh without gaps, in the same order, with its properties and a map from old to new descriptors; packed like a new one.
#include <concino/edit.hpp>
#include <concino/mesh.hpp>

#include <support/corpus.hpp>
#include <support/kinds.hpp>
#include <support/rebuilt.hpp>
#include <support/soups.hpp>
#include <support/whole_mesh.hpp>

#include <doctest/doctest.h>

#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace cn = concino;
using cn::testing::equals_rebuilt;
using cn::testing::keeps_all_laws;
using cn::testing::whole;

namespace {

using list = std::vector<unsigned>;

/// The new numbers of elements.
template<class Map, class R>
list renumbered(const Map& map, const R& range) {
  list all;
  for (const auto x : range) {
    REQUIRE(map[x].has_value());
    all.push_back(map[x]->raw());
  }
  return all;
}
template<class R>
list numbers(const R& range) {
  list all;
  for (const auto x : range) all.push_back(x.raw());
  return all;
}

/// Checks map[x] of the elements with index below `bound`: those that exist are numbered 0, 1, 2, ...; the others were removed.
template<class X, class M, class Map>
void checks_numbers(const M& before, const Map& map, std::size_t bound, std::size_t expected) {
  unsigned next = 0;
  for (std::size_t i = 0; i < bound; ++i) {
    const X x{i};
    if (!cn::contains(before, x)) CHECK(map[x] == std::nullopt);
    else CHECK(map[x] == X{next++});
  }
  CHECK(next == expected);
  CHECK(map[X{bound}] == std::nullopt);
  CHECK(map[X{}] == std::nullopt);
}

/// Checks that `after` is `before` under the map: points, adjacencies in their order, and the values of give_properties().
template<class M, class Map>
void is_renumbered(const M& before, const M& after, const Map& map) {
  checks_numbers<cn::vert_id>(before, map, cn::vert_index_bound(before), cn::vert_index_bound(after));
  checks_numbers<cn::edge_id>(before, map, cn::edge_index_bound(before), cn::edge_index_bound(after));
  checks_numbers<cn::poly_id>(before, map, cn::poly_index_bound(before), cn::poly_index_bound(after));
  const auto same = [&](const auto& range, const auto& now) { CHECK(renumbered(map, range) == numbers(now)); };
  const auto value = [&](auto find, auto x) {
    if (const auto old = find(before), now = find(after); old) CHECK(old[x].numbers == now[*map[x]].numbers);
  };
  using memory = cn::testing::value_with_memory;
  for (const auto v : cn::verts(before)) {
    const cn::vert_id w = *map[v];
    for (const std::size_t i : {0u, 1u, 2u}) CHECK((cn::point(before, v)[i] == cn::point(after, w)[i] || (std::isnan(cn::point(before, v)[i]) && std::isnan(cn::point(after, w)[i]))));
    same(cn::adj_v2v(before, v), cn::adj_v2v(after, w)), same(cn::adj_v2e(before, v), cn::adj_v2e(after, w)), same(cn::adj_v2p(before, v), cn::adj_v2p(after, w));
    value([](const M& m) { return cn::find_vert_property<memory>(m, "b"); }, v);
  }
  for (const auto e : cn::edges(before)) {
    same(cn::adj_e2v(before, e), cn::adj_e2v(after, *map[e])), same(cn::adj_e2p(before, e), cn::adj_e2p(after, *map[e]));
    value([](const M& m) { return cn::find_edge_property<memory>(m, "c"); }, e);
  }
  const auto old_corners = cn::find_corner_property<memory>(before, "f"), new_corners = cn::find_corner_property<memory>(after, "f");
  std::size_t corner = 0;
  for (const auto p : cn::polys(before)) {
    const cn::poly_id q = *map[p];
    same(cn::adj_p2v(before, p), cn::adj_p2v(after, q)), same(cn::adj_p2e(before, p), cn::adj_p2e(after, q)), same(cn::adj_p2p(before, p), cn::adj_p2p(after, q));
    for (std::uint32_t k = 0; k < cn::num_elements(cn::adj_p2v(before, p)); ++k, ++corner) {
      CHECK(cn::corner_index(after, {q, k}) == corner);
      CHECK(map.origins().corners.only(corner) == cn::corner_index(before, {p, k}));
      if (old_corners) CHECK(old_corners[{p, k}].numbers == new_corners[{q, k}].numbers);
    }
  }
  CHECK(corner == cn::mesh_traits<M>::corner_index_bound(after));
  if constexpr (cn::VolumeMesh<M>) {
    checks_numbers<cn::face_id>(before, map, cn::face_index_bound(before), cn::face_index_bound(after));
    for (const auto v : cn::verts(before)) same(cn::adj_v2f(before, v), cn::adj_v2f(after, *map[v]));
    for (const auto e : cn::edges(before)) same(cn::adj_e2f(before, e), cn::adj_e2f(after, *map[e]));
    for (const auto f : cn::faces(before)) {
      same(cn::adj_f2v(before, f), cn::adj_f2v(after, *map[f])), same(cn::adj_f2e(before, f), cn::adj_f2e(after, *map[f]));
      same(cn::adj_f2p(before, f), cn::adj_f2p(after, *map[f]));
      value([](const M& m) { return cn::find_face_property<memory>(m, "e"); }, f);
    }
    for (const auto p : cn::polys(before)) {
      same(cn::adj_p2f(before, p), cn::adj_p2f(after, *map[p]));
      for (const auto f : cn::adj_p2f(before, p)) CHECK(cn::face_is_outward(before, p, f) == cn::face_is_outward(after, *map[p], *map[f]));
    }
  }
}

/// The bytes that a copy of m takes; 0 under the address sanitizer, whose allocator does not tell.
template<class M>
std::size_t bytes_of_copy(const M& m) {
  const auto in_use = [] { return mallinfo2().uordblks + mallinfo2().hblkhd; };
  const std::size_t before = in_use();
  const M copy = m;
  return in_use() - before;
}

}  // namespace

TEST_CASE_TEMPLATE("garbage_collect: meshes without gaps stay as they are", M, CONCINO_ALL_KINDS) {
  for (M m : {M(), cn::testing::two_grids<M>(2)}) {
    cn::testing::give_properties(m);
    const M before = m;
    const auto map = cn::garbage_collect(m);
    CHECK(whole(m) == whole(before));
    is_renumbered(before, m, map);
    CHECK(map.origins().verts.size() == cn::num_verts(m));
  }
}

TEST_CASE_TEMPLATE("garbage_collect: random soups after removals and additions", M, CONCINO_ALL_KINDS) {
  std::mt19937 random(19);
  const unsigned rounds = cn::testing::long_run() ? 100 : 6;
  for (unsigned round = 0; round < rounds; ++round) {
    M m = round % 2 ? cn::testing::two_grids<M>(2) : cn::testing::random_soup<M>(random, 14, 12).mesh();
    cn::testing::give_properties(m);
    for (const auto p : M(m).tables().polys().all())
      if (random() % 3 == 0) cn::remove_poly(m, p);
    for (const auto v : M(m).tables().verts().all())
      if (random() % 6 == 0) cn::remove_vert(m, v);
    cn::add_vert(m, {1, 2, 3});
    cn::testing::give_properties(m);
    const M before = m;
    const auto a = cn::vert_property<double>(m, "a");
    const auto map = cn::garbage_collect(m);
    is_renumbered(before, m, map);
    for (const auto v : cn::verts(before)) CHECK(a[*map[v]] == 0.5 + v.raw());  // a handle that was made before
    keeps_all_laws(m);
    equals_rebuilt(m);
    const M once = m;
    cn::garbage_collect(m);
    CHECK(whole(m) == whole(once));
    // and it can be edited like any other
    const auto all = numbers(cn::polys(m));
    if (!all.empty()) cn::remove_poly(m, cn::poly_id{all[all.size() / 2]});
    keeps_all_laws(m);
  }
}

TEST_CASE_TEMPLATE("garbage_collect: equals a new mesh, takes as little memory, and can be built again", M, CONCINO_ALL_KINDS) {
  const unsigned n = cn::dimension_v<M> == 2 ? 40 : 8;
  const M new_mesh = cn::testing::grid<M>(n);
  M m = cn::testing::two_grids<M>(n);
  const auto polys = numbers(cn::polys(m));
  for (std::size_t i = polys.size() / 2; i < polys.size(); ++i) cn::remove_poly(m, cn::poly_id{polys[i]});
  cn::remove_unreferenced(m);
  const std::size_t with_gaps = bytes_of_copy(m);
  cn::garbage_collect(m);
  CHECK(whole(m) == whole(new_mesh));
  if (with_gaps > 0) {
    const auto bytes = static_cast<double>(bytes_of_copy(m)), expected = static_cast<double>(bytes_of_copy(new_mesh));
    CHECK(static_cast<double>(with_gaps) > 1.5 * expected);
    CHECK(bytes == doctest::Approx(expected).epsilon(0.01));
  }
  for (std::size_t i = 0; i < polys.size() / 2; ++i) cn::remove_poly(m, cn::poly_id{polys[i]});
  cn::remove_unreferenced(m);
  const auto map = cn::garbage_collect(m);
  CHECK(cn::vert_index_bound(m) + cn::edge_index_bound(m) + cn::poly_index_bound(m) == 0);
  CHECK(map[cn::poly_id{0}] == std::nullopt);
  keeps_all_laws(m);
  CHECK(cn::add_vert(m, {0, 0, 0}) == cn::vert_id{0});
}

TEST_CASE_TEMPLATE("garbage_collect: points that are not finite, and points that coincide", M, CONCINO_KINDS) {
  M m = cn::testing::grid<M>(1);
  const double inf = std::numeric_limits<double>::infinity();
  for (const auto v : cn::verts(m)) cn::set_point(m, v, cn::vec3{0, v.raw() % 2 ? inf : -0.0, -inf});
  const cn::vert_id nan = cn::add_vert(m, {std::numeric_limits<double>::quiet_NaN(), 0, 0});
  cn::remove_poly(m, cn::poly_id{0});
  const M before = m;
  const auto map = cn::garbage_collect(m);
  CHECK(std::isnan(cn::point(m, *map[nan])[0]));
  is_renumbered(before, m, map);
}

TEST_CASE("garbage_collect: values outside the mesh and properties with rules follow their elements") {
  auto m = cn::testing::grid<cn::trimesh>(2);
  const auto mass = cn::poly_property<double>(m, "mass"), sums = cn::poly_property<double>(m, "sums");
  cn::set_property_rule(m, cn::element_kind::poly, "sums", cn::property_rule::sum);
  auto heat = cn::make_vert_map<double>(m, 0.0);
  for (const auto p : cn::polys(m)) mass[p] = sums[p] = 10 + p.raw();
  for (const auto v : cn::verts(m)) heat[v] = v.raw();
  *cn::mesh_property<int>(m, "version") = 7;
  cn::remove_vert(m, cn::vert_id{0});
  const cn::trimesh before = m;
  const auto map = cn::garbage_collect(m);
  const auto heat_now = cn::transfer_values(map.origins().verts, heat.values(), cn::property_rule::interpolate);
  REQUIRE(heat_now.size() == cn::num_verts(m));
  for (const auto v : cn::verts(before)) CHECK(heat_now[map[v]->raw()] == v.raw());
  for (const auto p : cn::polys(before)) {
    CHECK(mass[*map[p]] == 10 + p.raw());
    CHECK(sums[*map[p]] == 10 + p.raw());
  }
  CHECK(*cn::mesh_property<int>(m, "version") == 7);
}

TEST_CASE("garbage_collect: non-manifold facets, and edges around which a walk does not meet all polys") {
  // five triangles at an edge, and three tets at an edge that share no face there
  cn::trimesh m({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}, {0, 0, -1}, {0, 1, 1}}, {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}, {0, 1, 5}, {1, 0, 6}});
  cn::remove_poly(m, cn::poly_id{1});
  cn::remove_unreferenced(m);
  cn::trimesh old = m;
  is_renumbered(old, m, cn::garbage_collect(m));
  keeps_all_laws(m), equals_rebuilt(m);
  std::vector<std::vector<unsigned>> fans, books;
  for (unsigned i = 0; i < 5; ++i) fans.push_back({0, 1, 2 + 2 * i, 3 + 2 * i}), books.push_back({0, 1, 2, 3 + i});
  for (const auto& tets : {fans, books}) {
    cn::tetmesh t(std::vector<cn::vec3>(12), tets);
    cn::remove_poly(t, cn::poly_id{0});
    cn::remove_poly(t, cn::poly_id{2});
    const cn::tetmesh t_old = t;
    is_renumbered(t_old, t, cn::garbage_collect(t));
    keeps_all_laws(t), equals_rebuilt(t);
  }
}

TEST_CASE("garbage_collect: verts of polyhedra with many neighbours, added in any order") {
  cn::polyhedralmesh m;
  const unsigned n = 200;
  for (unsigned i = 0; i <= n; ++i) cn::add_vert(m, {i, i * i, 0});
  const cn::vert_id hub{n / 2};
  std::mt19937 random(3);
  std::vector<unsigned> others(n);
  for (unsigned i = 0; i < n; ++i) others[i] = i < n / 2 ? i : i + 1;
  std::shuffle(others.begin(), others.end(), random);
  for (unsigned i = 0; i + 1 < n; ++i) cn::add_face(m, {hub, cn::vert_id{others[i]}, cn::vert_id{others[i + 1]}});
  cn::garbage_collect(m);
  REQUIRE(cn::num_elements(cn::adj_v2v(m, hub)) == n);
  for (const auto f : cn::faces(m))
    for (const auto e : cn::adj_f2e(m, f)) CHECK(cn::contains(m, e));
  unsigned smaller = 0;
  for (const auto v : cn::adj_v2v(m, hub)) {
    if (smaller < n / 2) CHECK(v.raw() == smaller);  // as in a new mesh, which finds edges by bisection
    ++smaller;
  }
  keeps_all_laws(m);
}

TEST_CASE_TEMPLATE("garbage_collect: refused while a transaction is open", M, cn::trimesh, cn::tetmesh) {
  M m = cn::testing::grid<M>(1);
  cn::transaction t(m);
  cn::remove_poly(m, cn::poly_id{0});
  const auto before = whole(m);
  CHECK_THROWS_WITH_AS(cn::garbage_collect(m), doctest::Contains("while a transaction is open"), cn::unsupported);
  CHECK(whole(m) == before);
  auto edits = t.commit();
  cn::garbage_collect(m);
  CHECK_THROWS_AS(edits.undo(), cn::invalid_argument);
}
