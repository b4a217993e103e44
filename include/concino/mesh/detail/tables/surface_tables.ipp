// Construction and editing of tables of surfaces; see surface_tables.hpp. Always included, for arities that are not in
// the compiled library.
#pragma once

#include <concino/mesh/surface_tables.hpp>

namespace concino {

template<unsigned Arity, class Lists>
vert_id surface_tables<Arity, Lists>::add_vert(function_ref<void(const detail::index_bounds&)> grow) {
  incident_.reserve_verts(1, 1);
  verts_.reserve(1);
  if (grow) grow(detail::index_bounds{verts_.bound() + 1, edges_.bound(), 0, polys_.bound(), p2v_.num_values()});
  incident_.add_vert(1);
  return verts_.add();
}

template<unsigned Arity, class Lists>
poly_id surface_tables<Arity, Lists>::add_poly(std::span<const vert_id> corners,
                                               function_ref<void(const detail::index_bounds&)> grow) {
  const poly_id p{polys_.bound()};
  if (Arity > 0 && corners.size() != Arity)
    core::throw_joined<invalid_mesh>(
        {"add_poly: poly ", p.raw(), " has ", corners.size(), " verts; every poly of this mesh has ", Arity});
  detail::check_new_verts({corners.data(), corners.data() + corners.size()}, verts_, "add_poly: poly", p.raw());
  const auto n = static_cast<std::uint32_t>(corners.size());
  const vert_id* const c = p2v_.stage_row(corners.data(), n);  // corners may have been in a row that moved
  edge_id* const e = facet_adjacency_.stage_poly(n);
  std::size_t more = 0;
  for (std::uint32_t k = 0; k < n; ++k) {
    e[k] = incident_.edge_between(c[k], c[k + 1 == n ? 0 : k + 1]);
    more += e[k].is_none();
  }
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t at_corner = (e[k].is_none() ? 1u : 0u) + (e[k == 0 ? n - 1 : k - 1].is_none() ? 1u : 0u);
    incident_.reserve_at(c[k], at_corner, 1);
  }
  e2v_.reserve_rows(more);
  edges_.reserve(more);
  polys_.reserve(1);
  auto scratch = facet_adjacency_.reserve_links(e, n, more);
  if (grow)
    grow(detail::index_bounds{verts_.bound(), edges_.bound() + more, 0, polys_.bound() + 1, p2v_.num_values() + n});

