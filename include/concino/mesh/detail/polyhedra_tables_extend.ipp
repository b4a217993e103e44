// Construction of tables of polyhedra that have most elements in common with others; see polyhedra_tables.hpp.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/core/parallel.hpp>
#include <concino/mesh/polyhedra_tables.hpp>

#include <concino/mesh/detail/polyhedra_edges_extend.ipp>

#include <numeric>
#include <optional>

namespace concino {

/// Lists of polys, and all that belongs to them. The edges are those of edge_extension.
template<class Lists>
class basic_polyhedra_tables<Lists>::extension {
  static constexpr std::uint32_t none = kept_polyhedra::none;

  basic_polyhedra_tables& t_;
  const basic_polyhedra_tables& before_;
  kept_polyhedra& kept_;
  const jagged<face_id>& polys_;
  const std::size_t vert_count_;
  edge_extension edges_;

 public:
  /// t has the lists of faces and of polys.
  extension(basic_polyhedra_tables& t, const basic_polyhedra_tables& before, kept_polyhedra& kept, std::size_t vert_count)
      : t_(t), before_(before), kept_(kept), polys_(t.facet_adjacency_.facet_rows()), vert_count_(vert_count), edges_(t, before, kept, vert_count) {}

  void build() {
    t_.face_vert_lookup_ = detail::row_lookup(t_.f2v_);
    const auto build_edges = [&] { edges_.build(); };
    std::optional<poly_rows<edge_id>> edges_of_polys;
    const auto build_polys = [&] {
      link_polys();
      list_verts_of_polys();
      list_polys_of_verts();
      edges_of_polys.emplace(*this, before_.p2e_, kept_.edges);
    };
    core::run_both(t_.is_large(), build_edges, build_polys);
    const auto list_edges_of_verts = [&] { edges_.list_edges_of_verts(); };
    const auto add_edges = [&] {
      if (edges_.are_few_at_vert()) add_edges_of_polys(*edges_of_polys);
    };
    const auto copy_edges = [&](std::size_t first, std::size_t last) { edges_of_polys->copy(first, last); };
    core::run_with_chunks(t_.is_large(), {list_edges_of_verts, add_edges}, kept_.polys.size(), 16384, copy_edges);
    if (!edges_.are_few_at_vert()) add_edges_of_polys(*edges_of_polys);
    t_.p2e_ = std::move(*edges_of_polys).take();
    t_.finish(vert_count_, polys_.size());
  }

 private:
  /// The rows of all polys: those of kept ones are rows of `before` with the numbers now.
  template<class Id>
  class poly_rows {
    const extension& x_;
    const jagged<Id>& before_;
    const std::vector<std::uint32_t>& numbers_;  // of which the values may be known later
    detail::offsets first_;
    core::flat_array<Id> all_, added_;  // added_ is joined to the others at the end

   public:
    poly_rows(const extension& x, const jagged<Id>& before, const std::vector<std::uint32_t>& numbers) : x_(x), before_(before), numbers_(numbers) {
      core::reserve_exact(first_, x_.polys_.size() + 1);
      first_.push_back(0);
      std::uint32_t end = 0;
      for (std::size_t p = 0; p < x_.kept_.polys.size(); ++p)
        if (x_.kept_.polys[p] != none) first_.push_back(end += before_.length(p));
      all_.reserve(end + x_.edges_.num_corners());
      all_.resize(end);
    }

    /// Copies the rows of polys that were first to last before. Several threads can do so.
    void copy(std::size_t first, std::size_t last) {
      Id* const rows = all_.data();
      const std::uint32_t *const begins = first_.data(), *const numbers = numbers_.data(), *const polys_now = x_.kept_.polys.data();
      for (std::size_t p = first; p < last; ++p) {
        if (polys_now[p] == none) continue;
        Id* next = rows + begins[polys_now[p]];
        for (const Id x : before_[p]) *next++ = Id{numbers[x.raw()]};
      }
    }

    /// Adds the rows of the other polys: what for_each_of_face(face, use) passes to use(x), each value below `bound` once.
    template<class F>
    void add(std::size_t bound, const F& for_each_of_face) {
      const jagged<face_id>& faces_of = x_.polys_;
      core::flat_array<std::uint32_t> met(faces_of.size() > x_.kept_.num_polys ? bound : 0, none);
      for (std::uint32_t p = x_.kept_.num_polys; p < faces_of.size(); ++p) {
        for (const face_id f : faces_of[p])
          for_each_of_face(f, [&](const Id& x) {
            if (met[x.raw()] == p) return;
            met[x.raw()] = p;
            added_.push_back(x);
          });
        first_.push_back(static_cast<std::uint32_t>(all_.size() + added_.size()));
      }
      if (all_.size() + added_.size() >= ~0u) throw unsupported("polyhedra_tables: the mesh has more than 2^32 adjacencies of one kind");
    }

