// Construction of tables of polyhedra that have most elements in common with others; see polyhedra_tables.hpp.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/core/parallel.hpp>
#include <concino/mesh/polyhedra_tables.hpp>

#include <algorithm>
#include <numeric>
#include <span>

namespace concino {

/// The constructor numbers edges by their smaller vert, and then in the order in which faces have them. Kept verts and faces keep their order, so the edges at a
/// vert do so too, unless a face that comes first at one of them is left out.
template<class Lists>
class basic_polyhedra_tables<Lists>::extension {
  static constexpr std::uint32_t none = kept_polyhedra::none;

  /// An edge of an added face, at its smaller vert.
  struct half_edge {
    std::uint32_t face, corner, far;
  };
  /// An edge of a kept face, by the first of these and its corner there, with the number of such faces.
  struct kept_edge {
    std::uint32_t face, corner, before, num_faces;
    bool operator<(const kept_edge& o) const { return face != o.face ? face < o.face : corner < o.corner; }
  };

  basic_polyhedra_tables& t_;
  const basic_polyhedra_tables& before_;
  kept_polyhedra& kept_;
  const jagged<face_id>& polys_;
  const std::size_t vert_count_, first_corner_, num_corners_;  // corners of the added faces

  core::flat_array<std::uint32_t> first_half_, edge_to_;  // by vert; edge_to_ is of one vert at a time
  core::flat_array<std::uint32_t> first_edge_;            // by vert: the first edge of which it is the smaller vert
  core::flat_array<half_edge> halves_;
  core::flat_array<edge_id> f2e_;  // of the added faces
  core::flat_array<vert_id> ends_;
  core::flat_array<face_id> faces_;
  detail::offsets first_face_, degrees_;
  std::uint32_t num_edges_ = 0, num_faces_ = 0;  // listed in ends_ and in faces_
  bool are_few_at_vert_ = true;                  // no vert is the smaller one of so many edges that a scan takes long
  std::vector<kept_edge> group_;
  std::vector<std::uint32_t> next_;

 public:
  /// t has the lists of faces and of polys.
  extension(basic_polyhedra_tables& t, const basic_polyhedra_tables& before, kept_polyhedra& kept, std::size_t vert_count)
      : t_(t), before_(before), kept_(kept), polys_(t.facet_adjacency_.facet_rows()), vert_count_(vert_count),
        first_corner_(kept.num_faces < t.f2v_.size() ? t.f2v_.first(kept.num_faces) : t.f2v_.num_values()), num_corners_(t.f2v_.num_values() - first_corner_) {}

  void build() {
    t_.face_vert_lookup_ = detail::row_lookup(t_.f2v_);
    const auto build_edges = [&] {
      list_half_edges();
      number_edges();
    };
    const auto build_polys = [&] {
      link_polys();
      list_verts_of_polys();
      list_polys_of_verts();
    };
    core::run_both(t_.is_large(), build_edges, build_polys);
    poly_rows<edge_id> edges_of_polys(*this, before_.p2e_, kept_.edges);
    const auto list_edges_of_verts = [&] { t_.incident_edges_ = detail::make_incident_edges(std::move(degrees_), t_.e2v_, edge_to_); };
    const auto add_edges = [&] {
      if (are_few_at_vert_) add_edges_of_polys(edges_of_polys);
    };
    const auto copy_edges = [&](std::size_t first, std::size_t last) { edges_of_polys.copy(first, last); };
    core::run_with_chunks(t_.is_large(), {list_edges_of_verts, add_edges}, kept_.polys.size(), 16384, copy_edges);
    if (!are_few_at_vert_) add_edges_of_polys(edges_of_polys);
    t_.p2e_ = std::move(edges_of_polys).take();
    t_.finish(vert_count_, polys_.size());
  }

 private:
  std::uint32_t now(face_id before) const { return kept_.faces[before.raw()]; }

  template<class F>
  void for_each_half_edge(const F& f) const {
    for (std::size_t i = kept_.num_faces, corner = 0; i < t_.f2v_.size(); ++i) {
      const id_span<vert_id> v = t_.f2v_[i];
      for (std::size_t k = 0; k < v.size(); ++k, ++corner) {
        const auto [a, b] = std::minmax({v[k].raw(), v[k + 1 == v.size() ? 0 : k + 1].raw()});
        f(a, half_edge{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(corner), b});
      }
    }
  }
  void list_half_edges() {
    first_half_ = core::flat_array<std::uint32_t>(vert_count_ + 1, 0);
    edge_to_.resize(vert_count_);
    halves_.resize(num_corners_);
    f2e_.resize(num_corners_);
    for_each_half_edge([&](std::uint32_t a, const half_edge&) { ++first_half_[a + 1]; });
    std::partial_sum(first_half_.begin(), first_half_.end(), first_half_.data());
    std::copy_n(first_half_.begin(), vert_count_, edge_to_.data());
    for_each_half_edge([&](std::uint32_t a, const half_edge& h) { halves_[edge_to_[a]++] = h; });
  }

