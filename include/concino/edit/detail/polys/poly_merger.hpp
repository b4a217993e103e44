// Merges old polys of a general_cavity into one.
#pragma once

#include <concino/edit/detail/facet_flip.hpp>
#include <concino/edit/detail/polys/general_checks.hpp>
#include <concino/edit/detail/polys/list_topology.hpp>

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>
#include <vector>

namespace concino::detail {

inline constexpr permission no_disk_or_ball{
    refusal::link_condition,
    "the polys are no disk or ball: what they share is not one chain of edges or one disk of faces, or is all of a "
    "boundary"};
inline constexpr permission third_poly{
    refusal::link_condition, "a third poly, or a face without polys, is at an element inside the merged polys"};

inline permission as_permission(list_fault fault) {
  if (fault == list_fault::none) return {};
  if (fault == list_fault::winding) return contradictory_winding;
  return fault == list_fault::third_list ? third_poly : no_disk_or_ball;
}

/// Merges old polys first, ..., last - 1 of c into one.
template<class M>
class poly_merger {
  const M& m_;
  general_cavity<M>& c_;
  const unsigned first_, last_;
  std::vector<std::span<const unsigned>> lists_, boundary_;

  bool is_member(const poly_t<M>& p) const {
    const unsigned k = c_.find_poly(index_of(m_, p));
    return k != core::local_numbers::none && k >= first_ && k < last_;
  }
  bool are_members(const auto& all) const {
    for (const poly_t<M> p : all)
      if (!is_member(p)) return false;
    return true;
  }
  bool is_enclosed(unsigned v) const {
    if constexpr (VolumeMesh<M>)  // surfaces have no faces
      if (is_any_loose(m_, adj_v2f(m_, c_.vert_at(v)))) return false;
    return are_members(adj_v2p(m_, c_.vert_at(v)));
  }
  bool is_enclosed(unsigned a, unsigned b) const {
    const edge_t<M> e = edge_between_verts(m_, c_.vert_at(a), c_.vert_at(b));
    if constexpr (VolumeMesh<M>)  // surfaces have no faces
      if (is_any_loose(m_, adj_e2f(m_, e))) return false;
    return are_members(adj_e2p(m_, e));
  }
  permission remove_inside(const std::vector<unsigned>& verts, const auto& edges) {
    for (const auto& [a, b] : edges)
      if (!is_enclosed(a, b)) return third_poly;
    for (const unsigned v : verts) {
      if (!is_enclosed(v)) return third_poly;
      c_.remove(v);
    }
    return {};
  }

  permission merge()
    requires SurfaceMesh<M>
  {
    merged_cycle merged;
    if (const permission p = as_permission(merge_lists(lists_, merged)); !p) return p;
    if (const permission p = remove_inside(merged.inside, merged.removed); !p) return p;
    c_.add_list(merged.boundary);
    return {};
  }
  /// The faces that only one poly has are the boundary.
  permission merge()
    requires VolumeMesh<M>
  {
    const std::size_t first_list = c_.old_polys().first_list(first_);
    struct entry { std::size_t face, list; };
    std::vector<entry> all;
    for (std::size_t i = 0; i < lists_.size(); ++i) all.push_back({index_of(m_, c_.face(first_list + i)), i});
    std::sort(all.begin(), all.end(),
              [](const entry& x, const entry& y) { return std::pair{x.face, x.list} < std::pair{y.face, y.list}; });
    std::vector<std::size_t> single;
    std::ptrdiff_t num_faces = 0;
    for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
      while (j < all.size() && all[j].face == all[i].face) ++j;
      ++num_faces;
      const face_t<M>& f = c_.face(first_list + all[i].list);
      if (j - i == 1) {
        single.push_back(all[i].list);
        continue;
      }
      if (j - i > 2 || !are_members(adj_f2p(m_, f))) return third_poly;
      if (is_same_cycle(lists_[all[i].list], lists_[all[i + 1].list])) return as_permission(list_fault::winding);
    }
    std::sort(single.begin(), single.end());
    for (const std::size_t i : single) boundary_.push_back(lists_[i]);
    if (const permission p = as_permission(check_sphere(boundary_)); !p) return p;
    return remove_faces(num_faces);
  }
  /// Whether two lists of the same verts run in the same direction.
  static bool is_same_cycle(std::span<const unsigned> x, std::span<const unsigned> y) {
    const auto at = static_cast<std::size_t>(std::find(y.begin(), y.end(), x[0]) - y.begin());
    return at < y.size() && y[at + 1 < y.size() ? at + 1 : 0] == x[1];
  }
  permission remove_faces(std::ptrdiff_t num_faces)
    requires VolumeMesh<M>
  {
    const auto edges_of = [](const auto& some) {
      std::vector<std::pair<unsigned, unsigned>> all;
      for (const auto& list : some)
        for_each_edge_of(list, [&](unsigned a, unsigned b) { all.emplace_back(std::min(a, b), std::max(a, b)); });
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
      return all;
    };
    const auto verts_of = [](const auto& some) {
      std::vector<unsigned> all;
      for (const auto& list : some) all.insert(all.end(), list.begin(), list.end());
      return sorted_list(all);
    };
    const auto all_edges = edges_of(lists_), outer_edges = edges_of(boundary_);
    const auto all_verts = verts_of(lists_), outer_verts = verts_of(boundary_);
    const auto count = [](const auto& all) { return static_cast<std::ptrdiff_t>(all.size()); };
    if (count(all_verts) - count(all_edges) + num_faces - static_cast<std::ptrdiff_t>(last_ - first_) != 1)
      return no_disk_or_ball;
    std::vector<unsigned> inside;
    std::vector<std::pair<unsigned, unsigned>> inner_edges;
    std::set_difference(all_verts.begin(), all_verts.end(), outer_verts.begin(), outer_verts.end(),
                        std::back_inserter(inside));
    std::set_difference(all_edges.begin(), all_edges.end(), outer_edges.begin(), outer_edges.end(),
                        std::back_inserter(inner_edges));
    if (const permission p = remove_inside(inside, inner_edges); !p) return p;
    for (const auto& list : boundary_) c_.add_list(list);
    return {};
  }

 public:
  poly_merger(general_cavity<M>& c, unsigned first, unsigned last)
      : m_(c.mesh()), c_(c), first_(first), last_(last) {
    for (std::size_t i = c.old_polys().first_list(first); i < c.old_polys().last_list(last - 1); ++i)
      lists_.push_back(c.old_polys().list(i));
  }
  /// Adds the new poly.
  permission operator()() {
    const permission p = merge();
    c_.end_new(first_, last_ - first_);
    return p;
  }
};

}  // namespace concino::detail
