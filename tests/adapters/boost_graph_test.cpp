#include <concino/adapters/boost_graph.hpp>

#include <concino/concepts/views.hpp>
#include <concino/graph.hpp>
#include <concino/operators/laplacian.hpp>
#include <concino/validate/check_laws.hpp>

#include <support/kinds.hpp>
#include <support/models.hpp>

#include <boost/graph/adjacency_matrix.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/grid_graph.hpp>
#include <boost/graph/reverse_graph.hpp>
#include <doctest/doctest.h>

#include <iterator>
#include <utility>
#include <vector>

using namespace concino;
using namespace concino::testing;

namespace {

using pairs = std::vector<std::pair<std::size_t, std::size_t>>;

/// A graph to which edges are added one by one; a directed graph gets both directions.
template<class G>
struct listed {
  static constexpr bool one_way = boost::is_directed_graph<G>::value;
  G g;
  listed(std::size_t n, const pairs& edges) : g(n) {
    for (const auto& [a, b] : edges) {
      add_edge(a, b, g);
      if (one_way) add_edge(b, a, g);
    }
  }
  const G& shown() const { return g; }
  std::size_t vert(std::size_t i) const { return i; }
};

template<class D, class Number>
struct csr {
  using graph = boost::compressed_sparse_row_graph<D, boost::no_property, boost::no_property, boost::no_property, Number>;
  graph g;
  static pairs both_ways(pairs edges) {
    const pairs once = edges;
    for (const auto& [a, b] : once) edges.emplace_back(b, a);
    return edges;
  }
  csr(std::size_t n, const pairs& edges) : csr(static_cast<Number>(n), both_ways(edges), 0) {}
  csr(Number n, const pairs& arcs, int) : g(boost::edges_are_unsorted_multi_pass, arcs.begin(), arcs.end(), n) {}
  const graph& shown() const { return g; }
  Number vert(std::size_t i) const { return static_cast<Number>(i); }
};

/// A graph whose verts are pointers, numbered by a property.
struct linked {
  using graph = boost::adjacency_list<boost::listS, boost::listS, boost::undirectedS, boost::property<boost::vertex_index_t, int>>;
  graph g;
  std::vector<graph::vertex_descriptor> all;
  linked(std::size_t n, const pairs& edges) {
    for (std::size_t i = 0; i < n; ++i) all.push_back(add_vertex(static_cast<int>(i), g));
    for (const auto& [a, b] : edges) add_edge(all[a], all[b], g);
  }
  auto shown() const { return graph_view(g); }
  auto vert(std::size_t i) const { return all[i]; }
};

/// The same without numbers.
struct unnumbered {
  using graph = boost::adjacency_list<boost::vecS, boost::listS, boost::undirectedS>;
  graph g;
  std::vector<graph::vertex_descriptor> all;
  struct index { const std::vector<graph::vertex_descriptor>* all; };
  friend std::size_t get(index m, graph::vertex_descriptor v) {
    return static_cast<std::size_t>(std::find(m.all->begin(), m.all->end(), v) - m.all->begin());
  }
  unnumbered(std::size_t n, const pairs& edges) {
    for (std::size_t i = 0; i < n; ++i) all.push_back(add_vertex(g));
    for (const auto& [a, b] : edges) add_edge(all[a], all[b], g);
  }
  auto shown() const { return graph_view(g, index{&all}); }
  auto vert(std::size_t i) const { return all[i]; }
};

struct matrix : listed<boost::adjacency_matrix<boost::undirectedS>> {
  using listed::listed;
  auto shown() const { return graph_view(g); }
};

/// A view of a graph that does not need one.
struct shown_list : listed<boost::adjacency_list<>> {
  using listed::listed;
  auto shown() const { return graph_view(g); }
};

/// A user's class.
struct roads : boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, boost::property<boost::edge_weight_t, double>> {
  using adjacency_list::adjacency_list;
};

template<class G>
using arc_lists = boost::adjacency_list<boost::vecS, boost::vecS, G>;

template<class M>
pairs edges_of(const M& m) {
  pairs all;
  for (const auto v : verts(m))
    for (const auto w : adj_v2v(m, v))
      if (index_of(m, v) < index_of(m, w)) all.emplace_back(index_of(m, v), index_of(m, w));
  return all;
}

}  // namespace

static_assert(models_in_all_forms<csr<boost::directedS, unsigned>::graph>(primal_graph) && models_in_all_forms<boost::adjacency_list<>>(primal_graph));
static_assert(models_in_all_forms<roads>(primal_graph) && std::same_as<vert_t<roads>, std::size_t>);
static_assert(models_in_all_forms<decltype(std::declval<linked>().shown())>(primal_graph));
static_assert(models_in_all_forms<linked::graph>(nothing) && models_in_all_forms<boost::adjacency_matrix<>>(nothing));  // these need graph_view
static_assert(requirement::has_vertex_index<linked::graph> && !requirement::has_vertex_index<int> && !requirement::has_vertex_index<std::vector<int>>);
static_assert(requirement::is_boost_graph<unnumbered::graph> && !requirement::has_vertex_index<unnumbered::graph>);