  void number_edges() {
    const std::size_t num_before = before_.e2v_.size(), bound = num_before + num_corners_;
    kept_.edges = core::large_vector(num_before, none);
    std::fill_n(edge_to_.data(), vert_count_, none);
    ends_.reserve(2 * bound);
    core::reserve_large(first_face_, bound + 1);
    first_face_.push_back(0);
    faces_.resize(t_.f2v_.num_values());
    degrees_ = core::exact_vector(vert_count_ + 1, 0u);
    first_edge_.resize(vert_count_);
    std::size_t e = 0;
    for (std::size_t v = 0; v < kept_.verts.size(); ++v) {
      const std::size_t first = e;
      while (e < num_before && before_.e2v_.begin(e)[0].raw() == v) ++e;
      if (kept_.verts[v] != none) add_edges_at(kept_.verts[v], first, e);
    }
    for (std::uint32_t v = kept_.num_verts; v < vert_count_; ++v) add_edges_at(v, 0, 0);
    ends_.shrink_to_fit();
    t_.e2v_ = detail::jagged_array<vert_id, 2>(std::move(ends_));
    detail::shrink_if_wasteful(first_face_);
    t_.e2f_ = {std::make_shared<const detail::offsets>(std::move(first_face_)), std::move(faces_)};
  }

  std::uint32_t add_edge(std::uint32_t a, std::uint32_t b) {
    ends_.push_back(vert_id{a});
    ends_.push_back(vert_id{b});
    ++degrees_[a + 1], ++degrees_[b + 1];
    return num_edges_++;
  }

  /// Adds the edges of which `a` is the smaller vert. Before, those of kept faces were among `first` to `last`.
  void add_edges_at(std::uint32_t a, std::size_t first, std::size_t last) {
    first_edge_[a] = num_edges_;
    bool keep_order = first_half_[a] == first_half_[a + 1];
    for (std::size_t e = first; keep_order && e < last; ++e) keep_order = now(*before_.e2f_.begin(e)) != none;
    are_few_at_vert_ = are_few_at_vert_ && last - first <= detail::row_lookup::longest_scan;
    if (!keep_order) return sort_edges_at(a, first, last);
    for (std::size_t e = first; e < last; ++e) {
      kept_.edges[e] = add_edge(a, kept_.verts[before_.e2v_.begin(e)[1].raw()]);
      for (const face_id f : before_.e2f_[e])
        if (now(f) != none) faces_[num_faces_++] = face_id{now(f)};
      first_face_.push_back(num_faces_);
    }
  }

