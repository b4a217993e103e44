// Checks that the polys around a vert of a volume form a ball, so that its dual cell is a closed manifold.
#pragma once

#include <concino/generate/detail/dual/dual_parts.hpp>
#include <concino/graph/disjoint_sets.hpp>

namespace concino::detail {

/// Checks that the polys around a vert form a ball, or half a ball on the boundary. Otherwise its dual cell would not
/// be a closed manifold.
template<VolumeMesh M>
class vertex_link_checker {
  const M& m_;
  dual_parts<M>& parts_;
  std::vector<std::uint32_t> slot_;  // by number of a poly: its position among the polys at the vert

 public:
  vertex_link_checker(const M& m, dual_parts<M>& parts) : m_(m), parts_(parts), slot_(parts.points.size()) {}

  /// Checks the link of v: on a small sphere around v, its edges, faces and polys are the verts, edges and polys of a
  /// polygon mesh, which must be one sphere or one disk.
  /// Errors: invalid_mesh that names v.
  void check(const vert_t<M>& v, bool on_border) {
    std::size_t np = 0, nf = 0, ne = 0;
    for (const poly_t<M> p : adj_v2p(m_, v)) slot_[parts_.number_of(p)] = static_cast<std::uint32_t>(np++);
    disjoint_sets joined(np);
    std::size_t pieces = np;
    for (const face_t<M> f : adj_v2f(m_, v)) {
      const auto [first, second] = parts_.polys_of(index_of(m_, f));
      if (first != parts_.none) ++nf;
      if (second != parts_.none && joined.unite(slot_[first], slot_[second])) --pieces;
    }
    for (const edge_t<M> e : adj_v2e(m_, v)) ne += parts_.has_polys(index_of(m_, e));
    if (pieces != 1 || ne + np != nf + (on_border ? 1 : 2))
      throw_no_dual("the polys around vert ", index_of(m_, v), " do not form a single ball");
    if (!on_border && ne < 3) throw_no_dual("vert ", index_of(m_, v), " has only two edges: its cell would be flat");
  }
};

}  // namespace concino::detail
