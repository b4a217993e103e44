// A field of any type at the verts, polys, edges or faces of a mesh, for options that hold one.
#pragma once

#include <concino/concepts/facets.hpp>
#include <concino/core/parallel.hpp>
#include <concino/render/detail/colors/kept_map.hpp>

#include <cassert>
#include <concepts>
#include <limits>
#include <memory>
#include <vector>

namespace concino {

namespace detail {

struct no_face_type {};
template<class M> struct optional_face { using type = no_face_type; };
template<VolumeMesh M> struct optional_face<M> { using type = face_t<M>; };

/// The elements at which a map of a mesh of type M gives numbers: the first of these kinds. `mesh`: none of them.
template<class M, class U>
consteval element_kind place_of_field() {
  if (requirement::gives_numbers<U, vert_t<M>>) return element_kind::vert;
  if (requirement::gives_numbers<U, poly_t<M>>) return element_kind::poly;
  if (requirement::gives_numbers<U, edge_t<M>>) return element_kind::edge;
  if (requirement::gives_numbers<U, typename optional_face<M>::type>) return element_kind::face;
  return element_kind::mesh;
}

/// The number u[x] at each of `all` elements, by index; NaN at other indices.
template<class X, class M, class U, class R>
void read_field(const M& m, const U& u, const R& all, std::size_t bound, element_kind kind,
                std::vector<double>& values) {
  check_map(m, u, bound, kind, "any_field");
  values.assign(bound, std::numeric_limits<double>::quiet_NaN());
  double* const first = values.data();
  parallel_for_each(all, [&m, &u, first](const X& x) { first[index_of(m, x)] = static_cast<double>(u[x]); }, 8192);
}

/// The values of a map of type U, which is at `map`.
template<class M, class U>
void read_any_field(const void* map, const M& m, std::vector<double>& values) {
  constexpr element_kind kind = place_of_field<M, U>();
  const U& u = *static_cast<const U*>(map);
  if constexpr (kind == element_kind::vert) read_field<vert_t<M>>(m, u, verts(m), vert_index_bound(m), kind, values);
  else if constexpr (kind == element_kind::poly)
    read_field<poly_t<M>>(m, u, polys(m), poly_index_bound(m), kind, values);
  else if constexpr (kind == element_kind::edge)
    read_field<edge_t<M>>(m, u, edges(m), edge_index_bound(m), kind, values);
  else read_field<face_t<M>>(m, u, faces(m), face_index_bound(m), kind, values);
}

}  // namespace detail

namespace requirement {

/// U gives a number at each vert, poly, edge or face of a mesh of type M.
template<class U, class M>
concept is_field = AnyMesh<M> && concino::detail::place_of_field<std::remove_cvref_t<M>, std::remove_cvref_t<U>>()
!= element_kind::mesh;

}  // namespace requirement

/// A field of numbers on a mesh of type M: any readable map of its verts, polys, edges or faces. Options such as those
/// of scenes hold one.
/// Needs:  AnyMesh M; u[x] is a number for each element of one kind. If this holds for several kinds, they are taken in
///         the order verts, polys, edges, faces. A map that is an lvalue must outlive the field; a temporary map is
///         stored in it.
/// Result: an implicit conversion from such a map. Copies share a stored map. By default there is no field.
/// Cost:   one allocation for a stored map; fill reads each value once, in parallel.
/// Errors: fill throws invalid_argument if u is a map of another mesh, or was made before elements were added.
template<AnyMesh M>
class any_field {
  std::shared_ptr<const void> map_;
  void (*read_)(const void*, const M&, std::vector<double>&) = nullptr;
  element_kind at_ = element_kind::mesh;

 public:
  any_field() = default;

  template<class U>
    requires(!std::same_as<std::remove_cvref_t<U>, any_field> && requirement::is_field<U, M>)
  any_field(U&& u)
      : read_(&detail::read_any_field<M, std::remove_cvref_t<U>>),
        at_(detail::place_of_field<M, std::remove_cvref_t<U>>()) {
    if constexpr (std::is_lvalue_reference_v<U>)
      map_ = std::shared_ptr<const void>(std::shared_ptr<const void>(), std::addressof(u));
    else map_ = std::make_shared<const std::remove_cvref_t<U>>(std::forward<U>(u));
  }

  explicit operator bool() const { return read_ != nullptr; }
  /// The kind of the elements that have values; `mesh` if there is no field.
  element_kind at() const { return at_; }
  /// The values by index of these elements; NaN at indices without an element. There must be a field.
  void fill(const M& m, std::vector<double>& by_index) const {
    assert(read_);
    read_(map_.get(), m, by_index);
  }
};

}  // namespace concino
