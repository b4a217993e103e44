// Construction and editing of tables of surfaces; see surface_tables.hpp. Always included, for arities that are not in the compiled library.
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
poly_id surface_tables<Arity, Lists>::add_poly(std::span<const vert_id> corners, function_ref<void(const detail::index_bounds&)> grow) {
  const poly_id p{polys_.bound()};
  if (Arity > 0 && corners.size() != Arity)
    core::throw_joined<invalid_mesh>({"add_poly: poly ", p.raw(), " has ", corners.size(), " verts; every poly of this mesh has ", Arity});
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
  if (grow) grow(detail::index_bounds{verts_.bound(), edges_.bound() + more, 0, polys_.bound() + 1, p2v_.num_values() + n});

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
  const auto check_some = [&](std::size_t first, std::size_t last) {
    std::vector<std::uint32_t> met;
    for (std::size_t p = first; p < last; ++p) detail::check_verts(p2v_[p], vert_count, "surface_tables: poly", p, met);
  };
  core::run_chunks(p2v_.size(), std::max<std::size_t>(8192, p2v_.size() / 8), check_some, nullptr);
}

/// Memory that is allocated before several threads request pages of it: while one of them does that, the system lets the others wait if they allocate.
template<unsigned Arity, class Lists>
struct surface_tables<Arity, Lists>::build_memory {
  detail::offsets counts;
  core::flat_array<poly_id> v2p;
  core::flat_array<edge_id> facets;
  core::flat_array<detail::encoded_neighbour> neighbours;

  build_memory(std::size_t vert_count, std::size_t corner_count) : v2p(corner_count), facets(corner_count), neighbours(corner_count) { counts.reserve(vert_count + 1); }
};

