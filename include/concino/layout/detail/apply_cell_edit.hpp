// Makes the edit of a patch of quads or hexes on its mesh, by one replace_polys.
#pragma once

#include <concino/edit/replace_polys.hpp>
#include <concino/edit/support/replacement_proposal.hpp>
#include <concino/layout/detail/cell_patch.hpp>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace concino::detail {

/// The lists for `rewire`.
template<class M>
class cell_replacement {
  std::vector<poly_t<M>> polys_;
  std::vector<vert_t<M>> verts_;
  std::vector<unsigned> corners_, ends_;
  std::vector<vec3> points_;
  std::vector<std::uint32_t> changed_;  // polys of the patch that remain
  core::local_numbers numbers_;         // in the cavity, of labels
  correspondence from_;
  std::vector<replaced_vert> successors_, of_removed_;  // of all verts; of removed ones that have only one
  std::size_t num_kept_ = 0, num_removed_ = 0;

  template<class T>
  static id_span<T> span(const std::vector<T>& v) {
    return {v.data(), v.data() + v.size()};
  }

  void find_successors(const cube_tables& t, const cell_edit& e) {
    for (std::size_t i = 0; i < e.labels.size(); ++i)
      if (const unsigned v = numbers_.find(t.poly_verts[i]); v != numbers_.none)
        successors_.push_back({v, numbers_.find(e.labels[i])});
    std::sort(successors_.begin(), successors_.end());
    successors_.erase(std::unique(successors_.begin(), successors_.end()), successors_.end());
    const std::size_t n = successors_.size();
    for (std::size_t i = 0; i < n; ++i) {
      const unsigned v = successors_[i].vert;
      const bool has_others =
          (i > 0 && successors_[i - 1].vert == v) || (i + 1 < n && successors_[i + 1].vert == v);
      if (v + num_removed_ >= verts_.size() && !has_others) of_removed_.push_back(successors_[i]);
    }
  }

  core::replacement_origins<M> origins(const cell_patch<M>& patch, const cell_edit& e) const {
    const cube_tables& t = patch.t;
    core::replacement_origins<M> from;
    for (unsigned k = 0; k < num_kept_; ++k) from.polys.push_back(k);
    for (const std::uint32_t p : e.added_from)
      from.polys.push_back(
          static_cast<unsigned>(std::lower_bound(changed_.begin(), changed_.end(), p) - changed_.begin()));
    from.verts = successors_;
    for (std::uint32_t p = 0; p < t.num_polys(); ++p)
      if (!e.is_gone[p] && !std::binary_search(changed_.begin(), changed_.end(), p))
        from.neighbours.push_back(patch.polys[p]);
    return from;
  }

 public:
  std::vector<vert_t<M>> new_verts;
  std::vector<poly_t<M>> new_polys;  // those that change, then those that are made

  cell_replacement(const M& m, const cell_patch<M>& patch, const cell_edit& e) {
    const cube_tables& t = patch.t;
    const unsigned n = t.num_corners();
    std::vector<std::uint32_t> from;
    std::vector<unsigned char> changes(t.num_polys());
    for (std::size_t i = 0; i < e.labels.size(); ++i) changes[i / n] |= e.labels[i] != t.poly_verts[i];
    for (const std::uint32_t p : e.added_from) changes[p] = 1;  // its values are those of new polys
    for (std::uint32_t p = 0; p < t.num_polys(); ++p)
      if (!e.is_gone[p] && changes[p]) changed_.push_back(p), polys_.push_back(patch.polys[p]);
    num_kept_ = polys_.size();
    std::vector<unsigned char> is_removed(t.num_verts);
    for (const std::uint32_t v : e.removed) is_removed[v] = 1;
    const auto add_verts = [&](std::uint32_t p) {
      for (unsigned k = 0; k < n; ++k)
        for (const std::uint32_t v : {t.poly_verts[p * n + k], e.labels[p * n + k]})
          if (v < t.num_verts && !is_removed[v]) numbers_.add(v);
    };
    for (const std::uint32_t p : changed_) add_verts(p);
    for (std::uint32_t p = 0; p < t.num_polys(); ++p)
      if (e.is_gone[p]) polys_.push_back(patch.polys[p]), add_verts(p);
    for (const std::uint32_t v : e.added)
      if (v < t.num_verts) numbers_.add(v);
    for (const std::uint32_t v : e.removed) numbers_.add(v);
    num_removed_ = e.removed.size();
    for (const std::size_t v : numbers_) verts_.push_back(patch.verts[v]);
    for (std::size_t i = 0; i < e.points.size(); ++i) numbers_.add(t.num_verts + i);
    points_ = e.points;
    const auto add_poly = [&](const std::uint32_t* labels, std::uint32_t old) {
      for (unsigned k = 0; k < n; ++k) corners_.push_back(numbers_.find(labels[corner_places[k]]));
      ends_.push_back(static_cast<unsigned>(corners_.size()));
      from.push_back(static_cast<std::uint32_t>(index_of(m, patch.polys[old])));
    };
    for (const std::uint32_t p : changed_) add_poly(e.labels.data() + p * n, p);
    for (std::size_t i = 0; i < e.added_from.size(); ++i) add_poly(e.added.data() + i * n, e.added_from[i]);
    from_.polys = element_origins(std::move(from));
    std::vector<origin> origins;
    for (std::size_t i = 0, at = 0; i < e.points.size(); ++i) {
      origins.clear();
      for (; at < e.origin_ends[i]; ++at)
        origins.push_back({static_cast<std::uint32_t>(index_of(m, patch.verts[e.origins[at]]))});
      from_.verts.add(std::span<const origin>(origins));
    }
    new_verts.resize(points_.size()), new_polys.resize(ends_.size());
    find_successors(t, e);
  }

  cavity<M> lists() const {
    return {span(polys_), span(verts_), span(points_), span(corners_), span(ends_), {}, num_kept_, num_removed_};
  }
  std::size_t num_kept() const { return num_kept_; }
  /// Whether the edit is allowed. plan: the patch, and its edit e.
  template<class Plan>
  permission ask(const M& m, const Plan& plan, const std::vector<invariant>& keep) const {
    if (const permission p = can_replace_polys(m, lists()); !p || keep.empty()) return p;
    return core::ask_about_replacement(keep, m, lists(), origins(plan.patch, plan.e));
  }
  void apply(M& m) {
    replace_polys(m, lists(), cavity_result<M>{new_verts.data(), new_polys.data()}, from_, {}, [] {}, of_removed_);
  }
};

/// The facet or edge of p at a place.
template<class M>
facet_t<M> facet_at(const M& m, const poly_t<M>& p, unsigned place, const char* caller) {
  const auto corners = corners_by_place(m, p, caller);
  for (const facet_t<M> f : adj_p2facet(m, p))
    if (const auto at = place_of_facet(m, p, corners, f, caller); 2 * at.axis + at.number == place) return f;
  throw_no_quad_or_hex(index_of(m, p), dimension_v<M> == 3, caller);
}
template<class M>
edge_t<M> edge_at(const M& m, const poly_t<M>& p, unsigned axis, const char* caller) {
  const auto corners = corners_by_place(m, p, caller);
  for (const edge_t<M> e : adj_p2e(m, p))
    if (const auto at = place_of_edge(m, p, corners, e, caller); at.axis == axis && at.number == 0) return e;
  throw_no_quad_or_hex(index_of(m, p), dimension_v<M> == 3, caller);
}

}  // namespace concino::detail
