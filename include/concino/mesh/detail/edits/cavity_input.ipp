// The checks of the input of `rewire`; see cavity_input.hpp.
#pragma once

#include <concino/core/compiled.hpp>
#include <concino/mesh/detail/edits/cavity_input.hpp>

namespace concino::detail {

CONCINO_INLINE void missing_cavity_vert(poly_id p, vert_id v) {
  core::throw_joined<invalid_mesh>({"rewire: vert ", v.raw(), " of old poly ", p.raw(),
                                    " is not among the verts of the cavity; list all verts of old and new polys"});
}

CONCINO_INLINE void removed_vert_in_use(vert_id v) {
  core::throw_joined<invalid_mesh>(
      {"rewire: vert ", v.raw(),
       " cannot be removed: it would still have a poly; list all its polys as old polys, and use it in no new one"});
}

CONCINO_INLINE void removed_vert_with_face(vert_id v) {
  core::throw_joined<invalid_mesh>(
      {"rewire: vert ", v.raw(), " cannot be removed: it has a face without polys; remove that first"});
}

/// The first value that an earlier one repeats; null if all differ.
template<class T>
const T* repeated(const T* first, const T* last) {
  if (last - first <= 16) {
    for (const T* i = first; i != last; ++i)
      for (const T* j = first; j != i; ++j)  // std::find takes longer for few values
        if (*i == *j) return i;
    return nullptr;
  }
  core::small_array<std::uint64_t, 1> sorted;
  for (const T* i = first; i != last; ++i) {
    if constexpr (std::is_same_v<T, poly_id>) sorted.push_back(i->raw());
    else sorted.push_back(*i);
  }
  std::sort(sorted.begin(), sorted.end());
  const std::uint64_t* const twice = std::adjacent_find(sorted.begin(), sorted.end());
  return twice == sorted.end() ? nullptr : std::find(first, last, T(static_cast<unsigned>(*twice)));
}

/// Checks the corners of new poly or face k; `what` says which of both.
CONCINO_INLINE void check_new_corners(const char* what, std::size_t k, id_span<unsigned> corners,
                                      std::size_t vert_count, unsigned arity) {
  const std::size_t n = corners.size();
  if (arity > 0 && n != arity)
    core::throw_joined<invalid_mesh>(
        {"rewire: new ", what, " ", k, " has ", n, " verts; every ", what, " of this mesh has ", arity});
  if (n < 3)
    core::throw_joined<invalid_mesh>({"rewire: new ", what, " ", k, " has ", n, " verts; it needs at least 3"});
  for (const unsigned v : corners)
    if (v >= vert_count)
      core::throw_joined<invalid_mesh>({"rewire: new ", what, " ", k, " names vert ", v, " of the cavity, which has ",
                                        vert_count, ", numbered from 0"});
  if (const unsigned* const twice = repeated(corners.begin(), corners.end()))
    core::throw_joined<invalid_mesh>(
        {"rewire: new ", what, " ", k, " has vert ", *twice, " of the cavity twice; its verts must differ"});
}

/// Checks the old elements of a cavity with so many new polys.
CONCINO_INLINE void check_old_elements(const native_cavity& c, const cavity_verts& local,
                                       const alive_elements<vert_id>& verts, const alive_elements<poly_id>& polys,
                                       std::size_t num_new) {
  for (const poly_id p : c.polys)
    if (!polys.contains(p))
      core::throw_joined<invalid_mesh>({"rewire: old poly ", p.raw(), " is not a poly of the mesh"});
  if (const poly_id* const twice = repeated(c.polys.begin(), c.polys.end()))
    core::throw_joined<invalid_mesh>({"rewire: old poly ", twice->raw(), " is listed twice; list it once"});
  for (const vert_id v : c.verts)
    if (!verts.contains(v))
      core::throw_joined<invalid_mesh>({"rewire: vert ", v.raw(), " of the cavity is not a vert of the mesh"});
  if (const vert_id v = local.repeated(); !v.is_none())
    core::throw_joined<invalid_mesh>({"rewire: vert ", v.raw(), " of the cavity is listed twice; list it once"});
  if (c.kept > c.polys.size() || c.kept > num_new)
    core::throw_joined<invalid_mesh>({"rewire: ", c.kept, " polys cannot keep their descriptors: there are ",
                                      c.polys.size(), " old and ", num_new, " new ones"});
  if (c.removed > c.verts.size())
    core::throw_joined<invalid_mesh>(
        {"rewire: ", c.removed, " verts cannot be removed: the cavity lists ", c.verts.size()});
}

/// Whether these few corners are different and below vert_count.
inline bool are_different_verts(const unsigned* v, std::size_t n, std::size_t vert_count) {
  bool all = true;
  for (std::size_t i = 0; i < n; ++i) {
    all &= v[i] < vert_count;
    for (std::size_t j = 0; j < i; ++j) all &= v[i] != v[j];
  }
  return all;
}

/// Checks the corners of the first `count` new polys or faces.
CONCINO_INLINE void check_corner_lists(const native_cavity& c, const char* what, std::size_t count, unsigned arity) {
  unsigned first = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const unsigned last = c.ends[k];
    if (last < first || last > c.corners.size())
      core::throw_joined<invalid_mesh>({"rewire: the corners of new ", what, " ", k, " end at ", last,
                                        ", which is not between ", first, " and ", c.corners.size()});
    const std::size_t vert_count = c.verts.size() + c.points.size();
    if (arity != 4 || last - first != 4 || !are_different_verts(c.corners.begin() + first, 4, vert_count))
      check_new_corners(what, k, {c.corners.begin() + first, c.corners.begin() + last}, vert_count, arity);
    first = last;
  }
  for (unsigned k = 0; c.removed > 0 && k < first; ++k)
    if (c.corners[k] < c.verts.size() && c.corners[k] + c.removed >= c.verts.size())
      removed_vert_in_use(c.verts[c.corners[k]]);
}

CONCINO_INLINE void check_cavity(const native_cavity& c, const cavity_verts& local,
                                 const alive_elements<vert_id>& verts, const alive_elements<poly_id>& polys,
                                 unsigned arity) {
  check_old_elements(c, local, verts, polys, c.ends.size());
  check_corner_lists(c, "poly", c.ends.size(), arity);
}

CONCINO_INLINE void check_cavity_of_polyhedra(const native_cavity& c, const cavity_verts& local,
                                              const alive_elements<vert_id>& verts,
                                              const alive_elements<poly_id>& polys) {
  check_old_elements(c, local, verts, polys, c.poly_ends.size());
  unsigned first = 0;
  for (std::size_t k = 0; k < c.poly_ends.size(); ++k) {
    const unsigned last = c.poly_ends[k];
    if (last <= first || last > c.ends.size())
      core::throw_joined<invalid_mesh>({"rewire: the faces of new poly ", k, " end at ", last,
                                        ", which is not between ", first + 1, " and ", c.ends.size(),
                                        "; it needs at least 1"});
    first = last;
  }
  check_corner_lists(c, "face", first, 0);
}

CONCINO_INLINE void repeated_cavity_face(std::size_t poly, std::size_t face) {
  core::throw_joined<invalid_mesh>(
      {"rewire: new poly ", poly, " has face ", face,
       " of the cavity twice, in the same or the reversed order of its verts; its faces must differ"});
}

}  // namespace concino::detail