TEST_CASE_TEMPLATE("Boost's graphs: iteration and searches work on every graph class", G, csr<boost::directedS, std::size_t>, csr<boost::directedS, unsigned>,
                   csr<boost::bidirectionalS, std::size_t>, listed<arc_lists<boost::undirectedS>>, listed<arc_lists<boost::directedS>>,
                   listed<arc_lists<boost::bidirectionalS>>, listed<boost::adjacency_list<boost::setS, boost::vecS, boost::undirectedS>>, listed<roads>, linked,
                   unnumbered, matrix, shown_list) {
  const auto m = two_grids<polygonmesh>(4);
  const G copy(num_verts(m), edges_of(m));
  const auto& g = copy.shown();
  using vert = vert_t<decltype(g)>;
  static_assert(std::ranges::forward_range<decltype(verts(g))> && std::ranges::forward_range<decltype(adj_v2v(g, vert()))>);
  REQUIRE(num_verts(g) == num_verts(m));
  REQUIRE(vert_index_bound(g) == num_verts(m));
  const auto hops = bfs(g, copy.vert(7));
  const auto mesh_hops = bfs(m, vert_id{7});
  for (const vert v : verts(g)) {
    const vert_id w{index_of(g, v)};
    CHECK(copy.vert(w.raw()) == v);
    CHECK(contains(g, v));
    CHECK(hops[v] == mesh_hops[w]);
    std::size_t neighbours = 0;
    for (const vert u : adj_v2v(g, v)) {
      ++neighbours;
      const auto near = adj_v2v(m, w);
      CHECK(std::find(near.begin(), near.end(), vert_id{index_of(g, u)}) != near.end());
    }
    CHECK(neighbours == adj_v2v(m, w).size());
  }

  const G none(0, {});
  CHECK(num_verts(none.shown()) == 0);
  CHECK(vert_index_bound(none.shown()) == 0);
  const G apart(3, {{0, 2}});
  CHECK(bfs(apart.shown(), apart.vert(0))[apart.vert(1)] == -1);
  CHECK(bfs(apart.shown(), apart.vert(0))[apart.vert(2)] == 1);
}

TEST_CASE_TEMPLATE("Boost's graphs: laws hold; paths, components and trees equal those of the copied mesh", G, csr<boost::directedS, unsigned>,
                   listed<arc_lists<boost::undirectedS>>, linked) {
  const polygonmesh m(jittered(two_grids_arrays<polygonmesh>(4), 0.05));
  const G copy(num_verts(m), edges_of(m));
  const auto& g = copy.shown();
  CHECK(check_laws(g).empty());
  using vert = vert_t<decltype(g)>;
  const auto length = [&](vert v, vert w) { return distance(point(m, vert_id{index_of(g, v)}), point(m, vert_id{index_of(g, w)})); };
  const vert s = copy.vert(7), t = copy.vert(20);

  const auto far = dijkstra(g, s, length);
  const auto mesh_far = dijkstra(m, vert_id{7});
  const auto pieces = connected_components(g);
  const auto mesh_pieces = connected_components(m);
  CHECK(pieces.count == mesh_pieces.count);
  for (const vert v : verts(g)) {
    const vert_id w{index_of(g, v)};
    CHECK(far[v] == mesh_far[w]);
    CHECK(pieces[v] == mesh_pieces[w]);
  }

  const auto same = [&](vert v, vert_id w) { return index_of(g, v) == w.raw(); };
  const auto path = shortest_path(g, s, t, length);
  const auto mesh_path = shortest_path(m, vert_id{7}, vert_id{20});
  REQUIRE(path.size() == mesh_path.size());
  for (std::size_t i = 0; i < path.size(); ++i) CHECK(same(path[i], mesh_path[i]));

  const auto tree = spanning_tree(g, length);
  const auto mesh_tree = spanning_tree(m);
  CHECK(tree.weight == mesh_tree.weight);
  REQUIRE(tree.arcs.size() == mesh_tree.arcs.size());
  for (std::size_t i = 0; i < tree.arcs.size(); ++i)
    CHECK((same(tree.arcs[i].first, mesh_tree.arcs[i].first) && same(tree.arcs[i].second, mesh_tree.arcs[i].second)));
}

