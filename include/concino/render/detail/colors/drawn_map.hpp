// Maps of any type with values that a drawable takes over: colours, or texture coordinates.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/parallel.hpp>
#include <concino/core/rgba.hpp>
#include <concino/mesh/corner.hpp>
#include <concino/render/any_field.hpp>
#include <concino/render/detail/colors/corner_values.hpp>
#include <concino/render/drawable.hpp>

#include <array>
#include <cassert>
#include <concepts>
#include <memory>
#include <type_traits>
#include <vector>

namespace concino::detail {

using drawn_point = std::array<float, 2>;

inline rgb drawn_value(const rgb& c, const rgb*) { return c; }
inline rgb drawn_value(const rgba& c, const rgb*) { return srgb(c.r, c.g, c.b); }
template<class T>
  requires requires(const T& t) { { t[0] } -> std::convertible_to<double>; { t[1] } -> std::convertible_to<double>; }
drawn_point drawn_value(const T& t, const drawn_point*) {
  return {static_cast<float>(t[0]), static_cast<float>(t[1])};
}

/// u[x] can be drawn as a T.
template<class U, class X, class T> concept gives_drawn = requires(const U& u, const X& x) {
  { drawn_value(u[x], static_cast<const T*>(nullptr)) } -> std::same_as<T>;
};

/// The first kind of elements at which a map can be drawn: texture coordinates at verts or corners, colours also at
/// polys and faces. `mesh`: none.
template<class M, class U, class T>
consteval element_kind drawn_at() {
  if (gives_drawn<U, vert_t<M>, T>) return element_kind::vert;
  if (std::is_same_v<T, rgb> && gives_drawn<U, poly_t<M>, T>) return element_kind::poly;
  if (std::is_same_v<T, rgb> && gives_drawn<U, typename optional_face<M>::type, T>) return element_kind::face;
  if (gives_drawn<U, corner<M>, T>) return element_kind::corner;
  return element_kind::mesh;
}

/// The values at `all` elements, by index.
template<class X, class T, class M, class U, class R>
std::vector<T> values_by_index(const M& m, const U& u, const R& all, std::size_t bound, element_kind kind) {
  check_map(m, u, bound, kind, "make_drawable");
  std::vector<T> values(bound);
  T* const first = values.data();
  parallel_for_each(
      all, [&m, &u, first](const X& x) { first[index_of(m, x)] = drawn_value(u[x], static_cast<const T*>(nullptr)); },
      8192);
  return values;
}

/// The values at corners, by corner of the drawable.
template<class T, class M, class U>
std::vector<T> values_at_corners(const M& m, const U& u, const drawable& d) {
  check_map(m, u, 0, element_kind::corner, "make_drawable");
  std::vector<T> result(d.corners.size()), values;
  std::vector<std::uint32_t> verts;
  const polygons_of_polys of_poly(d, poly_index_bound(m));
  for (const poly_t<M> p : polys(m)) {
    const std::span<const std::uint32_t> polygons = of_poly[index_of(m, p)];
    if (polygons.empty()) continue;
    verts.clear();
    values.clear();
    std::uint32_t k = 0;
    for (const vert_t<M> v : adj_p2v(m, p)) {
      verts.push_back(static_cast<std::uint32_t>(index_of(m, v)));
      values.push_back(drawn_value(u[corner<M>{p, k++}], static_cast<const T*>(nullptr)));
    }
    for (const std::uint32_t polygon : polygons)
      for_each_corner(d, polygon, verts, [&](std::uint32_t c, std::size_t i) { result[c] = values[i]; });
  }
  return result;
}

/// Reads the values of a map of type U, which is at `map`, for the drawable of a mesh.
template<class M, class U, class T>
std::vector<T> read_drawn_map(const void* map, const M& m, const drawable& d) {
  constexpr element_kind kind = drawn_at<M, U, T>();
  const U& u = *static_cast<const U*>(map);
  if constexpr (std::is_constructible_v<bool, const U&>)
    if (!u) throw invalid_argument("make_drawable: the mesh has no such property of colours or texture coordinates");
  const auto chosen = [](const std::vector<T>& by_index, std::span<const std::uint32_t> indices) {
    std::vector<T> result;
    result.reserve(indices.size());
    for (const std::uint32_t i : indices) result.push_back(by_index[i]);
    return result;
  };
  if constexpr (kind == element_kind::vert)
    return chosen(values_by_index<vert_t<M>, T>(m, u, verts(m), vert_index_bound(m), kind), d.verts);
  else if constexpr (kind == element_kind::poly)
    return chosen(values_by_index<poly_t<M>, T>(m, u, polys(m), poly_index_bound(m), kind), d.polys);
  else if constexpr (kind == element_kind::face)
    return chosen(values_by_index<face_t<M>, T>(m, u, faces(m), face_index_bound(m), kind), d.mesh_polygons);
  else return values_at_corners<T>(m, u, d);
}

/// A map of Ts on a mesh of type M, of any type.
template<AnyMesh M, class T>
class drawn_map {
  std::shared_ptr<const void> map_;
  std::vector<T> (*read_)(const void*, const M&, const drawable&) = nullptr;
  element_kind at_ = element_kind::mesh;

 public:
  drawn_map() = default;

  template<class U>
    requires(!std::same_as<std::remove_cvref_t<U>, drawn_map> &&
             drawn_at<M, std::remove_cvref_t<U>, T>() != element_kind::mesh)
  drawn_map(U&& u)
      : read_(&read_drawn_map<M, std::remove_cvref_t<U>, T>), at_(drawn_at<M, std::remove_cvref_t<U>, T>()) {
    if constexpr (std::is_lvalue_reference_v<U>)
      map_ = std::shared_ptr<const void>(std::shared_ptr<const void>(), std::addressof(u));
    else map_ = std::make_shared<const std::remove_cvref_t<U>>(std::forward<U>(u));
  }

  explicit operator bool() const { return read_ != nullptr; }
  /// The kind of the elements that have values; `mesh` if there is no map.
  element_kind at() const { return at_; }
  /// The values of the elements of a drawable of m: by point if they are at verts, by corner if at corners, else by
  /// polygon. There must be a map.
  std::vector<T> read(const M& m, const drawable& d) const {
    assert(read_);
    return read_(map_.get(), m, d);
  }
};

}  // namespace concino::detail