  p2v_.commit_row(n);
  facet_adjacency_.commit_poly(n);
  for (std::uint32_t k = 0; k < n; ++k) {
    edge_id edge = e[k];
    if (edge.is_none()) {
      edge = detail::add_edge(edges_, e2v_, incident_, c[k], c[k + 1 == n ? 0 : k + 1]);
      facet_adjacency_.add_facet();
    }
    facet_adjacency_.link(p.raw(), k, edge);
    incident_.push(c[k], p);
  }
  facet_adjacency_.update_marks(p.raw(), std::move(scratch));
  return polys_.add();
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::reserve_removal(std::span<const poly_id>) {
  incident_.make_growable();
  facet_adjacency_.reserve_removal();
  verts_.reserve_removal();
  edges_.reserve_removal();
  polys_.reserve_removal();
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::remove_poly(poly_id p) {
  reserve_removal({&p, 1});
  facet_adjacency_.unlink(p.raw());
  for (const edge_id e : facet_adjacency_.facets(p))
    if (!facet_adjacency_.is_owned(e)) detail::remove_edge(edges_, e2v_, incident_, e);
  for (const vert_id v : adj_p2v(p)) incident_.remove(v, p);
  polys_.remove(p);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::remove_vert(vert_id v) {
  assert(incident_.num_polys(v) == 0);
  verts_.reserve_removal();
  verts_.remove(v);
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::check(std::size_t vert_count) const {
  detail::check_counts("surface_tables", vert_count, p2v_.size(), p2v_.num_values());
  std::vector<std::uint32_t> visited;
  for (std::size_t p = 0; p < p2v_.size(); ++p)
    detail::check_verts(p2v_[p], vert_count, "surface_tables: poly", p, visited);
}

template<unsigned Arity, class Lists>
detail::offsets surface_tables<Arity, Lists>::list_at_verts(jagged<poly_id>& v2p,
                                                            core::flat_array<std::uint32_t>& scratch) const {
  const std::size_t vert_count = scratch.size(), corner_count = p2v_.num_values();
  const auto poly_count = static_cast<std::uint32_t>(p2v_.size());
  const vert_id* const corner_vert = p2v_.begin(0);
  detail::offsets poly_of;
  if constexpr (Arity == 0) {
    std::uint32_t longest = 0;
    for (std::uint32_t p = 0; p < poly_count; ++p) longest = std::max(longest, p2v_.length(p));
    if (longest > 32) {
      poly_of.reserve(corner_count);
      for (std::uint32_t p = 0; p < poly_count; ++p)
        for (std::uint32_t k = 0; k < p2v_.length(p); ++k) poly_of.push_back(p);
    }
  }
  detail::offsets counts(vert_count + 1, 0);
  for (std::size_t c = 0; c < corner_count; ++c) ++counts[corner_vert[c].raw() + 1];
  v2p = detail::make_jagged_array<poly_id>(std::move(counts));
  std::uint32_t* const fill = scratch.data();
  for (std::size_t v = 0; v < vert_count; ++v) fill[v] = static_cast<std::uint32_t>(v2p.begin(v) - v2p.begin(0));
  poly_id* const corners = v2p.begin(0);
  if (Arity > 0 || !poly_of.empty()) {
    for (std::size_t c = 0; c < corner_count; ++c) corners[fill[corner_vert[c].raw()]++] = poly_id{c};
  } else {
    for (std::uint32_t p = 0; p < poly_count; ++p)
      for (const vert_id v : p2v_[p]) corners[fill[v.raw()]++] = poly_id{p};
  }
  return poly_of;
}

template<unsigned Arity, class Lists>
auto surface_tables<Arity, Lists>::find_corner(poly_id listed, std::uint32_t vert, const detail::offsets& poly_of) const
    -> poly_corner {
  if constexpr (Arity > 0) {
    return {listed.raw() / Arity, listed.raw() % Arity, Arity};
  } else if (poly_of.empty()) {
    const std::uint32_t p = listed.raw();
    std::uint32_t k = 0;
    for (const vert_id* v = p2v_.begin(p); v[k].raw() != vert;) ++k;
    return {p, k, p2v_.length(p)};
  } else {
    const std::uint32_t p = poly_of[listed.raw()];
    return {p, listed.raw() - static_cast<std::uint32_t>(p2v_.begin(p) - p2v_.begin(0)), p2v_.length(p)};
  }
}

/// The edges, as they are found.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::found_edges {
  core::flat_array<std::uint32_t> edge_to;  // by vert
  core::flat_array<vert_id> ends = {};
  detail::offsets degrees = {};  // one vert later, for prefix_sum
};

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::find_edges(found_edges& found, jagged<poly_id>& v2p,
                                              const detail::offsets& poly_of) {
  // Every edge is found first at its smaller vert a; edge_to[b] is the edge from a to b if it is at least the first
  // edge of a.
  core::flat_array<std::uint32_t>& edge_to = found.edge_to;
  std::fill_n(edge_to.data(), edge_to.size(), ~0u);
  std::uint32_t edge_count = 0;
  // per edge of a, if polygons may be long
  std::vector<typename detail::facet_adjacency<edge_id, Arity>::incidence> first_incidence;
  const auto visit = [&](std::uint32_t a, vert_id b, std::uint32_t first_edge, std::uint32_t p, std::uint32_t k) {
    if (b.raw() < a) return;
    std::uint32_t e = edge_to[b.raw()];
    const bool is_new = e == ~0u || e < first_edge;
    if (is_new) {
      edge_to[b.raw()] = e = edge_count++;
      found.ends.push_back(vert_id{a});
      found.ends.push_back(b);
      ++found.degrees[a + 1];
      ++found.degrees[b.raw() + 1];
      facet_adjacency_.add_facet();
      if constexpr (Arity == 0) first_incidence.push_back({p, k});
    }
    if (Arity == 0 && !is_new) facet_adjacency_.link(p, k, edge_id{e}, first_incidence[e - first_edge]);
    else facet_adjacency_.link(p, k, edge_id{e});
  };
  for (std::uint32_t a = 0; a < edge_to.size(); ++a) {
    const std::uint32_t first_edge = edge_count;
    first_incidence.clear();
    for (poly_id *c = v2p.begin(a), *last = c + v2p.length(a); c != last; ++c) {
      const auto [p, k, n] = find_corner(*c, a, poly_of);
      const vert_id* const pv = p2v_.begin(p);
      const std::uint32_t next = k + 1 == n ? 0 : k + 1, previous = k == 0 ? n - 1 : k - 1;
      visit(a, pv[next], first_edge, p, k);
      visit(a, pv[previous], first_edge, p, previous);
      *c = poly_id{p};
    }
  }
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::build(std::size_t vert_count) {
  const std::size_t poly_count = p2v_.size(), corner_count = p2v_.num_values();
  // but for few meshes
  const std::size_t max_edges = std::min(vert_count + poly_count + poly_count / 64 + 16, corner_count);
  found_edges found{core::flat_array<std::uint32_t>(vert_count)};
  found.ends.reserve(2 * max_edges);
  found.degrees.assign(vert_count + 1, 0);
  jagged<poly_id> v2p;
  const detail::offsets poly_of = list_at_verts(v2p, found.edge_to);
  core::flat_array<edge_id> edges_of_polys(corner_count, edge_id{});
  core::flat_array<detail::encoded_neighbour> neighbours(corner_count);
  if constexpr (Arity == 0)
    facet_adjacency_ = {{p2v_.shared_offsets(), std::move(edges_of_polys)},
                        {p2v_.shared_offsets(), std::move(neighbours)}};
  else
    facet_adjacency_ = {per_poly<edge_id>(std::move(edges_of_polys)),
                        per_poly<detail::encoded_neighbour>(std::move(neighbours))};
  facet_adjacency_.reserve_facets(max_edges);
  find_edges(found, v2p, poly_of);
  facet_adjacency_.finish();
  found.ends.shrink_to_fit();
  const std::size_t edge_count = found.ends.size() / 2;
  e2v_ = detail::jagged_array<vert_id, 2>(std::move(found.ends));
  incident_ = {detail::make_incident_edges(std::move(found.degrees), e2v_, found.edge_to), std::move(v2p)};
  verts_ = detail::alive_elements<vert_id>(vert_count);
  edges_ = detail::alive_elements<edge_id>(edge_count);
  polys_ = detail::alive_elements<poly_id>(poly_count);
}

}  // namespace concino
