// Closes the gaps that removed elements leave in the numbers of a mesh, and tells how elements were renumbered.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/mesh/element_map.hpp>
#include <concino/mesh/element_origins.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace concino {

namespace requirement {

template<class M> concept has_garbage_collect = requires(std::remove_cvref_t<M>& m) {
  { traits<M>::garbage_collect(m) } -> std::same_as<correspondence>;
};

}  // namespace requirement

namespace detail {

/// The new descriptors of the elements of one kind, by the indices that they had.
template<class X>
class new_descriptors {
  std::vector<std::optional<X>> by_index_;

 public:
  explicit new_descriptors(std::size_t bound_before) : by_index_(bound_before) {}

  template<class M, class Range>
  void assign(const M& m, const Range& elements, const element_origins& origins) {
    for (const X& x : elements)
      if (const std::uint32_t before = origins.only(index_of(m, x)); before != element_origins::none)
        by_index_[before] = x;
  }
  std::optional<X> operator[](std::size_t i) const { return i < by_index_.size() ? by_index_[i] : std::nullopt; }
};

struct no_face {};
template<class M> struct face_or_none { using type = no_face; };
template<VolumeMesh M> struct face_or_none<M> { using type = face_t<M>; };

}  // namespace detail

/// What garbage_collect returns: map[x] is the new descriptor of an element x, or empty if x was removed. The mesh must
/// not be moved or destroyed while the map is used.
template<class M>
class renumbering {
  using face = typename detail::face_or_none<M>::type;

  detail::mesh_ref<M> mesh_;
  detail::new_descriptors<vert_t<M>> verts_;
  detail::new_descriptors<edge_t<M>> edges_;
  detail::new_descriptors<face> faces_;
  detail::new_descriptors<poly_t<M>> polys_;
  correspondence origins_;

  static std::size_t num_face_indices(const M& m) {
    if constexpr (VolumeMesh<M>) return face_index_bound(m);  // surfaces have no faces
    else return 0;
  }

 public:
  /// Allocates the memory for the elements of m before the change.
  explicit renumbering(const M& before)
      : mesh_(before), verts_(vert_index_bound(before)), edges_(edge_index_bound(before)),
        faces_(num_face_indices(before)), polys_(poly_index_bound(before)) {}

  /// Stores the descriptors after the change, without allocating memory.
  void assign(correspondence origins) {
    const M& m = mesh_.get();
    origins_ = std::move(origins);
    verts_.assign(m, concino::verts(m), origins_.verts);
    edges_.assign(m, concino::edges(m), origins_.edges);
    if constexpr (VolumeMesh<M>) faces_.assign(m, concino::faces(m), origins_.faces);  // surfaces have no faces
    polys_.assign(m, concino::polys(m), origins_.polys);
  }

  std::optional<vert_t<M>> operator[](const vert_t<M>& before) const { return verts_[index_of(mesh_.get(), before)]; }
  std::optional<edge_t<M>> operator[](const edge_t<M>& before) const { return edges_[index_of(mesh_.get(), before)]; }
  std::optional<face> operator[](const face& before) const { return faces_[index_of(mesh_.get(), before)]; }
  std::optional<poly_t<M>> operator[](const poly_t<M>& before) const { return polys_[index_of(mesh_.get(), before)]; }

  /// The old index of each element by its new one, for transfer_values: it takes values of maps that were made before
  /// to the new numbers.
  const correspondence& origins() const { return origins_; }
};

/// Numbers the elements of m without the gaps that removed ones have left, and frees the memory of these gaps. Reading
/// a mesh of this library is afterwards as fast, and takes as little memory, as if it had just been constructed. Named
/// properties follow their elements.
/// Needs:  AnyMesh M whose traits have garbage_collect. The index of a descriptor does not depend on what is in the
///         mesh.
/// Result: map[x], the new descriptor of x or none if x was removed. All old descriptors, and values in maps outside
///         the mesh, are meaningless in m. In meshes of this library the elements of each kind keep their order;
///         OpenMesh and CGAL move the last ones into the gaps.
/// Cost:   O(elements) time; memory for a second mesh while it runs.
/// Errors: unsupported while a transaction of m is open. The mesh is unchanged then, also if memory runs out.
///         Transactions committed before cannot be undone.
template<requirement::has_garbage_collect M>
  requires AnyMesh<M>
renumbering<M> garbage_collect(M& m) {
  renumbering<M> map(m);
  map.assign(traits<M>::garbage_collect(m));
  return map;
}

}  // namespace concino
