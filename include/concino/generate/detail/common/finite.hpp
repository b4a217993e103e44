// Checks that the points of a mesh are finite.
#pragma once

#include <concino/concepts/mesh.hpp>
#include <concino/core/error.hpp>
#include <concino/core/vec3.hpp>

namespace concino::detail {

template<Embedded M>
void check_points_finite(const char* what, const M& m, const char* hint = "nothing was moved") {
  for (const vert_t<M> v : verts(m))
    if (!is_finite(to_vec3(point(m, v))))
      core::throw_joined<invalid_mesh>({what, ": the point of vert ", index_of(m, v), " is not finite; ", hint});
}

}  // namespace concino::detail
