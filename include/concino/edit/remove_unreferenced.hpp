// Removes what belongs to no poly.
#pragma once

#include <concino/concepts/editable.hpp>
#include <concino/edit/elements.hpp>

#include <cstddef>
#include <vector>

namespace concino {

/// How many elements of each kind were removed.
struct removed_counts {
  std::size_t verts = 0, edges = 0, faces = 0;

  friend bool operator==(const removed_counts&, const removed_counts&) = default;
};

namespace detail {

template<class Range>
bool is_empty_range(const Range& range) {
  return range.begin() == range.end();
}

/// Whether v has no polys, and no edges that its removal would leave behind.
template<class M>
bool is_unreferenced(const M& m, const vert_t<M>& v) {
  if (!is_empty_range(adj_v2p(m, v))) return false;
  // with remove_face, its edges are removed with their last faces
  return requirement::has_remove_face<M> || is_empty_range(adj_v2e(m, v));
}

struct no_faces {
  static constexpr bool empty() { return true; }
};

/// The faces without polys, in a mesh from which they can be removed.
template<class M>
auto faces_without_polys(const M& m) {
  if constexpr (requirement::has_remove_face<M>) {
    std::vector<face_t<M>> all;
    for (const face_t<M> f : faces(m))
      if (is_empty_range(adj_f2p(m, f))) all.push_back(f);
    return all;
  } else {
    return no_faces{};
  }
}

}  // namespace detail

/// Removes all verts without polys and, in a mesh of general polyhedra, all faces and edges without polys.
/// Needs:  AnyMesh M whose traits have remove_vert, and remove_face if faces without polys can exist. In surfaces,
///         verts with edges stay.
/// Result: how many elements were removed. Other elements keep their descriptors; garbage_collect(m) closes the gaps in
///         their numbers.
/// Cost:   O(verts and faces), and the elements at those that are removed.
/// Errors: none of its own. If memory runs out, nothing is removed.
template<requirement::has_remove_vert M>
  requires AnyMesh<M>
removed_counts remove_unreferenced(M& m) {
  std::vector<vert_t<M>> unused;
  for (const vert_t<M> v : verts(m))
    if (detail::is_unreferenced(m, v)) unused.push_back(v);
  removed_counts removed{unused.size()};
  const auto unused_faces = detail::faces_without_polys(m);
  if constexpr (EditableMesh<M>)
    if (unused_faces.empty()) {  // all at once
      if (!unused.empty())
        rewire(m, cavity<M>{.verts = {unused.data(), unused.data() + unused.size()}, .removed = unused.size()},
               cavity_result<M>{});
      return removed;
    }
  const std::size_t num_edges_before = num_edges(m);
  detail::reserve_removal(m, {});
  detail::edit_in_steps(m, [&] {
    if constexpr (requirement::has_remove_face<M>)
      for (const face_t<M> f : unused_faces) traits<M>::remove_face(m, f), ++removed.faces;
    for (const vert_t<M> v : unused) traits<M>::remove_vert(m, v);
  });
  removed.edges = num_edges_before - num_edges(m);
  return removed;
}

}  // namespace concino
