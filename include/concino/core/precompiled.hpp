// Which meshes the compiled library supports: for the native meshes it contains the parts of algorithms that depend on
// the mesh type.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/core/compiled.hpp>

#include <concepts>
#include <type_traits>

namespace concino::core {

/// Whether M is a native mesh, with the traits of the library. Traits that are derived from those, and may replace a
/// verb, have the name of another mesh there.
template<class M>
inline constexpr bool is_native = requires {
  requires std::same_as < std::remove_cvref_t<M>,
  typename traits<M>::precompiled > ;
};

/// Whether to call a function that the library instantiates for the native meshes, instead of compiling it here.
/// Headers declare such a function without a definition. The meshes declare this in their traits, so that no header of
/// an algorithm includes a mesh.
#ifdef CONCINO_COMPILED
template<class M> inline constexpr bool is_precompiled = is_native<M>;
#else
template<class M> inline constexpr bool is_precompiled = false;
#endif

}  // namespace concino::core
