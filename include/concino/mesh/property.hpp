// Named, typed properties of a mesh's elements, and of the mesh itself. The mesh owns them: they are copied with it,
// edited with its elements, and read and written by file formats that support them. For values without a name, see
// element_map.hpp.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/mesh/property_set.hpp>

#include <cassert>

namespace concino {

/// A handle to one property: `u[v]` reads and writes. It stays valid, with its values, even if the property is removed
/// or the mesh is destroyed. Const: read-only.
template<class Id, class T>
class property_map {
  std::shared_ptr<detail::column> column_;

 public:
  using key_type = Id;
  using value_type = std::remove_const_t<T>;

  property_map() = default;
  explicit property_map(std::shared_ptr<detail::column> c) : column_(std::move(c)) {}

  explicit operator bool() const { return column_ != nullptr; }
  T& operator[](Id x) const {
    assert(column_ && x.raw() < column_->size());
    return static_cast<T*>(column_->data())[x.raw()];
  }
};

/// A handle to a property with one value for the mesh as a whole: `*u` reads and writes.
template<class T>
class property_value {
  std::shared_ptr<detail::column> column_;

 public:
  using value_type = std::remove_const_t<T>;

  property_value() = default;
  explicit property_value(std::shared_ptr<detail::column> c) : column_(std::move(c)) {}

  explicit operator bool() const { return column_ != nullptr; }
  T& operator*() const {
    assert(column_);
    return *static_cast<T*>(column_->data());
  }
  T* operator->() const { return &**this; }
};

/// A mesh with named properties, its own or those of the mesh of which it is a view.
template<class M>
concept ShowsProperties = requires(const std::remove_cvref_t<M>& m) {
  { traits<M>::properties(m) } -> std::same_as<const property_set&>;
};
/// A mesh that owns named properties.
template<class M>
concept HasProperties = ShowsProperties<M> && requires(std::remove_cvref_t<M>& m) {
  { traits<M>::properties(m) } -> std::same_as<property_set&>;
};

/// The property `name` of m's verts (edges, faces, polys), created with default values if there is none.
/// Needs:  a mesh of this library; T copyable with a default value.
/// Result: a handle u, u[v] is T&.             Cost: O(elements) if it is created, else O(number of properties).
/// Errors: invalid_argument if the property exists with values of another type.
template<class T, HasProperties M>
property_map<vert_t<M>, T> vert_property(M& m, std::string_view name) {
  return property_map<vert_t<M>, T>(
      traits<M>::properties(m).get(element_kind::vert, name, detail::values_of<T>, vert_index_bound(m)));
}
template<class T, HasProperties M>
property_map<edge_t<M>, T> edge_property(M& m, std::string_view name) {
  return property_map<edge_t<M>, T>(
      traits<M>::properties(m).get(element_kind::edge, name, detail::values_of<T>, edge_index_bound(m)));
}
template<class T, HasProperties M>
property_map<face_t<M>, T> face_property(M& m, std::string_view name) {
  return property_map<face_t<M>, T>(
      traits<M>::properties(m).get(element_kind::face, name, detail::values_of<T>, face_index_bound(m)));
}
template<class T, HasProperties M>
property_map<poly_t<M>, T> poly_property(M& m, std::string_view name) {
  return property_map<poly_t<M>, T>(
      traits<M>::properties(m).get(element_kind::poly, name, detail::values_of<T>, poly_index_bound(m)));
}

/// The property `name` of the mesh as a whole, created with a default value if there is none. Edits do not change it.
/// Needs:  a mesh of this library; T copyable with a default value.
/// Result: a handle u, *u is T&.               Cost: O(number of properties).
/// Errors: invalid_argument if the property exists with a value of another type.
template<class T, HasProperties M>
property_value<T> mesh_property(M& m, std::string_view name) {
  return property_value<T>(traits<M>::properties(m).get(element_kind::mesh, name, detail::values_of<T>, 1));
}

/// Read-only access to the property `name` of m's verts (edges, faces, polys) or of the mesh as a whole.
/// Needs:  a mesh of this library, or submesh() or with_points() of one.
/// Result: a handle as above, of const T; empty (tests false) if there is no property of that name.
/// Cost:   O(number of properties).
/// Errors: invalid_argument if the property exists with values of another type.
template<class T, ShowsProperties M>
property_map<vert_t<M>, const T> find_vert_property(const M& m, std::string_view name) {
  return property_map<vert_t<M>, const T>(
      traits<M>::properties(m).find(element_kind::vert, name, detail::values_of<T>));
}
template<class T, ShowsProperties M>
property_map<edge_t<M>, const T> find_edge_property(const M& m, std::string_view name) {
  return property_map<edge_t<M>, const T>(
      traits<M>::properties(m).find(element_kind::edge, name, detail::values_of<T>));
}
template<class T, ShowsProperties M>
property_map<face_t<M>, const T> find_face_property(const M& m, std::string_view name) {
  return property_map<face_t<M>, const T>(
      traits<M>::properties(m).find(element_kind::face, name, detail::values_of<T>));
}
template<class T, ShowsProperties M>
property_map<poly_t<M>, const T> find_poly_property(const M& m, std::string_view name) {
  return property_map<poly_t<M>, const T>(
      traits<M>::properties(m).find(element_kind::poly, name, detail::values_of<T>));
}
template<class T, ShowsProperties M>
property_value<const T> find_mesh_property(const M& m, std::string_view name) {
  return property_value<const T>(traits<M>::properties(m).find(element_kind::mesh, name, detail::values_of<T>));
}

/// Kind, name, type and rule of every property of m, in the order in which they were created.
/// Needs:  a mesh of this library, or submesh() or with_points() of one.      Result: an entry each.      Cost:
///         O(number of properties).      Errors: none.
template<ShowsProperties M>
std::vector<property_info> property_list(const M& m) {
  const property_set& all = traits<M>::properties(m);
  std::vector<property_info> list;
  for (std::size_t i = 0; i < all.size(); ++i) list.push_back(all.info(i));
  return list;
}

/// Sets the rule for the values of a property when elements are split, merged or interpolated. The default is
/// `interpolate` for values that have a mean (numbers other than integers, vectors, arrays of such, colours) and `copy`
/// for all others.
/// Needs:  a mesh of this library.      Result: none; copies of the mesh, and meshes made of it, keep the rule.
/// Cost:   O(number of properties).
/// Errors: invalid_argument if there is no such property, or if its values have no mean (interpolate) or no sum (sum);
///         integers have a sum.
template<HasProperties M>
void set_property_rule(M& m, element_kind kind, std::string_view name, property_rule rule) {
  traits<M>::properties(m).set_rule(kind, name, rule);
}

/// Removes a property from m. Handles to it keep its values.
/// Needs:  a mesh of this library.      Result: false if there was none of that kind and name.      Cost: O(number of
///         properties).
/// Errors: none.
template<HasProperties M>
bool remove_property(M& m, element_kind kind, std::string_view name) {
  return traits<M>::properties(m).remove(kind, name);
}

}  // namespace concino
