// CGAL::Polyhedron_3 obeys all laws, directly by its ids and through indexed(m), and algorithms take and return CGAL's handles.
#include <concino/adapters/cgal_polyhedron.hpp>
#include <concino/graph.hpp>
#include <concino/validate/check_laws.hpp>

#include <CGAL/HalfedgeDS_vector.h>
#include <CGAL/Polyhedron_incremental_builder_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Polyhedron_min_items_3.h>
#include <CGAL/Simple_cartesian.h>

#include <doctest/doctest.h>
#include <support/cgal.hpp>
#include <support/closed_surfaces.hpp>
#include <support/kinds.hpp>
#include <support/models.hpp>

#include <iterator>
#include <random>
#include <ranges>

using namespace concino;

namespace {

using kernel = CGAL::Simple_cartesian<double>;
using plain = CGAL::Polyhedron_3<kernel>;
using with_id = CGAL::Polyhedron_3<kernel, CGAL::Polyhedron_items_with_id_3>;
using in_vectors = CGAL::Polyhedron_3<kernel, CGAL::Polyhedron_items_with_id_3, CGAL::HalfedgeDS_vector>;
class derived : public with_id {
  using with_id::with_id;
};
template<class P> using view_of = decltype(indexed(std::declval<const P&>()));
template<class P> concept may_be_temporary = requires { indexed(P()); };

template<class R, class X>
concept walkable = std::ranges::forward_range<R> && std::same_as<std::ranges::range_value_t<R>, X>;

}  // namespace

static_assert(testing::models_in_all_forms<with_id>(testing::surface | testing::embedded | testing::mutable_points));
static_assert(testing::models_in_all_forms<in_vectors>(testing::models<with_id>()) && testing::models_in_all_forms<derived>(testing::models<with_id>()));
static_assert(testing::models_in_all_forms<view_of<plain>>(testing::surface | testing::embedded));
static_assert(testing::models_in_all_forms<view_of<with_id>>(testing::surface | testing::embedded) && std::same_as<view_of<derived>, view_of<with_id>>);
static_assert(!may_be_temporary<plain>);
static_assert(testing::models_in_all_forms<plain>(testing::embedded | testing::mutable_points));  // there is no index_of: use indexed(m)
static_assert(testing::models_in_all_forms<CGAL::Polyhedron_3<kernel, CGAL::Polyhedron_min_items_3>>(testing::nothing));

static_assert(std::same_as<vert_t<with_id>, with_id::Vertex_handle> && std::same_as<poly_t<with_id>, with_id::Facet_handle> &&
              std::same_as<edge_t<with_id>, boost::graph_traits<with_id>::edge_descriptor>);
static_assert(std::same_as<vert_t<view_of<plain>>, plain::Vertex_handle> && is_view_v<view_of<plain>> && !is_view_v<with_id>);
static_assert(walkable<decltype(verts(plain())), vert_t<plain>> && walkable<decltype(edges(plain())), edge_t<plain>> &&
              walkable<decltype(polys(plain())), poly_t<plain>> && walkable<decltype(adj_v2v(plain(), vert_t<plain>())), vert_t<plain>> &&
              walkable<decltype(adj_p2e(plain(), poly_t<plain>())), edge_t<plain>>);

