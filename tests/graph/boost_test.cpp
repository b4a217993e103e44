// Views model the graph concepts of Boost: descriptors, iterators, maps. Algorithms of Boost are in boost_algorithms_test.cpp.
#include <concino/graph/boost.hpp>

#include <concino/concepts/archetypes.hpp>
#include <concino/concepts/views.hpp>
#include <concino/edit.hpp>
#include <concino/graph/bfs.hpp>
#include <concino/mesh/boundary.hpp>
#include <concino/mesh/property.hpp>
#include <concino/mesh/submesh.hpp>

#include <support/kinds.hpp>
#include <support/user_mesh.hpp>

#include <boost/graph/connected_components.hpp>
#include <boost/graph/filtered_graph.hpp>
#include <boost/graph/graph_concepts.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

using namespace concino::testing;
namespace cn = concino;

namespace {

/// Whether g models all graph concepts of Boost, with its index map.
template<class G>
constexpr bool models_boost() {
  using traits = boost::graph_traits<G>;
  using vertex = typename traits::vertex_descriptor;
  using edge = typename traits::edge_descriptor;
  BOOST_CONCEPT_ASSERT((boost::concepts::VertexListGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::EdgeListGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::IncidenceGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::BidirectionalGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::AdjacencyGraph<G>));
  BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<G, vertex, boost::vertex_index_t>));
  BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<G, edge, boost::edge_index_t>));
  BOOST_CONCEPT_ASSERT((boost::ForwardIterator<typename traits::vertex_iterator>));
  BOOST_CONCEPT_ASSERT((boost::ForwardIterator<typename traits::edge_iterator>));
  BOOST_CONCEPT_ASSERT((boost::ForwardIterator<typename traits::out_edge_iterator>));
  BOOST_CONCEPT_ASSERT((boost::ForwardIterator<typename traits::in_edge_iterator>));
  BOOST_CONCEPT_ASSERT((boost::ForwardIterator<typename traits::adjacency_iterator>));
  return std::same_as<vertex, cn::detail::node_in<std::remove_const_t<G>>>;
}
template<class G>
constexpr bool weighted() {
  BOOST_CONCEPT_ASSERT((boost::concepts::ReadablePropertyGraph<G, typename boost::graph_traits<G>::edge_descriptor, boost::edge_weight_t>));
  return true;
}
template<class G>
constexpr bool models_with_arcs = models_boost<G>() && models_boost<const G>() && models_boost<cn::views::directed_view<G>>();
template<class M> using primal_of = decltype(cn::primal(std::declval<const M&>()));
template<class M> using dual_of = decltype(cn::dual(std::declval<const M&>()));

template<class M>
constexpr bool kind_models = models_with_arcs<primal_of<M>> && models_with_arcs<dual_of<M>> && weighted<primal_of<M>>() &&
                             weighted<dual_of<M>>() && weighted<cn::views::directed_view<dual_of<M>>>();
static_assert(kind_models<cn::trimesh> && kind_models<cn::quadmesh> && kind_models<cn::polygonmesh>);
static_assert(kind_models<cn::tetmesh> && kind_models<cn::hexmesh> && kind_models<cn::polyhedralmesh>);
static_assert(kind_models<user_mesh::surface> && kind_models<user_mesh::volume>);
static_assert(kind_models<decltype(cn::boundary(std::declval<const cn::hexmesh&>()))>);

using weak_primal = decltype(cn::only_primal_graph(std::declval<const cn::tetmesh&>()));
using weak_dual = decltype(cn::only_dual_graph(std::declval<const cn::tetmesh&>()));
static_assert(models_with_arcs<primal_of<weak_primal>> && models_with_arcs<dual_of<weak_dual>>);
template<class G> concept has_weights = requires(const G& g) { get(boost::edge_weight, g); };
static_assert(!has_weights<primal_of<weak_primal>> && !has_weights<dual_of<weak_dual>>);
static_assert(has_weights<primal_of<decltype(cn::only_embedded_graph(std::declval<const cn::tetmesh&>()))>>);

/// The indices of the ends of the edges in a range, in its order.
template<class G, class Range>
auto ends(const G& g, const Range& range) {
  std::vector<std::pair<std::size_t, std::size_t>> r;
  for (auto it = range.first; it != range.second; ++it)
    r.push_back({get(boost::vertex_index, g, source(*it, g)), get(boost::vertex_index, g, target(*it, g))});
  return r;
}

