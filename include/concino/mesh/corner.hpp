// Corners of a mesh, which are pairs of a poly and a position in its verts, and maps with a value for every corner.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/mistakes.hpp>
#include <concino/mesh/element_map.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace concino {

/// Corner k of a poly, at the k-th vert of adj_p2v.
template<class M>
struct corner {
  poly_t<M> poly;
  std::uint32_t k;
  friend bool operator==(const corner& a, const corner& b) { return a.poly == b.poly && a.k == b.k; }
};

/// The vert at a corner.
/// Needs:  AnyMesh; a corner of m.      Result: the k-th vert of adj_p2v.      Cost: O(k).      Errors: none.
template<AnyMesh M>
vert_t<M> vert_at(const M& m, const corner<M>& c) {
  const auto& ring = adj_p2v(m, c.poly);
  auto it = ring.begin();
  for (std::uint32_t i = 0; i < c.k; ++i) ++it;
  return *it;
}

/// A value of type T for every corner of the polys that a mesh had when the map was made, in one array. Use it for
/// values that differ between polys at the same vert, such as texture coordinates and normals at creases.
/// Needs:  an AnyMesh that is not moved or destroyed while the map is used; of a view the map keeps a copy.
/// Result: map[c] is a reference, map.of(p) the values of all corners of p in the order of adj_p2v.
/// Cost:   one array of values, one number per poly.
template<class M, class T>
class corner_map {
  detail::mesh_ref<M> mesh_;
  std::vector<std::size_t> first_;  // by poly index, one more than the bound
  std::vector<T> values_;

 public:
  using mesh_type = M;
  using key_type = corner<M>;
  using value_type = T;

  corner_map(const M& m, const T& init) : mesh_(m), first_(poly_index_bound(m) + 1) {
    for (const poly_t<M> p : polys(m)) first_[index_of(m, p) + 1] = num_elements(adj_p2v(m, p));
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    values_.assign(first_.back(), init);
  }

  auto& operator[](const corner<M>& c) { return values_[first_[index_of(mesh_.get(), c.poly)] + c.k]; }
  const T& operator[](const corner<M>& c) const { return values_[first_[index_of(mesh_.get(), c.poly)] + c.k]; }
  std::span<T> of(const poly_t<M>& p) {
    const std::size_t i = index_of(mesh_.get(), p);
    return {values_.data() + first_[i], values_.data() + first_[i + 1]};
  }
  std::span<const T> of(const poly_t<M>& p) const {
    const std::size_t i = index_of(mesh_.get(), p);
    return {values_.data() + first_[i], values_.data() + first_[i + 1]};
  }
  const M& mesh() const { return mesh_.get(); }
  /// All values, poly after poly by index.
  std::span<T> values() { return values_; }
  std::span<const T> values() const { return values_; }
};

/// A map with the same value `init` at every corner of m.
/// Needs:  AnyMesh, no temporary (views may be); T other than bool (take unsigned char).      Result: a map[corner] of
///         T.
/// Cost:   O(corners) time and memory.                                   Errors: none.
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && AnyMesh<M> && (!std::is_same_v<T, bool>)
corner_map<std::remove_cvref_t<M>, T> make_corner_map(M&& m, const T& init = T()) {
  return {m, init};
}

// What to write instead of calls that cannot compile.
template<class... T> void make_corner_map(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void make_corner_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
