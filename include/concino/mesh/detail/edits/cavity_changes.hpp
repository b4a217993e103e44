// Steps of `rewire` that surfaces and volumes share: which new elements take the descriptors of old ones, and the lists
// of edges and of verts.
#pragma once

#include <concino/core/small_array.hpp>
#include <concino/mesh/detail/edits/cavity_edges.hpp>
#include <concino/mesh/detail/rows/alive_elements.hpp>
#include <concino/mesh/detail/rows/jagged_array.hpp>
#include <concino/mesh/detail/tables/vertex_incidence.hpp>

#include <algorithm>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace concino::detail {

/// How many entries the lists of a vert lose and gain.
struct vert_change {
  std::uint32_t polys_before = 0, polys_after = 0, edges_lost = 0, edges_gained = 0;
};

/// New edges or faces take the descriptors of old ones that are unused: first of those with which they share all
/// verts but one, then of any. `num_new` are new to the mesh, `num_unused` have no poly afterwards. It may run out of
/// memory, so it comes before anything changes. share_all_but_one(x, y): whether these two share all verts but one.
template<class Elements, class Compare>
void reuse_descriptors(Elements& all, std::size_t num_new, std::size_t num_unused, const Compare& share_all_but_one) {
  constexpr std::size_t most_pairs = 4096;  // more take too long to compare
  if (num_new == 0 || num_unused == 0) return;
  using element = std::remove_reference_t<decltype(*all.begin())>;
  core::small_array<element*, 64> unused;
  for (element& x : all)
    if (x.is_unused()) unused.push_back(&x);
  const auto join = [&all](element* x, element* y) {
    x->partner = static_cast<std::uint32_t>(y - all.begin()), y->partner = static_cast<std::uint32_t>(x - all.begin());
  };
  const auto pair = [&unused, &join](element* x, std::size_t i) {
    join(x, unused[i]);
    std::copy(unused.begin() + i + 1, unused.end(), unused.begin() + i);
    unused.resize(unused.size() - 1, nullptr);
  };
  if (num_new * num_unused <= most_pairs)
    for (element* x = all.begin(); x != all.end() && !unused.empty(); ++x) {
      if (!x->id.is_none()) continue;
      std::size_t i = 0;
      while (i < unused.size() && !share_all_but_one(*x, *unused[i])) ++i;
      if (i < unused.size()) pair(x, i);
    }
  std::size_t next = 0;
  for (element* x = all.begin(); x != all.end() && next < unused.size(); ++x) {
    if (!x->id.is_none() || x->has_partner()) continue;
    join(x, unused[next]);
    ++next;
  }
}
template<class Elements>
void reuse_descriptors(Elements& all, std::size_t num_new, std::size_t num_unused) {
  reuse_descriptors(all, num_new, num_unused, [](const auto& x, const auto& y) { return x.shares_all_but_one(y); });
}

/// The numbers of edges and of polys of the new verts.
template<class Changes>
std::pair<std::size_t, std::size_t> count_at_new_verts(const Changes& changes, unsigned num_old) {
  std::size_t edges = 0, polys = 0;
  for (std::size_t v = num_old; v < changes.size(); ++v)
    edges += changes[v].edges_gained, polys += changes[v].polys_after;
  return {edges, polys};
}

inline std::uint32_t growth(std::uint32_t before, std::uint32_t after) { return after > before ? after - before : 0; }

/// Allocates memory for the lists of the verts as they will be. Memory for removals too. `vert` gives the vert with a
/// local number.
template<class Changes, class Verts>
void reserve_lists_of_verts(incident_edges& edges_at, jagged_array<poly_id, 0>& v2p, const Changes& changes,
                            unsigned num_old, const Verts& vert) {
  make_vertex_incidence_growable(edges_at, v2p);
  for (unsigned v = 0; v < num_old; ++v) {
    const vert_change& x = changes[v];
    if (const std::uint32_t n = growth(x.edges_lost, x.edges_gained)) edges_at.reserve_at(vert(v), n);
    if (const std::uint32_t n = growth(x.polys_before, x.polys_after)) v2p.reserve_in_row(vert(v).raw(), n);
  }
  if (changes.size() == num_old) return;
  const auto [edges, polys] = count_at_new_verts(changes, num_old);
  reserve_lists_of_new_verts(edges_at, v2p, changes.size() - num_old, edges, polys);
}
template<class Changes, class Verts>
void reserve_lists_of_verts(incident_edges_and_polys& lists, const Changes& changes, unsigned num_old,
                            const Verts& vert) {
  lists.make_growable();
  for (unsigned v = 0; v < num_old; ++v) {
    const vert_change& x = changes[v];
    const std::uint32_t edges = growth(x.edges_lost, x.edges_gained), polys = growth(x.polys_before, x.polys_after);
    if (edges > 0 || polys > 0) lists.reserve_at(vert(v), edges, polys);
  }
  if (changes.size() == num_old) return;
  const auto [edges, polys] = count_at_new_verts(changes, num_old);
  lists.reserve_verts(changes.size() - num_old, edges + polys);
}

/// Removes the unused edges, and gives all new ones their descriptors.
template<bool WithPolys, class Verts>
void change_edges(cavity_edges& all, alive_elements<edge_id>& edges, jagged_array<vert_id, 2>& ends,
                  incident_lists<WithPolys>& edges_at, const Verts& vert) {
  const auto has = [](const cavity_edge& x, unsigned v) { return x.a == v || x.b == v; };
  for (const cavity_edge& old : all) {
    if (!old.is_unused()) continue;
    for (const unsigned v : {old.a, old.b}) {
      const cavity_edge* const x = old.has_partner() ? &all[old.partner] : nullptr;
      if (x && has(*x, v)) edges_at.set_other_end(vert(v), old.id, vert(x->a == v ? x->b : x->a));
      else edges_at.replace_by_last(vert(v), old.id);
    }
    if (!old.has_partner()) edges.remove(old.id);
  }
  for (cavity_edge& x : all) {
    if (!x.id.is_none()) continue;
    const vert_id a = vert(x.a), b = vert(x.b), two[] = {std::min(a, b), std::max(a, b)};
    if (x.has_partner()) {
      x.id = all[x.partner].id;
      std::copy_n(two, 2, ends.begin(x.id.raw()));
    } else {
      x.id = edges.add();
      ends.add_row(two, two + 2);
    }
    for (const unsigned v : {x.a, x.b}) {
      if (x.has_partner() && has(all[x.partner], v)) continue;
      edges_at.push(vert(v), v == x.a ? b : a, x.id);
    }
  }
}

}  // namespace concino::detail
