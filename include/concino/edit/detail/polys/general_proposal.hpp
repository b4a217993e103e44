// Asks invariants whether an edit of polys with any number of verts, or one of several quads or hexes, is allowed.
#pragma once

#include <concino/edit/detail/polys/general_cavity.hpp>
#include <concino/edit/proposed_edit.hpp>

#include <vector>

namespace concino::detail {

/// Its address stands for the type of a mesh, in edits whose polys are lists.
template<class M> inline constexpr char general_tag = 0;

/// The first refusal. Nothing is computed if there are no invariants.
template<class M>
permission ask_general(const std::vector<invariant>& keep, const general_cavity<M>& c) {
  if (keep.empty()) return {};
  const M& m = c.mesh();
  std::vector<std::size_t> verts, polys;
  std::vector<vec3> before, after;
  for (unsigned v = 0; v < c.num_verts(); ++v) {
    verts.push_back(index_of(m, c.vert_at(v)));
    before.push_back(c.point_of(v));
    after.push_back(v == c.moved_vert() ? c.moved_to() : before.back());
  }
  after.insert(after.end(), c.points().begin(), c.points().end());
  const unsigned num_changed = c.moved_vert() == c.none ? c.num_old() : c.num_polys();
  for (unsigned k = 0; k < num_changed; ++k) polys.push_back(index_of(m, c.poly(k)));
  poly_lists lists = c.new_polys();
  lists.renumber([&](unsigned v) { return v >= c.new_vert ? c.num_verts() + (v - c.new_vert) : v; });
  proposed_edit e;
  e.verts = verts, e.points_before = before, e.points_after = after, e.old_polys = polys;
  e.old_corners = c.old_polys().corners(), e.new_corners = lists.corners();
  e.old_ends = c.old_polys().ends(), e.new_ends = lists.ends();
  e.old_poly_ends = c.old_polys().poly_ends(), e.new_poly_ends = lists.poly_ends();
  e.dimension = static_cast<unsigned>(dimension_v<M>);
  e.origins = c.origins();
  e.removed_vert = c.removed_vert(), e.kept_vert = c.kept_vert();
  e.mesh = &m, e.cavity = &c, e.mesh_type = &general_tag<M>;
  for (const invariant& x : keep)
    if (const permission p = x(e); !p) return p;
  return {};
}

}  // namespace concino::detail
