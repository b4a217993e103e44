// The numbers by which messages name verts and polys.
#pragma once

#include <concino/concepts/mesh.hpp>

#include <cstddef>

namespace concino::core {

/// The index of a vert or poly; in a mesh that is a part of another one, or in a view of it, its number in that one.
template<class M, class X>
std::size_t number_in_messages(const M& m, const X& x) {
  if constexpr (requires { m.global_number(x); }) return static_cast<std::size_t>(m.global_number(x));
  else if constexpr (requires { m.base().global_number(x); }) return number_in_messages(m.base(), x);
  else if constexpr (requires { m.base().base().global_number(x); }) return number_in_messages(m.base().base(), x);
  else return index_of(m, x);
}

}  // namespace concino::core
