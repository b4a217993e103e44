// Iterators for Boost.Graph: over the neighbours of a node, the edges at it, all edges. Edges are computed during
// iteration, nothing is copied.
#pragma once

#include <concino/concepts/views/dual.hpp>
#include <concino/concepts/views/primal.hpp>
#include <concino/graph/detail/any_iterator.hpp>
#include <concino/graph/detail/edge_numbers.hpp>

#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace concino::views {

template<class G> class directed_view;

}  // namespace concino::views

namespace concino::detail {

template<class M> primal_graph<M> base_graph(const views::primal_view<M>& g) { return {g.base()}; }
template<class M> dual_graph<M> base_graph(const views::dual_view<M>& g) { return {g.base()}; }
template<class G> auto base_graph(const views::directed_view<G>& g) { return base_graph(g.base()); }

template<class G> inline constexpr bool is_directed = false;
template<class G> inline constexpr bool is_directed<views::directed_view<G>> = true;
template<class G> inline constexpr bool is_undirected = false;
template<class M> inline constexpr bool is_undirected<views::primal_view<M>> = true;
template<class M> inline constexpr bool is_undirected<views::dual_view<M>> = true;
template<class G> concept boost_view = is_directed<G> || is_undirected<G>;

template<class G> struct undirected_of { using type = G; };
template<class G> struct undirected_of<views::directed_view<G>> { using type = G; };
template<class G> using undirected_form = typename undirected_of<G>::type;

template<class G> using base_graph_t = decltype(base_graph(std::declval<const G&>()));
template<class G> using node_in = typename base_graph_t<G>::node;
template<class G> using edge_in = node_pair<node_in<G>, is_directed<G>>;
template<class G> using nodes_in = decltype(std::declval<const base_graph_t<G>&>().nodes());
template<class G>
using ring_in = decltype(std::declval<const base_graph_t<G>&>().neighbours(std::declval<const node_in<G>&>()));

/// A graph stored in iterators and maps: by value if copies cost nothing, else as one copy that all of them share.
template<class G, bool = std::is_trivially_copyable_v<G>>
class graph_storage {
  std::optional<G> g_;

 public:
  graph_storage() = default;
  explicit graph_storage(const G& g) : g_(g) {}
  const G& get() const { return *g_; }
};
template<class G>
class graph_storage<G, false> {
  std::shared_ptr<const G> g_;

 public:
  graph_storage() = default;
  explicit graph_storage(const G& g) : g_(std::make_shared<const G>(g)) {}
  const G& get() const { return *g_; }
};

/// An iterator over a range of nodes: those of a graph, or the neighbours of a node.
template<class Node, class R>
class node_iterator : public forward_iterator<node_iterator<Node, R>, Node> {
  any_iterator<R> at_;

 public:
  node_iterator() = default;
  explicit node_iterator(any_iterator<R> at) : at_(std::move(at)) {}
  template<class F>
  static std::pair<node_iterator, node_iterator> begin_and_end(const F& make) {
    auto [b, e] = any_iterator<R>::begin_and_end(make);
    return {node_iterator(std::move(b)), node_iterator(std::move(e))};
  }
  Node operator*() const { return *at_; }
  void next() { at_.next(); }
  friend bool operator==(const node_iterator& a, const node_iterator& b) { return a.at_ == b.at_; }
  friend bool operator!=(const node_iterator& a, const node_iterator& b) { return !(a == b); }
};

/// An iterator over the edges at one node, directed away from it (Outwards) or towards it.
template<class Edge, class R, bool Outwards>
class incidence_iterator : public forward_iterator<incidence_iterator<Edge, R, Outwards>, Edge> {
  using node = decltype(Edge::source);
  node self_{};
  any_iterator<R> at_;
  std::uint32_t slot_ = 0;

 public:
  incidence_iterator() = default;
  incidence_iterator(const node& self, any_iterator<R> at) : self_(self), at_(std::move(at)) {}
  template<class F>
  static std::pair<incidence_iterator, incidence_iterator> begin_and_end(const node& self, const F& make) {
    auto [b, e] = any_iterator<R>::begin_and_end(make);
    return {incidence_iterator(self, std::move(b)), incidence_iterator(self, std::move(e))};
  }
  Edge operator*() const {
    if constexpr (Outwards) return {self_, *at_, slot_, true};
    else return {*at_, self_, slot_, false};
  }
  void next() {
    at_.next();
    ++slot_;
  }
  friend bool operator==(const incidence_iterator& a, const incidence_iterator& b) { return a.at_ == b.at_; }
  friend bool operator!=(const incidence_iterator& a, const incidence_iterator& b) { return !(a == b); }
};

/// An iterator over all edges: undirected ones once, from the end of smaller index; directed ones all.
template<class G>
class edge_iterator : public forward_iterator<edge_iterator<G>, edge_in<G>> {
  using nodes = node_iterator<node_in<G>, nodes_in<G>>;
  using ring = incidence_iterator<edge_in<G>, ring_in<G>, true>;
  graph_storage<G> g_;
  nodes node_, last_node_;
  ring edge_, last_edge_;

  bool is_listed() const {
    if constexpr (is_directed<G>) {
      return true;
    } else {
      const auto g = base_graph(g_.get());
      const edge_in<G> e = *edge_;
      return g.index(e.source) < g.index(e.target);
    }
  }
  void enter() {
    const node_in<G> v = *node_;
    std::tie(edge_, last_edge_) =
        ring::begin_and_end(v, [&]() -> decltype(auto) { return base_graph(g_.get()).neighbours(v); });
  }
  void skip_invalid() {
    for (;;) {
      for (; edge_ != last_edge_; ++edge_)
        if (is_listed()) return;
      ++node_;
      if (node_ == last_node_) break;
      enter();
    }
    edge_ = last_edge_ = {};
  }

 public:
  edge_iterator() = default;
  /// The end iterator if first == last.
  edge_iterator(const G& g, nodes first, nodes last) : g_(g), node_(std::move(first)), last_node_(std::move(last)) {
    if (node_ == last_node_) return;
    enter();
    skip_invalid();
  }
  edge_in<G> operator*() const { return *edge_; }
  void next() {
    ++edge_;
    skip_invalid();
  }
  friend bool operator==(const edge_iterator& a, const edge_iterator& b) {
    return a.node_ == b.node_ && (a.edge_ == b.edge_ || a.node_ == a.last_node_);
  }
  friend bool operator!=(const edge_iterator& a, const edge_iterator& b) { return !(a == b); }
};

}  // namespace concino::detail