  [[gnu::noinline]] void sort_edges_at(std::uint32_t a, std::size_t first, std::size_t last) {
    list_kept_edges(a, first, last);
    const std::uint32_t first_edge = num_edges_;
    next_.clear();
    for (const kept_edge& x : group_) {
      const std::uint32_t b = kept_.verts[before_.e2v_.begin(x.before)[1].raw()];
      kept_.edges[x.before] = edge_to_[b] = add_edge(a, b);
      next_.push_back(x.num_faces);
    }
    const auto is_known = [&](std::uint32_t b) { return b != none && edge_to_[b] != none && edge_to_[b] >= first_edge; };
    for (std::uint32_t i = first_half_[a]; i < first_half_[a + 1]; ++i) {
      const half_edge& h = halves_[i];
      if (!is_known(h.far)) edge_to_[h.far] = add_edge(a, h.far), next_.push_back(0);
      ++next_[edge_to_[h.far] - first_edge];
      f2e_[h.corner] = edge_id{edge_to_[h.far]};
    }
    for (std::size_t e = first; e < last; ++e)  // those that only added faces have
      if (const std::uint32_t b = kept_.verts[before_.e2v_.begin(e)[1].raw()]; kept_.edges[e] == none && is_known(b)) kept_.edges[e] = edge_to_[b];
    list_faces_at(a, first_edge);
    are_few_at_vert_ = are_few_at_vert_ && num_edges_ - first_edge <= detail::row_lookup::longest_scan;
  }
  void list_kept_edges(std::uint32_t a, std::size_t first, std::size_t last) {
    group_.clear();
    for (std::size_t e = first; e < last; ++e) {
      kept_edge x{none, 0, static_cast<std::uint32_t>(e), 0};
      for (const face_id f : before_.e2f_[e]) {
        if (now(f) == none) continue;
        if (x.face == none) x.face = now(f);
        ++x.num_faces;
      }
      if (x.face == none) continue;
      const std::uint32_t b = kept_.verts[before_.e2v_.begin(e)[1].raw()];
      const id_span<vert_id> v = t_.f2v_[x.face];
      const std::uint32_t at = place_of(x.face, vert_id{a}), end = place_of(x.face, vert_id{b});
      x.corner = end == (at + 1 == v.size() ? 0 : at + 1) ? at : end;
      group_.push_back(x);
    }
    std::sort(group_.begin(), group_.end());
  }
  std::uint32_t place_of(std::uint32_t face, const vert_id& v) const {
    return t_.f2v_.length(face) > detail::row_lookup::longest_scan ? t_.face_vert_lookup_.find(face, t_.f2v_[face], v) : t_.f2v_.find_in_row(face, v);
  }
  /// Lists the faces of the edges from first_edge on, of which next_ has the numbers: kept ones come first.
  void list_faces_at(std::uint32_t a, std::uint32_t first_edge) {
    for (std::uint32_t& n : next_) {
      const std::uint32_t begin = num_faces_;
      num_faces_ += n;
      n = begin;
      first_face_.push_back(num_faces_);
    }
    for (std::size_t i = 0; i < group_.size(); ++i)
      for (const face_id f : before_.e2f_[group_[i].before])
        if (now(f) != none) faces_[next_[i]++] = face_id{now(f)};
    for (std::uint32_t i = first_half_[a]; i < first_half_[a + 1]; ++i) faces_[next_[f2e_[halves_[i].corner].raw() - first_edge]++] = face_id{halves_[i].face};
  }

  /// The edge between two verts that have one. The edges of verts may not be listed yet if there are few.
  edge_id edge_between(vert_id a, vert_id b) const {
    if (!are_few_at_vert_) return t_.edge_between(a, b);
    const auto [smaller, larger] = std::minmax(a, b);
    std::uint32_t e = first_edge_[smaller.raw()];
    while (t_.e2v_.begin(e)[1] != larger) ++e;
    return edge_id{e};
  }

  /// The rows of all polys: those of kept ones are rows of `before` with the numbers now.
  template<class Id>
  class poly_rows {
    const extension& x_;
    const jagged<Id>& before_;
    const std::uint32_t* const numbers_;
    detail::offsets first_;
    core::flat_array<Id> all_, added_;  // added_ is joined to the others at the end

   public:
    poly_rows(const extension& x, const jagged<Id>& before, const std::vector<std::uint32_t>& numbers) : x_(x), before_(before), numbers_(numbers.data()) {
      core::reserve_exact(first_, x_.polys_.size() + 1);
      first_.push_back(0);
      std::uint32_t end = 0;
      for (std::size_t p = 0; p < x_.kept_.polys.size(); ++p)
        if (x_.kept_.polys[p] != none) first_.push_back(end += before_.length(p));
      all_.reserve(end + x_.num_corners_);
      all_.resize(end);
    }

    /// Copies the rows of polys that were first to last before. Several threads can do so.
    void copy(std::size_t first, std::size_t last) {
      Id* const rows = all_.data();
      const std::uint32_t *const begins = first_.data(), *const numbers = numbers_, *const polys_now = x_.kept_.polys.data();
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
    rows.add(num_edges_, [&](face_id f, const auto& use) {
      if (f.raw() < kept_.num_faces) {
        const id_span<vert_id> v = t_.f2v_[f.raw()];
        for (std::size_t k = 0; k < v.size(); ++k) use(edge_between(v[k], v[k + 1 == v.size() ? 0 : k + 1]));
      } else {
        const std::size_t first = t_.f2v_.first(f.raw()) - first_corner_;
        for (std::size_t i = first; i < first + t_.f2v_.length(f.raw()); ++i) use(f2e_[i]);
      }
    });
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

#ifdef CONCINO_COMPILED
template basic_polyhedra_tables<detail::jagged_array<vert_id, 0>>::basic_polyhedra_tables(const basic_polyhedra_tables&, kept_polyhedra&, std::size_t, std::vector<std::uint32_t>, std::vector<vert_id>,
                                                                                          std::vector<std::uint32_t>, std::vector<face_id>, std::vector<std::uint8_t>);
#endif

}  // namespace concino
