// The verbs of facets obey their laws, on surfaces and volumes, users' meshes, archetypes, at boundaries and at non-manifold facets.
#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/facets.hpp>

#include <support/user_mesh.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

namespace cn = concino;

namespace {

template<class M> concept has_facets = requires(const M& m, cn::facet_t<M> x, cn::poly_t<M> p) {
  cn::facets(m), cn::num_facets(m), cn::facet_index_bound(m);
  cn::adj_p2facet(m, p), cn::adj_facet2p(m, x), cn::adj_facet2v(m, x), cn::other_polys(m, p, x);
};
template<class M, class X> concept knows_boundary = requires(const M& m, X x) { cn::is_boundary(m, x); };

static_assert(has_facets<user_mesh::surface> && has_facets<user_mesh::volume>);
static_assert(!has_facets<int> && !knows_boundary<int, int>);
static_assert(std::same_as<cn::facet_t<user_mesh::surface>, user_mesh::segment> && std::same_as<cn::facet_t<const user_mesh::volume&>, user_mesh::facet>);
static_assert(knows_boundary<user_mesh::surface, user_mesh::vertex> && knows_boundary<user_mesh::surface, user_mesh::segment> && knows_boundary<user_mesh::surface, user_mesh::cell>);
static_assert(knows_boundary<user_mesh::volume, user_mesh::segment> && knows_boundary<user_mesh::volume, user_mesh::facet>);
static_assert(!knows_boundary<user_mesh::surface, user_mesh::facet> && !knows_boundary<user_mesh::surface, int>);

using graph = decltype(cn::only_primal_graph(std::declval<const user_mesh::surface&>()));
template<class M> concept lists_facets = requires(const M& m) { cn::facets(m); };
static_assert(!has_facets<graph> && !lists_facets<graph> && lists_facets<const user_mesh::volume>);

static_assert(cn::ElementRange<decltype(cn::other_polys(std::declval<const user_mesh::volume&>(), user_mesh::cell(), user_mesh::facet())), user_mesh::cell>);

template<class R, class X>
bool holds(const R& range, const X& x) {
  for (const X y : range)
    if (y == x) return true;
  return false;
}
template<class X, class R>
std::vector<X> listed(const R& range) {
  std::vector<X> r;
  for (const X x : range) r.push_back(x);
  return r;
}
template<class X>
bool is_permutation(const std::vector<X>& a, const std::vector<X>& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end());
}

/// Checks FC1 to FC4 by brute force.
template<class M>
void keeps_the_laws(const M& m) {
  using facet = cn::facet_t<M>;
  using poly = cn::poly_t<M>;
  std::size_t met = 0;
  std::vector<char> seen(cn::facet_index_bound(m));
  for (const facet x : cn::facets(m)) {
    ++met;
    CHECK(seen[cn::index_of(m, x)]++ == 0);  // FC1
    const auto around = listed<poly>(cn::adj_facet2p(m, x));
    for (const poly p : cn::polys(m)) {
      CHECK(holds(around, p) == holds(cn::adj_p2facet(m, p), x));  // FC2
      if (!holds(around, p)) continue;
      for (const cn::vert_t<M> v : cn::adj_facet2v(m, x)) CHECK(holds(cn::adj_p2v(m, p), v));
      std::vector<poly> others;
      for (const poly& q : around)
        if (!(q == p)) others.push_back(q);
      CHECK(listed<poly>(cn::other_polys(m, p, x)) == others);  // FC3
    }
    CHECK(cn::is_boundary(m, x) == (around.size() == 1));  // FC4
  }
  CHECK(met == cn::num_facets(m));  // FC1
  const auto has_boundary_facet = [&](const auto& is_at) {
    for (const facet x : cn::facets(m))
      if (is_at(x) && cn::is_boundary(m, x)) return true;
    return false;
  };
  for (const poly p : cn::polys(m)) {
    std::vector<poly> across;
    for (const facet x : cn::adj_p2facet(m, p))
      for (const poly q : cn::other_polys(m, p, x))
        if (!holds(across, q)) across.push_back(q);
    CHECK(is_permutation(across, listed<poly>(cn::adj_p2p(m, p))));  // FC3
    CHECK(cn::is_boundary(m, p) == has_boundary_facet([&](const facet& x) { return holds(cn::adj_facet2p(m, x), p); }));  // FC4
  }
  for (const cn::vert_t<M> v : cn::verts(m))
    CHECK(cn::is_boundary(m, v) == has_boundary_facet([&](const facet& x) { return holds(cn::adj_facet2v(m, x), v); }));
  for (const cn::edge_t<M> e : cn::edges(m))
    CHECK(cn::is_boundary(m, e) == has_boundary_facet([&](const facet& x) {
      if constexpr (cn::SurfaceMesh<M>) return x == e;  // here the dimension itself is tested
      else return holds(cn::adj_f2e(m, x), e);
    }));
}

template<class M>
void keeps_the_laws_stripped(const M& m) {
  keeps_the_laws(m);
  keeps_the_laws(cn::only_mesh(m));
  keeps_the_laws(cn::archetypes::owner<decltype(cn::only_mesh(m))>(m));
}

}  // namespace

TEST_CASE("facets: are the edges of a surface with boundary and an isolated vert") {
  const auto m = user_mesh::surface_example();
  keeps_the_laws_stripped(m);
  CHECK(cn::num_facets(m) == cn::num_edges(m));
  CHECK(cn::is_boundary(m, user_mesh::vertex{0}));
  CHECK_FALSE(cn::is_boundary(m, user_mesh::vertex{7}));
  CHECK(cn::is_boundary(m, user_mesh::cell{3}));
}

TEST_CASE("facets: are the faces of a volume with two polys") {
  const auto m = user_mesh::volume_example();
  keeps_the_laws_stripped(m);
  CHECK(cn::num_facets(m) == 10);
  CHECK_FALSE(cn::is_boundary(m, user_mesh::facet{1}));
  CHECK(cn::is_boundary(m, user_mesh::facet{0}));
  const auto across = cn::other_polys(m, user_mesh::cell{0}, user_mesh::facet{1});
  REQUIRE(across.begin() != across.end());
  CHECK(*across.begin() == user_mesh::cell{1});
  const auto outside = cn::other_polys(m, user_mesh::cell{0}, user_mesh::facet{0});
  CHECK_FALSE(outside.begin() != outside.end());
}

TEST_CASE("facets: an edge with three polys or none is not on the boundary") {
  user_mesh::surface book({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
  book.es.push_back({2, 3});
  const user_mesh::segment spine{0}, alone{static_cast<int>(book.es.size()) - 1};
  CHECK_FALSE(cn::is_boundary(book, spine));
  CHECK_FALSE(cn::is_boundary(book, alone));
  CHECK(listed<user_mesh::cell>(cn::other_polys(book, user_mesh::cell{1}, spine)) == std::vector{user_mesh::cell{0}, user_mesh::cell{2}});
  keeps_the_laws_stripped(book);
}

TEST_CASE("facets: closed surfaces and closed pairs of volumes have no boundary facets") {
  const user_mesh::surface tet({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}});
  keeps_the_laws_stripped(tet);
  for (const auto v : cn::verts(tet)) CHECK_FALSE(cn::is_boundary(tet, v));
  for (const auto p : cn::polys(tet)) CHECK_FALSE(cn::is_boundary(tet, p));
  keeps_the_laws_stripped(user_mesh::surface());
  keeps_the_laws_stripped(user_mesh::volume());
}
