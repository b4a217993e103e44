// A map that a criterion or a field refers to or owns, and checks that it fits a mesh.
#pragma once

#include <concino/concepts/maps.hpp>
#include <concino/concepts/mesh_traits.hpp>
#include <concino/core/error.hpp>
#include <concino/mesh/property_set.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace concino::detail {

/// P is the type of a forwarded argument: a reference to an lvalue is kept as its address, a temporary as a copy.
template<class P>
class kept_map {
  static constexpr bool by_reference = std::is_lvalue_reference_v<P>;
  using map = std::remove_cvref_t<P>;
  std::conditional_t<by_reference, const map*, map> map_;

 public:
  explicit kept_map(const map& p) requires by_reference : map_(&p) {}
  explicit kept_map(map&& p) requires(!by_reference) : map_(std::move(p)) {}
  const map& get() const {
    if constexpr (by_reference) return *map_;
    else return map_;
  }
};

/// The mesh of a map, if the map says which it is.
template<class U>
concept names_its_mesh = requires(const U& u) { requires requirement::is_adapted<decltype(u.mesh())>; };

/// Errors: invalid_argument if u is a map of another mesh, or was made before elements were added. bound: the index
///         bound of its elements.
template<class M, class U>
void check_map(const M& m, const U& u, std::size_t bound, element_kind kind, const char* caller) {
  const auto refuse = [&] {
    core::throw_joined<invalid_argument>(
        {caller, ": the map belongs to another mesh; make it with make_", to_string(kind), "_map<...>(m)"});
  };
  if constexpr (!is_view_v<M> && names_its_mesh<U>) {
    using other = std::remove_cvref_t<decltype(u.mesh())>;
    if constexpr (std::is_same_v<other, M>) {
      if (&u.mesh() != &m) refuse();
    } else if constexpr (!is_view_v<other>) {  // the elements of a view may be those of m
      refuse();
    }
  }
  if constexpr (requires { u.values().size(); })
    if (const std::size_t size = u.values().size(); size < bound)
      core::throw_joined<invalid_argument>({caller, ": the map has values below index ", size, ", but the mesh has a ",
                                            to_string(kind), " with index ", bound - 1,
                                            "; it was made for another mesh, or before elements were added"});
}

}  // namespace concino::detail