    jagged<Id> take() && {
      all_.append(added_.data(), added_.size());
      all_.shrink_to_fit();
      return {std::make_shared<const detail::offsets>(std::move(first_)), std::move(all_)};
    }
  };
  void add_edges_of_polys(poly_rows<edge_id>& rows) const {
    rows.add(edges_.num_edges(), [&](face_id f, const auto& use) { edges_.for_each_edge(f, use); });
  }
  void list_verts_of_polys() {
    poly_rows<vert_id> rows(*this, before_.p2v_, kept_.verts);
    rows.copy(0, kept_.polys.size());
    rows.add(vert_count_, [&](face_id f, const auto& use) {
      for (const vert_id v : t_.f2v_[f.raw()]) use(v);
    });
    t_.p2v_ = std::move(rows).take();
  }

  void list_polys_of_verts() {
    core::flat_array<std::uint32_t> first_added(vert_count_ + 1, 0);  // of the polys that are added, by vert
    const auto for_each_added = [&](const auto& f) {
      for (std::uint32_t p = kept_.num_polys; p < polys_.size(); ++p)
        for (const vert_id v : t_.p2v_[p]) f(v.raw(), poly_id{p});
    };
    for_each_added([&](std::uint32_t v, poly_id) { ++first_added[v]; });
    std::partial_sum(first_added.begin(), first_added.end(), first_added.data());
    core::flat_array<poly_id> added(first_added[vert_count_]);
    for (std::uint32_t p = static_cast<std::uint32_t>(polys_.size()); p > kept_.num_polys; --p)
      for (const vert_id v : t_.p2v_[p - 1]) added[--first_added[v.raw()]] = poly_id{p - 1};

    detail::offsets first;
    core::reserve_exact(first, vert_count_ + 1);
    first.push_back(0);
    core::flat_array<poly_id> all(t_.p2v_.num_values());
    std::uint32_t end = 0;
    const auto end_vert = [&](std::uint32_t v) {
      for (std::uint32_t i = first_added[v]; i < first_added[v + 1]; ++i) all[end++] = added[i];
      first.push_back(end);
    };
    for (std::size_t v = 0; v < kept_.verts.size(); ++v) {
      if (kept_.verts[v] == none) continue;
      for (const poly_id p : before_.v2p_[v])
        if (kept_.polys[p.raw()] != none) all[end++] = poly_id{kept_.polys[p.raw()]};
      end_vert(kept_.verts[v]);
    }
    for (std::uint32_t v = kept_.num_verts; v < vert_count_; ++v) end_vert(v);
    t_.v2p_ = {std::make_shared<const detail::offsets>(std::move(first)), std::move(all)};
  }

  void link_polys() {
    auto& links = t_.facet_adjacency_;
    links.set_facets(t_.f2v_.size());
    links.index_facets();
    for (std::uint32_t p = 0; p < kept_.polys.size(); ++p)
      if (kept_.polys[p] != none) links.copy_links(kept_.polys[p], before_.facet_adjacency_.neighbours_of(poly_id{p}), kept_.polys.data());
    std::vector<unsigned char> is_linked(kept_.num_polys, 0);
    for (std::uint32_t p = kept_.num_polys; p < polys_.size(); ++p)
      for (std::uint32_t k = 0; k < polys_.length(p); ++k) {
        const face_id f = polys_.begin(p)[k];
        for (const poly_id q : links.polys_of(f))
          if (q.raw() < kept_.num_polys) is_linked[q.raw()] = 1;
        links.link(p, k, f);
      }
    std::vector<std::uint32_t> linked;
    for (std::uint32_t p = 0; p < polys_.size(); ++p)
      if (p >= kept_.num_polys || is_linked[p]) linked.push_back(p);
    links.finish(linked);
  }
};

template<class Lists>
basic_polyhedra_tables<Lists>::basic_polyhedra_tables(const basic_polyhedra_tables& before, kept_polyhedra& kept, std::size_t vert_count, std::vector<std::uint32_t> face_offsets,
                                                      std::vector<vert_id> face_verts, std::vector<std::uint32_t> poly_offsets, std::vector<face_id> poly_faces,
                                                      std::vector<std::uint8_t> outward)
    : f2v_(std::make_shared<const detail::offsets>(std::move(face_offsets)), std::move(face_verts)) {
  detail::check_counts("polyhedra_tables", vert_count, poly_offsets.size() - 1, f2v_.num_values());
  const auto where = std::make_shared<const detail::offsets>(std::move(poly_offsets));
  outward_ = {where, std::move(outward)};
  facet_adjacency_ = {{where, std::move(poly_faces)}, {where, core::flat_array<detail::encoded_neighbour>(where->back())}};
  extension(*this, before, kept, vert_count).build();
}

}  // namespace concino