namespace {

template<class P>
struct builder : CGAL::Modifier_base<typename P::HDS> {
  const surface_arrays& arrays;
  explicit builder(const surface_arrays& s) : arrays(s) {}
  void operator()(typename P::HDS& hds) override {
    CGAL::Polyhedron_incremental_builder_3<typename P::HDS> b(hds);
    const auto all = testing::polys_of(arrays);
    b.begin_surface(arrays.points.size(), all.size(), 2 * arrays.verts.size() + 1);
    for (const vec3& x : arrays.points) b.add_vertex(kernel::Point_3(x.x, x.y, x.z));
    for (const auto& poly : all) b.add_facet(poly.begin(), poly.end());
    b.end_surface();
  }
};

template<class P>
void build(P& p, const surface_arrays& s) {
  builder<P> b(s);
  p.delegate(b);
  REQUIRE(p.size_of_facets() == s.num_polys());
  if constexpr (!std::same_as<P, plain>) CGAL::set_halfedgeds_items_id(p);
}

template<class M>
void check_sound(const M& m) {
  for (const auto& b : check_laws(m)) FAIL_CHECK(b.law << ": " << b.what);
}

/// A closed, an open and an empty surface, one with two components and an isolated vert, and polygons that share several verts.
std::vector<surface_arrays> inputs() {
  return {testing::rolled_grid(4, 3), testing::triangle_grid(3), surface_arrays{{}, {}, {}, 3}, testing::two_grids_arrays<trimesh>(2), testing::polygon_grid(2)};
}

}  // namespace

TEST_CASE_TEMPLATE("CGAL polyhedra: laws hold for every polyhedron with ids", P, CONCINO_FIRST_OF(with_id, in_vectors)) {
  for (const surface_arrays& s : inputs()) {
    P p;
    build(p, s);
    CHECK(num_verts(p) == s.points.size());
    CHECK(num_polys(p) == s.num_polys());
    check_sound(p);
    check_sound(indexed(p));
  }
}

TEST_CASE("CGAL polyhedra: laws hold without ids") {
  for (const surface_arrays& s : inputs()) {
    plain p;
    build(p, s);
    check_sound(indexed(p));
  }
}

TEST_CASE("CGAL polyhedra: laws hold after elements were erased") {
  std::mt19937 random(3);
  with_id p;
  build(p, testing::triangle_grid(6));
  p.normalize_border();
  for (int step = 0; step < 10; ++step) {
    auto f = p.facets_begin();
    std::advance(f, random() % p.size_of_facets());
    p.erase_facet(f->halfedge());
    check_sound(indexed(p));
    CGAL::set_halfedgeds_items_id(p);
    check_sound(p);
    if (step == 5) p.normalize_border();
    check_sound(p);
  }
}

TEST_CASE("CGAL polyhedra: ids that are not set, or not unique after an edit, are errors") {
  with_id p;
  const surface_arrays grid = testing::triangle_grid(2);
  builder<with_id> b(grid);
  p.delegate(b);
  CHECK_THROWS_WITH_AS(vert_index_bound(p), doctest::Contains("CGAL::set_halfedgeds_items_id(m)"), invalid_mesh);
  CHECK_THROWS_AS(edge_index_bound(p), invalid_mesh);
  CHECK_THROWS_AS(poly_index_bound(p), invalid_mesh);
  CHECK_THROWS_AS(bfs(p, p.vertices_begin()), invalid_mesh);
  CHECK_THROWS_AS(connected_components(p), invalid_mesh);
  CHECK(!check_laws(p).empty());
  check_sound(indexed(p));
  CGAL::set_halfedgeds_items_id(p);
  check_sound(p);
  p.create_center_vertex(p.facets_begin()->halfedge());
  CHECK_THROWS_AS(make_vert_map<int>(p), invalid_mesh);
  CHECK_THROWS_AS(make_edge_map<int>(p), invalid_mesh);
  CGAL::set_halfedgeds_items_id(p);
  check_sound(p);
  const auto h = p.facets_begin()->halfedge();
  p.split_edge(h);
  CHECK_THROWS_AS(edge_index_bound(p), invalid_mesh);
  CGAL::set_halfedgeds_items_id(p);
  check_sound(p);
  p.split_facet(h, h->next()->next());
  CHECK_THROWS_AS(edge_index_bound(p), invalid_mesh);
  CGAL::set_halfedgeds_items_id(p);
  p.erase_facet(p.facets_begin()->halfedge());
  CHECK_THROWS_AS(poly_index_bound(p), invalid_mesh);
  CHECK_THROWS_AS(edge_index_bound(p), invalid_mesh);
}