template<unsigned Arity, class Lists>
detail::offsets surface_tables<Arity, Lists>::list_at_verts(jagged<poly_id>& v2p, build_memory& memory, core::flat_array<std::uint32_t>& scratch) const {
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
  detail::offsets& counts = memory.counts;
  counts.assign(vert_count + 1, 0);
  for (std::size_t c = 0; c < corner_count; ++c) ++counts[corner_vert[c].raw() + 1];
  detail::prefix_sum(counts);
  memory.v2p.request_pages();
  v2p = {std::make_shared<const detail::offsets>(std::move(counts)), std::move(memory.v2p)};
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
[[gnu::always_inline]] inline auto surface_tables<Arity, Lists>::find_corner(poly_id listed, std::uint32_t vert, const detail::offsets& poly_of) const -> poly_corner {
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

/// The edges whose smaller verts are in a range. Two threads write to two of them, which therefore have no common cache line.
template<unsigned Arity, class Lists>
struct alignas(128) surface_tables<Arity, Lists>::edge_range {
  std::uint32_t first_vert, last_vert;
  core::flat_array<std::uint32_t> edge_to;  // by vert
  std::uint32_t mark = 0;                   // the number of the first edge: a bit, if another range comes before
  core::flat_array<vert_id> ends = {};
  core::flat_array<std::uint32_t> owners = {};  // see facet_adjacency::add_facets
  detail::offsets degrees = {};  // one vert later, for prefix_sum
  // Memory for make_incident_edges.
  core::flat_array<vert_id> verts_at_verts = {};
  core::flat_array<edge_id> edges_at_verts = {};
  bool is_manifold = true;
};

/// Alone: there is no other range. Otherwise edges of more than two polys are not allowed.
template<unsigned Arity, class Lists>
template<bool Alone>
void surface_tables<Arity, Lists>::find_edges(edge_range& range, jagged<poly_id>& v2p, const detail::offsets& poly_of) {
  // Every edge is found first at its smaller vert a; edge_to[b] is the edge from a to b if it is at least the first edge of a.
  core::flat_array<std::uint32_t>& edge_to = range.edge_to;
  std::fill_n(edge_to.data(), edge_to.size(), ~0u);
  range.degrees.assign(edge_to.size() + 1, 0);
  std::uint32_t edge_count = 0;
  std::vector<typename detail::facet_adjacency<edge_id, Arity>::incidence> met_first;  // per edge of a, if polygons may be long
  const auto visit = [&](std::uint32_t a, vert_id b, std::uint32_t first_edge, std::uint32_t p, std::uint32_t k) __attribute__((always_inline)) {  // g++ would not
    if (b.raw() < a) return;
    std::uint32_t e = edge_to[b.raw()];
    const bool is_new = e == ~0u || e < first_edge;
    if (is_new) {
      edge_to[b.raw()] = e = edge_count++;
      range.ends.push_back(vert_id{a});
      range.ends.push_back(b);
      ++range.degrees[a + 1];
      ++range.degrees[b.raw() + 1];
      if constexpr (Alone) facet_adjacency_.add_facet();
      else range.owners.push_back(facet_adjacency_.link_first(p, k, edge_id{e | range.mark}));
      if constexpr (Arity == 0 || !Alone) met_first.push_back({p, k});
    }
    if constexpr (!Alone) {
      if (!is_new) range.is_manifold = facet_adjacency_.link_second(p, k, edge_id{e | range.mark}, met_first[e - first_edge]) && range.is_manifold;
    } else if (Arity == 0 && !is_new) {
      facet_adjacency_.link(p, k, edge_id{e}, met_first[e - first_edge]);
    } else {
      facet_adjacency_.link(p, k, edge_id{e});
    }
  };
  for (std::uint32_t a = range.first_vert; a < range.last_vert; ++a) {
    const std::uint32_t first_edge = edge_count;
    met_first.clear();
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
void surface_tables<Arity, Lists>::start_facets(build_memory& memory) {
  memory.facets.request_pages(), memory.neighbours.request_pages();
  std::fill_n(memory.facets.data(), memory.facets.size(), edge_id{});
  if constexpr (Arity == 0) facet_adjacency_ = {{p2v_.shared_offsets(), std::move(memory.facets)}, {p2v_.shared_offsets(), std::move(memory.neighbours)}};
  else facet_adjacency_ = {per_poly<edge_id>(std::move(memory.facets)), per_poly<detail::encoded_neighbour>(std::move(memory.neighbours))};
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::find_edges_alone(edge_range& all, jagged<poly_id>& v2p, std::size_t max_edges) {
  build_memory memory(all.last_vert, p2v_.num_values());
  all.ends.reserve(2 * max_edges);
  const detail::offsets poly_of = list_at_verts(v2p, memory, all.edge_to);
  start_facets(memory);
  facet_adjacency_.reserve_facets(max_edges);
  all.ends.request_pages();
  find_edges<true>(all, v2p, poly_of);
}

/// Finds the edges in two threads; `second` is only memory for one of them. Returns false if an edge has more than two polys; the tables are undefined then.
template<unsigned Arity, class Lists>
bool surface_tables<Arity, Lists>::find_edges_in_two(edge_range& all, edge_range& second, jagged<poly_id>& v2p, std::size_t max_edges) {
  const std::uint32_t vert_count = all.last_vert;
  build_memory memory(all.last_vert, p2v_.num_values());
  second.mark = 1u << 31;
  all.ends.reserve(2 * max_edges), all.owners.reserve(max_edges);
  second.ends.reserve(max_edges), second.owners.reserve(max_edges / 2);
  detail::offsets poly_of;
  const auto list_polys = [&] { poly_of = list_at_verts(v2p, memory, all.edge_to); };
  const auto request_first = [&] { all.ends.request_pages(), all.owners.request_pages(); };
  const auto request_second = [&] { second.ends.request_pages(), second.owners.request_pages(); };
  core::run_all(true, {list_polys, [&] { start_facets(memory); }, request_first, request_second});
  const detail::offsets& first_poly = *v2p.shared_offsets();
  all.last_vert = static_cast<std::uint32_t>(std::lower_bound(first_poly.begin(), first_poly.begin() + vert_count, p2v_.num_values() / 2) - first_poly.begin());
  second.first_vert = all.last_vert;
  core::run_both(true, [&] { find_edges<false>(all, v2p, poly_of); }, [&] { find_edges<false>(second, v2p, poly_of); });
  if (!all.is_manifold || !second.is_manifold) return false;
  const auto add_facets = [&] {
    facet_adjacency_.add_facets(all.owners, 0);
    facet_adjacency_.add_facets(second.owners, second.mark);
  };
  const auto add_ends = [&] {
    all.ends.append(second.ends.data(), second.ends.size());
    for (std::size_t v = 0; v < all.degrees.size(); ++v) all.degrees[v] += second.degrees[v];
  };
  const std::size_t num_ends = all.ends.size() + second.ends.size();
  all.verts_at_verts = core::flat_array<vert_id>(num_ends), all.edges_at_verts = core::flat_array<edge_id>(num_ends);
  core::run_all(true, {add_facets, add_ends, [&] { all.verts_at_verts.request_pages(); }, [&] { all.edges_at_verts.request_pages(); }});
  return true;
}

template<unsigned Arity, class Lists>
void surface_tables<Arity, Lists>::build(std::size_t vert_count) {
  const std::size_t poly_count = p2v_.size(), corner_count = p2v_.num_values();
  const bool is_large = corner_count > 50'000 && corner_count < std::size_t{1} << 31 && core::num_threads() > 1;
  const core::thread_team threads(is_large);
  const std::size_t max_edges = std::min(vert_count + poly_count + poly_count / 64 + 16, corner_count);  // but for few meshes
  const auto range = [](std::size_t n) {
    edge_range all{0, static_cast<std::uint32_t>(n), core::flat_array<std::uint32_t>(n)};
    all.degrees.reserve(n + 1);
    return all;
  };
  edge_range edges = range(vert_count), second = range(is_large ? vert_count : 0);
  jagged<poly_id> v2p;
  const bool in_two = is_large && find_edges_in_two(edges, second, v2p, max_edges);
  if (is_large && !in_two) edges = range(vert_count);
  if (!in_two) find_edges_alone(edges, v2p, max_edges);
  const std::size_t edge_count = edges.ends.size() / 2;
  const auto list_edges = [&] {
    edges.ends.shrink_to_fit();
    e2v_ = detail::jagged_array<vert_id, 2>(std::move(edges.ends));
    detail::incident_edges incident = in_two ? detail::make_incident_edges(std::move(edges.degrees), e2v_, edges.edge_to, std::move(edges.verts_at_verts), std::move(edges.edges_at_verts))
                                             : detail::make_incident_edges(std::move(edges.degrees), e2v_, edges.edge_to);
    incident_ = {std::move(incident), std::move(v2p)};
    second = range(0);  // takes the system some time, while the other thread still works
  };
  core::run_both(is_large, list_edges, [&] { facet_adjacency_.finish(); });
  verts_ = detail::alive_elements<vert_id>(vert_count);
  edges_ = detail::alive_elements<edge_id>(edge_count);
  polys_ = detail::alive_elements<poly_id>(poly_count);
}

}  // namespace concino
