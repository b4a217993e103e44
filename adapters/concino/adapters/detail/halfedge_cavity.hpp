// The input of `rewire` for half-edge meshes of other libraries: the indices of its elements, and checks of its lists.
#pragma once

#include <concino/concepts/cavity.hpp>
#include <concino/core/error.hpp>
#include <concino/core/local_numbers.hpp>
#include <concino/core/message.hpp>
#include <concino/core/small_array.hpp>

#include <cstddef>

namespace concino::detail {

/// An edge of old or new polys.
struct planned_edge {
  static constexpr unsigned none = ~0u;

  unsigned verts[2] = {none, none};        // local numbers, ascending
  unsigned halfedge = none;                // the one from verts[0] to verts[1]. New edges are numbered from the mesh's
                                           // index bound
  unsigned corner[2] = {none, none};       // for each direction: the corner of a new poly where it begins
  bool has_other_poly[2] = {false, false};  // for each direction: whether it has a poly that stays
  bool has_old_poly[2] = {false, false};    // for each direction: whether it has a poly that goes
  bool is_new = false;

  bool remains() const {
    return !(has_old_poly[0] || has_old_poly[1]) || corner[0] != none || corner[1] != none || has_other_poly[0] ||
           has_other_poly[1];
  }
};

/// A cavity by indices: verts have local numbers, the existing ones as they are listed, then the new ones. K: what a
/// library says of its half-edges, see halfedge_edge_plan.hpp.
template<class K>
struct halfedge_cavity {
  using mesh = typename K::mesh;
  using cavity = cavity_of<typename K::vert, typename K::poly>;
  static constexpr unsigned none = ~0u;

  core::small_array<unsigned, 32> verts;  // indices
  core::small_array<unsigned, 32> polys;  // indices of old polys
  core::local_numbers local;              // of verts
  core::local_numbers old;                // of old polys
  id_span<unsigned> corners, ends;
  std::size_t num_new_verts, kept, removed;

  /// Errors: invalid_mesh if the lists have a mistake. `arity`: the number of verts of each poly, or 0 for any.
  halfedge_cavity(const mesh& m, const cavity& c, unsigned arity)
      : corners(c.corners), ends(c.ends), num_new_verts(c.points.size()), kept(c.kept), removed(c.removed) {
    add_elements(m, c);
    if (kept > polys.size() || kept > ends.size())
      core::throw_joined<invalid_mesh>({"rewire: ", kept, " polys cannot keep their descriptors: there are ",
                                        polys.size(), " old and ", ends.size(), " new ones"});
    if (removed > verts.size())
      core::throw_joined<invalid_mesh>(
          {"rewire: ", removed, " verts cannot be removed: the cavity lists ", verts.size()});
    unsigned first = 0;
    for (std::size_t k = 0; k < ends.size(); first = ends[k++]) check_new_poly(k, first, arity);
  }

  unsigned num_verts() const { return static_cast<unsigned>(verts.size()); }
  unsigned num_all_verts() const { return num_verts() + static_cast<unsigned>(num_new_verts); }
  bool is_removed(unsigned v) const { return v < num_verts() && v + removed >= num_verts(); }
  unsigned num_corners() const { return ends.empty() ? 0 : ends[ends.size() - 1]; }

  [[noreturn]] void refuse_removal(unsigned v) const {
    core::throw_joined<invalid_mesh>(
        {"rewire: vert ", verts[v],
         " cannot be removed: it would still have a poly; list all its polys as old polys, and use it in no new one"});
  }

 private:
  void add_elements(const mesh& m, const cavity& c) {
    for (const auto& p : c.polys) {
      if (!K::contains(m, p))
        core::throw_joined<invalid_mesh>({"rewire: old poly ", K::index(p), " is not a poly of the mesh"});
      polys.push_back(K::index(p));
      if (old.add(polys.back()) + 1 < polys.size())
        core::throw_joined<invalid_mesh>({"rewire: old poly ", polys.back(), " is listed twice; list it once"});
    }
    for (const auto& v : c.verts) {
      if (!K::contains(m, v))
        core::throw_joined<invalid_mesh>({"rewire: vert ", K::index(v), " of the cavity is not a vert of the mesh"});
      verts.push_back(K::index(v));
      if (local.add(verts.back()) + 1 < verts.size())
        core::throw_joined<invalid_mesh>(
            {"rewire: vert ", verts.back(), " of the cavity is listed twice; list it once"});
    }
  }

  void check_new_poly(std::size_t k, unsigned first, unsigned arity) const {
    const unsigned last = ends[k];
    if (last < first || last > corners.size())
      core::throw_joined<invalid_mesh>({"rewire: the corners of new poly ", k, " end at ", last,
                                        ", which is not between ", first, " and ", corners.size()});
    const unsigned n = last - first;
    if (arity > 0 && n != arity)
      core::throw_joined<invalid_mesh>(
          {"rewire: new poly ", k, " has ", n, " verts; every poly of this mesh has ", arity});
    if (n < 3) core::throw_joined<invalid_mesh>({"rewire: new poly ", k, " has ", n, " verts; it needs at least 3"});
    core::local_numbers own;
    for (unsigned i = first; i < last; ++i) {
      if (corners[i] >= num_all_verts())
        core::throw_joined<invalid_mesh>({"rewire: new poly ", k, " names vert ", corners[i],
                                          " of the cavity, which has ", num_all_verts(), ", numbered from 0"});
      if (own.add(corners[i]) + first < i)
        core::throw_joined<invalid_mesh>(
            {"rewire: new poly ", k, " has vert ", corners[i], " of the cavity twice; its verts must differ"});
    }
    for (unsigned i = first; i < last; ++i)
      if (is_removed(corners[i])) refuse_removal(corners[i]);
  }
};

}  // namespace concino::detail
