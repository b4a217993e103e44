// Boost property maps: of concino maps, of callables, and of the indices and numbers of nodes and edges.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/core/vec3.hpp>
#include <concino/geometry/centroid.hpp>
#include <concino/graph/detail/boost_iterators.hpp>

#include <boost/property_map/property_map.hpp>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace concino::detail {

/// A map of the caller's: by address if it is an lvalue, else stored and shared by all copies of the property map.
template<class P> inline P* base_map(P* p) { return p; }
template<class P> inline P* base_map(const std::shared_ptr<P>& p) { return p.get(); }

template<class P, class Key> using result_of = decltype(std::declval<P&>()[std::declval<const Key&>()]);
template<class P, class Key> struct value_in { using type = std::remove_cvref_t<result_of<P, Key>>; };
template<class P, class Key>
  requires requires { typename P::value_type; } && (!std::is_lvalue_reference_v<result_of<P, Key>>)
struct value_in<P, Key> { using type = typename P::value_type; };

  template<class P, class Key, class T>
  using map_category =
      std::conditional_t<!WritableMap<P&, Key, T>, boost::readable_property_map_tag,
                         std::conditional_t<std::is_same_v<result_of<P, Key>, T&>, boost::lvalue_property_map_tag,
                                            boost::read_write_property_map_tag>>;

  template<class P, class Key, class Kept>
  class map_of_map : public boost::put_get_helper<result_of<P, Key>, map_of_map<P, Key, Kept>> {
    Kept map_{};

   public:
    using key_type = Key;
    using value_type = typename value_in<P, Key>::type;
    using reference = result_of<P, Key>;
    using category = map_category<P, Key, value_type>;

    map_of_map() = default;
    explicit map_of_map(Kept map) : map_(std::move(map)) {}
    reference operator[](const Key& x) const { return (*base_map(map_))[x]; }
};

/// f(source, target) of an edge. f is shared by all copies, so that the map is assignable although callables with
/// captures are not.
template<class Edge, class F>
using called_with_ends = std::invoke_result_t<const F&, decltype(Edge::source), decltype(Edge::source)>;
template<class Edge, class F>
class map_of_ends : public boost::put_get_helper<called_with_ends<Edge, F>, map_of_ends<Edge, F>> {
  std::shared_ptr<const F> f_;

 public:
  using key_type = Edge;
  using reference = called_with_ends<Edge, F>;
  using value_type = std::remove_cvref_t<reference>;
  using category = boost::readable_property_map_tag;

  map_of_ends() = default;
  explicit map_of_ends(F f) : f_(std::make_shared<const F>(std::move(f))) {}
  reference operator[](const Edge& e) const { return (*f_)(e.source, e.target); }
};

template<class G>
class node_index_map : public boost::put_get_helper<std::size_t, node_index_map<G>> {
  graph_storage<G> g_;

 public:
  using key_type = node_in<G>;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  node_index_map() = default;
  explicit node_index_map(const G& g) : g_(g) {}
  std::size_t operator[](const key_type& x) const { return base_graph(g_.get()).index(x); }
};

template<class G>
class edge_index_map : public boost::put_get_helper<std::size_t, edge_index_map<G>> {
  graph_storage<undirected_form<G>> g_;
  std::shared_ptr<const edge_numbers<is_directed<G>>> numbers_;

 public:
  using key_type = edge_in<G>;
  using value_type = std::size_t;
  using reference = std::size_t;
  using category = boost::readable_property_map_tag;

  edge_index_map() = default;
  edge_index_map(const undirected_form<G>& g, std::shared_ptr<const edge_numbers<is_directed<G>>> numbers)
      : g_(g), numbers_(std::move(numbers)) {}
  std::size_t operator[](const key_type& e) const { return (*numbers_)(base_graph(g_.get()), e); }
  /// The number of edges.
  std::size_t size() const { return numbers_->size(); }
};

/// The opposite arc.
template<class Edge>
struct opposite_map : boost::put_get_helper<Edge, opposite_map<Edge>> {
  using key_type = Edge;
  using value_type = Edge;
  using reference = Edge;
  using category = boost::readable_property_map_tag;

  Edge operator[](const Edge& e) const { return {e.target, e.source, e.slot, !e.slot_of_source}; }
};

/// A value per edge, shared by all copies.
template<class G, class T>
class edge_value_map : public boost::put_get_helper<T&, edge_value_map<G, T>> {
  edge_index_map<G> index_;
  std::shared_ptr<T[]> values_;

 public:
  using key_type = edge_in<G>;
  using value_type = T;
  using reference = T&;
  using category = boost::lvalue_property_map_tag;

  edge_value_map() = default;
  edge_value_map(edge_index_map<G> index, const T& init)
      : index_(std::move(index)), values_(std::make_shared<T[]>(index_.size(), init)) {}
  T& operator[](const key_type& e) const { return values_.get()[index_[e]]; }
};

/// Euclidean distances: of verts, or of the means of polys' verts (each computed once).
template<class M>
struct vert_distance {
  graph_storage<M> m;
  double operator()(const vert_t<M>& a, const vert_t<M>& b) const {
    return norm(to_vec3(point(m.get(), a)) - to_vec3(point(m.get(), b)));
  }
};
template<class M>
class poly_distance {
  graph_storage<M> m_;
  std::shared_ptr<const std::vector<vec3>> centres_;

 public:
  explicit poly_distance(const M& view) : m_(view) {
    const auto& m = view.base();
    auto centres = std::make_shared<std::vector<vec3>>(poly_index_bound(m));
    for (const poly_t<M> p : polys(m)) (*centres)[index_of(m, p)] = vert_mean(m, p);
    centres_ = std::move(centres);
  }
  double operator()(const poly_t<M>& a, const poly_t<M>& b) const {
    return norm((*centres_)[index_of(m_.get(), a)] - (*centres_)[index_of(m_.get(), b)]);
  }
};

template<class M>
  requires Embedded<M>
auto distances(const views::primal_view<M>& g) {
  return vert_distance<views::primal_view<M>>{graph_storage<views::primal_view<M>>(g)};
}
template<EmbeddedMesh M>
auto distances(const views::dual_view<M>& g) { return poly_distance<views::dual_view<M>>(g); }
template<class G>
  requires requires(const G& g) { distances(g); }
auto distances(const views::directed_view<G>& g) { return distances(g.base()); }

template<class G> concept measured = requires(const G& g) { distances(g); };
template<class G> using distance_map = map_of_ends<edge_in<G>, decltype(distances(std::declval<const G&>()))>;

}  // namespace concino::detail