/// Compares everything that can be iterated in g with adj_v2v or adj_p2p. Returns the name of the first difference, or an empty string.
template<class G>
std::string wrong_walk(const G& g) {
  const auto shown = cn::detail::base_graph(g);
  const auto index = get(boost::vertex_index, g);
  const bool directed = boost::is_directed(g);
  std::set<std::pair<std::size_t, std::size_t>> arcs;
  for (const auto v : shown.nodes()) {
    std::vector<std::pair<std::size_t, std::size_t>> out, in;
    for (const auto w : shown.neighbours(v)) {
      out.push_back({shown.index(v), shown.index(w)});
      in.push_back({shown.index(w), shown.index(v)});
    }
    arcs.insert(out.begin(), out.end());
    if (ends(g, out_edges(v, g)) != out) return "out_edges";
    if (ends(g, in_edges(v, g)) != in) return "in_edges";
    if (out_degree(v, g) != out.size() || in_degree(v, g) != in.size()) return "out_degree, in_degree";
    if (degree(v, g) != (directed ? 2 : 1) * out.size()) return "degree";
    auto [w, last] = adjacent_vertices(v, g);
    for (std::size_t k = 0; k < out.size(); ++k, ++w)
      if (w == last || index[*w] != out[k].second) return "adjacent_vertices";
    if (w != last) return "adjacent_vertices: too many";
  }
  const auto listed = ends(g, edges(g));
  if (num_edges(g) != listed.size()) return "num_edges";
  std::set<std::pair<std::size_t, std::size_t>> met;
  for (const auto& [i, j] : listed)
    if (!met.insert({i, j}).second || (!directed && !met.insert({j, i}).second)) return "edges: one twice";
  if (met != arcs) return "edges";

  const auto number = get(boost::edge_index, g);
  std::set<std::size_t> numbers;
  for (auto [e, last] = edges(g); e != last; ++e) {
    numbers.insert(number[*e]);
    const auto [same, found] = edge(source(*e, g), target(*e, g), g);
    const auto [back, found_back] = edge(target(*e, g), source(*e, g), g);
    if (!found || !found_back || same != *e || number[same] != number[*e]) return "edge";
    if ((back == *e) == directed || (number[back] == number[*e]) == directed) return "edge, from the other end";
    for (auto [i, end] = in_edges(target(*e, g), g); i != end; ++i)
      if ((*i == *e) != (number[*i] == number[*e])) return "number of an edge that comes in";
    for (const auto v : {source(*e, g), target(*e, g)})
      for (auto [i, end] = out_edges(v, g); i != end; ++i)
        if ((*i == *e) != (number[*i] == number[*e])) return "number of an edge that goes out";
  }
  if (numbers.size() != listed.size() || (!numbers.empty() && *numbers.rbegin() != listed.size() - 1)) return "edge_index";
  return "";
}

/// A ring of verts that counts the queries for neighbours.
struct counted_ring {
  std::size_t n;
  mutable int asked = 0;
};
/// A graph of arcs without opposite arcs in general, whose range of verts may be in descending order.
struct arcs {
  std::vector<std::vector<unsigned>> to;
  bool backwards = false;
};
struct numbered { unsigned i = 0; friend bool operator==(numbered, numbered) = default; };
struct from_zero {};

/// A map whose operator[] returns a proxy, and a read-only map.
struct halves {
  using value_type = double;
  std::vector<int>* twice;
  struct proxy {
    int* at;
    operator double() const { return *at / 2.0; }
    const proxy& operator=(double x) const { *at = static_cast<int>(2 * x); return *this; }
  };
  proxy operator[](cn::vert_id v) const { return {&(*twice)[v.raw()]}; }
};
struct squares { unsigned operator[](cn::vert_id v) const { return v.raw() * v.raw(); } };

}  // namespace

