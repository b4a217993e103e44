// Values at the elements of a mesh, stored outside the mesh: make_vert_map<double>(m, 0.0), and the same for edges,
// faces and polys.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/flat_array.hpp>

#include <cassert>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace concino {

namespace detail {

/// The mesh of a map: its address, or a copy of the view. Always const: a map never changes its mesh.
template<class M, bool = is_view_v<M>>
class mesh_ref {
  const M* mesh_;

 public:
  explicit mesh_ref(const M& m) : mesh_(&m) {}
  const M& get() const { return *mesh_; }
};

template<class V>
class mesh_ref<V, true> {
  V view_;

 public:
  explicit mesh_ref(const V& v) : view_(v) {}
  const V& get() const { return view_; }
};

/// Tag for maps without initial values: the caller will write every value. Filling a large map first takes as long as
/// many a computation.
struct unwritten {};

template<class T>
struct map_storage {
  using type = std::vector<T>;
  static type filled(std::size_t n, const T& value) { return type(n, value); }
  static type unfilled(std::size_t n) { return type(n, T()); }
};
template<class T>
  requires(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t))
struct map_storage<T> {
  using type = core::flat_array<T>;
  static type filled(std::size_t n, const T& value) { return type(n, value); }
  static type unfilled(std::size_t n) { return type(n); }
};

}  // namespace detail

/// A value of type T for every X (a descriptor type) of a mesh of type M, in one array.
/// Needs:  index_of(m, x). The mesh is not moved or destroyed while the map is used; of a view the map keeps a copy.
/// Result: map[x] is a reference; bools are stored as unsigned char, so it is one for them too.
///         Elements added to the mesh after the map was made have no value in it until resize(): asking for one is a
///         programming error (assert).
/// Cost:   one array of index_bound values.
template<class M, class X, class T>
  requires(!std::is_reference_v<M> && !std::is_const_v<M>)
class element_map {
  using stored = std::conditional_t<std::is_same_v<T, bool>, unsigned char, T>;

  detail::mesh_ref<M> mesh_;
  typename detail::map_storage<stored>::type values_;

  std::size_t slot(const X& x) const {
    const std::size_t i = index_of(mesh_.get(), x);
    assert(i < values_.size() && "the element was added after the map was made, or belongs to another mesh");
    return i;
  }

 public:
  using mesh_type = M;
  using key_type = X;
  using value_type = T;

  element_map(const M& m, std::size_t bound, const T& init)
      : mesh_(m), values_(detail::map_storage<stored>::filled(bound, static_cast<stored>(init))) {}
  /// Without initial values: every element's value must be written before it is read.
  element_map(const M& m, std::size_t bound, detail::unwritten)
      : mesh_(m), values_(detail::map_storage<stored>::unfilled(bound)) {}

  element_map(const element_map&) = default;
  element_map(element_map&&) noexcept = default;
  element_map& operator=(const element_map& o) { return *this = element_map(o); }  // strong exception guarantee
  element_map& operator=(element_map&&) noexcept = default;

  stored& operator[](const X& x) { return values_[slot(x)]; }
  std::conditional_t<std::is_same_v<T, bool>, bool, const T&> operator[](const X& x) const {
    const auto& value = values_[slot(x)];
    if constexpr (std::is_same_v<T, bool>) return value != 0;
    else return value;
  }

  /// Changes the number of values, so that elements added to the mesh have one, too; it has no initial value. `bound`
  /// is an index bound of the mesh.
  void resize(std::size_t bound) { values_.resize(bound); }

  const M& mesh() const { return mesh_.get(); }
  /// All values, by index_of; those at the indices of deleted elements are meaningless.
  std::span<stored> values() { return {values_.data(), values_.size()}; }
  std::span<const stored> values() const { return {values_.data(), values_.size()}; }
  /// A pointer to the first value, for loops in many translation units: a span takes longer to compile.
  stored* data() { return values_.data(); }
  const stored* data() const { return values_.data(); }
};

template<class M, class T> using vert_map = element_map<std::remove_cvref_t<M>, vert_t<M>, T>;
template<class M, class T> using edge_map = element_map<std::remove_cvref_t<M>, edge_t<M>, T>;
template<class M, class T> using face_map = element_map<std::remove_cvref_t<M>, face_t<M>, T>;
template<class M, class T> using poly_map = element_map<std::remove_cvref_t<M>, poly_t<M>, T>;

/// A map with the same value `init` at every vert, edge, face or poly of m.
/// Needs:  index_of and the index bound of that kind of element; m is no temporary mesh (views may be).
/// Result: a map[x] of T.      Cost: O(index bound) time and memory.      Errors: those of the index bound.
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && requires(const M& m) { vert_index_bound(m); }
vert_map<M, T> make_vert_map(M&& m, const T& init = T()) {
  return {m, vert_index_bound(m), init};
}
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && requires(const M& m) { edge_index_bound(m); }
edge_map<M, T> make_edge_map(M&& m, const T& init = T()) {
  return {m, edge_index_bound(m), init};
}
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && requires(const M& m) { face_index_bound(m); }
face_map<M, T> make_face_map(M&& m, const T& init = T()) {
  return {m, face_index_bound(m), init};
}
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && requires(const M& m) { poly_index_bound(m); }
poly_map<M, T> make_poly_map(M&& m, const T& init = T()) {
  return {m, poly_index_bound(m), init};
}

// What to write instead of calls that cannot compile.
template<class... T> void make_vert_map(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void make_vert_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void make_edge_map(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void make_edge_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void make_face_map(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void make_face_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;
template<class... T> void make_poly_map(mistake::no_mesh_traits<mistake::include_adapter>, ...) = delete;  // #include <concino/adapters/openmesh.hpp> or another adapter
template<class... T> void make_poly_map(mistake::temporary_mesh<mistake::name_the_mesh>, ...) = delete;  // give the mesh a name: auto m = ...;

}  // namespace concino
