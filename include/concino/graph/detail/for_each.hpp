// The inner loops of graph algorithms: iteration over a range of neighbours in the fastest form.
#pragma once

namespace concino::detail {

/// Calls f(x) for all elements of a range, with the range's own for_each if it has one.
template<class R, class F>
void for_each(const R& r, F&& f) {
  if constexpr (requires { r.for_each(f); }) r.for_each(f);
  else
    for (const auto x : r) f(x);
}

/// The same for the neighbours of a node, except that some may be repeated and the node itself may occur. For loops in
/// which that does no harm: they avoid the cost of finding repetitions.
template<class R, class F>
void for_each_with_repeats(const R& r, F&& f) {
  if constexpr (requires { r.for_each_with_repeats(f); }) r.for_each_with_repeats(f);
  else detail::for_each(r, f);
}

}  // namespace concino::detail
