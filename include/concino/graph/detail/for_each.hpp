// The inner loops of graph algorithms: over a range of neighbours in the way that costs least.
#pragma once

namespace concino::detail {

/// Calls f(x) for all elements of a range: by its own loop if it has one.
template<class R, class F>
void for_each(const R& r, F&& f) {
  if constexpr (requires { r.for_each(f); }) r.for_each(f);
  else
    for (const auto x : r) f(x);
}

/// The same for the neighbours of a node, except that some may come more than once and the node itself may come too. For loops in which
/// that changes nothing: where telling neighbours apart costs time, they are spared it.
template<class R, class F>
void for_each_with_repeats(const R& r, F&& f) {
  if constexpr (requires { r.for_each_with_repeats(f); }) r.for_each_with_repeats(f);
  else detail::for_each(r, f);
}

}  // namespace concino::detail
