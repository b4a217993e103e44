// Random meshes with random barriers, as a mesh and as the list of the remaining arcs. Tests compare graph algorithms on the mesh with other
// implementations on the list.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/concepts/views.hpp>

#include <support/boost_graph.hpp>
#include <support/corpus.hpp>
#include <support/random_meshes.hpp>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <iterator>
#include <random>
#include <vector>

namespace concino::testing {

/// The graph of a mesh that a test uses: primal or dual.
template<class M_>
struct primal_side {
  using M = M_;
  using node = vert_t<M>;
  static auto view(const M& m) { return primal(m); }
  static auto nodes(const M& m) { return verts(m); }
  static std::size_t bound(const M& m) { return vert_index_bound(m); }
  static std::size_t num_crossings(const M& m) { return edge_index_bound(m); }
  /// Calls f(a, b, x) once for each pair of adjacent nodes a, b and each element x between them.
  template<class F> static void for_each_join(const M& m, const F& f) {
    for (const auto e : edges(m)) f(*adj_e2v(m, e).begin(), *std::next(adj_e2v(m, e).begin()), e);
  }
};
template<class M_>
struct dual_side {
  using M = M_;
  using node = poly_t<M>;
  static auto view(const M& m) { return dual(m); }
  static auto nodes(const M& m) { return polys(m); }
  static std::size_t bound(const M& m) { return poly_index_bound(m); }
  static std::size_t num_crossings(const M& m) {
    return facet_index_bound(m);
  }
  template<class F> static void for_each_join(const M& m, const F& f) {
    const auto pairs = [&](const auto x, const auto& at_x) {
      for (const auto p : at_x)
        for (const auto q : at_x)
          if (index_of(m, p) < index_of(m, q)) f(p, q, x);
    };
    for (const auto x : facets(m)) pairs(x, adj_facet2p(m, x));
  }
};

template<class Side>
struct barred_graph {
  using side = Side;
  using M = typename Side::M;
  using node = typename Side::node;

  M m;
  std::vector<char> free_node, free_crossing;  // by index_of
  unsigned salt = 0;

  auto enter() const {
    return [this](node v) { return free_node[index_of(m, v)] != 0; };
  }
  auto cross() const {
    return [this](auto x) { return free_crossing[index_of(m, x)] != 0; };
  }
  /// Lengths that are integers, so that sums are exact. Some are zero, and the length differs by direction. In some meshes they are small and often
  /// equal.
  auto length() const {
    return [this](node a, node b) { return double(((index_of(m, a) * 31 + index_of(m, b) * 17 + salt) * 2654435761u % 1009) % (salt % 3 == 0 ? 1009 : 4)); };
  }
  /// Lengths that are the same in both directions.
  auto even_length() const {
    return [l = length()](node a, node b) { return l(a, b) + l(b, a); };
  }
  std::vector<node> nodes() const {
    std::vector<node> r;
    for (const node x : Side::nodes(m)) r.push_back(x);
    return r;
  }
  std::size_t bound() const { return Side::bound(m); }

  /// Calls f(a, b) for all arcs with an open crossing and an open node b, in both directions.
  template<class F> void for_each_arc(const F& f) const {
    Side::for_each_join(m, [&](node a, node b, auto x) {
      if (!cross()(x)) return;
      if (enter()(b)) f(a, b);
      if (enter()(a)) f(b, a);
    });
  }
  template<class L> std::vector<arc> arcs(const L& length_of) const {
    std::vector<arc> r;
    for_each_arc([&](node a, node b) { r.push_back({index_of(m, a), index_of(m, b), length_of(a, b)}); });
    return r;
  }
  bool has_arc(node a, node b) const {
    bool found = false;
    for_each_arc([&](node x, node y) { found = found || (x == a && y == b); });
    return found;
  }
};

/// A graph of a random mesh with about one node in five and one crossing in four closed; in some meshes none is.
template<class Side>
barred_graph<Side> random_barred_graph(std::mt19937& random) {
  using M = typename Side::M;
  barred_graph<Side> g;
  g.m = random_mesh<M>(random);
  const bool open = random() % 4 == 0;
  const auto flags = [&](std::size_t n, unsigned closed_of) {
    std::vector<char> r(n);
    for (char& c : r) c = open || random() % closed_of != 0;
    return r;
  };
  g.free_node = flags(Side::bound(g.m), 5);
  g.free_crossing = flags(Side::num_crossings(g.m), 4);
  g.salt = static_cast<unsigned>(random());
  return g;
}

/// Calls check(g) for random primal and dual graphs of meshes of kind M, `count` meshes each.
template<class M, class F>
void for_random_graphs(unsigned count, const F& check) {
  std::mt19937 random(20);
  for (unsigned i = 0; i < count; ++i) {
    check(random_barred_graph<primal_side<M>>(random));
    check(random_barred_graph<dual_side<M>>(random));
  }
}

using boost_undirected = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, boost::property<boost::edge_weight_t, double>>;

template<class Side, class L>
boost_undirected make_undirected(const barred_graph<Side>& g, const L& length) {
  boost_undirected r(g.bound());
  for (const arc& a : g.arcs(length))
    if (a.from < a.to && g.free_node[a.from]) add_edge(a.from, a.to, a.length, r);
  return r;
}

/// The component of each index. Closed nodes and gaps are components of their own.
inline std::vector<int> boost_components(const boost_undirected& g) {
  std::vector<int> r(num_vertices(g));
  boost::connected_components(g, r.data());
  return r;
}

inline double boost_tree_weight(const boost_undirected& g) {
  std::vector<boost_undirected::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(g, std::back_inserter(tree));
  double sum = 0;
  for (const auto& e : tree) sum += get(boost::edge_weight, g, e);
  return sum;
}

}  // namespace concino::testing
