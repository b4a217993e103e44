// Whether the library of a mesh can represent what an edit leads to.
#pragma once

#include <concino/concepts/mesh_traits.hpp>
#include <concino/edit/permission.hpp>

#include <concepts>

namespace concino::detail {

/// Models that cannot represent every result of rewire, such as non-manifold edges, and say why: a text with static
/// lifetime, or null.
template<class M> concept says_why_not_rewire = requires(const M& m, const cavity<M>& c) {
  { traits<M>::why_not_rewire(m, c) } -> std::same_as<const char*>;
};

template<class M>
permission is_representable(const M& m, const cavity<M>& c) {
  if constexpr (says_why_not_rewire<M>)
    if (const char* const why = traits<M>::why_not_rewire(m, c)) return {refusal::unsupported, why};
  return {};
}

}  // namespace concino::detail
