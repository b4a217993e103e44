// Named, typed properties of corners, such as texture coordinates and normals at creases. The mesh owns them, as it
// owns those of its elements.
#pragma once

#include <concino/mesh/corner.hpp>
#include <concino/mesh/property.hpp>

#include <cassert>
#include <cstddef>
#include <span>

namespace concino {

/// A mesh with corner numbers. The corners of poly p are numbered from first_corner(m, p) on; all numbers are below
/// corner_index_bound(m).
template<class M>
concept NumbersCorners = requires(const std::remove_cvref_t<M>& m, const poly_t<M>& p) {
  { traits<M>::first_corner(m, p) } -> std::convertible_to<std::size_t>;
  { traits<M>::corner_index_bound(m) } -> std::convertible_to<std::size_t>;
};

/// The number of a corner. Edits do not change it; numbers of removed polys leave gaps.
/// Needs:  a mesh of this library, or submesh() or with_points() of one; a corner of m.
/// Result: below traits<M>::corner_index_bound(m), different for different corners.      Cost: O(1).      Errors: none.
template<NumbersCorners M>
std::size_t corner_index(const M& m, const corner<M>& c) {
  return traits<M>::first_corner(m, c.poly) + c.k;
}

/// A handle to one property of corners: u[c] is the value at a corner, u.of(p) the values of all corners of p in the
/// order of adj_p2v. The mesh must not be moved or destroyed while the handle is used; of a view the handle keeps a
/// copy. Const T: read-only.
template<class M, class T>
class corner_property_map {
  detail::mesh_ref<M> mesh_;
  std::shared_ptr<detail::column> column_;

 public:
  using mesh_type = M;
  using key_type = corner<M>;
  using value_type = std::remove_const_t<T>;

  corner_property_map(const M& m, std::shared_ptr<detail::column> c) : mesh_(m), column_(std::move(c)) {}

  explicit operator bool() const { return column_ != nullptr; }
  T& operator[](const corner<M>& c) const {
    const std::size_t i = corner_index(mesh_.get(), c);
    assert(column_ && i < column_->size());
    return static_cast<T*>(column_->data())[i];
  }
  std::span<T> of(const poly_t<M>& p) const {
    T* const first = static_cast<T*>(column_->data()) + traits<M>::first_corner(mesh_.get(), p);
    return {first, num_elements(adj_p2v(mesh_.get(), p))};
  }
};

/// The property `name` of m's corners, created with default values if there is none.
/// Needs:  a mesh of this library; T copyable with a default value.
/// Result: a handle u, u[c] is T&. Edits that add polys extend the property by default values.
/// Cost:   O(corners) if it is created, else O(number of properties).
/// Errors: invalid_argument if the property exists with values of another type.
template<class T, HasProperties M>
  requires NumbersCorners<M>
corner_property_map<M, T> corner_property(M& m, std::string_view name) {
    return {m, traits<M>::properties(m).get(element_kind::corner, name, detail::values_of<T>,
                                            traits<M>::corner_index_bound(m))};
}

/// Read-only access to the property `name` of m's corners.
/// Needs:  a mesh of this library, or submesh() or with_points() of one; no temporary (views may be).
/// Result: a handle as above, of const T; empty (tests false) if there is no property of that name.
/// Cost:   O(number of properties).
/// Errors: invalid_argument if the property exists with values of another type.
template<class T, class M>
  requires requirement::is_lvalue_or_view<M> && ShowsProperties<M> && NumbersCorners<M>
corner_property_map<std::remove_cvref_t<M>, const T> find_corner_property(M&& m, std::string_view name) {
  return {m, traits<M>::properties(std::as_const(m)).find(element_kind::corner, name, detail::values_of<T>)};
}

}  // namespace concino
