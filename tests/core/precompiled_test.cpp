#include <concino/core/precompiled.hpp>

#include <concino/mesh/tetmesh.hpp>
#include <concino/mesh/trimesh.hpp>

#include <doctest/doctest.h>

namespace {

struct no_mesh {};

struct derived_mesh : concino::trimesh {};

}  // namespace

template<>
struct concino::mesh_traits<derived_mesh> : concino::mesh_traits<concino::trimesh> {};

namespace {

#ifdef CONCINO_COMPILED
constexpr bool is_compiled = true;
#else
constexpr bool is_compiled = false;
#endif

}  // namespace

TEST_CASE("precompiled: is_precompiled is true for native meshes with the compiled library") {
  CHECK(concino::core::is_precompiled<concino::trimesh> == is_compiled);
  CHECK(concino::core::is_precompiled<concino::tetmesh> == is_compiled);
  CHECK(concino::core::is_precompiled<const concino::tetmesh&> == is_compiled);
  CHECK_FALSE(concino::core::is_precompiled<no_mesh>);
  CHECK_FALSE(concino::core::is_precompiled<derived_mesh>);  // the library has no functions for this type
}
