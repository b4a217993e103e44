// Refuses collapses after which the surface and the input would be too far apart, or their boundaries.
#pragma once

#include <concino/concepts/end_verts.hpp>
#include <concino/edit/proposed_edit.hpp>
#include <concino/edit/support/typed_edit.hpp>
#include <concino/remesh/detail/two_sided_bound.hpp>
#include <concino/remesh/detail/unit_points.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace concino::detail {

/// Polys that are no triangles stay as they are, so only triangles are parts.
template<class M>
class bounded_collapses {
  const M& m_;
  unit_points unit_;
  std::unordered_map<std::uint64_t, std::uint32_t> line_ids_;  // of edges of boundaries, by their ends
  two_sided_bound surface_, boundary_;
  part_change polys_, lines_;  // those of the edit that was asked about last

  std::uint32_t line_id(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax(a, b);
    return line_ids_.try_emplace(std::uint64_t{low} << 32 | high, static_cast<std::uint32_t>(line_ids_.size()))
        .first->second;
  }
  std::vector<surface_part> triangles() const {
    std::vector<surface_part> all;
    for (const poly_t<M> p : polys(m_)) {
      surface_part x{static_cast<std::uint32_t>(index_of(m_, p)), {}};
      std::size_t n = 0;
      for (const vert_t<M> v : adj_p2v(m_, p)) {
        if (n < 3) x.points[n] = unit_.at(m_, v);
        ++n;
      }
      if (n == 3) all.push_back(x);
    }
    return all;
  }
  std::vector<surface_part> boundary_edges() {
    std::vector<surface_part> all;
    for (const edge_t<M> e : edges(m_)) {
      if (num_elements(adj_e2p(m_, e)) != 1) continue;
      const auto ends = end_verts(m_, e);
      const vec3 a = unit_.at(m_, ends.first), b = unit_.at(m_, ends.second);
      all.push_back({line_id(index_of(m_, ends.first), index_of(m_, ends.second)), {a, b, b}});
    }
    return all;
  }

  /// The edges of the cavity's polys that are on the boundary and at the ends of the collapsed edge: before the edit,
  /// or after it.
  std::vector<std::array<unsigned, 2>> lines_at_ends(const cavity_builder<M>& c, bool after) const {
    std::vector<std::array<unsigned, 2>> all;
    const auto add = [&](const unsigned* corners) {
      for (unsigned i = 0; i < 3; ++i) {
        const unsigned a = corners[i], b = corners[(i + 1) % 3];
        for (const unsigned v : {a, b})
          if (v == c.kept_vert() || v == c.removed_vert()) {
            all.push_back({std::min(a, b), std::max(a, b)});
            break;
          }
      }
    };
    if (after)
      for (std::size_t k = 0; k < c.origins().size(); ++k) add(c.new_corners().data() + 3 * k);
    else
      for (unsigned k = 0; k < c.num_old(); ++k) add(c.corners(k));
    for (unsigned k = c.num_old(); k < c.num_polys(); ++k) add(c.corners(k));
    std::sort(all.begin(), all.end());
    std::size_t n = 0;
    for (std::size_t i = 0, j = 0; i < all.size(); i = j) {
      while (j < all.size() && all[j] == all[i]) ++j;
      if (j == i + 1) all[n++] = all[i];
    }
    all.resize(n);
    return all;
  }

  void find_changes(const proposed_edit& e, const cavity_builder<M>& c) {
    polys_.clear(), lines_.clear();
    const auto at = [&](unsigned v) { return unit_.to_unit(e.points_after[v]); };
    for (const std::size_t p : e.old_polys) polys_.old.push_back(static_cast<std::uint32_t>(p));
    for (std::size_t k = 0; k < e.num_new_polys(); ++k) {
      const auto v = e.new_poly(k);
      polys_.added.push_back({polys_.old[e.origins[k].first], {at(v[0]), at(v[1]), at(v[2])}});
    }
    if (line_ids_.empty()) return;
    for (const auto& [a, b] : lines_at_ends(c, false)) lines_.old.push_back(line_id(e.verts[a], e.verts[b]));
    for (const auto& [a, b] : lines_at_ends(c, true))
      lines_.added.push_back({line_id(e.verts[a], e.verts[b]), {at(a), at(b), at(b)}});
  }

 public:
  bounded_collapses(const M& m, double max_error, const char* caller)
      : m_(m), unit_(m, caller), surface_(triangles(), unit_.length_to_unit(max_error)),
        boundary_(boundary_edges(), unit_.length_to_unit(max_error)) {}

  permission ask(const proposed_edit& e) {
    find_changes(e, core::cavity_of_simplices(e, m_, "decimate"));
    if (surface_.stays_near(polys_) && boundary_.stays_near(lines_)) return {};
    return {refusal::invariant, "options.max_error: the surface would be too far from the input"};
  }
  /// The edit that was asked about last has been made.
  void accept() { surface_.accept(), boundary_.accept(); }
};

}  // namespace concino::detail
