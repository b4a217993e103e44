// Which meshes the compiled library knows: for those of the library itself it has the steps of algorithms that depend on the mesh.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/core/compiled.hpp>

#include <concepts>
#include <type_traits>

namespace concino::core {

/// Whether a function that the library instantiates for its own meshes is to be called, and not to be compiled here. Headers declare such a
/// function without a definition. The meshes say so in their traits, so that no header of an algorithm includes one: traits that are derived from
/// those of such a mesh name another mesh there.
#ifdef CONCINO_COMPILED
template<class M> inline constexpr bool is_precompiled = requires { requires std::same_as<std::remove_cvref_t<M>, typename traits<M>::precompiled>; };
#else
template<class M> inline constexpr bool is_precompiled = false;
#endif

}  // namespace concino::core