TEST_CASE("Boost's graphs: have a Laplacian") {
  const auto m = grid<polygonmesh>(4);
  const csr<boost::directedS, unsigned> copy(num_verts(m), edges_of(m));
  CHECK((laplacian(copy.g, uniform) - laplacian(m, uniform)).norm() == 0);
}

TEST_CASE("Boost's graphs: a number is a vert, and an invalid one is an error") {
  const arc_lists<boost::undirectedS> g(3);
  CHECK(bfs(g, 0)[0] == 0);
  CHECK(bfs(graph_view(g), 2)[2] == 0);
  CHECK_THROWS_AS(bfs(g, 3), invalid_mesh);
  CHECK_THROWS_AS(bfs(g, -1), invalid_mesh);
  CHECK_THROWS_AS(bfs(graph_view(g), 3), invalid_mesh);
  CHECK_THROWS_AS(dijkstra(g, 0, [](std::size_t, std::size_t) { return 1.0; }, {.targets = {5}}), invalid_mesh);
}

TEST_CASE("Boost's graphs: check_laws reports laws that Boost does not require") {
  arc_lists<boost::directedS> one_way(3);
  add_edge(0, 1, one_way);
  add_edge(1, 2, one_way);
  const auto lacking = check_laws(one_way);
  REQUIRE(!lacking.empty());
  CHECK(lacking[0].law == "PG3");
  CHECK(bfs(one_way, 0)[2] == 2);  // only in the direction of the arcs
  CHECK(bfs(one_way, 2)[0] == -1);
  CHECK(dijkstra(one_way, 0, [](auto, auto) { return 2.0; })[2] == 4);

  arc_lists<boost::undirectedS> doubled(2);
  add_edge(0, 1, doubled);
  add_edge(0, 1, doubled);
  REQUIRE(!check_laws(doubled).empty());
  CHECK(check_laws(doubled)[0].law == "PG4");
  arc_lists<boost::undirectedS> looped(1);
  add_edge(0, 0, looped);
  REQUIRE(!check_laws(looped).empty());
  CHECK(check_laws(looped)[0].law == "PG4");
}

TEST_CASE("graph_view: works on a graph with fewer verts than indices") {
  struct odd_only {
    bool operator()(std::size_t v) const { return v % 2 == 1; }
  };
  arc_lists<boost::undirectedS> path(8);
  for (std::size_t i = 0; i + 2 < 8; ++i) add_edge(i, i + 2, path);
  const boost::filtered_graph<arc_lists<boost::undirectedS>, boost::keep_all, odd_only> odd(path, {}, {});
  const auto g = graph_view(odd);
  CHECK(num_verts(g) == 4);
  CHECK(vert_index_bound(g) == 8);
  CHECK(check_laws(g).empty());
  CHECK(bfs(g, 1)[7] == 3);
  CHECK_THROWS_AS(bfs(g, 2), invalid_mesh);
  CHECK(connected_components(g).count == 1);
}

TEST_CASE("graph_view: works on implicit graphs and reversed ones") {
  using cell = boost::array<std::size_t, 2>;  // a vert is itself a container
  const boost::grid_graph<2> plane(cell{{5, 4}});
  const auto g = graph_view(plane);
  CHECK(check_laws(g).empty());
  CHECK(bfs(g, cell{{0, 0}})[cell{{4, 3}}] == 7);
  CHECK(bfs(g, std::vector<cell>{{{0, 0}}, {{4, 2}}})[cell{{4, 3}}] == 1);
  CHECK(shortest_path(g, cell{{0, 0}}, cell{{4, 0}}, [](const cell&, const cell&) { return 1.0; }).size() == 5);

  arc_lists<boost::bidirectionalS> one_way(3);
  add_edge(0, 1, one_way);
  add_edge(1, 2, one_way);
  const auto back = boost::make_reverse_graph(one_way);
  CHECK(bfs(graph_view(back), 2)[0] == 2);
}

TEST_CASE("Boost's graphs: weights are lengths, points are coordinates, new edges are seen") {
  roads g(4);
  add_edge(0, 1, 5.0, g);
  add_edge(1, 2, 1.0, g);
  add_edge(0, 3, 1.0, g);
  const auto weight = get(boost::edge_weight, g);
  const auto length = [&](std::size_t u, std::size_t v) { return get(weight, edge(u, v, g).first); };
  const auto seen = graph_view(g);
  CHECK(dijkstra(g, 0, length)[2] == 6);
  add_edge(3, 2, 2.0, g);
  CHECK(dijkstra(g, 0, length)[2] == 3);
  CHECK(dijkstra(seen, 0, length)[2] == 3);
  CHECK(shortest_path(seen, 0, 2, length) == std::vector<std::size_t>{0, 3, 2});

  const std::vector<vec3> points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 3, 0}};
  CHECK(dijkstra(with_points(g, points), 0)[2] == 2);
}