template<>
struct concino::mesh_traits<counted_ring> {
  using vert = vert_id;
  static std::size_t num_verts(const counted_ring& r) { return r.n; }
  static std::size_t vert_index_bound(const counted_ring& r) { return r.n; }
  static std::size_t index_of(const counted_ring&, vert_id v) { return v.raw(); }
  static id_range<vert_id> verts(const counted_ring& r) { return id_range<vert_id>(r.n); }
  static std::vector<vert_id> adj_v2v(const counted_ring& r, vert_id v) {
    ++r.asked;
    return {vert_id{(v.raw() + 1) % r.n}, vert_id{(v.raw() + r.n - 1) % r.n}};
  }
};
template<>
struct concino::mesh_traits<arcs> {
  using vert = vert_id;
  static std::size_t num_verts(const arcs& a) { return a.to.size(); }
  static std::size_t vert_index_bound(const arcs& a) { return a.to.size(); }
  static std::size_t index_of(const arcs&, vert_id v) { return v.raw(); }
  static std::vector<vert_id> verts(const arcs& a) {
    std::vector<vert_id> r;
    for (unsigned i = 0; i < a.to.size(); ++i) r.push_back(vert_id{i});
    if (a.backwards) std::reverse(r.begin(), r.end());
    return r;
  }
  static std::vector<vert_id> adj_v2v(const arcs& a, vert_id v) {
    std::vector<vert_id> r;
    for (const unsigned i : a.to[v.raw()]) r.push_back(vert_id{i});
    return r;
  }
};
template<>
struct concino::mesh_traits<from_zero> {
  using vert = numbered;
  static std::size_t num_verts(const from_zero&) { return 2; }
  static std::size_t vert_index_bound(const from_zero&) { return 2; }
  static std::size_t index_of(const from_zero&, numbered v) { return v.i; }
  static std::vector<numbered> verts(const from_zero&) { return {{0}, {1}}; }
  static std::vector<numbered> adj_v2v(const from_zero&, numbered v) { return {{1 - v.i}}; }
};

TEST_CASE_TEMPLATE("boost: iteration and numbers of edges equal those of the mesh", M, CONCINO_KINDS) {
  const M m = two_grids<M>(1);
  CHECK(wrong_walk(cn::primal(m)) == "");
  CHECK(wrong_walk(cn::dual(m)) == "");
  CHECK(wrong_walk(cn::directed(cn::primal(m))) == "");
  CHECK(wrong_walk(cn::directed(cn::dual(m))) == "");
  const M none;
  CHECK(wrong_walk(cn::primal(none)) == "");
  CHECK(wrong_walk(cn::directed(cn::dual(none))) == "");
}

TEST_CASE("boost: iteration works on users' meshes, views and archetypes") {
  const auto s = user_mesh::surface_example();
  const auto w = user_mesh::volume_example();
  CHECK(wrong_walk(cn::primal(s)) == "");
  CHECK(wrong_walk(cn::directed(cn::dual(w))) == "");
  const auto g = cn::only_primal_graph(s);
  const auto d = cn::only_dual_graph(w);
  CHECK(wrong_walk(cn::primal(g)) == "");
  CHECK(wrong_walk(cn::directed(cn::primal(g))) == "");
  CHECK(wrong_walk(cn::dual(d)) == "");
  const auto m = grid<cn::hexmesh>(2);
  CHECK(wrong_walk(cn::primal(cn::boundary(m))) == "");
  CHECK(wrong_walk(cn::dual(cn::submesh(m, [&](auto p) { return p.raw() != 3; }))) == "");
}

TEST_CASE("boost: an undirected edge is the same from both ends, an arc is not") {
  const auto m = grid<cn::quadmesh>(1);
  const auto g = cn::primal(m);
  const auto d = cn::directed(g);
  const cn::vert_id a{0}, b{1}, c{3};
  CHECK(edge(a, b, g).first == edge(b, a, g).first);
  CHECK_FALSE(edge(a, b, g).first != edge(b, a, g).first);
  CHECK(edge(a, b, g).first != edge(b, c, g).first);
  CHECK_FALSE(edge(a, c, g).second);
  CHECK(edge(a, b, d).first != edge(b, a, d).first);
  const auto back = get(boost::edge_reverse, d);
  const auto number = get(boost::edge_index, d);
  for (auto [e, last] = edges(d); e != last; ++e) {
    CHECK(back[*e] == edge(target(*e, d), source(*e, d), d).first);
    CHECK(number[back[*e]] == number[edge(target(*e, d), source(*e, d), d).first]);
    CHECK(number[back[back[*e]]] == number[*e]);
  }
}

