// Bodies of surface_steps.hpp that change what polys and verts are.
#pragma once

#include <concino/core/message.hpp>
#include <concino/graph/disjoint_sets.hpp>
#include <concino/mesh/support/face_merger.hpp>
#include <concino/repair/detail/edge_lists.hpp>
#include <concino/repair/detail/point_clusters.hpp>
#include <concino/repair/detail/surface_steps.hpp>

#include <algorithm>

namespace concino::detail {

CONCINO_INLINE void merge_verts_within(surface_lists& s, double tolerance, repair_log& log) {
  point_clusters clusters = find_clusters(std::move(s.points), tolerance);
  s.points = std::move(clusters.mean);
  std::vector<std::uint8_t> is_merged(s.points.size());
  bool any = false;
  for (std::uint32_t v = 0; v < clusters.first.size(); ++v)
    if (clusters.first[v] != v) is_merged[v] = is_merged[clusters.first[v]] = 1, any = true;
  if (!any) return;
  for (std::uint32_t v = 0; v < is_merged.size(); ++v)
    if (is_merged[v]) log.add(repair_kind::merged_verts, v);
  for (std::uint32_t& v : s.verts) v = clusters.first[v];
  for (std::uint32_t v = 0; v < s.vert_origin.size(); ++v) s.vert_origin[v] = clusters.first[v];
  s.cluster = std::move(clusters.first);
}

CONCINO_INLINE void cut_at_repeated_verts(surface_lists& s, std::uint32_t arity, repair_log& log) {
  std::vector<std::uint32_t> last(s.points.size(), surface_lists::none);  // by vert: the last poly with it
  const auto repeats = [&](std::uint32_t p) {
    bool found = false;
    for (const std::uint32_t v : s.poly(p)) {
      found = found || last[v] == p;
      last[v] = p;
    }
    return found;
  };
  std::uint32_t p = 0;
  const auto n = static_cast<std::uint32_t>(s.num_polys());
  while (p < n && !repeats(p)) ++p;
  if (p == n) return;
  surface_lists cut;  // the polys from p on
  std::vector<std::uint32_t> cycle;
  std::vector<std::uint32_t> place(s.points.size(), surface_lists::none);  // in the cycle, by vert
  const std::uint32_t first = p;
  for (; p < n; ++p) {
    const std::uint32_t origin = s.poly_origin[p];
    if (p != first && !repeats(p)) {
      cut.add_poly(s.poly(p), origin);
      continue;
    }
    std::size_t kept = 0;
    cycle.clear();
    const auto end_cycle = [&](std::size_t from) {
      const std::span<const std::uint32_t> part(cycle.data() + from, cycle.size() - from);
      for (const std::uint32_t v : part) place[v] = surface_lists::none;
      if (part.size() < 3) return;
      if (arity > 0 && part.size() != arity)
        core::throw_joined<unsupported>({"repair: poly ", log.poly_index()[origin], " of ", arity,
                                         " verts would become one of ", part.size(),
                                         ", as verts of it are merged; convert the mesh to a polygonmesh first"});
      cut.add_poly(part, origin);
      ++kept;
    };
    for (const std::uint32_t v : s.poly(p)) {
      if (place[v] != surface_lists::none) {
        const std::size_t from = place[v];
        end_cycle(from);
        cycle.resize(from);
      }
      place[v] = static_cast<std::uint32_t>(cycle.size());
      cycle.push_back(v);
    }
    end_cycle(0);
    log.add(kept == 0 ? repair_kind::removed_degenerate : repair_kind::collapsed_corners, origin);
  }
  s.offsets.resize(first + 1), s.verts.resize(s.offsets.back());
  s.poly_origin.resize(first), s.is_turned.resize(first);
  for (std::size_t k = 0; k < cut.num_polys(); ++k) s.add_poly(cut.poly(k), cut.poly_origin[k]);
}

CONCINO_INLINE void remove_duplicate_polys(surface_lists& s, repair_log& log) {
  face_merger merger(s.points.size());
  merger.reserve(s.num_polys(), s.verts.size());
  polyhedra_arrays merged;
  merged.poly_faces.reserve(s.num_polys());
  std::vector<vert_id> list;
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    list.clear();
    for (const std::uint32_t v : s.poly(p)) list.push_back(vert_id{v});
    std::sort(list.begin(), list.end());  // as cycles, sorted lists are equal if their sets are
    merged.poly_faces.push_back(merger.add(list.data(), list.size()).face);
  }
  merged.outward.resize(s.num_polys());
  merger.finish(merged);
  std::vector<std::uint8_t> is_known(s.num_polys()), is_again(s.num_polys());
  bool any = false;
  for (std::size_t p = 0; p < s.num_polys(); ++p) {
    is_again[p] = std::exchange(is_known[merged.poly_faces[p].raw()], std::uint8_t{1});
    if (!is_again[p]) continue;
    any = true;
    log.add(repair_kind::removed_duplicates, s.poly_origin[p]);
  }
  if (any) s.remove(is_again);
}

CONCINO_INLINE void split_into_fans(surface_lists& s, repair_log& log) {
  const edge_lists edges(s.offsets, s.verts, s.points.size());
  disjoint_sets fans(s.verts.size());
  for (std::size_t e = 0; e < edges.num_edges(); ++e) {
    const auto at = edges.corners(e);
    if (at.size() != 2) continue;
    const std::uint32_t a = at[0], b = at[1];
    const bool same_way = s.verts[a] == s.verts[b];
    fans.unite(a, same_way ? b : edges.next(b));
    fans.unite(edges.next(a), same_way ? edges.next(b) : b);
  }
  std::vector<std::uint32_t> vert_of(s.verts.size(), surface_lists::none);  // by root corner of a fan
  std::vector<std::uint8_t> is_taken(s.points.size());
  for (std::size_t c = 0; c < s.verts.size(); ++c) {
    const std::size_t fan = fans.root(c);
    const std::uint32_t v = s.verts[c];
    if (vert_of[fan] == surface_lists::none) {
      if (!std::exchange(is_taken[v], std::uint8_t{1})) vert_of[fan] = v;
      else {
        if (s.vert_origin[v] != surface_lists::none) log.add(repair_kind::split_verts, s.vert_origin[v]);
        vert_of[fan] = s.add_vert(vec3(s.points[v]), s.vert_origin[v]);
      }
    }
    s.verts[c] = vert_of[fan];
  }
}

CONCINO_INLINE void log_turned(const surface_lists& s, repair_log& log) {
  for (std::size_t p = 0; p < s.num_polys(); ++p)
    if (s.is_turned[p] && s.poly_origin[p] != surface_lists::none) log.add(repair_kind::turned_polys, s.poly_origin[p]);
}

}  // namespace concino::detail
