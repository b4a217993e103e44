// Maps give a value per element. Anything with `p[e]` is one: an array indexed by descriptors, a lambda in a wrapper, a property of a
// foreign library. Writing is `p[e] = t` and nothing more, so proxies qualify.
#pragma once

#include <concepts>
#include <cstddef>
#include <type_traits>

namespace concino {

template<class P, class E>
concept ReadableMap = requires(const std::remove_cvref_t<P>& p, const E& e) { p[e]; };

template<class P, class E, class T>
concept WritableMap = requires(std::remove_reference_t<P>& p, const E& e, const T& t) { p[e] = t; };

}  // namespace concino
