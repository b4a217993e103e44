// Builds and checks tables of polyhedra; see polyhedra_tables.hpp.
#pragma once

#include <concino/mesh/polyhedra_tables.hpp>

#include <numeric>

namespace concino {

template<class Lists>
basic_polyhedra_tables<Lists>::basic_polyhedra_tables(std::size_t vert_count, std::vector<std::uint32_t> face_offsets,
                                                      std::vector<vert_id> face_verts,
                                                      std::vector<std::uint32_t> poly_offsets,
                                                      std::vector<face_id> poly_faces,
                                                      std::vector<std::uint8_t> outward)
    : f2v_(detail::checked_lists(std::move(face_offsets), std::move(face_verts), "polyhedra_tables: face")) {
  const jagged<face_id> poly_lists =
      detail::checked_lists(std::move(poly_offsets), std::move(poly_faces), "polyhedra_tables: poly");
  if (outward.size() != poly_lists.num_values())
    core::throw_joined<invalid_mesh>({"polyhedra_tables: ", outward.size(), " outward flags were given for ",
                                      poly_lists.num_values(), " faces of polys; each needs one"});
  detail::shrink_if_wasteful(outward);
  outward_ = {poly_lists.shared_offsets(), std::move(outward)};
  build(vert_count, poly_lists, check(vert_count, poly_lists));
}

template<class Lists>
std::size_t basic_polyhedra_tables<Lists>::check(std::size_t vert_count, const jagged<face_id>& polys) const {
  detail::check_counts("polyhedra_tables", vert_count, polys.size(), f2v_.num_values());
  std::vector<std::uint32_t> visited;
  for (std::size_t f = 0; f < f2v_.size(); ++f)
    detail::check_verts(f2v_[f], vert_count, "polyhedra_tables: face", f, visited);
  const std::size_t poly_corners = check_polys(polys);
  check_poly_corners(poly_corners, f2v_.num_values(), polys.num_values(), "polyhedra_tables: ");
  return poly_corners;
}

template<class Lists>
std::size_t basic_polyhedra_tables<Lists>::check_polys(const jagged<face_id>& polys) const {
  std::vector<std::uint32_t> visited(f2v_.size(), ~0u);
  std::size_t corners = 0;
  for (std::size_t p = 0; p < polys.size(); ++p) {
    if (polys.length(p) == 0)
      core::throw_joined<invalid_mesh>({"polyhedra_tables: poly ", p, " has no faces; it needs at least 1"});
    for (const face_id f : polys[p]) {
      if (f.raw() >= f2v_.size())
        core::throw_joined<invalid_mesh>({"polyhedra_tables: poly ", p, " names face ", f.raw(), ", but the mesh has ",
                                          f2v_.size(), " faces, numbered from 0"});
      if (visited[f.raw()] == p)
        core::throw_joined<invalid_mesh>(
            {"polyhedra_tables: poly ", p, " has face ", f.raw(), " twice; its faces must differ"});
      visited[f.raw()] = static_cast<std::uint32_t>(p);
      corners += f2v_.length(f.raw());
    }
  }
  return corners;
}

template<class Lists>
void basic_polyhedra_tables<Lists>::build(std::size_t vert_count, const jagged<face_id>& polys,
                                          std::size_t poly_corners) {
  face_vert_lookup_ = detail::row_lookup(f2v_);
  core::flat_array<edge_id> f2e(f2v_.num_values());  // parallel to f2v_
  build_edges(vert_count, f2e);
  list_edges_of_polys(f2e, polys, poly_corners);
  list_faces_of_edges(f2e);
  link_polys(polys);
  list_verts_of_polys(vert_count, polys, poly_corners);
  if (*v2p_.shared_offsets() == *incident_edges_.shared_offsets()) v2p_.share_offsets(incident_edges_);
  verts_ = detail::alive_elements<vert_id>(vert_count);
  edges_ = detail::alive_elements<edge_id>(e2v_.size());
  faces_ = detail::alive_elements<face_id>(f2v_.size());
  polys_ = detail::alive_elements<poly_id>(polys.size());
}

template<class Lists>
void basic_polyhedra_tables<Lists>::list_faces_of_edges(const core::flat_array<edge_id>& f2e) {
  const std::size_t edge_count = e2v_.size();
  detail::offsets counts(edge_count + 1, 0);
  for (const edge_id e : f2e) ++counts[e.raw() + 1];
  e2f_ = detail::make_jagged_array<face_id>(std::move(counts));
  core::flat_array<std::uint32_t> next(edge_count);
  std::copy_n(e2f_.shared_offsets()->begin(), edge_count, next.data());
  face_id* const faces = e2f_.begin(0);
  const edge_id* e = f2e.begin();
  for (std::size_t f = 0; f < f2v_.size(); ++f)
    for (std::uint32_t n = f2v_.length(f); n > 0; --n) faces[next[(e++)->raw()]++] = face_id{f};
}

template<class Lists>
void basic_polyhedra_tables<Lists>::link_polys(const jagged<face_id>& polys) {
  facet_adjacency_ = {{polys.shared_offsets(), core::flat_array<face_id>(polys.num_values(), face_id{})},
                      {polys.shared_offsets(), core::flat_array<detail::encoded_neighbour>(polys.num_values())}};
  facet_adjacency_.set_facets(f2v_.size());
  core::flat_array<detail::facet_adjacency<face_id, 0>::incidence> first_incidence(f2v_.size());
  for (std::uint32_t p = 0; p < polys.size(); ++p)
    for (std::uint32_t k = 0; k < polys.length(p); ++k) {
      const face_id f = polys.begin(p)[k];
      if (facet_adjacency_.is_owned(f)) {
        facet_adjacency_.link(p, k, f, first_incidence[f.raw()]);
      } else {
        first_incidence[f.raw()] = {p, k};
        facet_adjacency_.link(p, k, f);
      }
    }
  facet_adjacency_.finish();
}

template<class Lists>
void basic_polyhedra_tables<Lists>::build_edges(std::size_t vert_count, core::flat_array<edge_id>& f2e) {
  const std::size_t corner_count = f2v_.num_values();
  core::flat_array<std::uint32_t> first(vert_count + 1, 0), edge_to(vert_count);
  // Half-edges, sorted by the smaller vert of their edge, with the other vert.
  struct half { std::uint32_t corner, far; };
  const auto for_each_half = [&](auto&& use) {
    std::uint32_t c = 0;
    for (std::size_t f = 0; f < f2v_.size(); ++f) {
      const id_span<vert_id> v = f2v_[f];
      for (std::size_t i = 0; i < v.size(); ++i, ++c) {
        const std::uint32_t a = v[i].raw(), b = v[i + 1 == v.size() ? 0 : i + 1].raw();
        use(c, std::min(a, b), std::max(a, b));
      }
    }
  };
  for_each_half([&](std::uint32_t, std::uint32_t a, std::uint32_t) { ++first[a + 1]; });
  std::partial_sum(first.begin(), first.end(), first.data());
  core::flat_array<half> halves(corner_count);
  std::copy_n(first.begin(), vert_count, edge_to.data());
  for_each_half([&](std::uint32_t c, std::uint32_t a, std::uint32_t b) { halves[edge_to[a]++] = {c, b}; });

  std::fill_n(edge_to.data(), vert_count, ~0u);
  core::flat_array<vert_id> ends;
  ends.reserve(corner_count * 2 / 3);
  detail::offsets degrees(vert_count + 1, 0);
  std::uint32_t num = 0;
  for (std::uint32_t a = 0; a < vert_count; ++a) {
    const std::uint32_t first_edge = num;
    for (std::uint32_t i = first[a]; i < first[a + 1]; ++i) {
      std::uint32_t e = edge_to[halves[i].far];
      if (e == ~0u || e < first_edge) {
        edge_to[halves[i].far] = e = num++;
        ends.push_back(vert_id{a});
        ends.push_back(vert_id{halves[i].far});
        ++degrees[a + 1];
        ++degrees[halves[i].far + 1];
      }
      f2e[halves[i].corner] = edge_id{e};
    }
  }
  ends.shrink_to_fit();
  e2v_ = detail::jagged_array<vert_id, 2>(std::move(ends));
  incident_edges_ = detail::make_incident_edges(std::move(degrees), e2v_, edge_to);
}

template<class Lists>
void basic_polyhedra_tables<Lists>::list_edges_of_polys(const core::flat_array<edge_id>& f2e,
                                                        const jagged<face_id>& polys, std::size_t poly_corners) {
  const vert_id* const corner_vert = f2v_.begin(0);
  core::flat_array<std::uint32_t> visited(e2v_.size(), ~0u);
  core::flat_array<edge_id> edges;
  edges.reserve(poly_corners / 2);  // in a closed poly every edge has two faces
  detail::offsets first;
  first.reserve(polys.size() + 1);
  first.push_back(0);
  for (std::uint32_t p = 0; p < polys.size(); ++p) {
    for (const face_id f : polys[p]) {
      const edge_id* const of_face = f2e.data() + (f2v_.begin(f.raw()) - corner_vert);
      for (const edge_id* e = of_face; e != of_face + f2v_.length(f.raw()); ++e) {
        if (visited[e->raw()] == p) continue;
        visited[e->raw()] = p;
        edges.push_back(*e);
      }
    }
    first.push_back(static_cast<std::uint32_t>(edges.size()));
  }
  if (edges.size() >= ~0u) throw unsupported("polyhedra_tables: the mesh has more than 2^32 adjacencies of one kind");
  edges.shrink_to_fit();
  p2e_ = {std::make_shared<const detail::offsets>(std::move(first)), std::move(edges)};
}

template<class Lists>
void basic_polyhedra_tables<Lists>::list_verts_of_polys(std::size_t vert_count, const jagged<face_id>& polys,
                                                        std::size_t poly_corners) {
  core::flat_array<std::uint32_t> visited(vert_count, ~0u);
  core::flat_array<vert_id> verts;
  // In a closed poly every edge has two faces, and verts + faces = edges + 2: this memory is exact for most meshes.
  const std::size_t incidence_count = polys.num_values();
  if (poly_corners / 2 + 2 * polys.size() > incidence_count)
    verts.reserve(poly_corners / 2 + 2 * polys.size() - incidence_count);
  detail::offsets first, degrees(vert_count + 1, 0);
  first.reserve(polys.size() + 1);
  first.push_back(0);
  for (std::uint32_t p = 0; p < polys.size(); ++p) {
    for (const face_id f : polys[p])
      for (const vert_id v : f2v_[f.raw()]) {
        if (visited[v.raw()] == p) continue;
        visited[v.raw()] = p;
        verts.push_back(v);
        ++degrees[v.raw() + 1];
      }
    first.push_back(static_cast<std::uint32_t>(verts.size()));
  }
  verts.shrink_to_fit();
  p2v_ = {std::make_shared<const detail::offsets>(std::move(first)), std::move(verts)};

  v2p_ = detail::make_jagged_array<poly_id>(std::move(degrees));
  std::copy_n(v2p_.shared_offsets()->begin(), vert_count, visited.data());
  poly_id* const polys_of_verts = v2p_.begin(0);
  for (std::uint32_t p = 0; p < polys.size(); ++p)
    for (const vert_id v : p2v_[p]) polys_of_verts[visited[v.raw()]++] = poly_id{p};
}

}  // namespace concino