TEST_CASE("boost: creating a view copies nothing and iterates over nothing") {
  const counted_ring r{1000};
  const auto g = cn::primal(r);
  [[maybe_unused]] const auto all = vertices(g);
  CHECK(r.asked == 0);
  const auto some = out_edges(cn::vert_id{5}, g);
  CHECK(r.asked == 1);
  CHECK(target(*some.first, g) == cn::vert_id{6});
  auto e = edges(g).first;
  for (int i = 0; i < 10; ++i) ++e;
  CHECK(r.asked < 20);
}

TEST_CASE("boost: iterators outlive the views they came from") {
  const auto m = grid<cn::trimesh>(2);
  auto [v, last] = vertices(cn::primal(m));
  CHECK(std::distance(v, last) == 9);
  auto [e, end] = edges(cn::primal(m));
  CHECK(std::distance(e, end) == 16);
  auto [f, stop] = edges(cn::directed(cn::dual(m)));
  CHECK(std::distance(f, stop) == 16);
  const auto index = get(boost::vertex_index, cn::directed(cn::primal(m)));
  CHECK(index[cn::vert_id{7}] == 7);
}

TEST_CASE("boost: arrays of Boost work with gaps in the indices") {
  auto m = grid<cn::tetmesh>(2);
  for (const unsigned p : {0u, 7u, 20u}) cn::remove_poly(m, cn::poly_id{p});
  cn::remove_vert(m, cn::vert_id{13});
  const auto g = cn::primal(m);
  CHECK(num_vertices(g) == cn::vert_index_bound(m));
  CHECK(std::distance(vertices(g).first, vertices(g).second) == static_cast<long>(cn::num_verts(m)));
  CHECK(wrong_walk(g) == "");
  CHECK(wrong_walk(cn::directed(cn::dual(m))) == "");
  auto label = cn::make_poly_map<int>(m, -1);
  const int k = boost::connected_components(cn::dual(m), cn::boost_map(label));
  for (const auto p : cn::polys(m)) CHECK((label[p] >= 0 && label[p] < k));
}

TEST_CASE("boost_map: has the category that the map allows") {
  auto m = grid<cn::trimesh>(1);
  auto map = cn::make_vert_map<double>(m, 1.5);
  const auto& fixed = map;
  const cn::vert_id v{2};

  auto b = cn::boost_map(map);
  BOOST_CONCEPT_ASSERT((boost::Mutable_LvaluePropertyMapConcept<decltype(b), cn::vert_id>));
  put(b, v, 2.5);
  b[cn::vert_id{1}] += 1;
  CHECK(map[v] == 2.5);
  CHECK(get(b, cn::vert_id{1}) == 2.5);

  const auto c = cn::boost_map(fixed);
  static_assert(std::same_as<decltype(c)::category, boost::readable_property_map_tag> && std::same_as<decltype(c)::value_type, double>);
  CHECK(get(c, v) == 2.5);

  std::vector<int> twice(4);
  const auto h = cn::boost_map<cn::vert_id>(halves{&twice});
  BOOST_CONCEPT_ASSERT((boost::ReadWritePropertyMapConcept<std::remove_const_t<decltype(h)>, cn::vert_id>));
  static_assert(std::same_as<decltype(h)::category, boost::read_write_property_map_tag> && std::same_as<decltype(h)::value_type, double>);
  put(h, v, 3.5);
  CHECK(twice[2] == 7);
  CHECK(get(h, v) == 3.5);

  const auto q = cn::boost_map<cn::vert_id>(squares{});
  static_assert(std::same_as<decltype(q)::category, boost::readable_property_map_tag>);
  CHECK(get(q, v) == 4);

  const auto u = cn::boost_map(cn::vert_property<int>(m, "label"));
  static_assert(std::same_as<decltype(u)::category, boost::lvalue_property_map_tag>);
  put(u, v, 9);
  CHECK(cn::vert_property<int>(m, "label")[v] == 9);

  auto flags = cn::make_vert_map<bool>(m);
  put(cn::boost_map(flags), v, true);
  CHECK(flags[v]);
  auto kept = cn::boost_map(cn::make_vert_map<int>(m, 3));
  auto copy = kept;
  put(copy, v, 4);
  CHECK(get(kept, v) == 4);
}

