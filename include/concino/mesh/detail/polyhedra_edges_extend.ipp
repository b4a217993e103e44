// The edges of tables of polyhedra that have most elements in common with others; see polyhedra_tables_extend.ipp.
#pragma once

#include <concino/core/large_pages.hpp>
#include <concino/mesh/polyhedra_tables.hpp>

#include <algorithm>
#include <numeric>

namespace concino {

/// The constructor numbers edges by their smaller vert, and then in the order in which faces have them. Kept verts and faces keep their order, so the edges at a
/// vert do so too, unless a face that comes first at one of them is left out.
template<class Lists>
class basic_polyhedra_tables<Lists>::edge_extension {
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
  const std::size_t vert_count_, first_corner_, num_corners_;  // corners of the added faces

  core::flat_array<std::uint32_t> first_half_, edge_to_;  // by vert; edge_to_ is of one vert at a time
  core::flat_array<std::uint32_t> first_edge_;            // by vert: the first edge of which it is the smaller vert
  core::flat_array<half_edge> halves_;
  core::flat_array<edge_id> f2e_;  // of the added faces
  core::flat_array<vert_id> ends_;
  core::flat_array<face_id> faces_;
  detail::offsets first_face_, degrees_;
  std::uint32_t num_edges_ = 0, num_faces_ = 0;  // listed in ends_ and in faces_
  bool are_few_at_vert_ = true;
  std::vector<kept_edge> group_;
  std::vector<std::uint32_t> next_;

 public:
  /// t has the lists of faces.
  edge_extension(basic_polyhedra_tables& t, const basic_polyhedra_tables& before, kept_polyhedra& kept, std::size_t vert_count)
      : t_(t), before_(before), kept_(kept), vert_count_(vert_count), first_corner_(kept.num_faces < t.f2v_.size() ? t.f2v_.first(kept.num_faces) : t.f2v_.num_values()),
        num_corners_(t.f2v_.num_values() - first_corner_) {}

  /// The number of corners of the added faces.
  std::size_t num_corners() const { return num_corners_; }
  std::uint32_t num_edges() const { return num_edges_; }
  /// Whether no vert is the smaller one of so many edges that a scan of them takes long.
  bool are_few_at_vert() const { return are_few_at_vert_; }

  /// Lists the edges, and the faces at each.
  void build() {
    list_half_edges();
    number_edges();
  }
  /// Lists the edges of verts, after build().
  void list_edges_of_verts() { t_.incident_edges_ = detail::make_incident_edges(std::move(degrees_), t_.e2v_, edge_to_); }

  /// Calls use(e) for the edges of a face, in their order, after build(). If are_few_at_vert(), the edges of verts need not be listed.
  template<class Use>
  void for_each_edge(face_id f, const Use& use) const {
    if (f.raw() < kept_.num_faces) {
      const id_span<vert_id> v = t_.f2v_[f.raw()];
      for (std::size_t k = 0; k < v.size(); ++k) use(edge_between(v[k], v[k + 1 == v.size() ? 0 : k + 1]));
    } else {
      const std::size_t first = t_.f2v_.first(f.raw()) - first_corner_;
      for (std::size_t i = first; i < first + t_.f2v_.length(f.raw()); ++i) use(f2e_[i]);
    }
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

  /// The edge between two verts that have one.
  edge_id edge_between(vert_id a, vert_id b) const {
    if (!are_few_at_vert_) return t_.edge_between(a, b);
    const auto [smaller, larger] = std::minmax(a, b);
    std::uint32_t e = first_edge_[smaller.raw()];
    while (t_.e2v_.begin(e)[1] != larger) ++e;
    return edge_id{e};
  }
};

}  // namespace concino
