// A selection of the polygons of a mesh, for options that hold one: the faces that a cut made, for example.
#pragma once

#include <concino/core/parallel.hpp>
#include <concino/geometry/outer_polygons.hpp>
#include <concino/render/detail/colors/kept_map.hpp>

#include <cassert>
#include <concepts>
#include <memory>
#include <vector>

namespace concino {

namespace detail {

/// A container of polygons of a mesh of type M.
template<class S, class M>
concept lists_polygons = requires(const std::remove_cvref_t<S>& some) {
  { *some.begin() } -> std::convertible_to<polygon_t<M>>;
  some.end();
};

/// A map that is true or false at polygons of a mesh of type M.
template<class S, class M>
concept marks_polygons = requires(const std::remove_cvref_t<S>& map, const polygon_t<M>& x) {
  { map[x] } -> std::convertible_to<bool>;
};

template<SurfaceMesh M> decltype(auto) all_polygons(const M& m) { return polys(m); }
template<VolumeMesh M> decltype(auto) all_polygons(const M& m) { return faces(m); }
template<SurfaceMesh M> std::size_t polygon_index_bound(const M& m) { return poly_index_bound(m); }
template<VolumeMesh M> std::size_t polygon_index_bound(const M& m) { return face_index_bound(m); }

/// Writes whether each polygon is in the container or marked by the map at `selected`, by index.
template<class M, class S>
void read_selection(const void* selected, const M& m, std::vector<unsigned char>& by_index) {
  const S& some = *static_cast<const S*>(selected);
  by_index.assign(polygon_index_bound(m), 0);
  if constexpr (marks_polygons<S, M>) {
    check_map(m, some, by_index.size(), dimension_v<M> == 2 ? element_kind::poly : element_kind::face,
              "polygon_selection");
    unsigned char* const all = by_index.data();
    parallel_for_each(
        all_polygons(m), [&m, &some, all](const polygon_t<M>& x) { all[index_of(m, x)] = static_cast<bool>(some[x]); },
        8192);
  } else {
    for (const polygon_t<M> x : some) {
      const std::size_t i = index_of(m, x);
      if (i >= by_index.size())
        core::throw_joined<invalid_argument>(
            {"polygon_selection: there is no polygon with index ", i, "; the selection was made for another mesh"});
      by_index[i] = 1;
    }
  }
}

}  // namespace detail

/// A selection of polygons of a mesh of type M, polys of a surface or faces of a volume: any container of them, or any
/// map that is true at them. The faces that a cut made are c.cut_faces, if c is the result of clip.
/// Needs:  AnyMesh M. An lvalue must outlive the selection; a temporary is stored in it.
/// Result: an implicit conversion from such a container or map. Copies share what is stored. By default there is no
///         selection.
/// Cost:   one allocation for a temporary; fill takes O(index bound + selected polygons).
/// Errors: fill throws invalid_argument if a polygon is not in the mesh, or the map belongs to another mesh.
template<AnyMesh M>
class polygon_selection {
  std::shared_ptr<const void> selected_;
  void (*read_)(const void*, const M&, std::vector<unsigned char>&) = nullptr;

 public:
  polygon_selection() = default;

  template<class S>
    requires(!std::same_as<std::remove_cvref_t<S>, polygon_selection> &&
             (detail::lists_polygons<S, M> || detail::marks_polygons<S, M>))
  polygon_selection(S&& some) : read_(&detail::read_selection<M, std::remove_cvref_t<S>>) {
    if constexpr (std::is_lvalue_reference_v<S>)
      selected_ = std::shared_ptr<const void>(std::shared_ptr<const void>(), std::addressof(some));
    else selected_ = std::make_shared<const std::remove_cvref_t<S>>(std::forward<S>(some));
  }

  explicit operator bool() const { return read_ != nullptr; }
  /// 1 for each selected polygon, else 0, by index. There must be a selection.
  void fill(const M& m, std::vector<unsigned char>& by_index) const {
    assert(read_);
    read_(selected_.get(), m, by_index);
  }
};

}  // namespace concino
