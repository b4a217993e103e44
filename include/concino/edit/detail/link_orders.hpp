// The order of a vert or an edge of triangles or tets: how far the complex is from a manifold there, by its link.
//
// A simplex has order 0 if the complex is a manifold at it, order i if a neighbourhood of it is the product of a space
// and of one that has i dimensions, and no smaller i will do. So points of order 1 are at boundaries and where sheets
// meet in a curve (of triangles) or in a surface (of tets).
// Source: Dey, Edelsbrunner, Guha and Nekhayev 1999, "Topology preserving edge contraction".
#pragma once

#include <concino/edit/detail/link_simplices.hpp>

namespace concino::detail {

/// Disjoint sets of a few numbers.
class few_sets {
  core::small_array<unsigned, 96> parent_;
  std::size_t num_sets_;

  unsigned root(unsigned x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }

 public:
  explicit few_sets(std::size_t n) : num_sets_(n) {
    for (unsigned i = 0; i < n; ++i) parent_.push_back(i);
  }
  void unite(unsigned x, unsigned y) {
    x = root(x), y = root(y);
    if (x != y) parent_[x] = y, --num_sets_;
  }
  std::size_t size() const { return num_sets_; }
};

inline void count_verts(std::size_t& n, core::small_array<unsigned, 64>& uses, unsigned v) {
  if (uses[v]++ == 0) ++n;
}

/// The number of components of a complex, without the vert `left_out`.
template<std::size_t N>
std::size_t num_components(const simplex_list<N>& all, unsigned num_verts, unsigned left_out = ~0u) {
  few_sets sets(num_verts);
  core::small_array<unsigned, 64> uses(num_verts, 0);
  std::size_t n = 0;
  for (const local_simplex<N>& s : all) {
    unsigned first = left_out;
    for (const unsigned v : s) {
      if (v == left_out) continue;
      count_verts(n, uses, v);
      if (first == left_out) first = v;
      else sets.unite(first, v);
    }
  }
  return sets.size() - (num_verts - n);
}

/// The number of verts of a complex.
template<std::size_t N>
std::size_t num_verts_of(const simplex_list<N>& all, unsigned num_verts) {
  core::small_array<unsigned, 64> uses(num_verts, 0);
  std::size_t n = 0;
  for (const local_simplex<N>& s : all)
    for (const unsigned v : s) count_verts(n, uses, v);
  return n;
}

/// Whether the link of a vert is a circle (N = 2) or a sphere (N = 3): each facet has two simplices, these are
/// connected, and the Euler characteristic is that of a sphere.
template<std::size_t N>
bool is_sphere(const simplex_list<N>& link, unsigned num_verts) {
  struct entry {
    std::uint64_t key;
    unsigned simplex;
    bool operator<(const entry& x) const { return key < x.key; }
  };
  core::small_array<entry, 96> entries;
  for (unsigned k = 0; k < link.size(); ++k)
    for (unsigned left_out = 0; left_out < N; ++left_out) {
      std::uint64_t key = 0;
      for (unsigned i = 0; i < N; ++i)
        if (i != left_out) key = key << 32 | link[k][i];
      entries.push_back({key, k});
    }
  if (entries.size() % 2 != 0) return false;
  std::sort(entries.begin(), entries.end());
  few_sets sets(link.size());
  for (std::size_t i = 0; i < entries.size(); i += 2) {
    if (entries[i].key != entries[i + 1].key || (i > 0 && entries[i - 1].key == entries[i].key)) return false;
    sets.unite(entries[i].simplex, entries[i + 1].simplex);
  }
  if (sets.size() != 1) return false;
  if constexpr (N == 3) return num_verts_of<3>(link, num_verts) == 2 + link.size() / 2;
  else return true;
}

/// A graph that is the link of a vert of triangles, or of an edge of tets.
struct graph_link {
  unsigned order = 2;                      // of that vert or edge
  std::ptrdiff_t euler_characteristic = 0;
  core::small_array<unsigned, 16> degrees;  // other than 2, ascending
};

inline void describe(const simplex_list<2>& graph, unsigned num_verts, graph_link& g) {
  core::small_array<unsigned, 64> degree(num_verts, 0);
  std::size_t n = 0;
  for (const local_simplex<2>& e : graph)
    for (const unsigned v : e) count_verts(n, degree, v);
  g.euler_characteristic = static_cast<std::ptrdiff_t>(n) - static_cast<std::ptrdiff_t>(graph.size());
  unsigned odd = 0;
  for (unsigned v = 0; v < num_verts; ++v)
    if (degree[v] != 0 && degree[v] != 2) odd = v, g.degrees.push_back(degree[v]);
  std::sort(g.degrees.begin(), g.degrees.end());
  if (num_components<2>(graph, num_verts) != 1) return;
  if (g.degrees.empty()) g.order = 0;
  // all arcs join the two
  else if (g.degrees.size() == 2 && g.degrees[0] == g.degrees[1] && num_components<2>(graph, num_verts, odd) == 1)
    g.order = 1;
}

/// The link of a vert of tets.
struct complex_link {
  unsigned order = 3;                                  // of the vert
  core::small_array<unsigned char, 64> order_of_edge;  // to each vert of the link
  weighted_simplices<2> odd;                           // edges of the link that do not have two triangles, with the
                                                       // numbers of these
};

inline void describe(const simplex_list<3>& link, unsigned num_verts, complex_link& c) {
  find_odd_facets<3>(link, nullptr, c.odd);
  c.order_of_edge.resize(num_verts, 0);
  core::small_array<unsigned, 64> uses(num_verts, 0);
  std::size_t n = 0, num_edges = 0, num_singular = 0;  // edges are counted twice
  graph_link singular[2];
  for (const local_simplex<3>& s : link)
    for (const unsigned v : s) count_verts(n, uses, v);
  for (unsigned v = 0; v < num_verts; ++v) {
    if (uses[v] == 0) continue;
    simplex_list<2> graph;
    for (const local_simplex<3>& s : link)
      if (s[0] == v || s[1] == v || s[2] == v) add_link_simplex<2>(graph, s.data(), 3, v, v);
    num_edges += num_verts_of<2>(graph, num_verts);
    graph_link scratch;
    graph_link& g = num_singular < 2 ? singular[num_singular] : scratch;
    g.degrees.clear();
    g.order = 2;
    describe(graph, num_verts, g);
    c.order_of_edge[v] = static_cast<unsigned char>(g.order);
    num_singular += g.order == 2;
  }
  if (num_components<3>(link, num_verts) != 1) return;
  const std::ptrdiff_t chi = static_cast<std::ptrdiff_t>(n + link.size()) - static_cast<std::ptrdiff_t>(num_edges / 2);
  if (num_singular == 0 && c.odd.simplices.empty()) {
    if (chi == 2) c.order = 0;
  } else if (num_singular == 0) {  // discs that are glued together at one circle have the largest Euler characteristic
    if (chi == static_cast<std::ptrdiff_t>(c.odd.weights[0]) && num_components<2>(c.odd.simplices, num_verts) == 1)
      c.order = 1;
  } else if (num_singular == 2) {
    const graph_link &g = singular[0], &h = singular[1];
    const bool are_alike = g.euler_characteristic == h.euler_characteristic &&
                           std::equal(g.degrees.begin(), g.degrees.end(), h.degrees.begin(), h.degrees.end());
    if (are_alike && chi == 2 - g.euler_characteristic) c.order = 2;
  }
}

/// Whether no simplex of the verts a and b has a higher order without than with the edge ab, for triangles. The links
/// of a and b meet in that of ab.
inline bool orders_allow_collapse(const simplex_list<2>& a, const simplex_list<2>& b, const simplex_list<1>& ab,
                                  unsigned num_verts) {
  graph_link at_a, at_b;
  describe(a, num_verts, at_a), describe(b, num_verts, at_b);
  if (std::min(at_a.order, at_b.order) > (ab.size() == 2 ? 0u : 1u)) return false;
  core::small_array<unsigned, 64> of_a(num_verts, 0), of_b(num_verts, 0);
  for (const local_simplex<2>& e : a) ++of_a[e[0]], ++of_a[e[1]];
  for (const local_simplex<2>& e : b) ++of_b[e[0]], ++of_b[e[1]];
  const auto is_odd = [](unsigned n) { return n != 0 && n != 2; };
  for (unsigned v = 0; v < num_verts; ++v)
    if (is_odd(of_a[v]) && is_odd(of_b[v])) return false;
  return true;
}

/// The same for tets.
inline bool orders_allow_collapse(const simplex_list<3>& a, const simplex_list<3>& b, const simplex_list<2>& ab,
                                  unsigned num_verts) {
  complex_link at_a, at_b;
  graph_link at_edge;
  describe(a, num_verts, at_a), describe(b, num_verts, at_b), describe(ab, num_verts, at_edge);
  if (std::min(at_a.order, at_b.order) > at_edge.order) return false;
  core::small_array<unsigned, 64> of_edge(num_verts, 0);
  for (const local_simplex<2>& e : ab) ++of_edge[e[0]], ++of_edge[e[1]];
  for (unsigned v = 0; v < num_verts; ++v)
    if (std::min(at_a.order_of_edge[v], at_b.order_of_edge[v]) > (of_edge[v] == 2 ? 0 : 1)) return false;
  for (const local_simplex<2>& e : at_a.odd.simplices)
    if (std::binary_search(at_b.odd.simplices.begin(), at_b.odd.simplices.end(), e)) return false;
  return true;
}

}  // namespace concino::detail
