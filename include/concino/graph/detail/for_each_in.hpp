// The inner loops of graph algorithms: over a range of neighbours in the way that costs least.
#pragma once

namespace concino::detail {

/// Calls f(x) for all elements of a range: by its own loop if it has one.
template<class R, class F>
void for_each_in(const R& r, F&& f) {
  if constexpr (requires { r.for_each(f); }) r.for_each(f);
  else
    for (const auto x : r) f(x);
}

}  // namespace concino::detail