TEST_CASE("CGAL polyhedra: contains is true exactly for elements of the polyhedron") {
  with_id p;
  build(p, testing::triangle_grid(2));
  const auto i = indexed(p);
  const auto here = [&](auto x) { return contains(p, x) && contains(i, x); };
  const auto nowhere = [&](auto x) { return !contains(p, x) && !contains(i, x); };
  CHECK(here(p.vertices_begin()));
  CHECK(here(p.facets_begin()));
  CHECK(here(edge_t<with_id>(p.halfedges_begin()->opposite())));
  CHECK(nowhere(vert_t<with_id>()));
  CHECK(nowhere(edge_t<with_id>()));
  CHECK(nowhere(poly_t<with_id>()));
  with_id q;
  build(q, testing::triangle_grid(2));
  CHECK(!contains(i, q.vertices_begin()));
  CHECK(!contains(i, q.facets_begin()));
  CHECK_THROWS_AS(dijkstra(i, q.vertices_begin()), invalid_mesh);
}

TEST_CASE_TEMPLATE("CGAL polyhedra: algorithms take and return handles, and results equal those of the native mesh", P, CONCINO_FIRST_OF(plain, with_id)) {
  const auto arrays = testing::jittered(testing::triangle_grid(5), 0.03);
  P p;
  build(p, arrays);
  const trimesh native(arrays);
  const auto number = [&](vert_t<P> v) { return vert_id{std::distance(p.vertices_begin(), v)}; };
  const auto check = [&](const auto& m) {
    const typename P::Vertex_handle a = p.vertices_begin();
    const auto d = dijkstra(m, a);
    const auto expected = dijkstra(native, vert_id{0});
    for (auto v = p.vertices_begin(); v != p.vertices_end(); ++v) CHECK(d[v] == expected[number(v)]);
    const auto hops = bfs(m, p.facets_begin());
    const auto expected_hops = bfs(native, poly_id{0});
    std::size_t i = 0;
    for (auto f = p.facets_begin(); f != p.facets_end(); ++f, ++i) CHECK(hops[f] == expected_hops[poly_id{i}]);
    const std::vector<typename P::Vertex_handle> path = shortest_path(m, a, std::prev(p.vertices_end()));
    CHECK(path.size() > 5);
    // Both half-edges of an edge give the same edge.
    auto crossed = make_edge_map<int>(m);
    for (auto h = p.halfedges_begin(); h != p.halfedges_end(); ++h) ++crossed[edge_t<P>(h)];
    for (const auto e : edges(m)) CHECK(crossed[e] == 2);
  };
  check(indexed(p));
  if constexpr (SurfaceMesh<P>) check(p);
  // A temporary view can be used: maps store a copy of it.
  CHECK(bfs(indexed(p), p.vertices_begin())[std::prev(p.vertices_end())] == bfs(native, vert_id{0})[vert_id{35}]);
}

TEST_CASE("CGAL polyhedra: set_point moves a point") {
  with_id p;
  build(p, testing::triangle_grid(1));
  const auto i = indexed(p);
  set_point(p, p.vertices_begin(), vec3{7, 8, 9});
  CHECK(p.vertices_begin()->point() == kernel::Point_3(7, 8, 9));
  CHECK(to_vec3(point(i, p.vertices_begin())) == vec3{7, 8, 9});
  plain q;
  build(q, testing::triangle_grid(1));
  set_point(q, q.vertices_begin(), std::array{1, 2, 3});
  CHECK(to_vec3(point(q, q.vertices_begin())) == vec3{1, 2, 3});
}

TEST_CASE("CGAL polyhedra: derived classes work, and iterating needs no index") {
  derived p;
  build(static_cast<with_id&>(p), testing::rolled_grid(3, 3));
  check_sound(p);
  check_sound(indexed(p));
  plain q;
  build(q, testing::rolled_grid(3, 3));
  int corners = 0;
  for (const auto f : polys(q))
    for ([[maybe_unused]] const auto v : adj_p2v(q, f)) ++corners;
  CHECK(corners == 36);
}
