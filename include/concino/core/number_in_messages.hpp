// The numbers by which messages name verts and polys.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <cstddef>

namespace concino::core {

/// The index of a vert or poly, or what the traits say.
template<class M, class X>
std::size_t number_in_messages(const M& m, const X& x) {
  if constexpr (requires { traits<M>::number_in_messages(m, x); }) return traits<M>::number_in_messages(m, x);
  else return index_of(m, x);
}

}  // namespace concino::core