TEST_CASE("boost_weights and boost_edge_map are property maps of edges") {
  const auto m = grid<cn::quadmesh>(2);
  const auto g = cn::primal(m);
  const auto length = get(boost::edge_weight, g);
  const auto across = get(boost::edge_weight, cn::dual(m));
  for (auto [e, last] = edges(g); e != last; ++e) CHECK(length[*e] == 0.5);
  for (auto [e, last] = edges(cn::dual(m)); e != last; ++e) CHECK(across[*e] == 0.5);
  CHECK(get(boost::edge_weight, g, edge(cn::vert_id{0}, cn::vert_id{1}, g).first) == 0.5);

  const auto sum = [](cn::vert_id a, cn::vert_id b) { return a.raw() + b.raw(); };
  const auto lazy = cn::boost_weights(g, sum);
  const auto kept = cn::boost_edge_map<double>(g, sum);
  const auto ones = cn::boost_edge_map<bool>(g, true);
  for (auto [e, last] = edges(g); e != last; ++e) {
    CHECK(get(lazy, *e) == sum(source(*e, g), target(*e, g)));
    CHECK(get(kept, *e) == get(lazy, *e));
    CHECK(get(ones, *e));
  }
  const auto d = cn::directed(g);
  auto arcs = cn::boost_edge_map<int>(d, [](cn::vert_id a, cn::vert_id b) { return int(a.raw()) - int(b.raw()); });
  for (auto [e, last] = edges(d); e != last; ++e) CHECK(arcs[*e] == -arcs[get(boost::edge_reverse, d)[*e]]);
}

TEST_CASE("boost: a filtered graph excludes nodes and edges") {
  const auto m = grid<cn::hexmesh>(3);
  const auto g = cn::dual(m);
  const auto in_layer = [](cn::poly_id p) { return p.raw() < 9; };
  const auto same_row = [&](const auto& e) { return source(e, g).raw() / 3 == target(e, g).raw() / 3; };
  const boost::filtered_graph layer(g, boost::keep_all(), std::function<bool(cn::poly_id)>(in_layer));
  auto label = cn::make_poly_map<int>(m);
  CHECK(boost::connected_components(layer, cn::boost_map(label)) == 1);
  const boost::filtered_graph rows(g, std::function<bool(boost::graph_traits<decltype(g)>::edge_descriptor)>(same_row));
  CHECK(boost::connected_components(rows, cn::boost_map(label)) == 9);
}

TEST_CASE("boost: throws for asymmetric neighbours, and rejects descriptors without an invalid value") {
  const auto check_refused = [](const arcs& bad, const char* what) {
    CHECK_THROWS_WITH_AS(cn::directed(cn::primal(bad)), doctest::Contains(what), cn::invalid_mesh);
    CHECK_THROWS_WITH_AS(get(boost::edge_index, cn::primal(bad)), doctest::Contains(what), cn::invalid_mesh);
  };
  check_refused({{{1}, {2}, {0}}, false}, "edge numbers: vert 0 is a neighbour of vert 2, but not");  // every vert has as many arcs in as out
  check_refused({{{1}, {2}, {0}}, true}, "edge numbers: vert 2 is a neighbour of vert 1, but not");
  check_refused({{{3}, {2}, {3}, {1, 0}}, false}, "edge numbers: vert 1 is a neighbour of vert 3, but not");
  check_refused({{{1, 2}, {0}, {}}, false}, "edge numbers: vert 2 is a neighbour of vert 0, but not");
  const from_zero zero;
  CHECK(num_edges(cn::primal(zero)) == 1);
  CHECK_THROWS_AS(cn::directed(cn::primal(zero)), cn::unsupported);
}

TEST_CASE("boost: concino's own algorithms run on the same views") {
  const auto m = grid<cn::tetmesh>(2);
  const auto hops = cn::bfs(m, cn::vert_id{0});
  const auto seen = cn::bfs(cn::primal(m), cn::vert_id{0});
  for (const auto v : cn::verts(m)) CHECK(hops[v] == seen[v]);
}
