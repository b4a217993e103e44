// The laws of facets (FC1 .. FC4). They follow from the laws of the mesh and are checked only if those hold. They then
// fail if a result depends on other queries in between. So ranges are iterated within one another here, as algorithms
// do.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/message.hpp>
#include <concino/validate/detail/mesh_laws.hpp>

#include <cstdint>
#include <new>

namespace concino::detail {

template<AnyMesh M>
class facet_laws {
  using facet = facet_t<M>;
  using poly = poly_t<M>;

  const M& m_;
  const element_table<vert_t<M>>& vs_;
  const element_table<poly>& ps_;
  const adjacency_lists& p2p_;
  law_log& log_;
  element_table<facet> xs_;
  adjacency_lists x2p_, p2x_, x2v_;

  /// Calls check(a) for all elements; an exception of the mesh breaks `law`.
  template<class A, class Check>
  void for_each(const element_table<A>& as, const char* law, const char* verb, const Check& check) {
    for (order_index a = 0; a < as.size() && !log_.full(law); ++a) {
      try {
        check(a);
      } catch (const std::bad_alloc&) {
        throw;
      } catch (const std::exception& e) {
        log_.add(law, core::joined({verb, " throws for ", as.name(a), ": ", e.what()}), as.name(a));
      }
    }
  }

  /// FC2: the verts of a facet are verts of each of its polys.
  void check_verts() {
    const adjacency_lists p2v = read_adjacency(m_, ps_, vs_, adj_p2v, "FC2", "adj_p2v", log_);
    std::vector<order_index> of(vs_.size(), no_order_index);
    for (order_index p = 0; p < ps_.size() && !log_.full("FC2"); ++p) {
      for (const order_index v : p2v[p]) of[v] = p;
      for (const order_index x : p2x_[p])
        for (const order_index v : x2v_[x])
          if (of[v] != p)
            log_.add("FC2",
                     core::joined({"adj_facet2v(", xs_.name(x), ") holds ", vs_.name(v), ", which is not a vert of ",
                                   ps_.name(p)}),
                     core::joined({xs_.name(x), " ", vs_.name(v), " ", ps_.name(p)}));
    }
  }

  /// FC3: other_polys of x are the polys of adj_facet2p without p. Sets `poly_of[q]` to p for each such q.
  void check_other_polys(order_index p, order_index x, std::vector<order_index>& poly_of) {
    const auto listed = x2p_[x];
    const auto call = [&] { return core::joined({"other_polys(", ps_.name(p), ", ", xs_.name(x), ")"}); };
    std::size_t i = 0;
    bool is_same = true;
    const auto skip = [&] { while (i < listed.size() && listed[i] == p) ++i; };
    const auto& others = other_polys(m_, ps_.items[p], xs_.items[x]);
    auto it = others.begin();
    for (; is_same && it != others.end(); ++it) {
      skip();
      const order_index q = ps_.find(m_, *it);
      is_same = i < listed.size() && q == listed[i++];
      if (is_same) poly_of[q] = p;
    }
    skip();
    if (!is_same || i != listed.size())
      log_.add("FC3", core::joined({call(), " is not adj_facet2p(", xs_.name(x), ") without ", ps_.name(p)}),
               core::joined({ps_.name(p), " ", xs_.name(x)}));
  }

  /// FC3: other_polys over all facets of p are adj_p2p(p).
  void check_adjacent_polys() {
    std::vector<order_index> poly_of(ps_.size(), no_order_index);
    for_each(ps_, "FC3", "other_polys", [&](order_index p) {
      std::size_t walked = 0;
      for (const facet x : adj_p2facet(m_, ps_.items[p])) {
        const order_index at = walked++ < p2x_[p].size() ? xs_.find(m_, x) : no_order_index;
        if (at == no_order_index || at != p2x_[p][walked - 1]) {
          log_.add("FC3", core::joined({"adj_p2facet(", ps_.name(p), ") changes while other_polys is called"}),
                   ps_.name(p));
          return;
        }
        check_other_polys(p, at, poly_of);
      }
      if (walked != p2x_[p].size())
        log_.add("FC3", core::joined({"adj_p2facet(", ps_.name(p), ") ends early while other_polys is called"}),
                 ps_.name(p));
      for (const order_index q : p2p_[p])
        if (poly_of[q] != p)
          log_.add("FC3",
                   core::joined({"adj_p2p(", ps_.name(p), ") holds ", ps_.name(q), ", which shares no facet with it"}),
                   core::joined({ps_.name(p), " ", ps_.name(q)}));
    });
  }

  bool has_one_poly(order_index x) const { return x2p_[x].size() == 1; }

  /// FC4: is_boundary of elements that have facets.
  template<class A>
  void check_boundary(const element_table<A>& as, const std::vector<bool>& expected) {
    for_each(as, "FC4", "is_boundary", [&](order_index a) {
      if (is_boundary(m_, as.items[a]) == expected[a]) return;
      log_.add("FC4",
               core::joined({"is_boundary(", as.name(a), ") is ", expected[a] ? "false" : "true", ", but it has ",
                             expected[a] ? "a" : "no", " facet of one poly"}),
               as.name(a));
    });
  }
  template<class A>
  void check_boundary(const element_table<A>& as, const adjacency_lists& facets_of) {
    std::vector<bool> expected(as.size());
    for (order_index a = 0; a < as.size(); ++a)
      for (const order_index x : facets_of[a]) expected[a] = expected[a] || has_one_poly(x);
    check_boundary(as, expected);
  }

 public:
  facet_laws(const M& m, const graph_tables<vert_t<M>>& primal, const graph_tables<poly>& dual, law_log& log)
      : m_(m), vs_(primal.nodes), ps_(dual.nodes), p2p_(dual.next), log_(log),
        xs_(read_elements<facet>(m, dimension_v<M> == 2 ? 'e' : 'f', facets, num_facets, facet_index_bound, "FC1",
                                 "FC1", log)) {}

  void check() {
    if (!log_.empty()) return;  // further checks would report the same faults again
    x2p_ = read_adjacency(m_, xs_, ps_, adj_facet2p, "FC2", "adj_facet2p", log_);
    p2x_ = read_adjacency(m_, ps_, xs_, adj_p2facet, "FC2", "adj_p2facet", log_);
    x2v_ = read_adjacency(m_, xs_, vs_, adj_facet2v, "FC2", "adj_facet2v", log_);
    check_mirror(xs_, ps_, x2p_, p2x_, "FC2", "adj_facet2p", "adj_p2facet", log_);
    check_verts();
    if (!log_.empty()) return;
    check_adjacent_polys();
    std::vector<bool> single(xs_.size());
    for (order_index x = 0; x < xs_.size(); ++x) single[x] = has_one_poly(x);
    check_boundary(xs_, single);
    check_boundary(ps_, p2x_);
    check_boundary(vs_, transposed(x2v_, vs_.size()));
    if constexpr (VolumeMesh<M>) {  // the edges of a surface are its facets
      law_log again;  // faults of the edges themselves have been reported already
      const auto es = read_elements<edge_t<M>>(m_, 'e', edges, num_edges, edge_index_bound, "SM1", "SM1", again);
      const adjacency_lists x2e = read_adjacency(m_, xs_, es, adj_f2e, "VM2", "adj_f2e", again);
      if (again.empty()) check_boundary(es, transposed(x2e, es.size()));
    }
  }
};

}  // namespace concino::detail
